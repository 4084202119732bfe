//! Studies as text.

use super::print::table;
use crate::study::order::{self, Limit};
use crate::study::{Findings, Plan, Quantity, Series, Task};
use crate::summary::words::number;
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
    format!("{}\n\n  case  {}\n\n{list}", plan.study.title, plan.case_file.display())
}

/// What a study found; `verbose` shows every level, too.
pub(super) fn findings(findings: &Findings, verbose: bool) -> String {
    let mut out = format!("{}\n", findings.title);
    for series in &findings.series {
        let title = series.title();
        let _ = if title.is_empty() { writeln!(out) } else { writeln!(out, "\n{title}\n") };
        let is_refined = series.levels.iter().any(|level| level.size.is_some());
        if verbose || !is_refined {
            for quantities in series.quantities.chunks(ABREAST) {
                out += &levels(series, quantities);
                out.push('\n');
            }
        }
        if let (true, Some(level)) = (is_refined, series.levels.last()) {
            let _ = writeln!(
                out,
                "  {} levels to horizon {}, spacing {}, {} points\n",
                series.levels.len(),
                number(level.record.horizon),
                number(level.record.spacing),
                level.record.points
            );
            out += &conclusions(series);
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

/// Values and orders of some quantities, level by level.
fn levels(series: &Series, quantities: &[Quantity]) -> String {
    let mut header =
        vec!["task".to_string(), "horizon".into(), "spacing".into(), "points".into(), "time, s".into()];
    for quantity in quantities {
        let column =
            if quantity.values.is_empty() { quantity.name.clone() } else { format!("{} ", quantity.name) };
        header.push(column.trim_end().into());
        if !quantity.values.is_empty() && !quantity.errors.is_empty() {
            header.push("error".into());
        }
        if !quantity.orders.is_empty() {
            header.push("order".into());
        }
    }
    let row = |k: usize| {
        let level = &series.levels[k];
        let r = &level.record;
        let mut row = vec![
            level.task.to_string(),
            number(r.horizon),
            number(r.spacing),
            r.points.to_string(),
            format!("{:.3}", r.seconds),
        ];
        for quantity in quantities {
            if let Some(value) = quantity.values.get(k) {
                row.push(number(*value));
            }
            if let Some(error) = quantity.errors.get(k) {
                row.push(format!("{error:.2e}"));
            }
            if !quantity.orders.is_empty() {
                let order = k.checked_sub(1).and_then(|k| quantity.orders[k]);
                row.push(order.map_or(String::new(), |order| format!("{order:.2}")));
            }
        }
        row
    };
    let rows: Vec<Vec<String>> = (0..series.levels.len()).map(row).collect();
    table(&header.iter().map(String::as_str).collect::<Vec<_>>(), &rows)
}

/// What the levels say of every quantity.
fn conclusions(series: &Series) -> String {
    let row = |quantity: &Quantity| {
        let error = quantity.errors.last().map_or(String::new(), |error| match *error > order::ROUNDING {
            true => format!("{error:.2e}"),
            false => format!("{error:.1e}, rounding"),
        });
        let orders = quantity.orders.iter().flatten().map(|order| format!("{order:.2}"));
        let fit = quantity.fit.map_or(String::new(), |fit| match fit.spread {
            Some(spread) => format!("{:.2} ± {spread:.2}", fit.order),
            None => format!("{:.2}", fit.order),
        });
        let [limit, estimate] = limit(quantity);
        let orders = orders.collect::<Vec<_>>().join(" ");
        vec![quantity.name.clone(), error, orders, fit, limit, estimate]
    };
    let rows: Vec<Vec<String>> = series.quantities.iter().map(row).collect();
    let header =
        ["quantity", "error of the finest", "orders", "by fit", "extrapolated", "estimated error of it"];
    table(&header, &rows)
}

/// Value and estimated error of a limit, or why there is none.
fn limit(quantity: &Quantity) -> [String; 2] {
    match &quantity.limit {
        None => Default::default(),
        Some(Limit::Exact { value }) => [format!("{value}"), "rounding".into()],
        Some(Limit::Extrapolated { value, error_estimate, confirmed, .. }) => {
            let doubt = if *confirmed { "" } else { ", one order only" };
            [number_with(*value, *error_estimate), format!("{error_estimate:.1e}{doubt}")]
        }
        Some(Limit::NotInTheAsymptoticRange(reason)) => {
            ["not in the asymptotic range".into(), reason.clone()]
        }
    }
}

/// A number with the digits that its error leaves, and one more.
fn number_with(value: f64, error: f64) -> String {
    let digits =
        if error > 0.0 && value != 0.0 { (value.abs() / error).log10().ceil() as usize + 1 } else { 16 };
    format!("{value:.*e}", digits.clamp(2, 16) - 1)
}
