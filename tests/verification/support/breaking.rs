//! Bodies that break, equilibrium by equilibrium.

use peristat::case::from_text;
use peristat::input::Folder;
use peristat::run::fracture::{Event, FractureReport};
use peristat::run::{Advance, Restart, RunOptions, RunReport, Sink, StateResult, run};
use peristat::scene::Scene;
use serde_json::Value;
use std::io;
use std::path::Path;

/// Keeps the equilibria.
#[derive(Default)]
struct Kept(Vec<Event>);

impl Sink for Kept {
    fn take(&mut self, _: StateResult) -> io::Result<()> {
        Ok(())
    }

    fn advance(&mut self, advance: Advance<'_>, _: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        let Advance::Break(event) = advance else { panic!("it breaks") };
        self.0.push(*event);
        Ok(())
    }
}

/// The equilibria of a case that breaks, and what is reported of it.
pub(crate) fn solve(case: &Value) -> (Vec<Event>, RunReport) {
    let source =
        from_text("case", format!("{case:#}"), &[], &Folder::default()).unwrap_or_else(|e| panic!("{e}"));
    let scene = Scene::new(source.case, Path::new("."), "case", &source.text, None);
    let scene = scene.unwrap_or_else(|e| panic!("{e}"));
    let mut kept = Kept::default();
    let report = run(&scene, &RunOptions::default(), None, &mut kept).unwrap_or_else(|e| panic!("{e}"));
    assert!(report.converged);
    (kept.0, report)
}

pub(crate) fn broke(report: &RunReport) -> &FractureReport {
    report.fracture.as_ref().expect("a body that breaks")
}

/// A fact of a body that broke, by its name.
pub(crate) fn fact(report: &RunReport, name: &str) -> f64 {
    broke(report).facts[name].as_f64().expect("a number")
}

/// Largest lack of the balance of work, strain energy and released energy.
pub(crate) fn imbalance(events: &[Event]) -> f64 {
    events.iter().map(|e| e.balance.abs()).fold(0.0, f64::max)
}

/// Largest load factor on the first half of the way of a crack.
pub(crate) fn growing(events: &[Event]) -> f64 {
    let broken = events.last().map_or(0, |event| event.broken);
    let early = events.iter().filter(|event| 5 * event.broken < 3 * broken);
    early.map(|event| event.load_factor).fold(0.0, f64::max)
}
