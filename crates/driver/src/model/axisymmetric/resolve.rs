//! What the keys become.

use super::super::state_based::{Families, LOCKS, admissible};
use super::super::{Asked, Keys, Material, Model, Refused, USUAL_HORIZON_RATIO};
use super::{Axisymmetric, NAME};
use crate::diagnostic::{Faults, positive, root};
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateEdges, StateParameters,
};

impl Keys for Axisymmetric {
    fn model(&self) -> Model {
        Model::Axisymmetric(self.clone())
    }

    fn thickness(&self) -> f64 {
        1.0
    }

    fn refuses(&self) -> Vec<Refused> {
        vec![
            Refused {
                key: "rigid",
                message: "a rigid region of a body of revolution can move along its axis alone",
                hint: "hold or move the region by a support with \"ux\": 0 and `uy`",
            },
            Refused {
                key: "stress_intensity",
                message: "stress intensities are of bodies in the plane",
                hint: "remove `stress_intensity`",
            },
        ]
    }

    fn with_usual_bonds(&self) -> Model {
        Model::Axisymmetric(Self { edges: None, measure: Measure::default(), axis: None, ..self.clone() })
    }

    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let mut keys = self.clone();
        let parameters = parameters(&mut keys, asked, faults)?;
        let filled = |of: &StateParameters, keys: &Self| {
            let axis = (of.edges != StateEdges::Border).then_some(of.axis);
            Model::Axisymmetric(Self { edges: Some(of.edges), axis, ..keys.clone() })
        };
        let usual_horizon_ratio = USUAL_HORIZON_RATIO;
        Some(Box::new(Families {
            name: NAME,
            keys,
            parameters,
            usual_horizon_ratio,
            ends_where_cut: false,
            filled,
        }))
    }
}

/// The parameters, filling in the defaults of the keys; the horizon ratio is to be set.
fn parameters(model: &mut Axisymmetric, asked: &Asked, faults: &mut Faults) -> Option<StateParameters> {
    let path = root("model").key(NAME);
    let mut fine = positive(model.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= admissible(model.poisson_ratio, &path, faults);
    let of_ghosts = [("axis", model.axis.is_some()), ("measure", model.measure != Measure::Section)];
    let of_ghosts = of_ghosts.into_iter().find(|(_, is_given)| *is_given).map(|(key, _)| key);
    if let (Some(StateEdges::Border), Some(key)) = (model.edges, of_ghosts) {
        faults
            .error(
                path.key(key),
                "a body that is completed along its border ends on its axis, and counts by areas",
            )
            .hint(format!("leave `{key}` out, or use the edges `ghosts`"));
        fine = false;
    }
    let edges = model.edges.unwrap_or_default();
    let is_full =
        matches!(edges, StateEdges::Border | StateEdges::Ghosts) && model.measure == Measure::Section;
    let axis = if is_full { Axis::Table } else { Axis::Images };
    let locks = asked.most_poisson_ratio(model.poisson_ratio) > LOCKS;
    let blocks = if locks { Dilatation::Blocks } else { Dilatation::Points };
    fine.then(|| StateParameters {
        youngs_modulus: model.youngs_modulus,
        poisson_ratio: model.poisson_ratio,
        geometry: Geometry::Axisymmetric,
        horizon_ratio: 0.0,
        influence: *model.influence.get_or_insert(Influence::Linear),
        edges,
        measure: model.measure,
        axis: model.axis.unwrap_or(axis),
        dilatation: *model.dilatation.get_or_insert(blocks),
    })
}
