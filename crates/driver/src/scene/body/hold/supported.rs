//! Supports of a body in the plane with their equations and springs.

use super::conditions::Conditions;
use super::rigid::RigidPoints;
use super::supports::HeldSupport;
use crate::diagnostic::{JsonPath, root};
use crate::scene::body::site::model_inputs::ModelInputs;
use peristat_assembly::model::BodyModel;
use std::ops::Range;

/// A support, or what is prescribed of a rigid region.
#[derive(Clone, Debug)]
pub struct BodySupport {
    /// What the user calls the place.
    pub name: String,
    /// Where it stands in the case.
    pub path: JsonPath,
    /// Its equations among those of the scene with how much of the force along x, the force along y and the moment each
    /// multiplier is.
    pub equations: Vec<(Range<usize>, [f64; 3])>,
    /// Its springs among those of the conditions.
    pub springs: Range<usize>,
}

/// Conditions on points of the model, and which of their equations and springs belong to which support.
pub(crate) fn conditions(
    held: &[HeldSupport],
    rigid: Vec<RigidPoints>,
    inputs: &ModelInputs,
    model: &dyn BodyModel,
) -> (Conditions, Vec<BodySupport>) {
    let mut conditions =
        Conditions { turning: model.component("phi").map(|(_, phi)| phi.scale), ..Conditions::default() };
    let (mut supports, mut next) = (Vec::new(), 0);
    for h in held {
        let (holds, springs) = (h.holds(inputs, model), h.spring_list(inputs, model));
        let mut equations = Vec::new();
        for hold in &holds {
            let [x, y, turn] = hold.direction;
            let shares = [x, y, turn * model.scale(2)];
            equations.push((next..next + hold.points.len(), shares));
            next += hold.points.len();
        }
        let first = conditions.springs.len();
        conditions.holds.extend(holds);
        conditions.springs.extend(springs);
        let springs = first..conditions.springs.len();
        supports.push(BodySupport { name: h.name.clone(), path: h.path.clone(), equations, springs });
    }
    let end = conditions.springs.len();
    for (k, region) in rigid.into_iter().enumerate() {
        let directions = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let mut equations = Vec::new();
        for (_, direction) in region.prescribed.iter().zip(directions).filter(|p| p.0.is_some()) {
            equations.push((next..next + 1, direction));
            next += 1;
        }
        if !equations.is_empty() {
            let path = root("rigid").index(k);
            let name = format!("the rigid region {}", k + 1);
            supports.push(BodySupport { name, path, equations, springs: end..end });
        }
        let points = region.points.iter().map(|&p| inputs.number(model, p)).collect();
        conditions.rigid.push(RigidPoints { points, ..region });
    }
    (conditions, supports)
}
