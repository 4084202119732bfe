//! What the keys become.

use super::super::state_based::{Families, LOCKS, admissible};
use super::super::{Asked, BodyKind, Keys, Material, Model, PlaneState, Refused, USUAL_HORIZON_RATIO};
use super::{NAME, StatePlane};
use crate::diagnostic::{Faults, positive, root};
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateEdges, StateParameters,
};

impl Keys for StatePlane {
    fn model(&self) -> Model {
        Model::StatePlane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn refuses(&self) -> Vec<Refused> {
        vec![Refused {
            key: "rigid.bearing",
            message: "families do not know of bearings",
            hint: "leave `bearing` out, or use the model `bond_plane`",
        }]
    }

    fn with_usual_bonds(&self) -> Model {
        Model::StatePlane(Self { edges: None, ..self.clone() })
    }

    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let mut keys = self.clone();
        let parameters = parameters(&mut keys, asked, faults)?;
        let filled = |of: &StateParameters, keys: &Self| {
            Model::StatePlane(Self { edges: Some(of.edges), ..keys.clone() })
        };
        let ends_where_cut = self.edges.is_none();
        let is_rectangle = matches!(asked.body, BodyKind::Rectangle { has_holes: false, .. });
        // Ghosts serve two spacings where edges lie between cells, and the completed border where it cuts them. The cycle of families
        // of several materials breaks down with two.
        let usual_edges = if is_rectangle { StateEdges::Ghosts } else { StateEdges::Border };
        let has_usual_edges = self.edges.is_none_or(|edges| edges == usual_edges);
        let usual_horizon_ratio = match asked.materials.is_none() && has_usual_edges {
            true => asked.usual_horizon_ratio(),
            false => USUAL_HORIZON_RATIO,
        };
        Some(Box::new(Families { name: NAME, keys, parameters, usual_horizon_ratio, ends_where_cut, filled }))
    }
}

/// The parameters, filling in the defaults of the keys; the horizon ratio is to be set.
fn parameters(model: &mut StatePlane, asked: &Asked, faults: &mut Faults) -> Option<StateParameters> {
    let path = root("model").key(NAME);
    let mut fine = positive(model.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= positive(model.thickness, "thickness", path.key("thickness"), faults);
    fine &= admissible(model.poisson_ratio, &path, faults);
    let geometry = match model.state {
        PlaneState::PlaneStress => Geometry::PlaneStress(model.thickness),
        PlaneState::PlaneStrain => Geometry::PlaneStrain(model.thickness),
    };
    let usual = match model.state {
        PlaneState::PlaneStrain if asked.most_poisson_ratio(model.poisson_ratio) > LOCKS => {
            Dilatation::Blocks
        }
        _ => Dilatation::Points,
    };
    let needs_ghosts = asked.breaks || asked.has_cracks || asked.materials.is_some();
    let edges = if needs_ghosts { StateEdges::Ghosts } else { StateEdges::Border };
    fine.then(|| StateParameters {
        youngs_modulus: model.youngs_modulus,
        poisson_ratio: model.poisson_ratio,
        geometry,
        horizon_ratio: 0.0,
        influence: *model.influence.get_or_insert(Influence::Linear),
        edges: model.edges.unwrap_or(edges),
        measure: Measure::Section,
        axis: Axis::Images,
        dilatation: *model.dilatation.get_or_insert(usual),
    })
}
