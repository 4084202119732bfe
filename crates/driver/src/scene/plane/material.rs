//! Material and bonds of a body in the plane.

use super::bonds::PlaneBonds;
use super::keys::PlaneKeys;
use super::root;
use crate::case::{self, Case, Model, Plane};
use crate::diagnostic::{Faults, positive, tidy};
use peristat_assembly::model::bond_plane::{PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor};
use peristat_assembly::model::plane::{Calibration, Edges};

/// How far a Poisson ratio may be off: 0.333 is a third.
const POISSON_SLACK: f64 = 1e-3;

impl PlaneKeys for Plane {
    fn model(&self) -> Model {
        Model::BondPlane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn take_usual_bonds(&mut self) {
        (self.calibration, self.volume_factor) = (None, None);
        (self.edges, self.bond_law) = (None, None);
    }

    fn bonds(&mut self, case: &Case, is_cloud: bool, faults: &mut Faults) -> Option<PlaneBonds> {
        parameters(self, [is_cloud, case.is_traced()], faults).map(PlaneBonds::Central)
    }

    fn settle(&mut self, bonds: &PlaneBonds, _: &mut Case) {
        if let PlaneBonds::Central(parameters) = bonds {
            self.edges = Some(parameters.edges);
        }
    }
}

/// The parameters, filling in the defaults of the case; the horizon ratio is to be set. `fails` is whether bonds break or
/// soften.
fn parameters(
    model: &mut Plane,
    [is_cloud, fails]: [bool; 2],
    faults: &mut Faults,
) -> Option<PlaneParameters> {
    let path = root("model").key("bond_plane");
    let mut fine = positive(model.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= positive(model.thickness, "thickness", path.key("thickness"), faults);
    let (state, words) = match model.state {
        case::PlaneState::PlaneStress => (PlaneState::Stress, "plane stress"),
        case::PlaneState::PlaneStrain => (PlaneState::Strain, "plane strain"),
    };
    if let Some(nu) = model.poisson_ratio.filter(|nu| (nu - state.poisson_ratio()).abs() > POISSON_SLACK) {
        let own = if state == PlaneState::Stress { "1/3" } else { "1/4" };
        faults
            .error(
                path.key("poisson_ratio"),
                format!("a body of central bonds has the Poisson ratio {own} in {words}, found {}", tidy(nu)),
            )
            .hint("leave `poisson_ratio` out; another one needs a model with more than central bonds, such as state-based or beam bonds");
        fine = false;
    }
    // Edges are completed with matched bonds only.
    let completes = model.edges.is_none_or(Edges::is_exact);
    let usual = match fails && !completes {
        true => Calibration::Published,
        false => Calibration::Matched,
    };
    let calibration = *model.calibration.get_or_insert(usual);
    let published = calibration == Calibration::Published;
    if model.volume_factor.is_some() && !published {
        faults
            .error(
                path.key("volume_factor"),
                "the calibration `matched` has no volume factors: its bonds are exact without them",
            )
            .hint(r#"remove `volume_factor`, or take "calibration": "published""#);
        fine = false;
    }
    if model.volume_factor == Some(VolumeFactor::Area) && is_cloud {
        faults
            .error(path.key("volume_factor"), "the volume factor `area` needs the cells of a lattice")
            .hint("use `ramp`");
        fine = false;
    }
    if model.edges.is_some_and(Edges::is_exact) && published {
        faults
            .error(
                path.key("edges"),
                "the edges `border` and `overlay` complete exact bonds, and those of the calibration `published` are not",
            )
            .hint("use `none`, `volume` or `energy`, or the calibration `matched`");
        fine = false;
    }
    if published {
        model.volume_factor.get_or_insert_default();
    }
    let edges = *model.edges.get_or_insert(if published { Edges::None } else { Edges::Border });
    fine.then(|| PlaneParameters {
        material: PlaneMaterial { youngs_modulus: model.youngs_modulus, thickness: model.thickness, state },
        horizon_ratio: 0.0,
        influence: model.influence,
        calibration,
        volume_factor: model.volume_factor.unwrap_or_default(),
        edges,
    })
}
