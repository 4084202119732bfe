//! Stored values that results are compared with.

use super::checks::CheckedBeam;
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::scene::files::{column, text};
use peristat_assembly::model::timoshenko_beam::TimoshenkoBeam;

/// The stored values of a baseline check, positions and values, if they belong to the points of the scene.
pub(super) fn stored(
    context: &CheckedBeam,
    check: &crate::case::Baseline,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<(f64, f64)>> {
    let text = text(context.folder, &check.file, context.max_memory, path, faults)?;
    let fitting = |stored| fits(stored, context.beam);
    let place = if context.on_frame { "s" } else { "x" };
    let units = [context.units.length(), check.field.about().unit.label(context.units)];
    match columns(&text, [place, check.field.name()], units).and_then(fitting) {
        Ok(stored) => Some(stored),
        Err(reason) => {
            faults.error(path.key("file"), format!("the baseline {} {reason}", check.file));
            None
        }
    }
}

/// Stored values, if they are at the points of the beam.
fn fits(stored: Vec<(f64, f64)>, beam: &TimoshenkoBeam) -> Result<Vec<(f64, f64)>, String> {
    let chains = beam.chains();
    let (rows, number) = (stored.len(), chains.iter().map(|c| c.points).sum::<usize>());
    if rows != number {
        return Err(format!("has {rows} rows, and the beam has {number} points"));
    }
    let points = chains.iter().flat_map(|c| (0..c.points).map(|k| (c.position(c.ghosts[0] + k), c.spacing)));
    let apart = |(s, p): &(&(f64, f64), (f64, f64))| (s.0 - p.0).abs() > 1e-6 * p.1;
    match stored.iter().zip(points).find(apart) {
        Some((s, p)) => {
            Err(format!("has a row at x = {}, where the beam has its point at {}", tidy(s.0), tidy(p.0)))
        }
        None => Ok(stored),
    }
}

/// The columns `place` and `field` of a CSV text, with their units.
fn columns(
    text: &str,
    [place, field]: [&str; 2],
    [length, unit]: [&str; 2],
) -> Result<Vec<(f64, f64)>, String> {
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap_or_default().split(',').map(str::trim).collect();
    let (x, value) = (column(&header, place, length)?, column(&header, field, unit)?);
    let mut stored = Vec::new();
    for (k, line) in lines.enumerate().filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<&str> = line.split(',').collect();
        let number =
            |c: usize| cells.get(c).and_then(|t| t.trim().parse::<f64>().ok()).filter(|v| v.is_finite());
        match (number(x), number(value)) {
            (Some(x), Some(value)) => stored.push((x, value)),
            _ => return Err(format!("has no number where one belongs in line {}", k + 2)),
        }
    }
    if stored.is_empty() { Err("has no rows".into()) } else { Ok(stored) }
}
