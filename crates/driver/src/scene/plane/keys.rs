//! What the models of bodies in the plane have in common as cases give them.

use super::bonds::PlaneBonds;
use crate::case::{Beam, Case, Model};
use crate::diagnostic::Faults;
use std::fmt::Debug;

/// The keys of a model of a body in the plane.
pub(in super::super) trait PlaneKeys: Debug {
    /// They as the model of a case.
    fn model(&self) -> Model;

    /// Thickness.
    fn thickness(&self) -> f64;

    /// Angle of the rows of the lattice from x, rad.
    fn lattice_angle(&self) -> f64 {
        0.0
    }

    /// Takes the bonds that elastic bodies have by default.
    fn take_usual_bonds(&mut self) {}

    /// The material and its bonds, filling in defaults; the horizon ratio is to be set.
    fn bonds(&mut self, case: &Case, is_cloud: bool, faults: &mut Faults) -> Option<PlaneBonds>;

    /// Fills in what only the bonds tell.
    fn settle(&mut self, _bonds: &PlaneBonds, _case: &mut Case) {}
}

/// The keys of a model of bodies in the plane.
///
/// # Errors
/// The model, where it is a beam.
pub(in super::super) fn of(model: Model) -> Result<Box<dyn PlaneKeys>, Box<Beam>> {
    Ok(match model {
        Model::TimoshenkoBeam(beam) => return Err(beam),
        Model::BondPlane(keys) => Box::new(keys),
        Model::BeamBondOrthotropic(keys) => Box::new(keys),
        Model::StatePlane(keys) => Box::new(keys),
        Model::Axisymmetric(keys) => Box::new(keys),
        Model::ShellMembrane(keys) => Box::new(keys),
    })
}
