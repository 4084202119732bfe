//! `report.html`: what a run has found, to be read by people.

mod sections;

use super::any_curve::AnyCurve;
use crate::case::{Case, Units};
use crate::output::plot::{Diagram, Style, thin};
use crate::output::report::{Axis, Badge, Block, Chart, Look, Page, Series, Tone};
use crate::scene::Scene;
use crate::summary::{Status, Summary};

/// Name of the file.
pub(super) const FILE: &str = "report.html";

/// States of which all figures are shown, at most: more would be a long list and a large file.
const MOST_STATES: usize = 12;
/// Points of all states that are shown, at most.
const MOST_POINTS: usize = 120_000;
/// Points of a line of a chart that are kept.
const MOST_DRAWN: usize = 1600;

/// The figures of the states of a run, collected as they come.
#[derive(Debug)]
pub(super) struct Report {
    /// Number of states that are shown.
    shown: usize,
    /// Number of a state among those of the summary, and its figures.
    states: Vec<(usize, Vec<Block>)>,
}

impl Report {
    /// Of no state yet.
    pub(super) fn new(scene: &Scene) -> Self {
        let states = scene.states();
        // A point of a beam is one in each of its charts, as numbers and not as bytes.
        let cost = match scene {
            Scene::Body(scene) => scene.body().points(),
            Scene::Beam(scene) => {
                15 * scene.beam.chains().iter().map(|c| c.points).sum::<usize>().min(MOST_DRAWN)
            }
        };
        let all = !scene.case().is_traced() && states <= MOST_STATES && states * cost <= MOST_POINTS;
        Self { shown: if all { states } else { 1 }, states: Vec::new() }
    }

    /// How many states share the report.
    pub(super) fn shown(&self) -> usize {
        self.shown
    }

    /// Whether a state is shown, besides the last one.
    pub(super) fn shows_all(&self) -> bool {
        self.shown > 1
    }

    /// Takes the figures of a state; they replace those of another one where only one is shown.
    pub(super) fn take(&mut self, state: usize, figures: Vec<Block>) {
        if self.states.len() == self.shown {
            self.states.remove(0);
        }
        self.states.push((state, figures));
    }

    /// The report of a finished run.
    pub(super) fn page(self, summary: &Summary, case: &Case, curve: Option<&AnyCurve>) -> Page {
        let (text, tone) = match summary.status {
            Status::Passed if summary.checks.is_empty() => ("solved", Tone::Good),
            Status::Passed => ("passed", Tone::Good),
            Status::CheckFailed => ("check failed", Tone::Bad),
            Status::NotConverged => ("not converged", Tone::Bad),
        };
        Page {
            title: summary.title.clone(),
            about: case.about.clone().unwrap_or_default(),
            badge: Some(Badge { text: text.into(), tone }),
            sections: sections::all(summary, case, curve, self.states),
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
        y: Axis::linear(diagram.y_label),
        series: series.collect(),
        ..Chart::default()
    }
}
