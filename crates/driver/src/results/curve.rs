//! `curve.csv`: every equilibrium of a body that breaks, and diagrams of them.

use crate::case::{Case, Units};
use crate::output::atomic;
use crate::output::csv::head;
use crate::output::plot::{self, Diagram, Series, Style};
use crate::run::fracture::Event;
use std::fmt::Write as _;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// Name of the table.
pub(super) const FILE: &str = "curve.csv";

/// The columns; those behind the colons are loads, and energies.
const COLUMNS: [&str; 18] = [
    "step",
    "solve",
    "load_factor",
    "load:load",
    "envelope_load_factor",
    "envelope_load:load",
    "broken_now",
    "broken",
    "island_points",
    "work:energy",
    "stored:energy",
    "released:energy",
    "bond_energy:energy",
    "unstable_release:energy",
    "balance",
    "iterations",
    "factorisations",
    "residual",
];

/// The table, open, with all of its rows.
#[derive(Debug)]
pub(super) struct Curve {
    file: File,
    events: Vec<Event>,
    /// Largest load factor so far.
    reached: f64,
}

impl Curve {
    /// Writes the table of the equilibria so far, and keeps it open for those to come.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn begin(folder: &Path, case: &Case, events: &[Event]) -> io::Result<Self> {
        let path = folder.join(FILE);
        let (mut text, mut reached) = (header(case), 0.0_f64);
        for event in events {
            reached = reached.max(event.load_factor);
            text.push_str(&row(event, reached));
        }
        atomic::write_atomically(&path, text.as_bytes())?;
        let file = OpenOptions::new().append(true).open(&path)?;
        Ok(Self { file, events: events.to_vec(), reached })
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        self.events.len()
    }

    /// Adds an equilibrium.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn add(&mut self, event: &Event) -> io::Result<()> {
        self.reached = self.reached.max(event.load_factor);
        self.events.push(*event);
        // One write, so that a reader finds whole rows.
        self.file.write_all(row(event, self.reached).as_bytes())
    }

    /// Draws the load over the load factor, and the energies over the equilibria.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn draw(&self, plots: &Path, case: &Case) -> io::Result<()> {
        if self.events.is_empty() {
            return Ok(());
        }
        let [loads, energies] = self.diagrams(case);
        plot::write(&plots.join("load_curve.svg"), &loads)?;
        plot::write(&plots.join("energy.svg"), &energies)
    }

    /// The load over the load factor, and the energies over the equilibria.
    pub(super) fn diagrams(&self, case: &Case) -> [Diagram; 2] {
        [self.loads(&case.title, load_label(case)), self.energies(&case.title, case.units)]
    }

    fn loads(&self, title: &str, y_label: String) -> Diagram {
        let start = std::iter::once((0.0, 0.0));
        let points = self.events.iter().map(|e| (e.load_factor, e.load));
        let points: Vec<(f64, f64)> = start.clone().chain(points).collect();
        let mut reached = 0.0_f64;
        let envelope = self.events.iter().map(|e| {
            reached = reached.max(e.load_factor);
            envelope(e, reached)
        });
        let envelope: Vec<(f64, f64)> = start.chain(envelope).collect();
        let series = vec![
            Series { label: "equilibria".into(), style: Style::Thin, points },
            Series { label: "envelope".into(), style: Style::Line, points: envelope },
        ];
        Diagram { title: title.into(), x_label: "load factor".into(), y_label, series, ..Diagram::default() }
    }

    fn energies(&self, title: &str, units: Units) -> Diagram {
        let series = |label: &str, of: fn(&Event) -> f64| {
            let points = self.events.iter().map(|e| (e.solve as f64, of(e))).collect();
            Series { label: label.into(), style: Style::Line, points }
        };
        Diagram {
            title: title.into(),
            x_label: "equilibrium".into(),
            y_label: units.label("energy", units.moment()),
            series: vec![
                series("work", |e| e.work),
                series("stored", |e| e.stored),
                series("released", |e| e.released),
            ],
            ..Diagram::default()
        }
    }
}

/// The first row of the table.
fn header(case: &Case) -> String {
    let column = |column: &&str| match column.split_once(':') {
        Some((name, "load")) => head(name, load_unit(case)),
        Some((name, _)) => head(name, case.units.moment()),
        None => (*column).to_string(),
    };
    COLUMNS.iter().map(column).collect::<Vec<_>>().join(",") + "\n"
}

/// Name of the probe that is the load.
fn load_name(case: &Case) -> &str {
    case.fracture.as_ref().map_or("load", |fracture| fracture.load.as_str())
}

/// Unit of the load; empty if it has none.
fn load_unit(case: &Case) -> &'static str {
    let probe = case.probes.iter().find(|probe| probe.name == load_name(case));
    probe.map_or("", |probe| probe.field.about().unit.label(case.units))
}

