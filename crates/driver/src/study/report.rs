//! The report of a study.

use super::findings::Findings;
use super::plan::Plan;
use super::words;
use super::write::{names, over_size, over_time};
use crate::output::plot::LogLog;
use crate::output::report;
use crate::output::report::{
    Axis, Badge, Block, Cell, Chart, Column, Look, Page, Section, Slope, Table, Tone,
};
use crate::summary::words::Listing;

/// Series of a chart, at most.
const MOST_LINES: usize = 6;
/// Triangles of slope in a chart, at most.
const MOST_TRIANGLES: usize = 4;

/// The page of a study.
pub(super) fn page(plan: &Plan, findings: &Findings) -> Page {
    let mut sections = Vec::new();
    if !findings.remarks.is_empty() {
        sections.push(Section::new("Other than asked", vec![Block::List(findings.remarks.clone())]));
    }
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
        let tables = [
            table("Quantities", words::conclusions(series)),
            table("Levels", words::levels(series, &series.quantities)),
        ];
        sections.push(Section::new(title, tables.map(Block::Table).into()));
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
    // More triangles would lie on each other.
    let with_slopes = with_slopes && lines.len() <= MOST_TRIANGLES;
    let note = match diagram.lines.len() > lines.len() {
        true => format!("{} of {} series; `plots` has all of them", lines.len(), diagram.lines.len()),
        false => String::new(),
    };
    Some(Block::Chart(Chart {
        slopes: if with_slopes { slopes.collect() } else { Vec::new() },
        marks: Vec::new(),
        series: lines
            .iter()
            .map(|line| report::Series {
                label: line.label.clone(),
                look: Look::Marked,
                points: line.points.clone(),
            })
            .collect(),
        title: name.into(),
        note,
        x: Axis::log(diagram.x_label),
        y: Axis::log(diagram.y_label),
    }))
}

/// A table of the record under a title; all columns but the first hold numbers.
fn table(title: &str, listing: Listing) -> Table {
    let columns = listing.header.iter().enumerate();
    let columns = columns.map(|(k, title)| Column { title: title.clone(), numbers: k > 0 }).collect();
    let row = |row: &Vec<String>| row.iter().map(|cell| Cell::from(cell.as_str())).collect();
    Table { title: title.into(), columns, rows: listing.rows.iter().map(row).collect() }
}
