//! How thick a plate is, where.

use super::materials::PlateMaterial;
use peristat_assembly::model::plate_bending::PlateBending;

/// Thicknesses of a plate.
#[derive(Clone, Debug, PartialEq)]
pub struct Thickness {
    /// Where nothing else is said.
    pub base: f64,
    /// By number of section, the base first.
    pub of_sections: Vec<f64>,
    /// Of the thinnest cell about every point; none where all are alike.
    of_points: Vec<f64>,
}

impl Thickness {
    pub(super) fn new(base: f64, materials: &[PlateMaterial], plate: &PlateBending) -> Self {
        let others = materials.iter().map(|material| material.keys.thickness);
        let of_sections: Vec<f64> = [base].into_iter().chain(others).collect();
        let about = |point: usize| {
            let numbers = plate.sections().about(plate.nodes(), point);
            numbers.iter().map(|&(number, _)| of_sections[number]).fold(f64::INFINITY, f64::min)
        };
        let points = if materials.is_empty() { 0 } else { plate.nodes().points() };
        let of_points = (0..points).map(about).collect();
        Self { base, of_sections, of_points }
    }

    /// That of the thinnest cell about a point.
    pub fn at(&self, point: usize) -> f64 {
        self.of_points.get(point).copied().unwrap_or(self.base)
    }

    /// The smallest one.
    pub(super) fn least(&self) -> f64 {
        self.of_sections.iter().copied().fold(self.base, f64::min)
    }
}
