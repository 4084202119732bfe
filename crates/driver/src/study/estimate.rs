//! The discretisation error of one run, from the same case on other spacings.

use super::judge::{Other, from_exact, of_quantities};
use super::record::{of_exact, quantities};
use crate::case::{self, Body};
use crate::model::Growth;
use crate::run::{RunOptions, taking};
use crate::scene::Scene;
use crate::summary::words::times;
use crate::summary::{Estimates, Grids, Status, Summary};
use crate::{Error, Loaded};
use peristat_assembly::body::Outline;
use peristat_assembly::model::timoshenko_beam::Grid;
use std::time::Instant;

/// Multiples of the spacing of a coarser grid, in the order in which they are tried. In the plane 2 costs a quarter of the
/// run, and 3/2, which is nearer, less than half.
const COARSER: [f64; 4] = [2.0, 1.5, 3.0, 4.0 / 3.0];
/// The same of state-based plates: with the couplings of whole families a factor costs at 3/2 times the spacing, where no
/// lattice is coarser, as much as the run.
const COARSER_OF_FAMILIES: [f64; 4] = [2.0, 3.0, 1.5, 4.0 / 3.0];
/// The same along lines, where the cost is in proportion to the points: with a second one it stays below that of the run.
const COARSER_ON_LINES: [f64; 2] = [2.0, 3.0];
/// Those of a second one, of which an order is observed.
const COARSEST: [f64; 4] = [4.0, 3.0, 6.0, 9.0];
/// The second over the first, at least.
const APART: f64 = 1.5;
/// Points of a body in the plane up to which a run estimates its error without being asked.
const CHEAP: usize = 10_000;

/// What an estimate of discretisation errors may cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum EstimateEffort {
    /// None is made.
    Nothing,
    /// That of coarser grids, where it is cheap.
    Cheap,
    /// That of a finer grid, whatever it costs.
    FromFiner,
}

impl Loaded {
    /// Adds the discretisation errors to the record of a run, or why they are not known.
    pub fn add_estimate(&self, summary: &mut Summary, effort: EstimateEffort, max_memory: Option<u64>) {
        let begin = Instant::now();
        let estimated = match effort {
            EstimateEffort::Nothing => return,
            EstimateEffort::Cheap => self.estimate_cheaply(summary, max_memory),
            EstimateEffort::FromFiner => self.estimate(summary, Grids::FinerAndCoarser, max_memory),
        };
        match estimated {
            Ok(estimates) => summary.estimate = Some(estimates),
            Err(reason) => summary.no_estimate = Some(reason),
        }
        summary.timing_s.estimate = begin.elapsed().as_secs_f64();
    }

    /// Estimates the discretisation error of every probe of a run, and of its energy, as a run does without being asked:
    /// from coarser grids, if the body is a beam, a frame or not large.
    ///
    /// # Errors
    /// Why there is no estimate.
    pub fn estimate_cheaply(&self, summary: &Summary, max_memory: Option<u64>) -> Result<Estimates, String> {
        let points = summary.sizes.points;
        if !self.is_on_lines() && points > CHEAP && !self.scene.case().is_traced() {
            return Err(format!(
                "above {CHEAP} points, here {points}, it is left to `--estimate`, which solves a finer grid, too"
            ));
        }
        self.estimate(summary, Grids::Coarser, max_memory)
    }

    /// Estimates the discretisation error of every probe of a run, and of its energy: the case is solved on other grids
    /// with the same horizon ratio. A finer one has the points of the run among its own; where it needs too much memory,
    /// coarser ones are taken.
    ///
    /// # Errors
    /// Why there is no estimate.
    pub fn estimate(
        &self,
        summary: &Summary,
        grids: Grids,
        max_memory: Option<u64>,
    ) -> Result<Estimates, String> {
        if self.scene.case().is_traced() {
            return Err("bodies that break or soften jump from state to state".into());
        }
        if self.scene.case().is_corrected() {
            return Err(
                "displacements are corrected: the size of the last correction tells what is left".into()
            );
        }
        if self.scene.case().foundation.iter().any(|foundation| foundation.only.is_some()) {
            return Err(
                "the part of a foundation that acts one way changes from grid to grid by whole cells".into(),
            );
        }
        if matches!(summary.status, Status::NotConverged | Status::Interrupted) {
            return Err("a state did not converge".into());
        }
        let exact = of_exact(summary);
        let against = "the local solution, horizon and spacing to zero at the same ratio".into();
        if let Some(exact) = exact.as_ref().filter(|_| self.scene.case().foundation.is_empty()) {
            let all = quantities(summary);
            let quantities = all.iter().filter_map(|own| Some(from_exact(own, *exact.get(&own.name)?)));
            let (kind, spacings) = (Grids::ExactBeam, Vec::new());
            return Ok(Estimates { kind, against, spacings, remark: None, quantities: quantities.collect() });
        }
        let mut others: Vec<Other> = Vec::new();
        let nested = nested(&self.written.body);
        if grids == Grids::FinerAndCoarser {
            match self.at_multiple(1.0 / nested, max_memory) {
                Ok(finer) => others.push(finer),
                Err(Failure::Memory(_)) => {}
                Err(Failure::Other(reason)) => return Err(reason),
            }
        }
        let kind = if others.is_empty() { Grids::Coarser } else { grids };
        let remark = match kind {
            Grids::FinerAndCoarser => self.add_first(&[nested], &mut others, max_memory).err(),
            Grids::Coarser | Grids::ExactBeam => {
                let first = match self.written.model.entry().growth {
                    Growth::Lines => &COARSER_ON_LINES[..],
                    Growth::Families => &COARSER_OF_FAMILIES,
                    Growth::Plane => &COARSER,
                };
                self.add_first(first, &mut others, max_memory)?;
                self.add_first(&COARSEST, &mut others, max_memory).err()
            }
        };
        others.sort_by(|a, b| a.multiple.total_cmp(&b.multiple));
        Ok(Estimates {
            kind,
            against,
            quantities: of_quantities(&quantities(summary), &others, exact.as_ref(), self.turns_inward()),
            spacings: others.iter().map(|other| other.multiple).collect(),
            remark: remark.map(|reason| format!("no order can be observed: {reason}")),
        })
    }

