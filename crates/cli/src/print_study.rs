//! Studies as text.

use super::print::{listing, table};
use peristat::study::{Findings, Plan, Task, words};
use peristat::summary::words::number;
use std::fmt::Write;

/// Quantities that share a table, at most.
const ABREAST: usize = 3;

/// The tasks of a study.
pub(super) fn plan(plan: &Plan, finished: impl Fn(&Task) -> bool) -> String {
    let row = |task: &Task| {
        let done = if finished(task) { "yes" } else { "no" };
        vec![task.number.to_string(), task.overrides.join(" "), done.into()]
    };
    let rows: Vec<Vec<String>> = plan.tasks.iter().map(row).collect();
    let list = table(&["task", "set", "finished"], &rows);
    let remarks = remarks(&plan.remarks());
    format!("{}\n{remarks}\n  case  {}\n\n{list}", plan.study.title, plan.case_file.display())
}

/// Remarks, one per line.
fn remarks(all: &[String]) -> String {
    all.iter().map(|remark| format!("note: {remark}\n")).collect()
}

/// What a study found; `verbose` shows every level, too.
pub(super) fn findings(findings: &Findings, verbose: bool) -> String {
    let mut out = format!("{}\n{}", findings.title, remarks(&findings.remarks));
    for series in &findings.series {
        let title = series.title();
        let _ = if title.is_empty() { writeln!(out) } else { writeln!(out, "\n{title}\n") };
        let is_refined = series.levels.iter().any(|level| level.size.is_some());
        if verbose || !is_refined {
            for quantities in series.quantities.chunks(ABREAST) {
                listing(&mut out, &words::levels(series, quantities));
            }
        }
        if let (true, Some(level)) = (is_refined, series.levels.last()) {
            let _ = writeln!(
                out,
                "  {} levels to horizon {}, spacing {}, {} points",
                series.levels.len(),
                number(level.record.horizon),
                number(level.record.spacing),
                level.record.points
            );
            listing(&mut out, &words::conclusions(series));
        }
    }
    if !findings.expectations.is_empty() {
        let verdict = |passed: bool| if passed { "passed" } else { "FAILED" };
        let rows = findings.expectations.iter();
        let rows: Vec<Vec<String>> =
            rows.map(|o| vec![o.expected.clone(), o.found.clone(), verdict(o.passed).into()]).collect();
        let _ = write!(out, "\n{}", table(&["expected", "found", ""], &rows));
    }
    for (what, tasks) in
        [("tasks without a result", &findings.missing), ("tasks not converged", &findings.not_converged)]
    {
        if !tasks.is_empty() {
            let numbers: Vec<String> = tasks.iter().map(ToString::to_string).collect();
            let _ = writeln!(out, "\n{what}: {}", numbers.join(", "));
        }
    }
    out.push('\n');
    out
}
