//! Results as text.

use super::print_state;
use comfy_table::{CellAlignment, Table, presets};
use peristat::run::{CheckResult, ProbeResult, Sizes};
use peristat::summary::words::{self, Listing};
use peristat::summary::{Status, Summary};
use std::fmt::Write;

/// A table that pastes as Markdown, numbers to the right.
pub(super) fn table(header: &[&str], rows: &[Vec<String>]) -> String {
    let mut table = Table::new();
    table.load_style(presets::ASCII_MARKDOWN).set_header(header.to_vec());
    rows.iter().for_each(|row| _ = table.add_row(row));
    for column in table.column_iter_mut().skip(1) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    format!("{table}\n")
}

/// A table of the record, with what it leaves out.
pub(super) fn listing(out: &mut String, listing: &Listing) {
    let header: Vec<&str> = listing.header.iter().map(String::as_str).collect();
    let _ = write!(out, "\n{}", table(&header, &listing.rows));
    if let Some(more) = &listing.more {
        let _ = writeln!(out, "\n  {more}");
    }
}

/// Names and what they are, one below the other.
fn facts(out: &mut String, facts: &[(String, String)]) {
    let width = facts.iter().map(|f| f.0.len()).max().unwrap_or(0);
    facts.iter().for_each(|(key, text)| _ = writeln!(out, "  {key:<width$}  {text}"));
}

/// The summary as JSON.
pub(super) fn json(summary: &Summary) -> String {
    let text = serde_json::to_string_pretty(summary).expect("a summary has only text keys");
    format!("{text}\n")
}

/// The summary as text.
pub(super) fn summary(summary: &Summary, verbose: bool) -> String {
    let mut out = format!("{}\n\n", summary.title);
    words::model(summary).iter().for_each(|(key, text)| _ = writeln!(out, "  {key:<8} {text}"));
    if let Some(course) = words::course(summary) {
        out.push('\n');
        facts(&mut out, &course);
    }
    // Of a body that breaks or softens the last equilibrium tells most; all are in its files.
    let is_traced = summary.fracture.is_some() || summary.path.is_some();
    let told = if is_traced { summary.states.len().saturating_sub(1) } else { 0 };
    for state in &summary.states[told..] {
        if summary.states.len() > 1 {
            let _ = writeln!(out, "\n{}", state.name);
        }
        listing(&mut out, &words::extremes(state));
        words::forces(state, summary.units).iter().for_each(|l| listing(&mut out, l));
        print_state::certificate(&mut out, state);
    }
    if let Some((sentence, table)) = words::estimates(summary) {
        let _ = writeln!(out, "\n  {sentence}");
        table.iter().for_each(|table| listing(&mut out, table));
    }
    if let Some(envelope) = words::envelope(summary) {
        out.push_str("\nenvelope\n");
        listing(&mut out, &envelope);
    }
    let probes = last_probes(summary, is_traced);
    if !probes.is_empty() {
        listing(&mut out, &words::probes(probes.iter(), &words::digits));
    }
    if !summary.checks.is_empty() {
        let _ = write!(out, "\n{}", checks(&summary.checks));
    }
    if verbose {
        details(&mut out, summary);
    }
    if summary.status == Status::NotConverged {
        out.push_str("\nNOT CONVERGED: the certificate shows how far it is; do not use these numbers\n");
    }
    out.push('\n');
    out
}

/// The probes that are printed: of a body that breaks or softens, those of its last state; `history.csv` has them all.
fn last_probes(summary: &Summary, is_traced: bool) -> &[ProbeResult] {
    let per_state = summary.probes.len() / summary.states.len().max(1);
    let told = if is_traced { per_state } else { summary.probes.len() };
    &summary.probes[summary.probes.len() - told..]
}

/// The checks of a case.
pub(super) fn checks(checks: &[CheckResult]) -> String {
    let told = words::checks(checks);
    let header: Vec<&str> = told.header.iter().map(String::as_str).collect();
    table(&header, &told.rows)
}

fn details(out: &mut String, summary: &Summary) {
    out.push_str("\nskipped\n");
    summary.skipped.iter().for_each(|s| _ = writeln!(out, "  {s}"));
    let c = &summary.counters;
    let _ = writeln!(
        out,
        "\ncounters\n  {} factorisations, {} analyses, {} right-hand sides, {} PCG iterations, {} bond evaluations",
        c.factorisations, c.analyses, c.right_hand_sides, c.pcg_iterations, c.bond_evaluations
    );
    let t = &summary.timing_s;
    let _ = writeln!(
        out,
        "\ntime, s\n  assemble {:.4}, factor {:.4}, solve {:.4}, certify {:.4}, record {:.4}, estimate {:.4}",
        t.assemble, t.factor, t.solve, t.certify, t.record, t.estimate
    );
}

/// Sizes of cases.
pub(super) fn sizes(all: &[(String, Sizes)]) -> String {
    let rows: Vec<Vec<String>> = all
        .iter()
        .map(|(case, s)| {
            let megabytes = format!("{:.1}", s.estimated_bytes as f64 / 1e6);
            vec![case.clone(), s.points.to_string(), s.bonds.to_string(), s.unknowns.to_string(), megabytes]
        })
        .collect();
    table(&["case", "points", "bonds", "unknowns", "memory, MB"], &rows)
}
