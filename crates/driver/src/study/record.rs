//! What a task finds.

use super::order::ROUNDING;
use super::plan::Task;
use crate::case::Reduction;
use crate::input::Folder;
use crate::run::beam::ExactState;
use crate::run::{Certificate, ProbeResult, RunOptions, taking};
use crate::summary::{Extremes, ModelSummary, StateSummary, Summary};
use crate::{Error, Loaded};
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::time::Instant;

/// Errors of the solution of a grid above this part are no rounding.
const MOST_ROUNDING: f64 = 1e-8;

/// Fields of displacements, by name.
const DISPLACEMENTS: [&str; 4] = ["w", "u", "ux", "uy"];

/// A number with its name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Name.
    pub name: String,
    /// Unit; empty if it has none, as relative errors.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub unit: String,
    /// Value.
    pub value: f64,
}

/// The record of a solved task, as it is stored.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Hash of the task.
    pub key: String,
    /// Overrides of the case file.
    pub overrides: Vec<String>,
    /// Spacing, of the first line of a beam.
    pub spacing: f64,
    /// Horizon, of the first line of a beam.
    pub horizon: f64,
    /// Points of the body.
    pub points: usize,
    /// Independent unknowns.
    pub unknowns: usize,
    /// Whether every state converged.
    pub converged: bool,
    /// Whether the body breaks or softens, so that its values jump.
    pub traced: bool,
    /// Wall time from reading the case to its last check, s.
    pub seconds: f64,
    /// Probes and stored energies.
    pub values: Vec<Measured>,
    /// Largest and mean square errors of checks that compare all points, relative.
    pub errors: Vec<Measured>,
    /// Warnings.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub warnings: Vec<String>,
}

impl Record {
    /// Solves a task; `folder` is where files that the case names are.
    ///
    /// # Errors
    /// Faults of the case, or why it has no result.
    pub fn solve(task: &Task, folder: &Folder, max_memory: Option<u64>) -> Result<Self, Error> {
        let begin = Instant::now();
        let loaded = Loaded::from_source(task.source.clone(), folder.clone(), max_memory)?;
        // A study measures errors itself.
        let options = RunOptions { recover: false, max_memory, compare: false };
        let summary = loaded.run(&options, None, &mut taking(|_| Ok(())))?;
        let seconds = begin.elapsed().as_secs_f64();
        let converged = summary.states.iter().all(|state| state.certificate.converged);
        Ok(Self {
            key: task.key.clone(),
            overrides: task.overrides.clone(),
            spacing: summary.model.spacing(),
            horizon: summary.model.horizon(),
            points: summary.sizes.points,
            unknowns: summary.sizes.unknowns,
            converged,
            traced: loaded.scene.case().is_traced(),
            seconds,
            values: distinct(values(&summary)),
            errors: distinct(errors(&summary)),
            warnings: summary.warnings,
        })
    }
}

/// A value of a run that a finer grid would improve.
pub(super) struct Quantity {
    /// Its name, with that of its state where there are several.
    pub(super) name: String,
    /// Field, or what it is else.
    pub(super) field: String,
    /// Unit; empty if it has none.
    pub(super) unit: String,
    /// Number of its state.
    pub(super) state: usize,
    /// Value.
    pub(super) value: f64,
    /// Largest magnitude of the field in its state, as far as it is known.
    pub(super) scale: f64,
    /// What the solution of its grid may be off by: grids that differ by less agree.
    pub(super) rounding: f64,
}

/// What a field may be off by in the solution of its grid, over its largest value.
fn rounding(field: &str, certificate: &Certificate) -> f64 {
    let known = match DISPLACEMENTS.contains(&field) {
        true => certificate.error,
        false => certificate.strain_error,
    };
    known.clamp(ROUNDING, MOST_ROUNDING)
}

/// The name of a quantity of a state.
fn named(name: &str, state: &StateSummary, summary: &Summary) -> String {
    if summary.states.len() > 1 { format!("{name} [{}]", state.name) } else { name.into() }
}

/// What the value of a probe is over one of its field: of an integral the volume or the length.
fn weight(probe: &ProbeResult) -> f64 {
    if probe.of == Some(Reduction::Integral) { probe.extent.unwrap_or(1.0) } else { 1.0 }
}

