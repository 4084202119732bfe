//! What came of many cases: a table, JSON, and the report that CI servers read.

use crate::print;
use peristat::Error;
use peristat::output::xml;
use peristat::run::CheckResult;
use peristat::summary::Summary;
use peristat::verify::{Found, Outcome, PASSED, UNCHECKED};
use std::collections::BTreeMap;
use std::fmt::Write;

/// How every JUnit report begins.
pub(super) const JUNIT: &str = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"peristat\" ";

/// Cases that passed, that did not, that have no checks, and files that were skipped.
struct Counts {
    passed: usize,
    failed: usize,
    unchecked: usize,
    skipped: usize,
}

impl Counts {
    fn of(outcomes: &[Outcome]) -> Self {
        let count = |is: fn(&Outcome) -> bool| outcomes.iter().filter(|o| is(o)).count();
        Self {
            passed: count(|o| o.verdict() == PASSED),
            failed: count(Outcome::is_failure),
            unchecked: count(|o| o.verdict() == UNCHECKED),
            skipped: count(|o| matches!(o.found, Found::Skipped(_))),
        }
    }
}

/// Worst check of a summary: the largest error over tolerance. A limit is no error, so it comes last.
fn worst(summary: &Summary) -> Option<&CheckResult> {
    let rank = |c: &CheckResult| (c.kind != "limit", c.error / c.tolerance);
    summary.checks.iter().max_by(|a, b| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    })
}

/// A table of all cases, and what was skipped: how many of a kind, or which.
pub(super) fn table(outcomes: &[Outcome], verbose: bool) -> String {
    let row = |o: &Outcome| {
        let worst = o.summary().and_then(worst);
        vec![
            o.case.display().to_string(),
            o.summary().map_or(String::new(), |s| s.checks.len().to_string()),
            worst.map_or(String::new(), |c| {
                if c.error.is_finite() { format!("{:.1e}", c.error) } else { "none".into() }
            }),
            worst.map_or(String::new(), |c| format!("{:.0e}", c.tolerance)),
            format!("{:.3}", o.seconds),
            o.verdict().into(),
        ]
    };
    let made = outcomes.iter().filter(|o| !matches!(o.found, Found::Skipped(_)));
    let rows: Vec<Vec<String>> = made.map(row).collect();
    let mut text = print::table(&["case", "checks", "worst error", "tolerance", "time, s", ""], &rows);
    for outcome in outcomes.iter().filter(|o| o.is_failure()) {
        if let Some(summary) = outcome.summary() {
            let _ = write!(text, "\n{}\n\n{}", outcome.case.display(), print::checks(&summary.checks));
        }
    }
    text + &skipped(outcomes, verbose) + &last_line(&Counts::of(outcomes))
}

/// Files that were skipped: their names, or how many for what reason.
fn skipped(outcomes: &[Outcome], verbose: bool) -> String {
    let skipped = outcomes.iter().filter_map(|o| match o.found {
        Found::Skipped(reason) => Some((reason, o)),
        _ => None,
    });
    let mut text = String::new();
    if verbose {
        for (reason, outcome) in skipped {
            let _ = writeln!(text, "skipped {}: {reason}", outcome.case.display());
        }
    } else {
        let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
        skipped.for_each(|(reason, _)| *counts.entry(reason).or_default() += 1);
        for (reason, count) in counts {
            let (s, name) = if count == 1 { ("", "its name") } else { ("s", "their names") };
            let _ = writeln!(text, "skipped {count} file{s}: {reason} (`-v` tells {name})");
        }
    }
    if text.is_empty() { text } else { format!("\n{text}") }
}

fn last_line(counts: &Counts) -> String {
    let Counts { passed, failed, unchecked, skipped } = counts;
    let mut text = format!("\n{passed} passed, {failed} failed");
    for (count, what) in [(unchecked, UNCHECKED), (skipped, "skipped")] {
        if *count > 0 {
            let _ = write!(text, ", {count} {what}");
        }
    }
    text + "\n"
}

/// The outcomes for machines.
pub(super) fn json(outcomes: &[Outcome]) -> String {
    let list = outcomes.iter().map(|o| {
        let error = match &o.found {
            Found::Fault(error) => Some(error),
            Found::Solved(_) | Found::Skipped(_) => None,
        };
        let mut object = serde_json::json!({
            "case": o.case, "verdict": o.verdict().to_lowercase(), "time_s": o.seconds,
            "checks": o.summary().map(|s| &s.checks), "error": error.map(Error::text)
        });
        if let (Some(error), Some(keys)) = (error, object.as_object_mut()) {
            keys.insert("faults".into(), serde_json::json!(error.records()));
        }
        if let (Found::Skipped(reason), Some(keys)) = (&o.found, object.as_object_mut()) {
            keys.insert("reason".into(), (*reason).into());
        }
        object
    });
    format!("{:#}\n", serde_json::Value::from(list.collect::<Vec<_>>()))
}

/// The outcomes in the form that CI servers read: a case without checks tests nothing, and counts as skipped there, too.
pub(super) fn junit(outcomes: &[Outcome]) -> String {
    let Counts { failed, unchecked, skipped, .. } = Counts::of(outcomes);
    let (tests, skipped) = (outcomes.len(), unchecked + skipped);
    let mut text = format!("{JUNIT}tests=\"{tests}\" failures=\"{failed}\" skipped=\"{skipped}\">\n");
    for o in outcomes {
        let name = xml(&o.case.display().to_string());
        let _ = write!(text, "  <testcase name=\"{name}\" classname=\"peristat\" time=\"{:.3}\"", o.seconds);
        let skip = |reason: &str| format!("<skipped message=\"{}\"/>", xml(reason));
        let fail = |details: &str| format!("<failure message=\"{}\">{}</failure>", o.verdict(), xml(details));
        let inner = match &o.found {
            Found::Skipped(reason) => skip(reason),
            Found::Fault(error) => fail(&error.to_string()),
            Found::Solved(s) if o.is_failure() => fail(&print::checks(&s.checks)),
            Found::Solved(s) if s.checks.is_empty() => skip(UNCHECKED),
            Found::Solved(_) => {
                text.push_str("/>\n");
                continue;
            }
        };
        let _ = write!(text, ">\n    {inner}\n  </testcase>\n");
    }
    text + "</testsuite>\n"
}