/// Name of the load, with its unit.
fn load_label(case: &Case) -> String {
    head(load_name(case), load_unit(case))
}

/// Where the body is if the load factor never falls: at the largest one so far, with the bonds that are left.
fn envelope(event: &Event, reached: f64) -> (f64, f64) {
    let grown = if event.load_factor == 0.0 { 1.0 } else { reached / event.load_factor };
    (reached, event.load * grown)
}

fn row(event: &Event, reached: f64) -> String {
    let (e, (reached, load)) = (event, envelope(event, reached));
    let mut row = format!("{},{},{:?},{:?},{reached:?},{load:?}", e.step, e.solve, e.load_factor, e.load);
    let _ = write!(row, ",{},{},{}", e.broken_now, e.broken, e.island_points);
    for energy in [e.work, e.stored, e.released, e.bond_energy, e.unstable_release, e.balance] {
        let _ = write!(row, ",{energy:?}");
    }
    let _ = writeln!(row, ",{},{},{:?}", e.iterations, e.factorisations, e.residual);
    row
}

#[cfg(test)]
mod tests {
    use super::*;

    fn event(solve: usize, load: f64) -> Event {
        Event { solve, load_factor: solve as f64 / 3.0, load, work: 0.1, broken: 2, ..Event::default() }
    }

    fn case() -> Case {
        let text = r#"{ "title": "t", "units": "mm-N-MPa",
            "model": { "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress" } },
            "body": { "rectangle": { "size": [8.0, 6.0], "spacing": 1.0 } },
            "supports": [], "probes": [ { "name": "pull", "at": { "region": "top" }, "field": "reaction_y" } ],
            "fracture": { "critical": { "stretch": 0.1 }, "load": "pull" } }"#;
        serde_json::from_str(text).unwrap()
    }

    fn text(folder: &Path) -> String {
        std::fs::read_to_string(folder.join(FILE)).unwrap()
    }

    #[test]
    fn rows_are_there_at_once_and_a_table_goes_on_from_any_of_them() {
        let folder = tempfile::tempdir().unwrap();
        let events = [event(0, 0.1), event(1, 0.30000000000000004), event(2, 0.2)];
        let mut curve = Curve::begin(folder.path(), &case(), &[]).unwrap();
        for (k, event) in events.iter().enumerate() {
            curve.add(event).unwrap();
            assert_eq!(text(folder.path()).lines().count(), k + 2);
        }
        let whole = text(folder.path());
        let columns: Vec<_> = whole.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(columns, [18; 4]);
        let head = "step,solve,load_factor,load [N],envelope_load_factor,envelope_load [N],broken_now,broken,island_points,work [N mm],";
        assert!(whole.starts_with(head), "{whole}");
        let last = "0,2,0.6666666666666666,0.2,0.6666666666666666,0.2,0,2,0,0.1,0.0,0.0,0.0,0.0,0.0,0,0,0.0";
        assert_eq!(whole.lines().last(), Some(last));
        let mut again = Curve::begin(folder.path(), &case(), &events[..1]).unwrap();
        events[1..].iter().for_each(|event| again.add(event).unwrap());
        assert_eq!(text(folder.path()), whole);
    }

    #[test]
    fn the_envelope_is_the_curve_of_a_load_factor_that_never_falls() {
        let folder = tempfile::tempdir().unwrap();
        let path = [(0.5, 2.0), (0.25, 0.75), (1.0, 2.0)];
        let at =
            |(k, &(load_factor, load)): (usize, &(f64, f64))| Event { load_factor, load, ..event(k, load) };
        let events: Vec<Event> = path.iter().enumerate().map(at).collect();
        let curve = Curve::begin(folder.path(), &case(), &events).unwrap();
        let found: Vec<String> = text(folder.path())
            .lines()
            .skip(1)
            .map(|l| l.split(',').skip(4).take(2).collect::<Vec<_>>().join(" "))
            .collect();
        // Back at the load factor 0.5 the bonds that are left carry 0.75·0.5/0.25.
        assert_eq!(found, ["0.5 2.0", "0.5 1.5", "1.0 2.0"]);
        assert_eq!(
            curve.loads("t", "load".into()).series[1].points,
            [(0.0, 0.0), (0.5, 2.0), (0.5, 1.5), (1.0, 2.0)]
        );
        curve.draw(folder.path(), &case()).unwrap();
        let words = [("load_curve.svg", "load factor"), ("load_curve.svg", "pull [N]")];
        for (file, words) in words.into_iter().chain([("energy.svg", "energy [N mm]")]) {
            let svg = std::fs::read_to_string(folder.path().join(file)).unwrap();
            assert!(svg.contains(words), "{file}: {words}");
        }
    }
}
