//! `report.html`: what a run has found, to be read by people.

mod over_displacement;
mod sections;

use super::any_curve::AnyCurve;
use crate::case::{Case, Units};
use crate::output::plot::{Diagram, Style, thin};
use crate::output::report::{Axis, Badge, Block, Chart, Frames, Look, Page, Series, Tone};
use crate::scene::Scene;
use crate::summary::{Status, Summary};
use sections::Found;
use serde::{Deserialize, Serialize};

/// Name of the file.
pub(super) const FILE: &str = "report.html";

/// States of which all figures, not only maps, are shown, at most: more would be a long list and a large file.
const MOST_STATES: usize = 12;
/// Points of all states that are shown, at most.
const MOST_POINTS: usize = 120_000;
/// Points of a line of a chart that are kept.
const MOST_DRAWN: usize = 1600;

/// What a report keeps of all states.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(super) struct Recorded {
    /// Maps of a body in the plane.
    maps: Frames,
    /// Rows in the table of equilibria, by state.
    rows: Vec<usize>,
}

/// The figures of the states of a run, collected as they come.
#[derive(Debug)]
pub(super) struct Report {
    /// Number of states of which all figures are shown.
    shown: usize,
    /// Whether there are maps, which show all states however many there are.
    has_maps: bool,
    /// Number of a state among those of the summary, and its figures.
    states: Vec<(usize, Vec<Block>)>,
    recorded: Recorded,
}

impl Report {
    /// Of no state yet.
    pub(super) fn new(scene: &Scene) -> Self {
        let states = scene.states();
        // A point of a beam is one in each of its charts, as numbers and not as bytes.
        let cost = match scene {
            Scene::Body(scene) => scene.body().points(),
            Scene::Plate(scene) => scene.body.points(),
            Scene::Beam(scene) => {
                15 * scene.beam.chains().iter().map(|c| c.points).sum::<usize>().min(MOST_DRAWN)
            }
        };
        let is_traced = scene.case().is_traced();
        let all = !is_traced && states <= MOST_STATES && states * cost <= MOST_POINTS;
        let has_maps = match scene {
            Scene::Body(scene) => !scene.body().is_solid(),
            Scene::Plate(_) => true,
            Scene::Beam(_) => false,
        };
        let maps = Frames::new((!is_traced).then_some(states));
        let recorded = Recorded { maps, rows: Vec::new() };
        Self { shown: if all { states } else { 1 }, has_maps, states: Vec::new(), recorded }
    }

    /// Goes on from what was kept of earlier states.
    pub(super) fn resume(scene: &Scene, recorded: Recorded) -> Self {
        Self { recorded, ..Self::new(scene) }
    }

    /// What is kept of the states so far, as there will be a later one.
    pub(super) fn recorded(&self) -> Recorded {
        let mut recorded = self.recorded.clone();
        recorded.maps.settle();
        recorded
    }

    /// How many states share the report.
    pub(super) fn shown(&self) -> usize {
        self.shown
    }

    /// Whether a state is drawn, besides the last one.
    pub(super) fn draws_all(&self) -> bool {
        self.shown > 1 || self.has_maps
    }

    /// Takes the figures of a state, which stands in a row of the table of equilibria; but for its map they replace those of
    /// another one where only one is shown.
    pub(super) fn take(&mut self, state: usize, row: usize, mut figures: Vec<Block>) {
        figures.retain_mut(|figure| match figure {
            Block::Map(map) => {
                self.recorded.maps.take(std::mem::take(map));
                false
            }
            _ => true,
        });
        self.recorded.rows.push(row);
        if self.states.len() == self.shown {
            self.states.remove(0);
        }
        self.states.push((state, figures));
    }

    /// The report of a finished run.
    pub(super) fn page(
        self,
        summary: &Summary,
        case: &Case,
        (curve, history): (Option<&AnyCurve>, &[Vec<f64>]),
    ) -> Page {
        let Recorded { maps, rows } = self.recorded;
        let stride = maps.stride();
        let map = maps.map();
        // Rings on curves follow the states of a map.
        let rows = if map.is_some() { rows } else { Vec::new() };
        let curves = curve.map_or_else(Vec::new, |curve| sections::curves(case, curve, history, &rows));
        let (text, tone) = match summary.status {
            Status::Passed if summary.checks.is_empty() => ("solved", Tone::Good),
            Status::Passed => ("passed", Tone::Good),
            Status::CheckFailed => ("check failed", Tone::Bad),
            Status::NotConverged => ("not converged", Tone::Bad),
            Status::Interrupted => ("interrupted", Tone::Bad),
        };
        Page {
            title: summary.title.clone(),
            about: case.about.clone().unwrap_or_default(),
            badge: Some(Badge { text: text.into(), tone }),
            sections: sections::all(summary, case, curves, Found { map, stride, states: self.states }),
            footer: format!("peristat {}, numbers in {}", summary.version, unit_words(case)),
        }
    }
}

/// The units of a case, spelled for the last line.
fn unit_words(case: &Case) -> String {
    match case.units {
        Units::Dimensionless => "no units".into(),
        units => format!("{}, N and {}", units.length(), units.stress()),
    }
}

/// A diagram as a chart under a title, which may be empty.
pub(super) fn chart(title: &str, diagram: Diagram) -> Chart {
    let series = diagram.series.into_iter().map(|s| Series {
        label: s.label,
        look: match s.style {
            Style::Line => Look::Line,
            Style::Thin => Look::Thin,
            Style::Dots => Look::Dots,
            Style::Dashed => Look::Dashed,
        },
        points: thin(&s.points, MOST_DRAWN),
    });
    Chart {
        title: title.into(),
        x: Axis::linear(diagram.x_label),
        y: Axis { turned: diagram.downwards, ..Axis::linear(diagram.y_label) },
        series: series.collect(),
        ..Chart::default()
    }
}