    /// Whether the body has a corner that turns into it.
    fn turns_inward(&self) -> bool {
        match &self.scene {
            Scene::Body(body) => body.outline().is_some_and(Outline::turns_inward),
            Scene::Plate(plate) => plate.turns_inward,
            Scene::Beam(_) => false,
        }
    }

    fn is_on_lines(&self) -> bool {
        matches!(self.written.body, Body::Line(_) | Body::Lines(_) | Body::Frame(_))
    }

    /// Adds the first of some grids that the case has, far enough from those that are there.
    ///
    /// # Errors
    /// Why the first of them is none.
    fn add_first(
        &self,
        multiples: &[f64],
        others: &mut Vec<Other>,
        max_memory: Option<u64>,
    ) -> Result<(), String> {
        let mut first = None;
        let coarsest = others.iter().map(|other| other.multiple).fold(1.0, f64::max);
        let apart = |multiple: &&f64| coarsest == 1.0 || **multiple >= APART * coarsest;
        for &multiple in multiples.iter().filter(apart) {
            match self.at_multiple(multiple, max_memory) {
                Ok(other) => {
                    others.push(other);
                    return Ok(());
                }
                Err(failure) => first = first.or(Some(failure.reason())),
            }
        }
        Err(first.unwrap_or_default())
    }

    /// The same case at a multiple of its spacing and horizon.
    fn at_multiple(&self, multiple: f64, max_memory: Option<u64>) -> Result<Other, Failure> {
        let overrides = self.written.refined(1.0 / multiple).map_err(Failure::Other)?;
        let mut overrides: Vec<String> =
            overrides.iter().map(|(path, value)| format!("{path}={value}")).collect();
        // Checks may name files that fit one spacing only.
        overrides.push("checks=[]".into());
        let solved = case::from_text(&self.file, self.text.clone(), &overrides, &self.folder)
            .map_err(Error::Case)
            .and_then(|source| Loaded::from_source(source, self.folder.clone(), max_memory))
            .and_then(|loaded| {
                loaded.run(
                    &RunOptions { recover: false, max_memory, compare: false },
                    None,
                    &mut taking(|_| Ok(())),
                )
            });
        match solved {
            Ok(summary) if summary.states.iter().all(|state| state.certificate.converged) => {
                Ok(Other::new(multiple, &summary))
            }
            Ok(_) => Err(Failure::Other(format!(
                "at {} times the spacing a state does not converge",
                times(multiple)
            ))),
            Err(error) if error.lacks_memory() => Err(Failure::Memory(error.to_string())),
            Err(Error::Case(report)) => {
                let first = report.diagnostics.first().map_or(String::new(), |d| d.message.clone());
                Err(Failure::Other(format!("at {} times the spacing: {first}", times(multiple))))
            }
            Err(other) => Err(Failure::Other(other.to_string())),
        }
    }
}

/// The smallest whole number of cells into which a cell can be divided so that its point stays one.
fn nested(body: &Body) -> f64 {
    let at_ends = match body {
        Body::Frame(_) => true,
        Body::Line(_) | Body::Lines(_) => body.lines().iter().all(|line| line.grid == Grid::Nodes),
        _ => false,
    };
    if at_ends { 2.0 } else { 3.0 }
}

/// Why another spacing has no values.
enum Failure {
    Memory(String),
    Other(String),
}

impl Failure {
    fn reason(self) -> String {
        match self {
            Self::Memory(reason) | Self::Other(reason) => reason,
        }
    }
}
