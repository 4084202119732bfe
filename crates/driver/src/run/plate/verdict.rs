//! Probes and checks on the result of a plate.

use super::{PlateResult, fields};
use crate::case::FieldName;
use crate::run::reducer::{Reduced, Reducer};
use crate::run::verdict::{self, CheckResult, ProbeResult};
use crate::scene::body::BodyComparison;
use crate::scene::plate::{OnLine, PlateProbe, PlateQuantity};
use crate::scene::{Expectation, ExpectationKind, PlateScene};
use peristat_assembly::sum::Sum;

/// Whether a check of all points needs moments; those of probes are known from the probes.
pub(super) fn is_recovered(expectation: &Expectation<BodyComparison>) -> bool {
    matches!(&expectation.kind, ExpectationKind::Points(points) if points.field != FieldName::Damage && points.field.is_recovered())
}

/// Values of all probes on one state.
pub(crate) fn probes(scene: &PlateScene, result: &PlateResult) -> Vec<ProbeResult> {
    let probe = |p: &PlateProbe| {
        let found = read(scene, result, p)?;
        let position = p.position.or_else(|| found.place.map(|point| scene.plate.nodes().place(point)));
        Some(ProbeResult {
            name: p.name.clone(),
            state: result.record.name.clone(),
            x: position.map(|at| at[0]),
            y: position.map(|at| at[1]),
            z: None,
            place: position.is_none().then(|| p.place.clone()),
            field: p.field.name().into(),
            of: p.reduction(),
            value: found.value,
            unit: verdict::unit(p.field, p.reduction(), power(p), scene.units),
            extent: found.extent,
            misfit: None,
        })
    };
    scene.probes.iter().filter_map(probe).collect()
}

/// What integrals are over: lengths to this power.
fn power(probe: &PlateProbe) -> i32 {
    if matches!(probe.quantity, PlateQuantity::OnLine(_)) { 1 } else { 2 }
}

/// What a probe finds along lines that are held; means and integrals are over lengths.
fn along_lines(
    scene: &PlateScene,
    result: &PlateResult,
    field: FieldName,
    found: &OnLine,
) -> Option<Reduced<usize>> {
    let values = |line: usize| match field {
        FieldName::ReactionMomentPerLength => &result.along_lines.lines[line].moment,
        _ => &result.along_lines.lines[line].force,
    };
    let plain = |value: f64| Some(Reduced { value, place: None, extent: None });
    match found {
        OnLine::At(line, shares) => plain(shares.iter().map(|&(k, share)| share * values(*line)[k]).sum()),
        OnLine::Corners(points) => {
            plain(points.iter().filter_map(|point| result.along_lines.corners.get(point)).sum())
        }
        OnLine::Reduced { of, lines } => {
            let (h, mut reducer) = (scene.plate.nodes().spacing(), Reducer::new(*of));
            for &line in lines {
                let held = &scene.held_lines[line];
                for (k, (&point, &value)) in held.points.iter().zip(values(line)).enumerate() {
                    reducer.take(value, point as usize, |_| h * held.weight(k));
                }
            }
            reducer.found()
        }
    }
}

/// What a probe finds; means and integrals are over areas.
fn read(scene: &PlateScene, result: &PlateResult, probe: &PlateProbe) -> Option<Reduced<usize>> {
    let plain = |value: f64| Reduced { value, place: None, extent: None };
    match &probe.quantity {
        PlateQuantity::Field(weights) => result.value(probe.field, weights).map(plain),
        PlateQuantity::Reduced { of, points } => {
            let (values, mut reducer) = (result.values(probe.field)?, Reducer::new(*of));
            let mut take = |p: usize| reducer.take(values[p], p, |p| scene.plate.nodes().area(p));
            match points {
                Some(points) => points.iter().for_each(|&p| take(p as usize)),
                None => (0..values.len()).for_each(&mut take),
            }
            reducer.found()
        }
        PlateQuantity::OnLine(found) => along_lines(scene, result, probe.field, found),
        PlateQuantity::Reaction { .. } => {
            mechanical(scene, probe, &result.record.u, &result.multipliers).map(plain)
        }
    }
}

/// What a probe reads that follows from unknowns and from the forces that hold the equations; none of another one.
pub(super) fn mechanical(
    scene: &PlateScene,
    probe: &PlateProbe,
    u: &[f64],
    multipliers: &[f64],
) -> Option<f64> {
    let n = scene.plate.nodes().points();
    let mut sum = Sum::default();
    match &probe.quantity {
        PlateQuantity::Field(weights) => {
            let plane = fields::plane(probe.field)? * n;
            weights.iter().for_each(|&(p, w)| sum.add(w * u[plane + p as usize]));
        }
        PlateQuantity::Reaction { component, equations, springs } => {
            equations.iter().for_each(|&(k, share)| sum.add(share * multipliers[k]));
            for &(k, share) in springs {
                let forces = scene.springs[k].forces(n, u).into_iter();
                let own = forces.filter(|(unknown, _)| unknown / n == *component);
                own.for_each(|(_, force)| sum.add(-share * force));
            }
        }
        _ => return None,
    }
    Some(sum.total())
}

/// Outcomes of the checks that are made on this state, with what its probes found.
pub(crate) fn checks(scene: &PlateScene, result: &PlateResult, probes: &[ProbeResult]) -> Vec<CheckResult> {
    // Which equilibrium of a plate that breaks is the last is known only after it.
    let breaks = scene.fracture.is_some();
    let mine = scene.expectations.iter().filter(|e| breaks || e.state == result.record.index);
    let fact = |k: usize| result.record.facts.as_ref()?.value(scene.facts().get(k - scene.probes.len())?);
    let probed = |k: usize| {
        let Some(probe) = scene.probes.get(k) else { return fact(k).unwrap_or(f64::NAN) };
        probes.iter().find(|found| found.name == probe.name).map_or(f64::NAN, |found| found.value)
    };
    let check = |expectation: &Expectation<BodyComparison>| {
        let points = |points: &BodyComparison| {
            verdict::compared(&expectation.name, points, &result.values(points.field).unwrap_or_default())
        };
        verdict::check(expectation, probed, |probe| [probed(probe); 2], points)
    };
    mine.map(check).collect()
}
