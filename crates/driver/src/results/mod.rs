//! The folder of a run, written state by state; `summary.json` comes last and means that the run is finished. While a body
//! breaks, `restart.bin` is what the run can go on from.

mod any_curve;
mod beam;
mod body;
mod claim;
mod curve;
mod digest;
mod envelope;
mod factor;
mod inputs;
mod path_curve;
mod report;
mod restart;
mod resume;
pub mod stiffness;

use crate::case::Case;
use crate::output::{self, atomic, csv, pvd};
use crate::run::fracture::Restart;
use crate::run::{Advance, ProbeResult, StateResult};
use crate::scene::{INPUTS, Scene};
use crate::summary::Summary;
use any_curve::AnyCurve;
pub(crate) use claim::plain;
pub use claim::{Claim, MARK};
use digest::Digest;
use envelope::Envelope;
use report::Report;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

/// What peristat writes into a folder.
const OWN: [&str; 11] = [
    "case.json",
    INPUTS,
    "fields",
    "fields.pvd",
    "history.csv",
    curve::FILE,
    "envelope.csv",
    "plots",
    report::FILE,
    restart::FILE,
    "summary.json",
];

/// Time between two writes of the restart over the time that one takes: it is to cost no more than a few percent of a run.
const SELDOM: u32 = 20;

/// A results folder being written.
#[derive(Debug)]
pub struct Results {
    folder: PathBuf,
    /// Files of states.
    files: Vec<String>,
    /// Those of their tables and grids, where a run can be resumed.
    digests: Vec<Digest>,
    steps: Vec<(f64, String)>,
    history: Vec<Vec<f64>>,
    envelope: Option<Envelope>,
    curve: Option<AnyCurve>,
    report: Report,
    /// When the restart is worth writing again.
    due: Option<Instant>,
}

/// The first columns of `history.csv`; those of the probes follow.
const HISTORY: [&str; 2] = ["step", "load_factor"];

/// A row of `history.csv`.
fn history_row(index: usize, load_factor: f64, probes: &[ProbeResult]) -> Vec<f64> {
    [index as f64, load_factor].into_iter().chain(probes.iter().map(|p| p.value)).collect()
}

/// A column of a table.
type Column = (&'static str, Vec<f64>);

/// Writes columns as a table.
fn write_table<'a>(file: &Path, columns: impl Iterator<Item = &'a Column>) -> io::Result<()> {
    let columns: Vec<(&str, &[f64])> = columns.map(|(name, values)| (*name, values.as_slice())).collect();
    csv::write(file, &columns)
}

/// Whether every value of a state that a folder would hold is a number.
pub fn finite(result: &StateResult) -> bool {
    let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    finite(&result.record().u)
        && match result {
            StateResult::Beam(result) => beam::fields(result).all(|(_, values)| finite(&values)),
            StateResult::Body(result) => body::finite(result),
        }
}

/// Whether a file is one that was being written when its run was killed.
fn is_leftover(name: &str) -> bool {
    name.starts_with('.') && name.ends_with(".part")
}

/// Removes what was being written in a folder when its run was killed.
pub(crate) fn sweep(folder: &Path) -> io::Result<()> {
    let leftover = names_in(folder)?.into_iter().filter(|name| is_leftover(name));
    leftover.map(|name| folder.join(name)).try_for_each(fs::remove_file)
}

/// Removes an earlier run from a folder, and nothing else.
fn clear(folder: &Path) -> io::Result<()> {
    // The mark of a finished run goes first, so that an interrupted replacement cannot look finished.
    for name in OWN.iter().rev() {
        let path = folder.join(name);
        match path.symlink_metadata() {
            // Where a run writes a file, a folder is somebody else's.
            Ok(data) if data.is_dir() && !claim::is_part(name) => {}
            Ok(data) if data.is_dir() => {
                let own = names_in(&path)?.into_iter().filter(|file| claim::is_of_part(folder, name, file));
                own.map(|file| path.join(file)).try_for_each(fs::remove_file)?;
            }
            Ok(_) => fs::remove_file(&path)?,
            Err(_) => {}
        }
    }
    sweep(folder)
}

/// The table and the grid of a state.
fn fields(index: usize) -> [String; 2] {
    ["csv", "vtu"].map(|extension| format!("fields/{}.{extension}", step_name(index)))
}

/// The first of some files that is not in a folder.
fn lost(folder: &Path, files: impl IntoIterator<Item = String>) -> Option<String> {
    files.into_iter().find(|file| !folder.join(file).is_file())
}

/// Names of what a folder holds.
fn names_in(folder: &Path) -> io::Result<Vec<String>> {
    fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect()
}

