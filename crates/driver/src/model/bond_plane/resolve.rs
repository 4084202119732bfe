//! What the keys become.

use super::super::bond_choice::BondChoice;
use super::super::{
    Asked, BodyKind, Keys, Material, Model, PlaneBondLaw, PlaneState as State, USUAL_HORIZON_RATIO,
};
use super::{Central, Plane};
use crate::diagnostic::{Faults, positive, root, tidy};
use peristat_assembly::model::bond_plane::{PlaneMaterial, PlaneParameters, PlaneState};
use peristat_assembly::model::plane::{Calibration, Edges};

/// How far a Poisson ratio may be off: 0.333 is a third.
const POISSON_SLACK: f64 = 1e-3;

impl Keys for Plane {
    fn model(&self) -> Model {
        Model::BondPlane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn bond_law(&self) -> Option<&PlaneBondLaw> {
        self.bond_law.as_ref()
    }

    fn with_usual_bonds(&self) -> Model {
        let usual = Self {
            calibration: None,
            weights: None,
            volume_factor: None,
            edges: None,
            bond_law: None,
            ..self.clone()
        };
        Model::BondPlane(usual)
    }

    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let mut keys = self.clone();
        let parameters = parameters(&mut keys, asked, faults)?;
        let is_exact = parameters.edges.is_exact();
        let usual_horizon_ratio = if is_exact { asked.usual_horizon_ratio() } else { USUAL_HORIZON_RATIO };
        Some(Box::new(Central { keys, parameters, usual_horizon_ratio }))
    }
}

/// The parameters, filling in the defaults of the keys; the horizon ratio is to be set.
fn parameters(model: &mut Plane, asked: &Asked, faults: &mut Faults) -> Option<PlaneParameters> {
    let path = root("model").key("bond_plane");
    let mut fine = positive(model.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= positive(model.thickness, "thickness", path.key("thickness"), faults);
    let (state, words) = match model.state {
        State::PlaneStress => (PlaneState::Stress, "plane stress"),
        State::PlaneStrain => (PlaneState::Strain, "plane strain"),
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
    // Edges are completed with matched bonds only, and those alone can be chosen.
    let is_matched = model.edges.is_none_or(Edges::is_exact) || model.weights.is_some();
    let usual = match (asked.breaks || asked.softens) && !is_matched {
        true => Calibration::Published,
        false => Calibration::Matched,
    };
    let calibration = *model.calibration.get_or_insert(usual);
    let published = calibration == Calibration::Published;
    let choice = BondChoice { weights: model.weights, volume_factor: model.volume_factor };
    fine &= choice.check(calibration, &path, faults);
    if asked.body == BodyKind::Points {
        fine &= choice.check_listed(&path, faults);
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
        weights: model.weights.unwrap_or_default(),
        volume_factor: model.volume_factor.unwrap_or_default(),
        edges,
    })
}
