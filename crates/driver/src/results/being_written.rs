//! A results folder while it is written.

use super::any_curve::AnyCurve;
use super::claim::{self, Claim};
use super::digest::Digest;
use super::envelope::Envelope;
use super::files::{clear, fields, lost, step, step_name, write_case};
use super::kept::{FieldFiles, FieldStates};
use super::pictures::write_formats;
use super::report::Report;
use super::restart::Kept;
use super::{beam, body, curve, plate, report, restart};
use crate::case::Case;
use crate::output::{self, atomic, csv, pvd};
use crate::run::{Advance, ProbeResult, Restart, StateResult};
use crate::scene::Scene;
use crate::summary::{Status, Summary};
use std::fs;
use std::io;
use std::path::PathBuf;
use std::time::{Duration, Instant};

/// Time between two writes of the restart over the time that one takes: it is to cost no more than a few percent of a run.
const SELDOM: u32 = 20;

/// A results folder being written.
#[derive(Debug)]
pub struct Results {
    pub(super) folder: PathBuf,
    pub(super) kept: FieldFiles,
    /// Files of states.
    pub(super) files: Vec<String>,
    /// The tables and grids that a run can be resumed with: none that a later state takes the place of.
    pub(super) digests: Vec<Kept>,
    /// Those of the latest state.
    pub(super) latest: Vec<String>,
    /// States in the collection, with their grids.
    pub(super) steps: Vec<(f64, String)>,
    pub(super) history: Vec<Vec<f64>>,
    pub(super) envelope: Option<Envelope>,
    pub(super) curve: Option<AnyCurve>,
    pub(super) report: Report,
    /// When the restart is worth writing again.
    pub(super) due: Option<Instant>,
}

/// The first columns of `history.csv`; those of the probes follow.
pub(super) const HISTORY: [&str; 2] = ["step", "load_factor"];

/// A row of `history.csv`.
pub(super) fn history_row(index: usize, load_factor: f64, probes: &[ProbeResult]) -> Vec<f64> {
    [index as f64, load_factor].into_iter().chain(probes.iter().map(|p| p.value)).collect()
}

/// Whether every value of a state that a folder would hold is a number.
pub fn finite(result: &StateResult) -> bool {
    let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    finite(&result.record().u)
        && match result {
            StateResult::Beam(result) => beam::fields(result).all(|(_, values)| finite(&values)),
            StateResult::Body(result) => body::finite(result),
            StateResult::Plate(result) => plate::finite(result),
        }
}

