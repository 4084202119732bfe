//! Probes and checks on the result of a beam.

use super::between::Between;
use super::comparison::Compared;
use super::{BeamResult, reduced};
use crate::case::FRACTURE_FACTS;
use crate::case::FieldName;
use crate::reference::{Field, Solution};
use crate::run::reducer::Reduced;
use crate::run::verdict::{self, CheckResult, ProbeResult, Worst};
use crate::scene::Expectation;
use crate::scene::beam::{BeamComparison, BeamProbe, BeamScene, ProbeSite};
use crate::units::number;

/// Values of all probes on one state.
pub(crate) fn probes(scene: &BeamScene, result: &BeamResult) -> Vec<ProbeResult> {
    let probe = |p: &BeamProbe| {
        let Reading { value, x, place, extent } = read(scene, result, p)?;
        Some(ProbeResult {
            name: p.name.clone(),
            state: result.record.name.clone(),
            x,
            y: None,
            z: None,
            place,
            field: p.field.name().into(),
            of: p.reduction(),
            value,
            unit: verdict::unit(p.field, p.reduction(), 1, scene.units),
            extent,
            misfit: None,
        })
    };
    scene.probes.iter().filter_map(probe).collect()
}

/// What a probe finds.
struct Reading {
    value: f64,
    /// Position on its line, unless it is that of lines as a whole.
    x: Option<f64>,
    /// Place in words, on a frame or of lines as a whole.
    place: Option<String>,
    /// Length that a mean or an integral is taken over.
    extent: Option<f64>,
}

fn read(scene: &BeamScene, result: &BeamResult, probe: &BeamProbe) -> Option<Reading> {
    match &probe.site {
        ProbeSite::Point(p) => {
            let value = result.value(probe.field, p.local.0, p.local.1)?;
            Some(Reading { value, x: Some(p.x), place: p.place.clone(), extent: None })
        }
        ProbeSite::Between(at) => {
            let value =
                Between::new(scene, result, at.line).cell(at.before).value(probe.field, at.x, true)?;
            Some(Reading { value, x: Some(at.x), place: at.place.clone(), extent: None })
        }
        ProbeSite::Lines { of, lines, place } => {
            let found = reduced::read(scene, result, (probe.field, *of), lines)?;
            let member = |(line, x): (usize, f64)| {
                let frame = scene.frame.as_ref()?;
                Some(format!("member `{}` at x = {}", frame.members[line].name, number(x)))
            };
            let place = match found.place {
                Some(at) => member(at),
                None => Some(place.clone()),
            };
            let Reduced { value, extent, .. } = found;
            Some(Reading { value, x: found.place.map(|at| at.1), place, extent })
        }
    }
}

/// Outcomes of the checks that are made on this state, with what its probes found.
pub(crate) fn checks(scene: &BeamScene, result: &BeamResult, probes: &[ProbeResult]) -> Vec<CheckResult> {
    // Which equilibrium of a beam that breaks is the last is known only after it.
    let breaks = scene.fracture.is_some();
    let mine: Vec<&Expectation<BeamComparison>> =
        scene.expectations.iter().filter(|e| breaks || e.state == result.record.index).collect();
    let compared = Compared::new(scene, &mine, result);
    let fact = |name: &&str| result.record.facts.as_ref()?.value(name);
    let probed = |probe: usize| {
        let found = match scene.probes.get(probe) {
            Some(p) => probes.iter().find(|found| found.name == p.name).map(|found| found.value),
            None => FRACTURE_FACTS.get(probe - scene.probes.len()).and_then(fact),
        };
        found.unwrap_or(f64::NAN)
    };
    let sides = |probe: usize| {
        let right = probed(probe);
        let Some(p) = scene.probes.get(probe) else { return [right; 2] };
        let Some([line, point]) = p.point().map(|p| [p.local.0, p.local.1]) else { return [right; 2] };
        let left = result.left_values(p.field, line).map(|values| values[point]);
        [right, left.unwrap_or(right)]
    };
    let check = |expectation: &Expectation<BeamComparison>| {
        let points = |points: &BeamComparison| compare(&expectation.name, points, scene, result, &compared);
        verdict::check(expectation, probed, sides, points)
    };
    mine.into_iter().map(check).collect()
}

/// All points against a closed form or stored values.
fn compare(
    name: &str,
    comparison: &BeamComparison,
    scene: &BeamScene,
    result: &BeamResult,
    compared: &Compared,
) -> CheckResult {
    match comparison {
        BeamComparison::ClosedForm { reference, solution, field, tolerance } => {
            let displacement = compared.worst(reference, *field);
            let mut worst = displacement.unwrap_or_else(|| closed_form(scene, solution, *field, result));
            if worst.scale == 0.0 {
                worst.scale = fallback_scale(scene, result, *field);
            }
            CheckResult::of(name, "closed_form", worst, *tolerance, "closed form")
        }
        BeamComparison::Baseline { field, stored, tolerance } => {
            let worst = baseline(stored, *field, result);
            CheckResult::of(name, "baseline", worst, *tolerance, "stored baseline")
        }
    }
}

/// Energy or section forces against a closed form.
fn closed_form(scene: &BeamScene, solution: &Solution, field: Field, result: &BeamResult) -> Worst {
    if field == Field::Energy {
        let expected = solution.energy.unwrap_or(f64::NAN);
        return Worst::of(&[expected], &[result.record.certificate.energy]);
    }
    let from = scene.beam.chains()[0].line().from;
    let at = |x: f64| solution.value(field, x - from).unwrap_or(f64::NAN);
    let line = &result.lines[0];
    // Section forces may jump at a point; a reference answers for its left.
    let cells =
        line.forces.as_ref().map_or(&[][..], |f| if field == Field::M { &f.moment } else { &f.shear });
    let expected: Vec<f64> = line.x[1..].iter().map(|&x| at(x)).collect();
    let found: Vec<f64> = cells.iter().map(|cell| cell[1]).collect();
    Worst::of(&expected, &found)
}

/// Scale for a field whose reference vanishes: what the other fields make of it over the length of the beam.
fn fallback_scale(scene: &BeamScene, result: &BeamResult, field: Field) -> f64 {
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

fn baseline(stored: &[(f64, f64)], field: FieldName, result: &BeamResult) -> Worst {
    let values = (0..result.lines.len()).map(|line| result.values(field, line).unwrap_or_default());
    let found = values.collect::<Vec<_>>().concat();
    let expected: Vec<f64> = stored.iter().map(|s| s.1).collect();
    if found.len() != expected.len() {
        let (expected, found) = (expected.len() as f64, found.len() as f64);
        return Worst { expected, found, difference: f64::NAN, scale: 1.0, ..Worst::NONE };
    }
    Worst::of(&expected, &found)
}
