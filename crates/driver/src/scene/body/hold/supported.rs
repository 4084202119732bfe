//! Supports of a body with their equations and springs.

use super::conditions::Conditions;
use super::corners::HeldCorners;
use super::rigid::{MOTIONS, RigidPoints};
use super::supports::HeldSupport;
use crate::diagnostic::{Faults, JsonPath, root};
use crate::scene::body::site::model_inputs::ModelInputs;
use peristat_assembly::model::BodyModel;
use std::ops::Range;
use std::str::FromStr;

/// A support, or what is prescribed of a rigid region.
#[derive(Clone, Debug)]
pub struct BodySupport {
    /// What the user calls the place.
    pub name: String,
    /// Where it stands in the case.
    pub path: JsonPath,
    /// Its equations among those of the scene with how much of the forces along x, y and z and of the moments about them each
    /// multiplier is.
    pub equations: Vec<(Range<usize>, [f64; MOTIONS])>,
    /// Its springs among those of the conditions.
    pub springs: Range<usize>,
}

/// What helps where points are held twice, at different values.
pub(crate) const CONTRADICTION: &str = "prescribe each motion once: edges share the points of their corner, and those of a rigid region move together";

/// Conditions on points of the model, and which of their equations and springs belong to which support.
pub(crate) fn conditions(
    held: &[HeldSupport],
    rigid: Vec<RigidPoints>,
    inputs: &ModelInputs,
    model: &dyn BodyModel,
    faults: &mut Faults,
) -> (Conditions, Vec<BodySupport>) {
    let mut conditions = Conditions {
        turning: model.component("phi").map(|(_, phi)| phi.scale),
        axes: inputs.body.axes(),
        ..Conditions::default()
    };
    let (mut supports, mut next, mut corners) = (Vec::new(), 0, HeldCorners::default());
    for h in held {
        let (mut holds, springs) = (h.holds(inputs, model, faults), h.spring_list(inputs, model));
        for (hold, (_, given, _)) in holds.iter_mut().zip(&h.motions) {
            let mut others = corners.leave(hold, given, model);
            others.sort_unstable();
            others.dedup();
            if let Some(other) = others.first() {
                let message = format!("`{}` contradicts `{other}`", hold.origin);
                faults
                    .error(JsonPath::from_str(&hold.origin).unwrap_or_default(), message)
                    .hint(CONTRADICTION);
            }
        }
        let mut equations = Vec::new();
        for hold in &holds {
            let mut shares = [0.0; MOTIONS];
            for (share, component) in hold.direction.iter().zip(model.components()) {
                let motion = component.axis + if component.is_rotation { 3 } else { 0 };
                shares[motion] = share * component.scale;
            }
            equations.push((next..next + hold.points.len(), shares));
            next += hold.points.len();
        }
        let first = conditions.springs.len();
        conditions.holds.extend(holds);
        conditions.springs.extend(springs);
        let springs = first..conditions.springs.len();
        // Parts of one support follow each other.
        match supports.last_mut().filter(|last: &&mut BodySupport| last.path == h.path) {
            Some(last) => {
                last.equations.extend(equations);
                last.springs.end = springs.end;
            }
            None => {
                supports.push(BodySupport { name: h.name.clone(), path: h.path.clone(), equations, springs })
            }
        }
    }
    let end = conditions.springs.len();
    for (k, region) in rigid.into_iter().enumerate() {
        let mut equations = Vec::new();
        for motion in (0..MOTIONS).filter(|&motion| region.prescribed[motion].is_some()) {
            let mut direction = [0.0; MOTIONS];
            direction[motion] = 1.0;
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
