//! What a task finds.

use super::plan::Task;
use crate::input::Folder;
use crate::run::{RunOptions, taking};
use crate::summary::{Extremes, ModelSummary, StateSummary, Summary};
use crate::{Error, Loaded};
use serde::{Deserialize, Serialize};
use std::time::Instant;

/// Fields of displacements, by name.
const DISPLACEMENTS: [&str; 4] = ["w", "u", "ux", "uy"];

/// A number with its name.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Measured {
    /// Name.
    pub name: String,
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
        let options = RunOptions { recover: false, max_memory };
        let summary = loaded.run(&options, None, &mut taking(|_| Ok(())))?;
        // A study measures errors itself.
        let seconds = begin.elapsed().as_secs_f64() - summary.timing_s.compare;
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
    /// Value.
    pub(super) value: f64,
    /// Largest magnitude of the field in its state, as far as it is known.
    pub(super) scale: f64,
}

/// Probes, or of beams without any the largest displacements, and stored energies of all states.
pub(super) fn quantities(summary: &Summary) -> Vec<Quantity> {
    let several = summary.states.len() > 1;
    let new = |name: &str, state: &StateSummary, field: &str, value: f64, scale: f64| {
        let name = if several { format!("{name} [{}]", state.name) } else { name.into() };
        Quantity { name, field: field.into(), value, scale }
    };
    let largest = |e: &Extremes| e.largest.value.abs().max(e.smallest.value.abs());
    let (mut probes, mut others, mut energies) = (Vec::new(), Vec::new(), Vec::new());
    // Points of bodies in the plane are in the middle of cells: where the outermost one is depends on the spacing.
    let has_largest = summary.probes.is_empty() && matches!(summary.model, ModelSummary::Beam(_));
    for state in &summary.states {
        let of_state = || summary.probes.iter().filter(|p| p.state == state.name);
        for probe in of_state() {
            let alike = of_state().filter(|p| p.field == probe.field).map(|p| p.value.abs());
            let scale = alike.fold(state.extremes.get(&probe.field).map_or(0.0, largest), f64::max);
            probes.push(new(&probe.name, state, &probe.field, probe.value, scale));
        }
        for (field, extremes) in &state.extremes {
            if has_largest && DISPLACEMENTS.contains(&field.as_ref()) {
                let value = largest(extremes);
                others.push(new(&format!("largest {field}"), state, field, value, value));
            }
        }
        let energy = state.certificate.energy;
        energies.push(new("energy", state, "energy", energy, energy.abs()));
    }
    let all = probes.into_iter().chain(others).chain(energies);
    all.filter(|q| q.value.is_finite()).collect()
}

/// The same as names and values.
pub(super) fn values(summary: &Summary) -> Vec<Measured> {
    quantities(summary).into_iter().map(|q| Measured { name: q.name, value: q.value }).collect()
}

/// The same with a number behind names that others have, too.
fn distinct(mut all: Vec<Measured>) -> Vec<Measured> {
    for k in 1..all.len() {
        let earlier =
            all[..k].iter().filter(|m| m.name.trim_end_matches(char::is_numeric).trim_end() == all[k].name);
        let same = earlier.count();
        if same > 0 {
            all[k].name = format!("{} {}", all[k].name, same + 1);
        }
    }
    all
}

/// Errors of the checks that compare all points with an exact solution.
fn errors(summary: &Summary) -> Vec<Measured> {
    let exact = summary.checks.iter().filter(|c| matches!(c.kind, "closed_form" | "formula"));
    let both = exact.flat_map(|check| {
        let of = |norm: &str, value: f64| Measured { name: format!("{} {norm}", check.name), value };
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
        let all = all.map(|name| Measured { name: name.into(), value: 0.0 });
        let names: Vec<String> = distinct(all.into()).into_iter().map(|m| m.name).collect();
        assert_eq!(names, ["ux formula max", "energy", "ux formula max 2", "ux formula max 3"]);
    }
}
