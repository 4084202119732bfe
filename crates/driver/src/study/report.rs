//! The report of a study.

use super::findings::{Findings, Quantity, Series};
use super::order::{Limit, ROUNDING};
use super::plan::Plan;
use super::write::{names, over_size, over_time};
use crate::output::plot::LogLog;
use crate::output::report;
use crate::output::report::{
    Axis, Badge, Block, Cell, Chart, Column, Look, Page, Section, Slope, Table, Tone, number,
};

/// Series of a chart, at most.
const MOST_LINES: usize = 12;

/// The page of a study.
pub(super) fn page(plan: &Plan, findings: &Findings) -> Page {
    let mut sections = Vec::new();
    if !findings.expectations.is_empty() {
        sections.push(Section::new("Expectations", vec![Block::Table(expectations(findings))]));
    }
    let charts: Vec<Block> = names(findings).iter().filter_map(|name| convergence(findings, name)).collect();
    if !charts.is_empty() {
        sections.push(Section::new("Convergence", charts));
    }
    for series in &findings.series {
        let title = series.title();
        let title = if title.is_empty() { "Values".into() } else { title };
        sections
            .push(Section::new(title, vec![Block::Table(conclusions(series)), Block::Table(levels(series))]));
    }
    let timed = names(findings).into_iter().map(|name| chart(over_time(findings, name), name, false));
    let timed: Vec<Block> = timed.flatten().collect();
    if !timed.is_empty() {
        sections.push(Section { folded: true, ..Section::new("Error over run time", timed) });
    }
    let study = serde_json::to_string_pretty(&plan.study).unwrap_or_default();
    sections.push(Section { folded: true, ..Section::new("Study", vec![Block::Code(study)]) });
    let (text, tone) = match findings.passed() {
        true => ("passed", Tone::Good),
        false if !findings.missing.is_empty() => ("not complete", Tone::Bad),
        false => ("failed", Tone::Bad),
    };
    Page {
        title: findings.title.clone(),
        about: plan.study.about.clone().unwrap_or_default(),
        badge: Some(Badge { text: text.into(), tone }),
        sections,
        footer: format!("peristat {}, {} tasks", findings.version, findings.tasks),
    }
}

fn expectations(findings: &Findings) -> Table {
    let row = |outcome: &super::Outcome| {
        let (text, tone) = if outcome.passed { ("passed", Tone::Good) } else { ("failed", Tone::Bad) };
        vec![
            Cell::from(outcome.expected.as_str()),
            Cell::from(outcome.found.as_str()),
            Cell { text: text.into(), tone },
        ]
    };
    Table {
        title: String::new(),
        columns: vec![Column::words("expected"), Column::numbers("found"), Column::words("")],
        rows: findings.expectations.iter().map(row).collect(),
    }
}

/// Errors of a quantity over the size of the discretisation.
fn convergence(findings: &Findings, name: &str) -> Option<Block> {
    chart(over_size(findings, name), name, true)
}

/// A diagram as a chart of the page, if it has lines.
fn chart(diagram: LogLog, name: &str, with_slopes: bool) -> Option<Block> {
    if diagram.lines.is_empty() {
        return None;
    }
    let lines = &diagram.lines[..diagram.lines.len().min(MOST_LINES)];
    let slopes = lines.iter().filter_map(|line| Slope::below(&line.points, line.slope?));
    Some(Block::Chart(Chart {
        slopes: if with_slopes { slopes.collect() } else { Vec::new() },
        series: lines
            .iter()
            .map(|line| report::Series {
                label: line.label.clone(),
                look: Look::Marked,
                points: line.points.clone(),
            })
            .collect(),
        title: name.into(),
        note: String::new(),
        x: Axis::log(diagram.x_label),
        y: Axis::log(diagram.y_label),
    }))
}

/// Orders and limits of the quantities of a series.
fn conclusions(series: &Series) -> Table {
    let row = |quantity: &Quantity| {
        let error = quantity.errors.last().map_or(String::new(), |error| match *error > ROUNDING {
            true => number(*error),
            false => "rounding".into(),
        });
        let fit = quantity.fit.map_or(String::new(), |fit| match fit.spread {
            Some(spread) => format!("{:.2} ± {spread:.2}", fit.order),
            None => format!("{:.2}", fit.order),
        });
        let last = quantity.last_order().map_or(String::new(), |order| format!("{order:.2}"));
        let [limit, estimate] = match &quantity.limit {
            None => Default::default(),
            Some(Limit::Exact { value }) => [value.to_string(), "rounding".into()],
            Some(Limit::Extrapolated { value, error_estimate, .. }) => {
                [value.to_string(), number(*error_estimate)]
            }
            Some(Limit::NotInTheAsymptoticRange(reason)) => {
                [format!("not in the asymptotic range: {reason}"), String::new()]
            }
        };
        let exact = quantity.exact.map_or(String::new(), |exact| exact.to_string());
        [quantity.name.clone(), error, last, fit, limit, estimate, exact].map(Cell::from).to_vec()
    };
    let titles = [
        "error of the finest",
        "last order",
        "order by fit",
        "extrapolated",
        "estimated error of it",
        "exact",
    ];
    Table {
        title: "Quantities".into(),
        columns: std::iter::once(Column::words("quantity")).chain(titles.map(Column::numbers)).collect(),
        rows: series.quantities.iter().map(row).collect(),
    }
}

/// Every level of a series.
fn levels(series: &Series) -> Table {
    let mut columns: Vec<Column> =
        ["task", "horizon", "spacing", "points", "time, s"].map(Column::numbers).into();
    let named =
        |q: &Quantity| if q.values.is_empty() { q.name.clone() } else { format!("{}, error", q.name) };
    for quantity in &series.quantities {
        if !quantity.values.is_empty() {
            columns.push(Column::numbers(quantity.name.clone()));
        }
        if !quantity.errors.is_empty() {
            columns.push(Column::numbers(named(quantity)));
        }
    }
    let row = |(k, level): (usize, &super::Level)| {
        let r = &level.record;
        let mut row: Vec<Cell> = vec![
            level.task.to_string().into(),
            number(r.horizon).into(),
            number(r.spacing).into(),
            r.points.to_string().into(),
            format!("{:.3}", r.seconds).into(),
        ];
        for quantity in &series.quantities {
            row.extend(quantity.values.get(k).map(|value| Cell::from(number(*value))));
            row.extend(quantity.errors.get(k).map(|error| Cell::from(number(*error))));
        }
        row
    };
    Table { title: "Levels".into(), columns, rows: series.levels.iter().enumerate().map(row).collect() }
}
