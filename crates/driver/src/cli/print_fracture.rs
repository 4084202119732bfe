//! How a body broke, as text.

use super::print::number;
use crate::run::fracture::FractureReport;
use std::fmt::Write;

/// What is told of every body that breaks.
pub(super) fn fracture(out: &mut String, report: &FractureReport) {
    let mut line = |key: &str, text: String| _ = writeln!(out, "  {key:<12} {text}");
    let fact = |name: &str| report.facts.get(name).and_then(serde_json::Value::as_f64).unwrap_or(0.0);
    let at = |factor: &str, load: &str| {
        format!("load factor {}, load {}", number(fact(factor)), number(fact(load)))
    };
    line("first break", at("first_break_load_factor", "first_break_load"));
    line("peak", at("peak_load_factor", "peak_load"));
    let off = match report.island_points {
        0 => String::new(),
        1 => ", 1 point came off".into(),
        points => format!(", {points} points came off"),
    };
    line("broken", format!("{} bonds in {} equilibria{off}", report.broken_bonds, report.solves));
    line("ended", report.ending.to_string());
    line("iterations", format!("{:.1} per equilibrium", report.mean_iterations));
    let general = crate::run::fracture::FACTS;
    for (name, value) in report.facts.iter().filter(|f| !general.contains(&f.0.as_str())) {
        line(name, number(value.as_f64().unwrap_or(f64::NAN)));
    }
}
