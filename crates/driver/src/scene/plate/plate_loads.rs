//! A load case of a plate.

use crate::scene::Resultant;
use peristat_assembly::model::plate_bending::{FreeCurvature, PlateBending};

/// Part of the forces of bonds on an unknown up to which their sum is rounding.
const ROUNDING: f64 = 1e-14;

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
    /// What they do to the unknowns; nothing where there are none.
    pub heat: Heat,
}

/// What curvatures that need no moments do to the unknowns. Forces of bonds cancel inside of what curves evenly: what is left is none.
#[derive(Clone, Debug, Default)]
pub struct Heat {
    force: Vec<f64>,
    /// Sums of the magnitudes of the forces of bonds.
    size: Vec<f64>,
}

impl PlateLoads {
    /// Adds a curvature that needs no moments.
    pub(super) fn bend(&mut self, free: FreeCurvature, plate: &PlateBending) {
        let mut own = Heat { force: vec![0.0; self.force.len()], size: vec![0.0; self.force.len()] };
        plate.add_free_curvature(&free, &mut |unknown, force| {
            own.force[unknown] += force;
            own.size[unknown] += force.abs();
        });
        self.heat.add(1.0, &own);
        self.free.push(free);
    }
}

impl Heat {
    /// Adds a multiple of another one.
    pub(crate) fn add(&mut self, factor: f64, other: &Self) {
        let unknowns = self.force.len().max(other.force.len());
        let add = |to: &mut Vec<f64>, from: &[f64], factor: f64| {
            to.resize(unknowns, 0.0);
            to.iter_mut().zip(from).for_each(|(own, other)| *own += factor * other);
        };
        add(&mut self.force, &other.force, factor);
        add(&mut self.size, &other.size, factor.abs());
    }

    /// Forces on the unknowns, zero where they are rounding.
    pub(crate) fn forces(&self) -> impl Iterator<Item = f64> + '_ {
        let sizes = self.force.iter().zip(&self.size);
        sizes.map(|(force, size)| if force.abs() > ROUNDING * size { *force } else { 0.0 })
    }
}
