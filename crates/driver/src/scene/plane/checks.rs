//! Checks of a body in the plane.

use super::super::expectation::{self, Expectation, PointsCheck};
use super::super::words::tidy;
use super::PlaneBonds;
use crate::case::{Baseline, Case, FieldName};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::body::PlaneBody;
use std::path::Path;

/// What is compared at all points of a body in the plane.
#[derive(Clone, Debug)]
pub struct PlaneComparison {
    /// The field.
    pub field: FieldName,
    /// Stored values of the points of the body, images left out.
    pub stored: Vec<f64>,
    /// Largest difference relative to the largest stored value.
    pub tolerance: f64,
}

/// Checks of the case on a body with its bonds; states and probes by their names.
pub(super) fn expectations(
    case: &Case,
    (body, bonds): (&PlaneBody, &PlaneBonds),
    states: &[&str],
    probes: &[&str],
    folder: &Path,
    faults: &mut Faults,
) -> Vec<Expectation<PlaneComparison>> {
    let compare = |check: PointsCheck, path: &JsonPath, _: usize, faults: &mut Faults| match check {
        PointsCheck::ClosedForm(_) => {
            faults
                .error(path.clone(), "closed forms are for beams")
                .hint("compare a probe with a number by a `value` check, or all points by a `baseline`");
            None
        }
        PointsCheck::Baseline(check) => baseline(check, (body, bonds), folder, path, faults),
    };
    expectation::expectations(case, states, probes, compare, faults)
}

fn baseline(
    check: &Baseline,
    (body, bonds): (&PlaneBody, &PlaneBonds),
    folder: &Path,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<PlaneComparison> {
    let missing = match check.field {
        FieldName::Phi => !bonds.points_turn(),
        FieldName::W => !bonds.deflects(),
        field => !FieldName::PLANE.contains(&field),
    };
    if missing {
        faults.error(
            path.key("field"),
            format!("`{}` is no field of all points of a body in the plane", check.field.name()),
        );
        return None;
    }
    let stored = match std::fs::read_to_string(folder.join(&check.file)) {
        Ok(text) => columns(&text, check.field.name()).and_then(|rows| fitting(&rows, body)),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => Err("does not exist".into()),
        Err(error) => Err(format!("cannot be read: {error}")),
    };
    match stored {
        Ok(stored) => Some(PlaneComparison { field: check.field, stored, tolerance: check.tolerance }),
        Err(reason) => {
            faults.error(path.key("file"), format!("the baseline {} {reason}", check.file)).hint(
                "the path is relative to the case; `fields/step_000.csv` of an earlier run is a baseline",
            );
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