impl Results {
    /// Removes an earlier run from a folder and writes `case.json`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn begin(claim: &Claim, scene: &Scene) -> io::Result<Self> {
        let folder = claim.folder();
        clear(folder)?;
        write_case(folder, scene)?;
        claim::PARTS.iter().try_for_each(|part| output::folder::make(&folder.join(part)))?;
        Ok(Self {
            folder: folder.into(),
            files: Vec::new(),
            digests: Vec::new(),
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
        self.files.extend(fields(record.index));
        // Which equilibrium is the last of a body that breaks is known only after it: any may be.
        let is_last = self.curve.is_some() || record.index + 1 == scene.states();
        let is_drawn = is_last || self.report.shows_all();
        let (plots, share) = (is_last.then(|| self.folder.join("plots")), self.report.shown());
        let (probes, figures) = match (scene, result) {
            (Scene::Beam(scene), StateResult::Beam(result)) => {
                beam::write(&self.folder, &name, scene, result, self.envelope.as_mut())?;
                let draw = || beam::draw(plots.as_deref(), scene, result, share);
                (crate::run::beam::probes(scene, result), is_drawn.then(draw).transpose()?)
            }
            (Scene::Body(scene), StateResult::Body(result)) => {
                body::write(&self.folder, &name, scene, result, self.envelope.as_mut())?;
                self.files.extend(scene.lines.iter().map(|line| format!("fields/{name}_{}.csv", line.name)));
                let draw = || body::draw(plots.as_deref(), scene, result);
                (crate::run::body::probes(scene, result), is_drawn.then(draw).transpose()?)
            }
            _ => unreachable!("a scene has results of its own kind"),
        };
        if scene.case().fracture.is_some() {
            for file in fields(record.index) {
                self.digests.push(Digest::of(&self.folder.join(file))?);
            }
        }
        if let Some(figures) = figures {
            self.report.take(record.index, figures);
        }
        self.steps.push(step(scene, record.index, record.load_factor));
        self.history.push(history_row(record.index, record.load_factor, &probes));
        self.write_collection()?;
        self.write_history(&probes)?;
        self.draw_curve(scene.case())?;
        match &self.envelope {
            Some(envelope) if is_last => envelope.write(&self.folder.join("envelope.csv")),
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
            restart::write(&self.folder.join(restart::FILE), &restart(), &self.digests)?;
            let end = Instant::now();
            let pause = (end - begin).saturating_mul(SELDOM);
            self.due = Some(end.checked_add(pause).unwrap_or(end + Duration::from_secs(60)));
        }
        Ok(())
    }

    /// Writes `report.html` and then `summary.json`; there is nothing left to go on with.
    ///
    /// # Errors
    /// The folder cannot be written, or someone has removed what was written into it.
    pub fn finish(self, summary: &Summary, case: &Case) -> io::Result<()> {
        self.draw_curve(case)?;
        if let Some(file) = self.lost() {
            let message = format!("`{file}` was removed while the run went on\nhint: run the case again");
            return Err(io::Error::new(io::ErrorKind::NotFound, message));
        }
        let page = self.report.page(summary, case, self.curve.as_ref());
        crate::output::report::write(&self.folder.join(report::FILE), &page)?;
        let text = serde_json::to_string_pretty(summary)?;
        atomic::write_atomically(&self.folder.join("summary.json"), format!("{text}\n").as_bytes())?;
        match fs::remove_file(self.folder.join(restart::FILE)) {
            Err(error) if error.kind() != io::ErrorKind::NotFound => Err(error),
            _ => Ok(()),
        }
    }

    /// A file of the run that is not there any more.
    fn lost(&self) -> Option<String> {
        let curve = self.curve.as_ref().map(|_| curve::FILE);
        let envelope = self.envelope.as_ref().map(|_| "envelope.csv");
        let tables = ["case.json", "fields.pvd", "history.csv"].into_iter().chain(curve).chain(envelope);
        lost(&self.folder, tables.map(String::from).chain(self.files.iter().cloned()))
    }

    fn draw_curve(&self, case: &Case) -> io::Result<()> {
        match &self.curve {
            Some(curve) => curve.draw(&self.folder.join("plots"), case),
            None => Ok(()),
        }
    }

    fn write_collection(&self) -> io::Result<()> {
        let steps: Vec<(f64, &str)> = self.steps.iter().map(|(t, f)| (*t, f.as_str())).collect();
        pvd::write(&self.folder.join("fields.pvd"), &steps)
    }

    /// Writes the table of states; `probes` are those of any of them.
    fn write_history(&self, probes: &[ProbeResult]) -> io::Result<()> {
        let mut names = HISTORY.to_vec();
        names.extend(probes.iter().map(|p| p.name.as_str()));
        let columns: Vec<Vec<f64>> =
            (0..names.len()).map(|c| self.history.iter().map(|row| row[c]).collect()).collect();
        let columns: Vec<(&str, &[f64])> =
            names.into_iter().zip(&columns).map(|(name, values)| (name, values.as_slice())).collect();
        csv::write(&self.folder.join("history.csv"), &columns)
    }
}

/// First part of the names of the files of a state.
fn step_name(index: usize) -> String {
    format!("step_{index:03}")
}

/// A state in the collection: its time, which is the load factor of a step, the number of a load case or equilibrium; and
/// its file.
fn step(scene: &Scene, index: usize, load_factor: f64) -> (f64, String) {
    let time = if scene.case().steps.is_some() { load_factor } else { index as f64 };
    (time, format!("fields/{}.vtu", step_name(index)))
}

/// Writes `case.json` and the files that it names.
fn write_case(folder: &Path, scene: &Scene) -> io::Result<()> {
    inputs::write(folder, scene)?;
    let case = serde_json::to_string_pretty(scene.case())?;
    atomic::write_atomically(&folder.join("case.json"), format!("{case}\n").as_bytes())
}
