//! Pressures on whole cylinders.

use super::context::LoadContext;
use super::stress_field::StressField;
use super::sums::BodyLoads;
use crate::case::Pressure;
use crate::diagnostic::{Faults, JsonPath};
use crate::model::hints;
use peristat_assembly::body::PointBody;

/// Adds a pressure.
pub(crate) fn resolve(
    load: &Pressure,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    if context.material.cylinder_radius().is_none() {
        return refuse(context, path, faults);
    }
    let PointBody::Lattice(lattice) = context.ground.body else { return };
    let mirrors = &context.symmetry.mirrors;
    let Some(pressure) = context.material.pressure(load, lattice, mirrors, path, faults) else { return };
    let points = 0..context.ground.body.points() as u32;
    let arc = |p: u32| context.ground.body.position(p as usize)[1];
    let k = pressure.wave_number;
    let Some(hoop) = pressure.hoop_stress else {
        let force = |p: u32| {
            let area = context.ground.body.measure(p as usize);
            (p, [0.0, 0.0, pressure.value * area * (k * arc(p)).cos()])
        };
        to.forces.extend(points.map(force));
        return;
    };
    to.stresses.push(StressField::hoop(hoop, k));
    // What a stress that varies does along the circumference is taken back: its divergence.
    let force = |p: u32| {
        let divergence = -hoop * k * (k * arc(p)).sin();
        (p, [0.0, context.volume(p) * divergence, 0.0])
    };
    if k > 0.0 {
        to.forces.extend(points.map(force));
    }
}

/// The fault of a pressure on a body that is no shell.
fn refuse(context: &LoadContext, path: &JsonPath, faults: &mut Faults) {
    let hint = match context.ground.body.axes() {
        2 => {
            "in the plane a pressure acts on an edge or a hole: { \"traction\": { \"edge\": …, \"pressure\": … } }"
        }
        _ => "on a solid a pressure acts on a face: { \"traction\": { \"face\": …, \"pressure\": … } }",
    };
    faults
        .error(path.clone(), format!("a `pressure` on the body is for the model `{}`", hints::SHELLS))
        .hint(hint);
}
