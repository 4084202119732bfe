//! How a body went along its path, in words.

use super::{Fact, number};
use crate::run::path::PathReport;

/// What is reported of a body that softens.
pub(in crate::summary) fn path(report: &PathReport) -> Vec<Fact> {
    let fact = |name: &str| report.facts.get(name).and_then(serde_json::Value::as_f64);
    let at = |factor: &str, load: &str| match fact(factor).zip(fact(load)) {
        Some((factor, load)) => format!("load factor {}, load {}", number(factor), number(load)),
        None => "no bond yields".into(),
    };
    let value = |name: &str| fact(name).map_or_else(|| "none".into(), number);
    let off = match report.island_points {
        0 => String::new(),
        1 => ", 1 point came off".into(),
        points => format!(", {points} points came off"),
    };
    let refused = match report.refused_steps {
        0 => String::new(),
        1 => ", 1 step refused".into(),
        steps => format!(", {steps} steps refused"),
    };
    let back = match fact("snap_back_steps") {
        Some(steps) if steps > 0.0 => format!(", {steps} of them snap back"),
        _ => String::new(),
    };
    let control = serde_json::to_value(report.control).ok();
    let name = control.as_ref().and_then(serde_json::Value::as_str).unwrap_or_default();
    let lines = [
        (
            "bonds",
            format!(
                "yield at {}, fail at {} (s_f/s_y = {})",
                number(report.yield_stretch),
                number(report.failure_stretch),
                number(report.brittleness)
            ),
        ),
        ("control", format!("{name}: {}", report.control_reason)),
        ("first yield", at("first_yield_load_factor", "first_yield_load")),
        ("peak", at("peak_load_factor", "peak_load")),
        ("end", at("load_factor", "end_load")),
        (
            "energy",
            format!(
                "work {}, stored {}, dissipated {}",
                value("work"),
                value("stored_energy"),
                value("dissipated_energy")
            ),
        ),
        (
            "balance",
            format!("{} of the work, equilibrium {}", value("energy_balance"), value("work_identity")),
        ),
        ("steps", format!("{}{back}{refused}", report.steps)),
        (
            "effort",
            format!(
                "{:.1} iterations and {:.1} factorisations per step",
                report.mean_iterations, report.mean_factorisations
            ),
        ),
        ("failed", format!("{} bonds{off}", value("broken_bonds"))),
        ("ended", report.ending.to_string()),
    ];
    lines.into_iter().map(|(key, text)| (key.to_string(), text)).collect()
}
