//! Probes and checks on the result of a body.

use super::{BodyResult, hole_fits, probed, reduced};
use crate::case::{FieldName, Origin, TipQuantity};
use crate::run::verdict::{self, CheckResult, ProbeResult};
use crate::scene::body::{BodyComparison, BodyProbe, BodyScene, Quantity};
use crate::scene::{Expectation, ExpectationKind};
use peristat_assembly::sum::Sum;

/// Whether a check of all points needs stresses; those of probes are known from the probes.
pub(super) fn is_recovered(expectation: &Expectation<BodyComparison>) -> bool {
    matches!(&expectation.kind, ExpectationKind::Points(points) if points.field.is_recovered())
}

/// Values of all probes on one state.
pub(crate) fn probes(scene: &BodyScene, result: &BodyResult) -> Vec<ProbeResult> {
    let probe = |(k, p): (usize, &BodyProbe)| {
        let Reading { value, misfit, position, extent } = read(scene, result, (k, p))?;
        Some(ProbeResult {
            name: p.name.clone(),
            state: result.record.name.clone(),
            x: position.map(|at| at[0]),
            y: position.map(|at| at[1]),
            z: position.filter(|_| scene.body().axes() > 2).map(|at| at[2]),
            place: position.is_none().then(|| p.place.clone()),
            field: p.field_name().into(),
            of: p.reduction(),
            value,
            unit: match p.field() {
                Some(field) => verdict::unit(field, p.reduction(), 3, scene.units),
                None if matches!(
                    p.quantity,
                    Quantity::StressIntensity(_, TipQuantity::EnergyReleaseRate)
                ) =>
                {
                    scene.units.force_per_length().into()
                }
                None => scene.units.stress_intensity().into(),
            },
            extent,
            misfit,
        })
    };
    scene.probes.iter().enumerate().filter_map(probe).collect()
}

/// What a probe finds.
struct Reading {
    value: f64,
    /// On a hole, and in the local limit anywhere, the misfit of the fields around it.
    misfit: Option<f64>,
    /// Where it is, unless that is a region or a crack.
    position: Option<[f64; 3]>,
    /// Volume that a mean or an integral is taken over.
    extent: Option<f64>,
}

fn read(scene: &BodyScene, result: &BodyResult, (k, probe): (usize, &BodyProbe)) -> Option<Reading> {
    let reading = |value: f64, misfit| Reading { value, misfit, position: probe.position, extent: None };
    if let Some((value, misfit)) = hole_fits::read(scene, result, probe) {
        return Some(reading(value, Some(misfit)));
    }
    if let Some((value, misfit)) = probed::read(scene, result, (k, probe)) {
        return Some(reading(value, misfit));
    }
    let Quantity::Reduced { field, of, points } = &probe.quantity else {
        return Some(reading(value(scene, result, &probe.quantity)?, None));
    };
    let found = reduced::read(scene, result, *field, *of, points.as_deref())?;
    let position = found.place.map(|point| scene.body().position(point));
    Some(Reading { value: found.value, misfit: None, position, extent: found.extent })
}

/// What is found away from holes.
fn value(scene: &BodyScene, result: &BodyResult, quantity: &Quantity) -> Option<f64> {
    match quantity {
        Quantity::Field { field, weights } => result.value(scene, *field, weights),
        Quantity::Reaction { .. } | Quantity::Opening { .. } => {
            mechanical(scene, quantity, &result.record.u, &result.multipliers)
        }
        Quantity::Rotation { field, region } => rotation(scene, result, *field, *region),
        Quantity::StressIntensity(k, _) => result.intensities.get(*k).copied(),
        Quantity::Reduced { .. } => None,
    }
}

/// A reaction, a displacement or an opening, from the unknowns and the forces that hold the equations alone.
pub(super) fn mechanical(
    scene: &BodyScene,
    quantity: &Quantity,
    u: &[f64],
    multipliers: &[f64],
) -> Option<f64> {
    let n = scene.model.points();
    match quantity {
        Quantity::Reaction { equations, springs, .. } => {
            let mut sum = Sum::default();
            equations.iter().for_each(|&(k, share)| sum.add(share * multipliers[k]));
            let springs = springs.iter().map(|&k| &scene.conditions.springs[k]);
            springs.flat_map(|s| s.forces(n, u)).for_each(|(_, force)| sum.add(-force));
            Some(sum.total())
        }
        Quantity::Field { field, weights } if field.about().origin == Origin::Unknown => {
            let (k, component) = scene.model.component(field.name())?;
            Some(weights.iter().map(|&(p, w)| w * u[k * n + p as usize]).sum::<f64>() / component.scale)
        }
        Quantity::Opening { component, weights } => {
            Some(weights.iter().map(|&(p, w)| w * u[component * n + p as usize]).sum())
        }
        _ => None,
    }
}

/// Rotation of a rigid region, as its points tell it.
fn rotation(scene: &BodyScene, result: &BodyResult, field: FieldName, region: usize) -> Option<f64> {
    let axis = if let Origin::Turn(axis) = field.about().origin { axis } else { 2 };
    let rigid = scene.conditions.rigid.get(region)?;
    let (n, u) = (scene.model.points(), &result.record.u);
    Some(
        scene
            .conditions
            .rotation(rigid, axis, &|p| scene.model.position(p), &|of| u[of.component * n + of.point]),
    )
}

/// Outcomes of the checks that are made on this state, with what its probes found.
pub(crate) fn checks(scene: &BodyScene, result: &BodyResult, probes: &[ProbeResult]) -> Vec<CheckResult> {
    // Which equilibrium of a body that breaks is the last is known only after it.
    let breaks = scene.case.is_traced();
    let mine = scene.expectations.iter().filter(|e| breaks || e.state == result.record.index);
    let names = &scene.facts;
    let fact = |name: &String| result.record.facts.as_ref()?.value(name);
    let probed = |k: usize| {
        let found = match scene.probes.get(k) {
            Some(probe) => probes.iter().find(|found| found.name == probe.name).map(|found| found.value),
            None => names.get(k - scene.probes.len()).and_then(fact),
        };
        found.unwrap_or(f64::NAN)
    };
    let check = |expectation: &Expectation<BodyComparison>| {
        let points = |points: &BodyComparison| {
            verdict::compared(
                &expectation.name,
                points,
                &result.values(scene, points.field).unwrap_or_default(),
            )
        };
        verdict::check(expectation, probed, |probe| [probed(probe); 2], points)
    };
    mine.map(check).collect()
}
