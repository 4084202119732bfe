//! A load case of a plate.

use crate::scene::Resultant;
use peristat_assembly::model::plate_bending::{FreeCurvature, PlateBending};

/// A load case.
#[derive(Clone, Debug)]
pub struct PlateLoads {
    /// Forces and moments on the unknowns, component by component.
    pub force: Vec<f64>,
    /// Resultant as the case asks for it.
    pub asked: Resultant,
    /// Whether something follows a formula, or the steps of a border that cuts cells: its integrals are approximate.
    pub is_approximate: bool,
    /// Curvatures that need no moments.
    pub free: Vec<FreeCurvature>,
}

impl PlateLoads {
    /// Adds a curvature that needs no moments. It has no resultant.
    pub(super) fn bend(&mut self, free: FreeCurvature, plate: &PlateBending) {
        plate.add_free_curvature(&free, &mut self.force);
        self.free.push(free);
    }
}
