//! `curve.csv` of a body that softens: every state on its path, and diagrams of them.

use super::curve::FILE;
use crate::case::{Case, FieldName, Path as CasePath, Probe};
use crate::output::atomic;
use crate::output::csv::head;
use crate::output::plot::{self, Diagram, Series, Style};
use crate::run::path::PathPoint;
use std::fmt::Write as _;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// The columns between the load and what is known of the crack; energies come first.
const COLUMNS: &str = "balance,identity,changed,softened,broken,island_points,iterations,blended,refused,factorisations,residual,\
    negative_eigenvalues";

/// The table, open, with all of its rows.
#[derive(Debug)]
pub(super) struct PathCurve {
    file: File,
    points: Vec<PathPoint>,
    /// Probes with a column, by number.
    probes: Vec<usize>,
    /// The probe that the load is drawn over.
    opening: Option<usize>,
}

/// Whether a probe is known without the fields of all points.
fn has_column(probe: &Probe) -> bool {
    use FieldName::{Opening, ReactionX, ReactionY, Ux, Uy};
    matches!(probe.field, ReactionX | ReactionY | Ux | Uy | Opening)
}

impl PathCurve {
    /// Writes the table of the states so far, and keeps it open for those to come.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn begin(
        folder: &Path,
        case: &Case,
        path: &CasePath,
        points: &[PathPoint],
    ) -> io::Result<Self> {
        let probes: Vec<usize> = (0..case.probes.len()).filter(|&k| has_column(&case.probes[k])).collect();
        let mut text = header(case, &probes);
        points.iter().for_each(|point| text.push_str(&row(point, &probes)));
        let file = folder.join(FILE);
        atomic::write_atomically(&file, text.as_bytes())?;
        let file = OpenOptions::new().append(true).open(&file)?;
        let opening = path.opening.as_ref().and_then(|name| case.probes.iter().position(|p| p.name == *name));
        Ok(Self { file, points: points.to_vec(), probes, opening })
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        self.points.len()
    }

    /// Adds a state.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn add(&mut self, point: &PathPoint) -> io::Result<()> {
        self.points.push(point.clone());
        // One write, so that a reader finds whole rows.
        self.file.write_all(row(point, &self.probes).as_bytes())
    }

    /// Draws the load, the energies, and what is known of the crack.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn draw(&self, plots: &Path, case: &Case) -> io::Result<()> {
        let mut diagrams = self.diagrams(case).into_iter();
        diagrams.try_for_each(|(file, diagram)| plot::write(&plots.join(format!("{file}.svg")), &diagram))
    }

    /// The load, the energies, and what is known of the crack: the name of the file of each, and its diagram.
    pub(super) fn diagrams(&self, case: &Case) -> Vec<(&'static str, Diagram)> {
        if self.points.len() < 2 {
            return Vec::new();
        }
        let units = case.units;
        let length = units.length();
        let (name, unit) = load(case);
        let load_label = head(name, unit);
        let all: [(&str, String, &[Line]); 5] = [
            ("load_curve", load_label, &[("path", &|p| Some(p.load))]),
            (
                "energy",
                units.label("energy", units.moment()),
                &[
                    ("work", &|p| Some(p.work)),
                    ("dissipated", &|p| Some(p.dissipated)),
                    ("stored", &|p| Some(p.stored)),
                ],
            ),
            ("crack_growth", units.label("crack growth", length), &[("crack growth", &|p| p.crack_growth)]),
            (
                "stress_intensity",
                units.label("K at the load", &format!("{} √{length}", units.stress())),
                &[("K", &|p| p.stress_intensity)],
            ),
            ("j_integral", units.label("J", &format!("N/{length}")), &[("J", &|p| p.j_integral)]),
        ];
        let of = |(file, label, lines): (&'static str, String, &[Line])| {
            Some((file, self.diagram(case, label, lines)?))
        };
        all.into_iter().filter_map(of).collect()
    }

    /// Lines that have any points; none if there are none.
    fn diagram(&self, case: &Case, y_label: String, lines: &[Line]) -> Option<Diagram> {
        let x = |p: &PathPoint| self.opening.map_or(p.load_factor, |k| p.probes[k]);
        let line = |(label, of): &Line| Series {
            label: (*label).into(),
            style: Style::Line,
            points: self.points.iter().filter_map(|p| Some((x(p), of(p)?))).collect(),
        };
        let series: Vec<Series> = lines.iter().map(line).filter(|s| !s.points.is_empty()).collect();
        let x_label = match self.opening {
            Some(k) => case.units.label(&case.probes[k].name, case.units.length()),
            None => "load factor".into(),
        };
        let title = case.title.clone();
        (!series.is_empty()).then(|| Diagram { title, x_label, y_label, series, ..Diagram::default() })
    }
}

/// Name of the load and its unit.
fn load(case: &Case) -> (&str, &'static str) {
    let name = case.path.as_ref().map_or("load", |p| p.load.as_str());
    let probe = case.probes.iter().find(|p| p.name == name);
    (name, probe.map_or(case.units.force(), |probe| probe.field.about().unit.label(case.units)))
}

/// The first row of the table; `probes` are those with a column.
fn header(case: &Case, probes: &[usize]) -> String {
    let units = case.units;
    let energies = ["work", "stored", "dissipated"].map(|name| head(name, units.moment()));
    let mut columns = vec!["step".into(), "load_factor".into(), head("load", load(case).1)];
    columns.extend(energies);
    columns.push(COLUMNS.into());
    columns.extend([
        head("crack_growth", units.length()),
        head("stress_intensity", units.stress_intensity()),
        head("j_integral", units.force_per_length()),
    ]);
    let of_probe = |k: &usize| {
        let probe = &case.probes[*k];
        head(&probe.name.replace([',', '"'], " "), probe.field.about().unit.label(units))
    };
    columns.extend(probes.iter().map(of_probe));
    columns.join(",") + "\n"
}

/// A row of the table; `probes` are those with a column.
fn row(p: &PathPoint, probes: &[usize]) -> String {
    let mut row = format!("{},{:?},{:?}", p.step, p.load_factor, p.load);
    for value in [p.work, p.stored, p.dissipated, p.balance, p.identity] {
        let _ = write!(row, ",{value:?}");
    }
    for count in [
        p.changed,
        p.softened,
        p.broken,
        p.island_points,
        p.iterations,
        p.blended,
        p.refused,
        p.factorisations,
    ] {
        let _ = write!(row, ",{count}");
    }
    let _ = write!(row, ",{:?},", p.residual);
    p.negative_eigenvalues.iter().for_each(|n| _ = write!(row, "{n}"));
    for value in [p.crack_growth, p.stress_intensity, p.j_integral] {
        row.push(',');
        value.iter().for_each(|v| _ = write!(row, "{v:?}"));
    }
    probes.iter().for_each(|&k| _ = write!(row, ",{:?}", p.probes[k]));
    row.push('\n');
    row
}

/// A line of a diagram: its label and its values.
type Line<'a> = (&'a str, &'a dyn Fn(&PathPoint) -> Option<f64>);
