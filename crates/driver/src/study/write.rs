//! The files of a study beside its tasks.

use super::findings::{Findings, Quantity, Series};
use super::order::ROUNDING;
use super::plan::Plan;
use crate::output::plot::{LogLog, PowerLine, write_log_log};
use crate::output::{atomic, csv, folder as folders, report};
use crate::results::{is_picture, write_formats};
use std::fs;
use std::io;
use std::path::Path;

/// Writes `study.csv`, `study.json` and diagrams of the errors, which replace older ones.
///
/// # Errors
/// The folder cannot be written.
pub fn write(folder: &Path, plan: &Plan, findings: &Findings) -> io::Result<()> {
    let describe = |error: io::Error| {
        io::Error::new(error.kind(), format!("cannot write {}: {error}", folder.display()))
    };
    write_all(folder, plan, findings).map_err(describe)
}

fn write_all(folder: &Path, plan: &Plan, findings: &Findings) -> io::Result<()> {
    let plots = folder.join("plots");
    folders::make(&plots)?;
    let mut drawn = Vec::new();
    for (k, name) in names(findings).into_iter().enumerate() {
        let file = file_name(k, name);
        for (file, diagram) in [
            (format!("{file}.svg"), over_size(findings, name)),
            (format!("{file}_time.svg"), over_time(findings, name)),
        ] {
            if !diagram.lines.is_empty() {
                write_log_log(&plots.join(&file), &diagram)?;
                drawn.push(file);
            }
        }
    }
    sweep(&plots, &drawn)?;
    let formats = plan.tasks.first().map_or(&[][..], |task| &task.source.case.drawing.formats);
    write_formats(&plots, formats)?;
    write_table(&folder.join("study.csv"), plan, findings)?;
    report::write(&folder.join("report.html"), &super::report::page(plan, findings))?;
    let text = serde_json::to_string_pretty(findings)?;
    atomic::write_atomically(&folder.join("study.json"), format!("{text}\n").as_bytes())
}

/// Removes pictures of diagrams that are no longer made, in any format; another process that collects the same study may have done so.
fn sweep(plots: &Path, drawn: &[String]) -> io::Result<()> {
    for entry in fs::read_dir(plots)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if is_picture(&name) && !drawn.contains(&name) {
            match fs::remove_file(plots.join(&name)) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => return Err(error),
                _ => {}
            }
        }
    }
    Ok(())
}

/// Names of all quantities, each once.
pub(super) fn names(findings: &Findings) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for quantity in findings.series.iter().flat_map(|s| &s.quantities) {
        if !names.contains(&quantity.name.as_str()) {
            names.push(&quantity.name);
        }
    }
    names
}

/// A quantity as the name of a file; the number tells apart those that differ in odd characters only.
fn file_name(number: usize, name: &str) -> String {
    let plain = |c: char| if c.is_ascii_alphanumeric() { c } else { '_' };
    let short: String = name.chars().map(plain).take(60).collect();
    format!("{:02}_{short}", number + 1)
}

fn lines<'a>(
    findings: &'a Findings,
    name: &'a str,
    line: impl Fn(&Series, &Quantity) -> PowerLine + 'a,
) -> Vec<PowerLine> {
    let of = |series: &'a Series| {
        let quantity = series.quantities.iter().find(|q| q.name == name)?;
        Some(line(series, quantity)).filter(|line| line.points.iter().filter(|p| p.1 > 0.0).count() > 1)
    };
    let lines: Vec<PowerLine> = findings.series.iter().filter_map(of).collect();
    // A diagram of rounding shows nothing.
    let tells = lines.iter().flat_map(|line| &line.points).any(|point| point.1 > ROUNDING);
    if tells { lines } else { Vec::new() }
}

/// Errors of a quantity over the size that its orders are of.
pub(super) fn over_size(findings: &Findings, name: &str) -> LogLog {
    let line = |series: &Series, quantity: &Quantity| {
        let size = series.levels.iter().filter_map(|l| match findings.size {
            "horizon" => l.size.map(|_| l.record.horizon),
            "spacing" => l.size.map(|_| l.record.spacing),
            _ => l.size,
        });
        let slope = quantity.last_order();
        PowerLine {
            label: series.title(),
            points: size.zip(quantity.errors.iter().copied()).collect(),
            slope,
        }
    };
    LogLog {
        title: format!("{}: {name}", findings.title),
        x_label: findings.size.into(),
        y_label: "relative error".into(),
        lines: lines(findings, name, line),
    }
}

/// Errors of a quantity over the run time, where they are errors against something known.
pub(super) fn over_time(findings: &Findings, name: &str) -> LogLog {
    let line = |series: &Series, quantity: &Quantity| {
        let errors = if quantity.is_known() { &quantity.errors[..] } else { &[] };
        let points = series.levels.iter().map(|l| l.record.seconds).zip(errors.iter().copied());
        PowerLine { label: series.title(), points: points.collect(), slope: None }
    };
    LogLog {
        title: format!("{}: {name}", findings.title),
        x_label: "run time, s".into(),
        y_label: "relative error".into(),
        lines: lines(findings, name, line),
    }
}

/// One row for every quantity of every task.
fn write_table(file: &Path, plan: &Plan, findings: &Findings) -> io::Result<()> {
    let mut paths: Vec<&str> = Vec::new();
    for path in plan.study.vary.iter().flat_map(|axis| axis.keys()) {
        if !paths.contains(&path.as_str()) {
            paths.push(path);
        }
    }
    let length = plan.tasks.first().map_or("", |task| task.source.case.units.length());
    let [horizon, spacing] = ["horizon", "spacing"].map(|size| csv::head(size, length));
    let mut headers = vec!["task"];
    headers.extend(&paths);
    headers.extend([&horizon, &spacing, "points", "unknowns", "converged", "seconds"]);
    headers.extend(["quantity", "unit", "value", "error", "order"]);
    let mut rows = Vec::new();
    for series in &findings.series {
        let setting = |path: &&str| {
            series.settings.get(*path).map_or(String::new(), |value| match value.as_str() {
                Some(text) => text.into(),
                None => value.to_string(),
            })
        };
        for (k, level) in series.levels.iter().enumerate() {
            let r = &level.record;
            for quantity in &series.quantities {
                let number = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:?}"));
                let mut row = vec![level.task.to_string()];
                row.extend(paths.iter().map(setting));
                row.extend([r.horizon, r.spacing].map(|v| format!("{v:?}")));
                row.extend([r.points, r.unknowns].map(|v| v.to_string()));
                row.extend([r.converged.to_string(), format!("{:?}", r.seconds)]);
                row.extend([quantity.name.clone(), quantity.unit.clone()]);
                row.push(number(quantity.values.get(k).copied()));
                row.push(number(quantity.errors.get(k).copied()));
                row.push(number(k.checked_sub(1).and_then(|k| quantity.orders.get(k).copied().flatten())));
                rows.push(row);
            }
        }
    }
    csv::write_rows(file, &headers, &rows)
}
