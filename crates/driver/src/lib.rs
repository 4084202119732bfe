//! Peridynamic plates of central bonds, orthotropic plates of beam bonds, Timoshenko beams and plane frames, elastic or
//! breaking, from a JSON case to a certified answer.
//!
//! A [`case::Case`] is what a file says; a [`scene::Scene`] is the same with every default resolved and every fault
//! reported; [`run::run`] assembles, factors and solves it and certifies each result. The results
//! folder in [`results`] and the command `peristat` are built on these three.
//!
//! ```
//! let case = r#"{
//!     "title": "Cantilever under a tip load",
//!     "model": { "timoshenko_beam": { "youngs_modulus": 2e11, "poisson_ratio": 0.3,
//!         "section": { "rectangle": { "width": 0.05, "height": 0.05 } }, "bond_law": "exact" } },
//!     "body": { "line": { "length": 1.0, "cells": 96 } },
//!     "supports": [ { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 } ],
//!     "loads": [ { "point": { "at": { "x": 1.0 }, "force": 1000.0 } } ],
//!     "probes": [ { "name": "tip", "at": { "x": 1.0 }, "field": "w" } ]
//! }"#;
//! let solved = peristat::solve_text(case)?;
//! let tip = solved.summary.probes[0].value;
//! // F L³/(3 EI) + F L/(κGA) for this section.
//! assert!((tip - 0.00320624).abs() < 1e-13 * 0.00320624);
//! assert!(solved.summary.states[0].certificate.converged);
//!
//! // Fields by name, one value per point: `points` says where these are, `volumes` how large.
//! let (points, deflection) = (solved.points(), solved.field(0, "w")?);
//! assert_eq!((points.len(), points[96]), (97, [1.0, 0.0, 0.0]));
//! assert_eq!(deflection[96], tip);
//! let missing = solved.field(0, "ux").unwrap_err();
//! assert!(missing.to_string().starts_with("there is no field `ux`; there are w, phi, M, V"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod case;
pub mod diagnostic;
pub mod input;
pub mod memory;
pub mod model;
mod operator;
pub mod output;
pub mod reference;
pub mod results;
pub mod run;
pub mod scene;
mod solved;
pub mod study;
pub mod summary;
pub mod units;
pub mod verify;
mod workers;

pub use operator::Operator;
pub use solved::{FieldError, Solved};

use diagnostic::{Diagnostic, Faults, Report, Severity};
use input::{Folder, Reach};
use peristat_solve::Ranks;
use run::{Advance, Restart, RunError, RunOptions, RunReport, Sink, StateResult, taking};
use scene::Scene;
use std::io;
use std::path::Path;
use study::TaskFaults;
use summary::{Collector, Summary};
use thiserror::Error;

/// Why a case has no result.
#[derive(Debug, Error)]
pub enum Error {
    /// The case is at fault.
    #[error("{0}")]
    Case(Report),
    /// The case needs more memory than is allowed, or has no factor.
    #[error("{0}")]
    Run(RunError),
    /// Some tasks of a study cannot be solved.
    #[error("{0}")]
    Tasks(TaskFaults),
    /// A file cannot be written.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl Error {
    /// Whether the case could be solved with more memory.
    pub fn lacks_memory(&self) -> bool {
        match self {
            Self::Case(report) => report.diagnostics.iter().any(|d| d.lacks_memory),
            Self::Run(error) => matches!(error, RunError::Memory { .. }),
            Self::Tasks(_) | Self::Io(_) => false,
        }
    }
}

impl From<Report> for Error {
    fn from(report: Report) -> Self {
        Self::Case(report)
    }
}

/// Reads a case from a text and solves it, with all fields recovered.
///
/// # Errors
/// [`enum@Error`] with the place of the fault.
pub fn solve_text(text: &str) -> Result<Solved, Error> {
    let source = case::from_text("case", text.into(), &[], &Folder::default()).map_err(Error::Case)?;
    let loaded = Loaded::from_source(source, Folder::default(), None)?;
    loaded.solve(&RunOptions { recover: true, max_memory: None, compare: true })
}

/// A scene with the text it came from.
#[derive(Debug)]
pub struct Loaded {
    /// The scene.
    pub scene: Scene,
    /// The case as its author wrote it.
    pub(crate) written: case::Case,
    /// Folder of the files that it names.
    pub(crate) folder: Folder,
    pub(crate) file: String,
    pub(crate) text: String,
}

impl Loaded {
    /// Reads a case file, applies overrides `path=value`, and resolves it within a limit on memory, bytes; without one it
    /// may use what the machine has. Files that the case names must lie in its folder, or below.
    ///
    /// # Errors
    /// [`Error::Case`] with all faults.
    pub fn read(path: &Path, overrides: &[String], max_memory: Option<u64>) -> Result<Self, Error> {
        let folder = Folder::of(path, Reach::Inside);
        let source = case::read(path, overrides, &folder, max_memory).map_err(Error::Case)?;
        Self::from_source(source, folder, max_memory)
    }

