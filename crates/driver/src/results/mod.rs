//! The folder of a run, written state by state; `summary.json` comes last and means that the run is finished.

mod columns;
mod frame_plots;
mod plots;

use crate::output::vtu::{CellType, Cells, DataArray, Grid};
use crate::output::{atomic, csv, pvd, vtu};
use crate::run::StateResult;
use crate::scene::Scene;
use crate::summary::Summary;
use columns::{Column, Envelope, all};
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
    envelope: Envelope,
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
    let values = result.fields().iter().filter_map(|&f| all(result, f));
    result.u.iter().all(|u| u.is_finite()) && values.flatten().all(|v| v.is_finite())
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
        let case = serde_json::to_string_pretty(&scene.case)?;
        atomic::write_atomically(&folder.join("case.json"), format!("{case}\n").as_bytes())?;
        fs::create_dir(folder.join("fields"))?;
        fs::create_dir(folder.join("plots"))?;
        Ok(Self {
            folder: folder.into(),
            steps: Vec::new(),
            history: Vec::new(),
            envelope: Envelope::default(),
        })
    }

    /// Writes one state, the values of which must be [`finite`].
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn take(&mut self, scene: &Scene, result: &StateResult) -> io::Result<()> {
        let name = format!("step_{:03}", result.index);
        let (places, fields) = (columns::places(scene, result), columns::fields(result));
        let left = columns::left(scene, result);
        let table: Vec<(&str, &[f64])> =
            places.iter().chain(&fields).chain(&left).map(|(name, v)| (*name, v.as_slice())).collect();
        csv::write(&self.folder.join("fields").join(format!("{name}.csv")), &table)?;
        self.write_grid(&name, &fields, result)?;
        self.steps.push((step_time(scene, result), format!("fields/{name}.vtu")));
        let steps: Vec<(f64, &str)> = self.steps.iter().map(|(t, f)| (*t, f.as_str())).collect();
        pvd::write(&self.folder.join("fields.pvd"), &steps)?;
        self.write_history(scene, result)?;
        if scene.has_envelope {
            self.envelope.widen(result);
        }
        if result.index + 1 == scene.states.len() {
            plots::write(&self.folder.join("plots"), scene, result)?;
            if scene.has_envelope {
                self.write_envelope(&places)?;
            }
        }
        Ok(())
    }

    /// Writes `summary.json`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn finish(self, summary: &Summary) -> io::Result<()> {
        let text = serde_json::to_string_pretty(summary)?;
        atomic::write_atomically(&self.folder.join("summary.json"), format!("{text}\n").as_bytes())
    }

    fn write_grid(&self, name: &str, fields: &[Column], result: &StateResult) -> io::Result<()> {
        let points = columns::positions(result);
        let mut connectivity: Vec<u32> = Vec::new();
        let mut first = 0;
        for line in &result.lines {
            let count = line.x.len() as u32;
            connectivity.extend((first..first + count - 1).flat_map(|p| [p, p + 1]));
            first += count;
        }
        // The displacement as a vector, so that viewers can warp the body by it.
        let displacement: Vec<f64> = result.displacements().flat_map(|[x, y]| [x, y, 0.0]).collect();
        let mut data = vec![DataArray { name: "displacement", components: 3, values: &displacement }];
        data.extend(fields.iter().map(|(name, values)| DataArray { name, components: 1, values }));
        let grid = Grid {
            points: &points,
            cells: &[Cells { cell_type: CellType::Line, connectivity: &connectivity }],
            point_data: &data,
            cell_data: &[],
        };
        vtu::write(&self.folder.join("fields").join(format!("{name}.vtu")), &grid)
    }

    fn write_history(&mut self, scene: &Scene, result: &StateResult) -> io::Result<()> {
        let probes = crate::run::probes(scene, result);
        let mut row = vec![result.index as f64, result.load_factor];
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

    fn write_envelope(&self, places: &[Column]) -> io::Result<()> {
        let bounds = self.envelope.columns();
        let mut table: Vec<(&str, &[f64])> = places.iter().map(|(n, v)| (*n, v.as_slice())).collect();
        table.extend(bounds.iter().map(|(name, v)| (name.as_str(), v.as_slice())));
        csv::write(&self.folder.join("envelope.csv"), &table)
    }
}

/// Time of a state in the collection: the load factor of a step, the number of a load case.
fn step_time(scene: &Scene, result: &StateResult) -> f64 {
    if scene.case.steps.is_some() { result.load_factor } else { result.index as f64 }
}
