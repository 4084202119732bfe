//! The folder of a run, written state by state; `summary.json` comes last and means that the run is finished.

mod beam;
mod envelope;
mod factor;
mod plane;

use crate::output::{atomic, csv, pvd};
use crate::run::{ProbeResult, StateRecord, StateResult};
use crate::scene::Scene;
use crate::summary::Summary;
use envelope::Envelope;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What peristat writes into a folder.
const OWN: [&str; 7] =
    ["case.json", "fields", "fields.pvd", "history.csv", "envelope.csv", "plots", "summary.json"];

/// A results folder being written.
#[derive(Debug)]
pub struct Results {
    folder: PathBuf,
    steps: Vec<(f64, String)>,
    history: Vec<Vec<f64>>,
    envelope: Option<Envelope>,
}

/// A column of a table.
type Column = (&'static str, Vec<f64>);

/// Writes columns as a table.
fn write_table<'a>(file: &Path, columns: impl Iterator<Item = &'a Column>) -> io::Result<()> {
    let columns: Vec<(&str, &[f64])> = columns.map(|(name, values)| (*name, values.as_slice())).collect();
    csv::write(file, &columns)
}

/// Name of the file that marks a folder as written by peristat.
pub const MARK: &str = ".peristat";

/// Whether a run may write into a folder: it is new, empty, or holds nothing but an earlier run.
///
/// # Errors
/// The folder holds something that peristat did not write, and `force` is not given.
pub fn admit(folder: &Path, force: bool) -> io::Result<()> {
    let foreign = |message: String| Err(io::Error::new(io::ErrorKind::AlreadyExists, message));
    if folder.exists() && !folder.is_dir() {
        return foreign(format!("{} is a file, not a folder", folder.display()));
    }
    if !folder.exists() || force {
        return Ok(());
    }
    let names = names_in(folder)?;
    let marked = names.iter().any(|n| n == MARK);
    let other = names.iter().find(|n| *n != MARK && !(marked && OWN.contains(&n.as_str())));
    let inside = |part: &str, own: &dyn Fn(&str) -> bool| -> io::Result<Option<String>> {
        let path = folder.join(part);
        let found = if path.is_dir() { names_in(&path)?.into_iter().find(|n| !own(n)) } else { None };
        Ok(found.map(|n| format!("{part}/{n}")))
    };
    let found = match other {
        Some(name) => Some(name.clone()),
        None => inside("fields", &|n| n.starts_with("step_"))?.or(inside("plots", &|n| n.ends_with(".svg"))?),
    };
    match found {
        Some(name) => foreign(format!("{} holds `{name}`, which peristat did not write", folder.display())),
        None => Ok(()),
    }
}

/// Whether every value of a state that a folder would hold is a number.
pub fn finite(result: &StateResult) -> bool {
    let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
    finite(&result.record().u)
        && match result {
            StateResult::Beam(result) => beam::fields(result).all(|(_, values)| finite(&values)),
            StateResult::Plane(result) => plane::finite(result),
        }
}

/// Names of what a folder holds.
fn names_in(folder: &Path) -> io::Result<Vec<String>> {
    fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect()
}

impl Results {
    /// Makes the folder, removes an earlier run from it and writes `case.json`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn begin(folder: &Path, scene: &Scene) -> io::Result<Self> {
        fs::create_dir_all(folder)?;
        // The mark of a finished run goes first, so that an interrupted replacement cannot look finished.
        for name in OWN.iter().rev() {
            let path = folder.join(name);
            match path.symlink_metadata() {
                Ok(data) if data.is_dir() => fs::remove_dir_all(&path)?,
                Ok(_) => fs::remove_file(&path)?,
                Err(_) => {}
            }
        }
        fs::write(folder.join(MARK), "results of peristat\n")?;
        let case = serde_json::to_string_pretty(scene.case())?;
        atomic::write_atomically(&folder.join("case.json"), format!("{case}\n").as_bytes())?;
        fs::create_dir(folder.join("fields"))?;
        fs::create_dir(folder.join("plots"))?;
        Ok(Self {
            folder: folder.into(),
            steps: Vec::new(),
            history: Vec::new(),
            envelope: scene.has_envelope().then(Envelope::default),
        })
    }

    /// Writes one state, the values of which must be [`finite`].
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn take(&mut self, scene: &Scene, result: &StateResult) -> io::Result<()> {
        let record = result.record();
        let name = format!("step_{:03}", record.index);
        let is_last = record.index + 1 == scene.states();
        let probes = match (scene, result) {
            (Scene::Beam(scene), StateResult::Beam(result)) => {
                beam::write(&self.folder, &name, scene, result, self.envelope.as_mut())?;
                if is_last {
                    beam::plots::write(&self.folder.join("plots"), scene, result)?;
                }
                crate::run::beam::probes(scene, result)
            }
            (Scene::Plane(scene), StateResult::Plane(result)) => {
                plane::write(&self.folder, &name, scene, result, self.envelope.as_mut())?;
                if is_last {
                    plane::plots::write(&self.folder.join("plots"), scene, result)?;
                }
                crate::run::plane::probes(scene, result)
            }
            _ => unreachable!("a scene has results of its own kind"),
        };
        self.steps.push((step_time(scene, record), format!("fields/{name}.vtu")));
        let steps: Vec<(f64, &str)> = self.steps.iter().map(|(t, f)| (*t, f.as_str())).collect();
        pvd::write(&self.folder.join("fields.pvd"), &steps)?;
        self.write_history(record, &probes)?;
        match &self.envelope {
            Some(envelope) if is_last => envelope.write(&self.folder.join("envelope.csv")),
            _ => Ok(()),
        }
    }

    /// Writes `summary.json`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn finish(self, summary: &Summary) -> io::Result<()> {
        let text = serde_json::to_string_pretty(summary)?;
        atomic::write_atomically(&self.folder.join("summary.json"), format!("{text}\n").as_bytes())
    }

    fn write_history(&mut self, record: &StateRecord, probes: &[ProbeResult]) -> io::Result<()> {
        let mut row = vec![record.index as f64, record.load_factor];
        row.extend(probes.iter().map(|p| p.value));
        self.history.push(row);
        let mut names = vec!["step", "load_factor"];
        names.extend(probes.iter().map(|p| p.name.as_str()));
        let columns: Vec<Vec<f64>> =
            (0..names.len()).map(|c| self.history.iter().map(|row| row[c]).collect()).collect();
        let columns: Vec<(&str, &[f64])> =
            names.into_iter().zip(&columns).map(|(name, values)| (name, values.as_slice())).collect();
        csv::write(&self.folder.join("history.csv"), &columns)
    }
}

/// Time of a state in the collection: the load factor of a step, the number of a load case.
fn step_time(scene: &Scene, record: &StateRecord) -> f64 {
    if scene.case().steps.is_some() { record.load_factor } else { record.index as f64 }
}
