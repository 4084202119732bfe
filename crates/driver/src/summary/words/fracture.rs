//! How a body broke, in words.

use super::{Fact, number};
use crate::run::fracture::FractureReport;

/// What is reported of a body that breaks: what every such body has, then what checks know by name.
pub(in crate::summary) fn fracture(report: &FractureReport) -> Vec<Fact> {
    let fact = |name: &str| report.facts.get(name).and_then(serde_json::Value::as_f64);
    let at = |factor: &str, load: &str| match fact(factor).zip(fact(load)) {
        Some((factor, load)) => format!("load factor {}, load {}", number(factor), number(load)),
        None => "nothing broke".into(),
    };
    let off = match report.island_points {
        0 => String::new(),
        1 => ", 1 point came off".into(),
        points => format!(", {points} points came off"),
    };
    let mut lines = vec![
        ("first break", at("first_break_load_factor", "first_break_load")),
        ("peak", at("peak_load_factor", "peak_load")),
        ("broken", format!("{} bonds in {} equilibria{off}", report.broken_bonds, report.solves)),
        ("ended", report.ending.to_string()),
        ("iterations", format!("{:.1} per equilibrium", report.mean_iterations)),
    ];
    let general = crate::case::FRACTURE_FACTS;
    for (name, value) in report.facts.iter().filter(|f| !general.contains(&f.0.as_str())) {
        let unit = if name.ends_with("_direction") { "° from x" } else { "" };
        lines.push((name, format!("{}{unit}", number(value.as_f64().unwrap_or(f64::NAN)))));
    }
    lines.into_iter().map(|(key, text)| (key.to_string(), text)).collect()
}
