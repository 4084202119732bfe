//! Probes and checks on results.

use super::comparison::{Compared, Worst};
use super::fields::StateResult;
use crate::case::FieldName;
use crate::reference::{Field, Solution};
use crate::scene::{Expectation, ExpectationKind, Scene};
use serde::Serialize;

/// A probed value.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ProbeResult {
    /// Name of the probe.
    pub name: String,
    /// Name of the state.
    pub state: String,
    /// Position of the point that answered, on its line.
    pub x: f64,
    /// Joint, or member and position, on a frame.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub place: Option<String>,
    /// Field.
    pub field: FieldName,
    /// Value.
    pub value: f64,
}

/// The outcome of one check.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CheckResult {
    /// Name.
    pub name: String,
    /// `closed_form`, `value`, `limit` or `baseline`.
    pub kind: &'static str,
    /// What was expected: a number, or the largest magnitude of a reference.
    pub expected: f64,
    /// What was found, at the worst point where several are compared.
    pub found: f64,
    /// Error, relative to `expected` unless that is zero; for a limit the magnitude over the limit.
    pub error: f64,
    /// Largest error that passes.
    pub tolerance: f64,
    /// Whether it passes.
    pub passed: bool,
    /// Where the expectation comes from.
    pub source: String,
}

/// Values of all probes on one state.
pub(crate) fn probes(scene: &Scene, result: &StateResult) -> Vec<ProbeResult> {
    let probe = |p: &crate::scene::ProbePoint| {
        let value = result.value(p.field, p.local.0, p.local.1)?;
        let (name, state, place) = (p.name.clone(), result.name.clone(), p.place.clone());
        Some(ProbeResult { name, state, x: p.x, place, field: p.field, value })
    };
    scene.probes.iter().filter_map(probe).collect()
}

/// Outcomes of the checks that are made on this state.
pub(crate) fn checks(scene: &Scene, result: &StateResult) -> Vec<CheckResult> {
    let mine: Vec<&Expectation> = scene.expectations.iter().filter(|e| e.state == result.index).collect();
    let compared = Compared::new(scene, &mine, result);
    mine.into_iter().map(|e| check(scene, e, result, &compared)).collect()
}

fn check(scene: &Scene, expectation: &Expectation, result: &StateResult, compared: &Compared) -> CheckResult {
    let name = expectation.name.clone();
    let probed = |probe: usize| {
        let p = &scene.probes[probe];
        result.value(p.field, p.local.0, p.local.1).unwrap_or(f64::NAN)
    };
    match &expectation.kind {
        ExpectationKind::ClosedForm { reference, solution, field, tolerance } => {
            let displacement = compared.worst(reference, *field);
            let mut worst = displacement.unwrap_or_else(|| closed_form(scene, solution, *field, result));
            if worst.scale == 0.0 {
                worst.scale = fallback_scale(scene, result, *field);
            }
            verdict(name, "closed_form", worst, *tolerance, "closed form".into())
        }
        ExpectationKind::Value { probe, expected, tolerance, source } => {
            let found = probed(*probe);
            verdict(name, "value", Worst::of(&[*expected], &[found]), *tolerance, source.clone())
        }
        ExpectationKind::Limit { probe, at_most, why } => {
            // The larger side of a jump: a bound that one side exceeds is not kept.
            let p = &scene.probes[*probe];
            let left = result.left_values(p.field, p.local.0).map(|values| values[p.local.1]);
            let right = probed(*probe);
            let found = left.filter(|left| left.abs() > right.abs()).unwrap_or(right);
            let error = found.abs() / at_most;
            CheckResult {
                name,
                kind: "limit",
                expected: *at_most,
                found,
                error,
                tolerance: 1.0,
                passed: error <= 1.0,
                source: why.clone(),
            }
        }
        ExpectationKind::Baseline { field, stored, tolerance } => {
            let worst = baseline(stored, *field, result);
            verdict(name, "baseline", worst, *tolerance, "stored baseline".into())
        }
    }
}

fn verdict(name: String, kind: &'static str, worst: Worst, tolerance: f64, source: String) -> CheckResult {
    let error = if worst.scale > 0.0 { worst.difference / worst.scale } else { worst.difference };
    // A missing value is not a number, no comparison at all a negative one: neither must pass.
    let passed = (0.0..=tolerance).contains(&error);
    CheckResult { name, kind, expected: worst.expected, found: worst.found, error, tolerance, passed, source }
}

/// Energy or section forces against a closed form.
fn closed_form(scene: &Scene, solution: &Solution, field: Field, result: &StateResult) -> Worst {
    if field == Field::Energy {
        let expected = solution.energy.unwrap_or(f64::NAN);
        return Worst::of(&[expected], &[result.certificate.energy]);
    }
    let from = scene.beam.chains()[0].line().from;
    let at = |x: f64| solution.value(field, x - from).unwrap_or(f64::NAN);
    let line = &result.lines[0];
    // Section forces may jump at a point; a reference answers for its left.
    let forces = line.recovered.as_ref().map(|r| &r.forces);
    let cells = forces.map_or(&[][..], |f| if field == Field::M { &f.moment } else { &f.shear });
    let expected: Vec<f64> = line.x[1..].iter().map(|&x| at(x)).collect();
    let found: Vec<f64> = cells.iter().map(|cell| cell[1]).collect();
    Worst::of(&expected, &found)
}

/// Scale for a field whose reference vanishes: what the other fields make of it over the length of the beam.
fn fallback_scale(scene: &Scene, result: &StateResult, field: Field) -> f64 {
    let length = scene.beam.chains()[0].line().length;
    let largest =
        |field: FieldName| result.extremes(field).map_or(0.0, |[low, high]| low.0.abs().max(high.0.abs()));
    match field {
        Field::W => largest(FieldName::Phi) * length,
        Field::Phi => largest(FieldName::W) / length,
        Field::M => largest(FieldName::V) * length,
        Field::V => largest(FieldName::M) / length,
        Field::Energy => 0.0,
    }
}

fn baseline(stored: &[(f64, f64)], field: FieldName, result: &StateResult) -> Worst {
    let values = (0..result.lines.len()).map(|line| result.values(field, line).unwrap_or_default());
    let found = values.collect::<Vec<_>>().concat();
    let expected: Vec<f64> = stored.iter().map(|s| s.1).collect();
    if found.len() != expected.len() {
        let (expected, found) = (expected.len() as f64, found.len() as f64);
        return Worst { expected, found, difference: f64::NAN, scale: 1.0 };
    }
    Worst::of(&expected, &found)
}