/// Probes, or of beams without any the largest displacements, and stored energies of all states.
pub(super) fn quantities(summary: &Summary) -> Vec<Quantity> {
    let new = |(name, unit): (&str, &str), state: usize, field: &str, value: f64, scale: f64| Quantity {
        name: named(name, &summary.states[state], summary),
        unit: unit.into(),
        field: field.into(),
        state,
        value,
        scale,
        rounding: scale * rounding(field, &summary.states[state].certificate),
    };
    let largest = |e: &Extremes| e.largest.value.abs().max(e.smallest.value.abs());
    let mut of_state: HashMap<&str, Vec<&ProbeResult>> = HashMap::new();
    summary.probes.iter().for_each(|probe| of_state.entry(&probe.state).or_default().push(probe));
    let (mut probes, mut others, mut energies) = (Vec::new(), Vec::new(), Vec::new());
    // Points of bodies in the plane are in the middle of cells: where the outermost one is depends on the spacing.
    let has_largest = summary.probes.is_empty() && matches!(summary.model, ModelSummary::Beam(_));
    for (k, state) in summary.states.iter().enumerate() {
        let own = of_state.get(state.name.as_str()).map_or(&[][..], Vec::as_slice);
        let mut scales: HashMap<&str, f64> = HashMap::new();
        for probe in own {
            let scale = scales
                .entry(&probe.field)
                .or_insert_with(|| state.extremes.get(&probe.field).map_or(0.0, largest));
            *scale = scale.max(probe.value.abs() / weight(probe));
        }
        for probe in own {
            let scale = scales[&*probe.field] * weight(probe);
            probes.push(new((&probe.name, &probe.unit), k, &probe.field, probe.value, scale));
        }
        for (field, extremes) in &state.extremes {
            if has_largest && DISPLACEMENTS.contains(&field.as_ref()) {
                let value = largest(extremes);
                others.push(new((&format!("largest {field}"), &extremes.unit), k, field, value, value));
            }
        }
        let energy = state.certificate.energy;
        energies.push(new(("energy", summary.units.moment()), k, "energy", energy, energy.abs()));
    }
    let all = probes.into_iter().chain(others).chain(energies);
    all.filter(|q| q.value.is_finite()).collect()
}

/// The same of the exact beam that a beam was compared with, by name.
pub(super) fn of_exact(summary: &Summary) -> Option<HashMap<String, f64>> {
    let states = summary.states.iter().zip(summary.exact.as_ref()?);
    let of_state = |(state, exact): (&StateSummary, &ExactState)| {
        let probes = exact.probes.iter().map(|probe| (probe.name.clone(), probe.value));
        let largest =
            exact.largest.iter().map(|(field, value)| (format!("largest {}", field.name()), *value));
        // A probe may have the name of the energy, and comes before it.
        let all = [("energy".into(), exact.energy)].into_iter().chain(largest).chain(probes);
        all.map(|(name, value)| (named(&name, state, summary), value)).collect::<Vec<_>>()
    };
    Some(states.flat_map(of_state).collect())
}

/// The same as names and values.
fn values(summary: &Summary) -> Vec<Measured> {
    quantities(summary).into_iter().map(|q| Measured { name: q.name, unit: q.unit, value: q.value }).collect()
}

/// The same with a number behind names that others have, too.
fn distinct(mut all: Vec<Measured>) -> Vec<Measured> {
    let mut counts: HashMap<String, usize> = HashMap::new();
    for measured in &mut all {
        let count = counts.entry(measured.name.clone()).or_default();
        *count += 1;
        if *count > 1 {
            measured.name = format!("{} {count}", measured.name);
        }
    }
    all
}

/// Errors of the checks that compare all points with an exact solution.
fn errors(summary: &Summary) -> Vec<Measured> {
    let exact = summary.checks.iter().filter(|c| matches!(c.kind, "closed_form" | "formula"));
    let both = exact.flat_map(|check| {
        let name = |norm: &str| format!("{} {norm}", check.name);
        let of = |norm: &str, value: f64| Measured { name: name(norm), unit: String::new(), value };
        let max = of(if check.l2_error.is_some() { "max" } else { "error" }, check.error);
        [Some(max), check.l2_error.map(|l2| of("l2", l2))]
    });
    both.flatten().filter(|m| m.value.is_finite()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_names_are_numbered() {
        let all = ["ux formula max", "energy", "ux formula max", "ux formula max"];
        let all = all.map(|name| Measured { name: name.into(), unit: String::new(), value: 0.0 });
        let names: Vec<String> = distinct(all.into()).into_iter().map(|m| m.name).collect();
        assert_eq!(names, ["ux formula max", "energy", "ux formula max 2", "ux formula max 3"]);
    }
}
