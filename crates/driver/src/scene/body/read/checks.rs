//! Checks of a body.

use super::fields;
use super::fields::Says;
use crate::case::{Baseline, Case, FieldName, Formula};
use crate::diagnostic::{Faults, JsonPath};
use crate::input::Folder;
use crate::scene::expectation::{self, Expectation, PointsCheck};
use crate::scene::files::{BASELINE, column, text};
use crate::scene::formula;
use crate::scene::words;
use crate::units::Units;
use peristat_assembly::body::PointBody;
use peristat_assembly::model::BodyModel;

/// What is compared at all points of a body.
#[derive(Clone, Debug)]
pub struct BodyComparison {
    /// The field.
    pub field: FieldName,
    /// Expected values at the points of the body, images left out.
    pub expected: Vec<f64>,
    /// `baseline` or `formula`.
    pub kind: &'static str,
    /// Where the values come from.
    pub source: String,
    /// Largest difference relative to the largest expected value.
    pub tolerance: f64,
}

/// Checks of the case on a body with its model; states and probes by their names.
pub(crate) fn expectations(
    case: &Case,
    (body, model, says): (&PointBody, &dyn BodyModel, Says),
    states: &[&str],
    probes: &[&str],
    (folder, max_memory): (&Folder, Option<u64>),
    faults: &mut Faults,
) -> Vec<Expectation<BodyComparison>> {
    let is_field = |field: FieldName, path: &JsonPath, faults: &mut Faults| {
        let there_are: Vec<FieldName> = fields::answered(model, says).collect();
        let is_there = there_are.contains(&field);
        if !is_there {
            let (name, model) = (field.name(), case.model.name());
            faults
                .error(path.key("field"), format!("`{name}` is no field of all points of `{model}`"))
                .hint(words::there_are(&there_are));
        }
        is_there
    };
    let compare = |check: PointsCheck, path: &JsonPath, _: usize, faults: &mut Faults| {
        compare(check, body, (is_field, case.units), (folder, max_memory), path, faults)
    };
    expectation::expectations(case, states, probes, compare, faults)
}

/// What a check of all points of a body compares. `is_field` tells whether they have a field, with a fault if not.
pub(in crate::scene) fn compare(
    check: PointsCheck,
    body: &PointBody,
    (is_field, units): (impl Fn(FieldName, &JsonPath, &mut Faults) -> bool, Units),
    (folder, max_memory): (&Folder, Option<u64>),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<BodyComparison> {
    match check {
        PointsCheck::ClosedForm(_) => {
            faults
                .error(path.clone(), "closed forms are for beams")
                .hint("compare all points with a `formula` or a `baseline`, or a probe with a number by a `value` check");
            None
        }
        PointsCheck::Baseline(check) => is_field(check.field, path, faults)
            .then(|| of_baseline(check, (body, units), (folder, max_memory), path, faults))?,
        PointsCheck::Formula(check) => {
            is_field(check.field, path, faults).then(|| of_formula(check, body, path, faults))?
        }
    }
}

fn of_formula(
    check: &Formula,
    body: &PointBody,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<BodyComparison> {
    match formula::values(&check.is, body) {
        Ok(expected) => Some(BodyComparison {
            field: check.field,
            expected,
            kind: "formula",
            source: check.source.clone(),
            tolerance: check.tolerance,
        }),
        Err(reason) => {
            faults
                .error(path.key("is"), reason)
                .hint("for example `1e-3*x - 2*y^2`, in x and y, and z of a solid");
            None
        }
    }
}

fn of_baseline(
    check: &Baseline,
    (body, units): (&PointBody, Units),
    (folder, max_memory): (&Folder, Option<u64>),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<BodyComparison> {
    let text = text(folder, &check.file, max_memory, path, faults)?;
    match columns(&text, body.axes(), check.field, units).and_then(|rows| fitting(&rows, body)) {
        Ok(expected) => Some(BodyComparison {
            field: check.field,
            expected,
            kind: "baseline",
            source: "stored baseline".into(),
            tolerance: check.tolerance,
        }),
        Err(reason) => {
            faults.error(path.key("file"), format!("the baseline {} {reason}", check.file)).hint(BASELINE);
            None
        }
    }
}

/// Values, if their rows are the points of the body.
fn fitting(rows: &[Vec<f64>], body: &PointBody) -> Result<Vec<f64>, String> {
    if rows.len() != body.points() {
        return Err(format!("has {} rows, and the body has {} points", rows.len(), body.points()));
    }
    let slack = 1e-6 * body.spacing();
    for (k, row) in rows.iter().enumerate() {
        let at = body.position(k);
        if (0..body.axes()).any(|axis| (row[axis] - at[axis]).abs() > slack) {
            let found = [row[0], row[1], if body.axes() > 2 { row[2] } else { 0.0 }];
            let [found, at] = [found, at].map(|at| words::place(at, body));
            return Err(format!("has a row at {found}, where the body has its point at {at}"));
        }
    }
    Ok(rows.iter().map(|row| row[body.axes()]).collect())
}

/// The columns of some coordinates and of a field of a CSV text.
fn columns(text: &str, axes: usize, field: FieldName, units: Units) -> Result<Vec<Vec<f64>>, String> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').map(str::trim).collect();
    let places = ["x", "y", "z"][..axes].iter().map(|axis| (*axis, units.length()));
    let all = places.chain([(field.name(), field.about().unit.label(units))]);
    let wanted: Vec<usize> = all.map(|(name, unit)| column(&header, name, unit)).collect::<Result<_, _>>()?;
    let mut rows = Vec::new();
    for (k, line) in lines.enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<&str> = line.split(',').collect();
        let number =
            |c: usize| cells.get(c).and_then(|t| t.trim().parse::<f64>().ok()).filter(|v| v.is_finite());
        match wanted.iter().map(|&c| number(c)).collect::<Option<_>>() {
            Some(row) => rows.push(row),
            None => return Err(format!("has no number where one belongs in line {}", k + 2)),
        }
    }
    if rows.is_empty() { Err("has no rows".into()) } else { Ok(rows) }
}