    /// The same of a case that is read; `folder` is where files that it names are looked for.
    pub fn from_source(source: case::Source, folder: Folder, max_memory: Option<u64>) -> Result<Self, Error> {
        let case::Source { case, file, text } = source;
        let written = case.clone();
        let scene = Scene::new(case, &folder, &file, &text, max_memory).map_err(Error::Case)?;
        Ok(Self { scene, written, folder, file, text })
    }

    /// The error of a run with the place in the case, where it is the case's fault.
    pub fn explain(&self, error: RunError) -> Error {
        match error {
            RunError::Case(faults) => Error::Case(faults.into_report(&self.file, &self.text)),
            RunError::Sink(error) => Error::Io(error),
            other => Error::Run(other),
        }
    }

    /// Warnings on the case, ready to be shown; `None` if there are none.
    pub fn warnings(&self) -> Option<Report> {
        let mut report = self.scene.warnings().clone().into_report(&self.file, &self.text);
        report.diagnostics.retain(|d| d.severity == Severity::Warning);
        (!report.diagnostics.is_empty()).then_some(report)
    }

    /// Solves every state and keeps all results, with their fields where `options` ask for these.
    ///
    /// # Errors
    /// As [`Loaded::run`].
    pub fn solve(self, options: &RunOptions) -> Result<Solved, Error> {
        let mut states = Vec::new();
        let mut push = taking(|result| {
            states.push(result);
            Ok(())
        });
        let summary = self.run(options, None, &mut push)?;
        drop(push);
        Ok(Solved { scene: self.scene, summary, states })
    }

    /// Solves every state; `sink` gets each result as it comes. A body that breaks or softens goes on from `resume`.
    ///
    /// # Errors
    /// [`enum@Error`]; a failed check or a state that did not converge is an outcome, not an error.
    pub fn run(
        &self,
        options: &RunOptions,
        resume: Option<Restart>,
        sink: &mut dyn Sink,
    ) -> Result<Summary, Error> {
        let collector = match &resume {
            Some(restart) => Collector::restore(&self.scene, &restart.summaries).map_err(io::Error::from)?,
            None => Collector::default(),
        };
        let fingerprint = if self.scene.case().is_traced() {
            self.scene.fingerprint().map_err(io::Error::from)?
        } else {
            String::new()
        };
        let mut collecting = Collecting { scene: &self.scene, fingerprint, collector, sink };
        let report = run::run(&self.scene, options, resume, &mut collecting).map_err(|e| self.explain(e))?;
        Ok(self.summarise(collecting.collector, report))
    }

    /// As [`Loaded::run`], by several processes of which this is the first; the others do [`run::body::follow`].
    ///
    /// # Errors
    /// As [`Loaded::run`], and [`RunError::NotShared`] for cases that cannot be solved so.
    pub fn run_on(
        &self,
        ranks: &dyn Ranks,
        options: &RunOptions,
        sink: &mut dyn Sink,
    ) -> Result<Summary, Error> {
        let (collector, fingerprint) = (Collector::default(), String::new());
        let mut collecting = Collecting { scene: &self.scene, fingerprint, collector, sink };
        let mut take = |result| collecting.take(StateResult::Body(result));
        let report =
            run::body::run_on(ranks, &self.scene, options, &mut take).map_err(|e| self.explain(e))?;
        Ok(self.summarise(collecting.collector, report))
    }

    /// The summary of a run.
    fn summarise(&self, collector: Collector, report: RunReport) -> Summary {
        let mut warnings = warning_texts(self.scene.warnings(), &self.file);
        warnings.extend(warning_texts(&report.warnings, &self.file));
        collector.finish(&self.scene, report, warnings)
    }
}

/// A sink that keeps what the summary needs of each result before it hands it on, and adds it to every restart.
struct Collecting<'a> {
    scene: &'a Scene,
    fingerprint: String,
    collector: Collector,
    sink: &'a mut dyn Sink,
}

impl Sink for Collecting<'_> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        self.collector.take(self.scene, &result);
        let is_last = result.record().index + 1 == self.scene.states();
        self.sink.take(result)?;
        // One that breaks or softens asks between its equilibria.
        match self.sink.is_interrupted() && !is_last && !self.scene.case().is_traced() {
            true => Err(io::ErrorKind::Interrupted.into()),
            false => Ok(()),
        }
    }

    fn advance(&mut self, event: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        let Some(restart) = restart else { return self.sink.advance(event, None) };
        let restart =
            || Restart { case: self.fingerprint.clone(), summaries: self.collector.save(), ..restart() };
        self.sink.advance(event, Some(&restart))
    }

    fn is_interrupted(&self) -> bool {
        self.sink.is_interrupted()
    }
}

fn warning_texts(faults: &Faults, file: &str) -> Vec<String> {
    let report = faults.clone().into_report(file, "");
    let warnings = report.diagnostics.iter().filter(|d| d.severity == Severity::Warning);
    let hint = |d: &Diagnostic| d.hint.as_ref().map_or(String::new(), |hint| format!("\nhint: {hint}"));
    warnings.map(|d| format!("{}: {}{}", d.path, d.message, hint(d))).collect()
}
