//! Results as text.

use super::{print_beam, print_fracture, print_path, print_plane, print_state};
use crate::run::{CheckResult, ProbeResult, Sizes};
use crate::summary::{Estimate, Estimates, Forces, Located, ModelSummary, Status, Summary};
use comfy_table::{CellAlignment, Table, presets};
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

/// A number with six digits, the way engineers write it.
pub(super) fn number(value: f64) -> String {
    match value.abs() {
        0.0 => "0".into(),
        size if (1e-3..1e6).contains(&size) => {
            let digits = (5 - size.log10().floor() as i32).max(0) as usize;
            let text = format!("{value:.digits$}");
            if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').into() } else { text }
        }
        _ => {
            let text = format!("{value:.5e}");
            let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
            let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
            format!("{mantissa}e{exponent}")
        }
    }
}

/// The summary as JSON.
pub(super) fn json(summary: &Summary) -> String {
    let text = serde_json::to_string_pretty(summary).expect("a summary has only text keys");
    format!("{text}\n")
}

/// The summary as text.
pub(super) fn summary(summary: &Summary, verbose: bool) -> String {
    let mut out = format!("{}\n\n", summary.title);
    model(&mut out, summary);
    if let Some(report) = &summary.fracture {
        out.push('\n');
        print_fracture::fracture(&mut out, report);
    }
    if let Some(report) = &summary.path {
        out.push('\n');
        print_path::path(&mut out, report);
    }
    // Of a body that breaks or softens the last equilibrium tells most; all are in its files.
    let is_traced = summary.fracture.is_some() || summary.path.is_some();
    let told = if is_traced { summary.states.len().saturating_sub(1) } else { 0 };
    for state in &summary.states[told..] {
        if summary.states.len() > 1 {
            let _ = writeln!(out, "\n{}", state.name);
        }
        out.push('\n');
        print_state::extremes(&mut out, state);
        match &state.forces {
            Forces::Beam(forces) => print_beam::forces(&mut out, forces),
            Forces::Plane(forces) => print_plane::forces(&mut out, forces, summary.units),
        }
        print_state::certificate(&mut out, state);
    }
    if !summary.envelope.is_empty() {
        envelope(&mut out, summary);
    }
    if !summary.probes.is_empty() && !is_traced {
        probes(&mut out, summary);
    }
    if let Some(estimates) = &summary.estimate {
        estimated(&mut out, estimates);
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

fn model(out: &mut String, summary: &Summary) {
    let mut line = |key: &str, text: String| _ = writeln!(out, "  {key:<8} {text}");
    match &summary.model {
        ModelSummary::Beam(model) => print_beam::model(model, summary.units, &mut line),
        ModelSummary::Plane(model) => print_plane::model(model, summary.units, &mut line),
    }
    let sizes = &summary.sizes;
    line("size", format!("{} points, {} bonds, {} unknowns", sizes.points, sizes.bonds, sizes.unknowns));
    let iterations: Vec<String> = summary.solver.iterations.iter().map(ToString::to_string).collect();
    let method = &summary.solver.method;
    line(
        "solver",
        match iterations.is_empty() {
            true => method.clone(),
            false => format!("{method} finished by {} PCG iterations on the bonds", iterations.join(", ")),
        },
    );
    line("why", summary.solver.reason.clone());
}

fn envelope(out: &mut String, summary: &Summary) {
    let rows: Vec<Vec<String>> = summary
        .envelope
        .iter()
        .map(|(field, [low, high])| {
            let place = |e: &(String, Located)| format!("{} at {}", e.0, print_state::place(&e.1));
            vec![field.to_string(), number(low.1.value), place(low), number(high.1.value), place(high)]
        })
        .collect();
    let _ = write!(out, "\nenvelope\n\n{}", table(&["field", "smallest", "in", "largest", "in"], &rows));
}

/// Estimated errors of the discretisation.
fn estimated(out: &mut String, estimates: &Estimates) {
    let row = |e: &Estimate| {
        let relative = e.relative.map_or(String::new(), |relative| format!("{relative:.1e}"));
        vec![e.name.clone(), format!("{:?}", e.value), format!("{:.1e}", e.error), relative, e.basis.clone()]
    };
    let rows: Vec<Vec<String>> = estimates.quantities.iter().map(row).collect();
    let header = ["quantity", "value", "estimated error", "relative", "basis"];
    let spacings: Vec<String> = estimates.spacings.iter().map(ToString::to_string).collect();
    let _ = write!(
        out,
        "\nerror of the discretisation, against {}; from {} times the spacing, in {:.3} s\n\n{}",
        estimates.against,
        spacings.join(" and "),
        estimates.seconds,
        table(&header, &rows)
    );
}

fn probes(out: &mut String, summary: &Summary) {
    let row = |p: &ProbeResult| {
        let place = p.place.clone().or_else(|| Some(print_state::position(p.x?, p.y))).unwrap_or_default();
        vec![p.name.clone(), p.state.clone(), p.field.to_string(), place, format!("{:?}", p.value)]
    };
    let rows: Vec<Vec<String>> = summary.probes.iter().map(row).collect();
    let on_lines = summary.probes.iter().all(|p| p.place.is_none() && p.y.is_none());
    let at = if on_lines { "x" } else { "at" };
    let _ = write!(out, "\n{}", table(&["probe", "state", "field", at, "value"], &rows));
}

/// The checks of a case.
pub(super) fn checks(checks: &[CheckResult]) -> String {
    let rows: Vec<Vec<String>> = checks
        .iter()
        .map(|c| {
            vec![
                c.name.clone(),
                number(c.expected),
                number(c.found),
                format!("{:.2e}", c.error),
                format!("{:.0e}", c.tolerance),
                if c.passed { "passed".into() } else { "FAILED".into() },
            ]
        })
        .collect();
    table(&["check", "expected", "found", "error", "tolerance", ""], &rows)
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
        "\ntime, s\n  assemble {:.4}, factor {:.4}, solve {:.4}, certify {:.4}, record {:.4}",
        t.assemble, t.factor, t.solve, t.certify, t.record
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

#[cfg(test)]
mod tests {
    use super::number;

    #[test]
    fn numbers_have_six_digits() {
        let text = [0.0, 1.0, -0.003_206_24, 123_456.7, 2e11, 5.208_333_333e-7].map(number);
        assert_eq!(text, ["0", "1", "-0.00320624", "123457", "2e11", "5.20833e-7"]);
    }
}
