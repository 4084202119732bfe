//! The models of bodies in the plane as cases give them, with their defaults filled in as they are resolved.

use super::bonds::PlaneBonds;
use super::{material, orthotropic, shell, state_based};
use crate::case::{Axisymmetric, Case, LatticeRows, Model, Orthotropic, Plane, Shell, StatePlane};
use crate::diagnostic::Faults;
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::state_based::{Measure, StateEdges};

/// A model of a body in the plane.
#[derive(Clone, Debug)]
pub(in super::super) enum Given {
    /// Of central bonds.
    Central(Plane),
    /// Of beam bonds.
    Beams(Orthotropic),
    /// Of state-based families.
    State(StatePlane),
    /// The same, of revolution.
    Revolved(Axisymmetric),
    /// Of a shell membrane.
    Shell(Shell),
}

impl Given {
    /// Thickness.
    pub(super) fn thickness(&self) -> f64 {
        match self {
            Self::Central(model) => model.thickness,
            Self::Beams(model) => model.thickness,
            Self::State(model) => model.thickness,
            Self::Revolved(_) => 1.0,
            Self::Shell(model) => model.thickness,
        }
    }

    /// Angle of the rows of its lattice from x, rad.
    pub(super) fn lattice_angle(&self) -> f64 {
        match self {
            Self::Beams(model) if model.lattice == LatticeRows::Fibre => model.fibre_angle.to_radians(),
            _ => 0.0,
        }
    }

    /// The same with the bonds that elastic bodies have by default.
    pub(super) fn with_usual_bonds(self) -> Self {
        match self {
            Self::Central(model) => Self::Central(Plane {
                calibration: None,
                volume_factor: None,
                edges: None,
                bond_law: None,
                ..model
            }),
            Self::Beams(model) => {
                let calibration = Calibration::default();
                Self::Beams(Orthotropic { calibration, start: None, edges: None, ..model })
            }
            Self::State(model) => Self::State(StatePlane { edges: None, ..model }),
            Self::Revolved(model) => {
                Self::Revolved(Axisymmetric { edges: None, measure: Measure::default(), axis: None, ..model })
            }
            Self::Shell(model) => Self::Shell(model),
        }
    }

    /// Its material and bonds, filling in its defaults; the horizon ratio is to be set.
    pub(super) fn bonds(&mut self, case: &Case, is_cloud: bool, faults: &mut Faults) -> Option<PlaneBonds> {
        match self {
            Self::Central(model) => {
                let fails = case.path.is_some() || case.fracture.is_some();
                material::parameters(model, [is_cloud, fails], faults).map(PlaneBonds::Central)
            }
            Self::Beams(model) => {
                orthotropic::parameters(model, case, is_cloud, faults).map(PlaneBonds::Beams)
            }
            Self::State(model) => state_based::in_plane(model, case, faults).map(PlaneBonds::State),
            Self::Revolved(model) => state_based::revolved(model, faults).map(PlaneBonds::State),
            Self::Shell(model) => shell::parameters(model, case, faults).map(PlaneBonds::Shell),
        }
    }

    /// Fills in what only its bonds have told.
    pub(super) fn settle(&mut self, bonds: &PlaneBonds, case: &mut Case) {
        match (self, bonds) {
            (Self::Central(model), PlaneBonds::Central(parameters)) => model.edges = Some(parameters.edges),
            (Self::Beams(model), PlaneBonds::Beams(parameters)) => {
                model.start = orthotropic::start(parameters);
                if case.horizon.is_none() {
                    case.horizon_ratio = Some(parameters.horizon_ratio);
                }
            }
            (Self::State(model), PlaneBonds::State(parameters)) => model.edges = Some(parameters.edges),
            (Self::Revolved(model), PlaneBonds::State(parameters)) => {
                model.edges = Some(parameters.edges);
                model.axis = (parameters.edges != StateEdges::Border).then_some(parameters.axis);
            }
            _ => {}
        }
    }
}

impl From<Given> for Model {
    fn from(given: Given) -> Self {
        match given {
            Given::Central(model) => Self::BondPlane(model),
            Given::Beams(model) => Self::BeamBondOrthotropic(model),
            Given::State(model) => Self::StatePlane(model),
            Given::Revolved(model) => Self::Axisymmetric(model),
            Given::Shell(model) => Self::ShellMembrane(model),
        }
    }
}
