//! Checks of a body in the plane.

use super::super::expectation::{self, Expectation, PointsCheck};
use super::super::files::{BASELINE, text};
use super::super::words::tidy;
use super::PlaneBonds;
use super::formula;
use crate::case::{Baseline, Case, FieldName, Formula};
use crate::diagnostic::{Faults, JsonPath};
use crate::input::Folder;
use peristat_assembly::body::PlaneBody;

/// What is compared at all points of a body in the plane.
#[derive(Clone, Debug)]
pub struct PlaneComparison {
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

/// Checks of the case on a body with its bonds; states and probes by their names.
pub(super) fn expectations(
    case: &Case,
    (body, bonds): (&PlaneBody, &PlaneBonds),
    states: &[&str],
    probes: &[&str],
    (folder, max_memory): (&Folder, Option<u64>),
    faults: &mut Faults,
) -> Vec<Expectation<PlaneComparison>> {
    let compare = |check: PointsCheck, path: &JsonPath, _: usize, faults: &mut Faults| match check {
        PointsCheck::ClosedForm(_) => {
            faults
                .error(path.clone(), "closed forms are for beams")
                .hint("compare all points with a `formula` or a `baseline`, or a probe with a number by a `value` check");
            None
        }
        PointsCheck::Baseline(check) => baseline(check, (body, bonds), (folder, max_memory), path, faults),
        PointsCheck::Formula(check) => of_formula(check, (body, bonds), path, faults),
    };
    expectation::expectations(case, states, probes, compare, faults)
}

/// Whether all points have a field; a fault if not.
fn is_field(field: FieldName, bonds: &PlaneBonds, path: &JsonPath, faults: &mut Faults) -> bool {
    let missing = match field {
        FieldName::Phi => !bonds.points_turn(),
        FieldName::W => !bonds.deflects(),
        field => !FieldName::PLANE.contains(&field),
    };
    if missing {
        faults.error(
            path.key("field"),
            format!("`{}` is no field of all points of a body in the plane", field.name()),
        );
    }
    !missing
}

fn of_formula(
    check: &Formula,
    (body, bonds): (&PlaneBody, &PlaneBonds),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<PlaneComparison> {
    if !is_field(check.field, bonds, path, faults) {
        return None;
    }
    match formula::values(&check.is, body) {
        Ok(expected) => Some(PlaneComparison {
            field: check.field,
            expected,
            kind: "formula",
            source: check.source.clone(),
            tolerance: check.tolerance,
        }),
        Err(reason) => {
            faults.error(path.key("is"), reason).hint("for example `1e-3*x - 2*y^2`, in x and y");
            None
        }
    }
}

fn baseline(
    check: &Baseline,
    (body, bonds): (&PlaneBody, &PlaneBonds),
    (folder, max_memory): (&Folder, Option<u64>),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<PlaneComparison> {
    if !is_field(check.field, bonds, path, faults) {
        return None;
    }
    let text = text(folder, &check.file, max_memory, path, faults)?;
    match columns(&text, check.field.name()).and_then(|rows| fitting(&rows, body)) {
        Ok(expected) => Some(PlaneComparison {
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
fn fitting(rows: &[[f64; 3]], body: &PlaneBody) -> Result<Vec<f64>, String> {
    if rows.len() != body.points() {
        return Err(format!("has {} rows, and the body has {} points", rows.len(), body.points()));
    }
    let slack = 1e-6 * body.spacing();
    for (k, row) in rows.iter().enumerate() {
        let [x, y] = body.position(k);
        if (row[0] - x).abs() > slack || (row[1] - y).abs() > slack {
            let [a, b, x, y] = [row[0], row[1], x, y].map(tidy);
            return Err(format!("has a row at ({a}, {b}), where the body has its point at ({x}, {y})"));
        }
    }
    Ok(rows.iter().map(|r| r[2]).collect())
}

/// The columns `x`, `y` and `field` of a CSV text.
fn columns(text: &str, field: &str) -> Result<Vec<[f64; 3]>, String> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').map(str::trim).collect();
    let column =
        |name: &str| header.iter().position(|h| *h == name).ok_or_else(|| format!("has no column `{name}`"));
    let wanted = [column("x")?, column("y")?, column(field)?];
    let mut rows = Vec::new();
    for (k, line) in lines.enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<&str> = line.split(',').collect();
        let number =
            |c: usize| cells.get(c).and_then(|t| t.trim().parse::<f64>().ok()).filter(|v| v.is_finite());
        match wanted.map(number) {
            [Some(x), Some(y), Some(value)] => rows.push([x, y, value]),
            _ => return Err(format!("has no number where one belongs in line {}", k + 2)),
        }
    }
    if rows.is_empty() { Err("has no rows".into()) } else { Ok(rows) }
}