impl Results {
    /// Removes an earlier run from a folder and writes `case.json`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn begin(claim: &Claim, scene: &Scene, kept: FieldFiles) -> io::Result<Self> {
        let folder = claim.folder();
        clear(folder)?;
        claim.sign()?;
        write_case(folder, scene)?;
        claim::PARTS.iter().try_for_each(|part| output::folder::make(&folder.join(part)))?;
        Ok(Self {
            folder: folder.into(),
            kept,
            files: Vec::new(),
            digests: Vec::new(),
            latest: Vec::new(),
            steps: Vec::new(),
            history: Vec::new(),
            envelope: scene.has_envelope().then(Envelope::default),
            curve: AnyCurve::begin(folder, scene)?,
            report: Report::new(scene),
            due: None,
        })
    }

    /// Writes one state, the values of which must be [`finite`].
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn take(&mut self, scene: &Scene, result: &StateResult) -> io::Result<()> {
        let record = result.record();
        let name = step_name(record.index);
        // Which equilibrium is the last of a body that breaks is known only after it: any may be.
        let is_last = self.curve.is_some() || record.index + 1 == scene.states();
        let is_drawn = is_last || self.report.draws_all();
        let kept = self.kept.of(is_last);
        let (plots, share) = (is_last.then(|| self.folder.join("plots")), self.report.shown());
        let (probes, figures) = match (scene, result) {
            (Scene::Beam(scene), StateResult::Beam(result)) => {
                beam::write(&self.folder, &name, scene, result, (kept, self.envelope.as_mut()))?;
                let draw = || beam::draw(plots.as_deref(), scene, result, share);
                (crate::run::beam::probes(scene, result), is_drawn.then(draw).transpose()?)
            }
            (Scene::Body(scene), StateResult::Body(result)) => {
                body::write(&self.folder, &name, scene, result, (kept, self.envelope.as_mut()))?;
                self.files.extend(scene.lines.iter().map(|line| format!("fields/{name}_{}.csv", line.name)));
                let draw = || body::draw(plots.as_deref(), scene, result);
                (crate::run::body::probes(scene, result), is_drawn.then(draw).transpose()?)
            }
            (Scene::Plate(scene), StateResult::Plate(result)) => {
                plate::write(&self.folder, &name, scene, result, (kept, self.envelope.as_mut()))?;
                self.files.extend(scene.lines.iter().map(|line| format!("fields/{name}_{}.csv", line.name)));
                if !scene.held_lines.is_empty() {
                    self.files.push(format!("fields/{name}{}", plate::TABLE));
                }
                let draw = || plate::draw(plots.as_deref(), scene, result);
                (crate::run::plate::probes(scene, result), is_drawn.then(draw).transpose()?)
            }
            _ => unreachable!("a scene has results of its own kind"),
        };
        self.keep(fields(record.index, kept).collect(), scene)?;
        if let Some(figures) = figures {
            self.report.take(record.index, self.curve.as_ref().map_or(0, AnyCurve::rows), figures);
        }
        if kept.grids {
            self.steps.push(step(scene, record.index, record.load_factor));
        }
        self.history.push(history_row(record.index, record.load_factor, &probes));
        self.write_collection()?;
        self.write_history(&probes)?;
        self.draw_curve(scene.case())?;
        match &self.envelope {
            Some(envelope) if is_last => {
                envelope.write(&self.folder.join("envelope.csv"), scene.case().units)
            }
            _ => Ok(()),
        }
    }

    /// Writes an equilibrium of a body that breaks, and what the run can go on from: at once if it is about to end, else not
    /// so often that it takes a notable part of the time.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn advance(
        &mut self,
        event: Advance<'_>,
        restart: Option<&dyn Fn() -> Restart>,
        ends: bool,
    ) -> io::Result<()> {
        if let Some(curve) = &mut self.curve {
            curve.add(&event)?;
        }
        let Some(restart) = restart else { return Ok(()) };
        let begin = Instant::now();
        if ends || self.due.is_none_or(|due| due <= begin) {
            let kept = (&self.digests[..], &self.report.recorded());
            restart::write(&self.folder.join(restart::FILE), &restart(), kept)?;
            let end = Instant::now();
            let pause = (end - begin).saturating_mul(SELDOM);
            self.due = Some(end.checked_add(pause).unwrap_or(end + Duration::from_secs(60)));
        }
        Ok(())
    }

    /// Writes `report.html` and then `summary.json`; there is nothing left to go on with, but of an interrupted run.
    ///
    /// # Errors
    /// The folder cannot be written, or someone has removed what was written into it.
    pub fn finish(self, summary: &Summary, case: &Case) -> io::Result<()> {
        let is_interrupted = summary.status == Status::Interrupted;
        self.draw_curve(case)?;
        if let Some(envelope) = self.envelope.as_ref().filter(|_| is_interrupted) {
            envelope.write(&self.folder.join("envelope.csv"), case.units)?;
        }
        if let Some(file) = self.lost() {
            let message = format!("`{file}` was removed while the run went on\nhint: run the case again");
            return Err(io::Error::new(io::ErrorKind::NotFound, message));
        }
        write_formats(&self.folder.join("plots"), &case.drawing.formats)?;
        let page = self.report.page(summary, case, (self.curve.as_ref(), &self.history));
        crate::output::report::write(&self.folder.join(report::FILE), &page)?;
        let text = serde_json::to_string_pretty(summary)?;
        atomic::write_atomically(&self.folder.join("summary.json"), format!("{text}\n").as_bytes())?;
        if is_interrupted {
            return Ok(());
        }
        if self.files.is_empty() {
            // One that holds something stays.
            let _ = fs::remove_dir(self.folder.join("fields"));
        }
        match fs::remove_file(self.folder.join(restart::FILE)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        }
    }

    /// A file of the run that is not there any more.
    fn lost(&self) -> Option<String> {
        let curve = self.curve.as_ref().map(|_| curve::FILE);
        let envelope = self.envelope.as_ref().map(|_| "envelope.csv");
        let grids = (!self.steps.is_empty()).then_some("fields.pvd");
        let history = (!self.history.is_empty()).then_some("history.csv");
        let tables = ["case.json"].into_iter().chain(history).chain(grids).chain(curve).chain(envelope);
        lost(&self.folder, tables.map(String::from).chain(self.files.iter().cloned()))
    }

    fn draw_curve(&self, case: &Case) -> io::Result<()> {
        match &self.curve {
            Some(curve) => curve.draw(&self.folder.join("plots"), case),
            None => Ok(()),
        }
    }

    /// Takes the tables and grids of a state; where only the last state has any, those of the one before go.
    fn keep(&mut self, files: Vec<String>, scene: &Scene) -> io::Result<()> {
        if self.kept.states == FieldStates::Last {
            let past = std::mem::take(&mut self.latest);
            self.files.retain(|file| !past.contains(file));
            self.steps.retain(|(_, grid)| !past.contains(grid));
            past.iter().try_for_each(|file| fs::remove_file(self.folder.join(file)))?;
        } else if scene.case().is_traced() {
            for file in &files {
                self.digests.push((file.clone(), Digest::of(&self.folder.join(file))?));
            }
        }
        self.files.extend(files.iter().cloned());
        self.latest = files;
        Ok(())
    }

    pub(super) fn write_collection(&self) -> io::Result<()> {
        if self.steps.is_empty() {
            // One of a run that goes on with other files names grids that are gone.
            return match fs::remove_file(self.folder.join("fields.pvd")) {
                Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
                _ => Ok(()),
            };
        }
        let steps: Vec<(f64, &str)> = self.steps.iter().map(|(t, f)| (*t, f.as_str())).collect();
        pvd::write(&self.folder.join("fields.pvd"), &steps)
    }

    /// Writes the table of states; `probes` are those of any of them.
    pub(super) fn write_history(&self, probes: &[ProbeResult]) -> io::Result<()> {
        let mut names = HISTORY.map(String::from).to_vec();
        names.extend(probes.iter().map(|probe| csv::head(&probe.name, &probe.unit)));
        let columns: Vec<Vec<f64>> =
            (0..names.len()).map(|c| self.history.iter().map(|row| row[c]).collect()).collect();
        let columns: Vec<(&str, &[f64])> =
            names.iter().zip(&columns).map(|(name, values)| (name.as_str(), values.as_slice())).collect();
        csv::write(&self.folder.join("history.csv"), &columns)
    }
}
