//! `curve.csv`: every equilibrium of a body that breaks, and diagrams of them.

use crate::case::Units;
use crate::output::atomic;
use crate::output::plot::{self, Diagram, Series, Style};
use crate::run::fracture::Event;
use std::fmt::Write as _;
use std::fs::{File, OpenOptions};
use std::io::{self, Write};
use std::path::Path;

/// Name of the table.
pub(super) const FILE: &str = "curve.csv";

const HEADER: &str = "step,solve,load_factor,load,envelope,broken_now,broken,islands,work,stored,released,bond_energy,\
    unstable_release,balance,iterations,factorisations,residual\n";

/// The table, open, with all of its rows.
#[derive(Debug)]
pub(super) struct Curve {
    file: File,
    events: Vec<Event>,
    envelope: f64,
}

impl Curve {
    /// Writes the table of the equilibria so far, and keeps it open for those to come.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn begin(folder: &Path, events: &[Event]) -> io::Result<Self> {
        let path = folder.join(FILE);
        let (mut text, mut envelope) = (HEADER.to_string(), 0.0);
        for event in events {
            envelope = widened(envelope, event.load);
            text.push_str(&row(event, envelope));
        }
        atomic::write_atomically(&path, text.as_bytes())?;
        let file = OpenOptions::new().append(true).open(&path)?;
        Ok(Self { file, events: events.to_vec(), envelope })
    }

    /// Adds an equilibrium.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn add(&mut self, event: &Event) -> io::Result<()> {
        self.envelope = widened(self.envelope, event.load);
        self.events.push(*event);
        // One write, so that a reader finds whole rows.
        self.file.write_all(row(event, self.envelope).as_bytes())
    }

    /// Draws the load over the load factor, and the energies over the equilibria.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn draw(&self, plots: &Path, title: &str, units: Units) -> io::Result<()> {
        if self.events.is_empty() {
            return Ok(());
        }
        plot::write(&plots.join("load_curve.svg"), &self.loads(title))?;
        plot::write(&plots.join("energy.svg"), &self.energies(title, units))
    }

    fn loads(&self, title: &str) -> Diagram {
        let points: Vec<(f64, f64)> = self.events.iter().map(|e| (e.load_factor, e.load)).collect();
        let mut largest = 0.0;
        let grows = |p: &&(f64, f64)| {
            let before = largest;
            largest = widened(before, p.1);
            before != largest
        };
        let envelope: Vec<(f64, f64)> = points.iter().filter(grows).copied().collect();
        let series = vec![
            Series { label: "equilibria".into(), style: Style::Thin, points },
            Series { label: "envelope".into(), style: Style::Line, points: envelope },
        ];
        Diagram { title: title.into(), x_label: "load factor".into(), y_label: "load".into(), series }
    }

    fn energies(&self, title: &str, units: Units) -> Diagram {
        let series = |label: &str, of: fn(&Event) -> f64| {
            let points = self.events.iter().map(|e| (e.solve as f64, of(e))).collect();
            Series { label: label.into(), style: Style::Line, points }
        };
        Diagram {
            title: title.into(),
            x_label: "equilibrium".into(),
            y_label: format!("energy [{}]", units.moment()),
            series: vec![
                series("work", |e| e.work),
                series("stored", |e| e.stored),
                series("released", |e| e.released),
            ],
        }
    }
}

/// The load of the largest magnitude so far.
fn widened(envelope: f64, load: f64) -> f64 {
    if load.abs() > envelope.abs() { load } else { envelope }
}

fn row(event: &Event, envelope: f64) -> String {
    let e = event;
    let mut row = format!("{},{},{:?},{:?},{envelope:?}", e.step, e.solve, e.load_factor, e.load);
    let _ = write!(row, ",{},{},{}", e.broken_now, e.broken, e.islands);
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

    fn text(folder: &Path) -> String {
        std::fs::read_to_string(folder.join(FILE)).unwrap()
    }

    #[test]
    fn rows_are_there_at_once_and_a_table_goes_on_from_any_of_them() {
        let folder = tempfile::tempdir().unwrap();
        let events = [event(0, 0.1), event(1, 0.30000000000000004), event(2, 0.2)];
        let mut curve = Curve::begin(folder.path(), &[]).unwrap();
        for (k, event) in events.iter().enumerate() {
            curve.add(event).unwrap();
            assert_eq!(text(folder.path()).lines().count(), k + 2);
        }
        let whole = text(folder.path());
        let columns: Vec<_> = whole.lines().map(|line| line.split(',').count()).collect();
        assert_eq!(columns, [17; 4]);
        let last = "0,2,0.6666666666666666,0.2,0.30000000000000004,0,2,0,0.1,0.0,0.0,0.0,0.0,0.0,0,0,0.0";
        assert_eq!(whole.lines().last(), Some(last));
        let mut again = Curve::begin(folder.path(), &events[..1]).unwrap();
        events[1..].iter().for_each(|event| again.add(event).unwrap());
        assert_eq!(text(folder.path()), whole);
    }

    #[test]
    fn the_envelope_is_the_largest_load_so_far_whatever_its_sign() {
        let folder = tempfile::tempdir().unwrap();
        let loads = [-1.0, -3.0, -2.0, -3.5];
        let events: Vec<Event> = loads.iter().enumerate().map(|(k, load)| event(k, *load)).collect();
        let curve = Curve::begin(folder.path(), &events).unwrap();
        let envelope: Vec<String> =
            text(folder.path()).lines().skip(1).map(|l| l.split(',').nth(4).unwrap().into()).collect();
        assert_eq!(envelope, ["-1.0", "-3.0", "-3.0", "-3.5"]);
        let drawn = &curve.loads("t").series[1].points;
        assert_eq!(drawn.iter().map(|p| p.1).collect::<Vec<_>>(), [-1.0, -3.0, -3.5]);
        curve.draw(folder.path(), "t", Units::default()).unwrap();
        for (file, words) in [("load_curve.svg", "load factor"), ("energy.svg", "energy [N m]")] {
            let svg = std::fs::read_to_string(folder.path().join(file)).unwrap();
            assert!(svg.contains(words), "{file}");
        }
    }
}
