//! Many cases, solved for their checks side by side.

mod find;
mod outcome;

pub use outcome::{Found, Outcome, PASSED, SLOW, UNCHECKED};

use crate::input::{Folder, Reach};
use crate::output::folder::below;
use crate::results::{Claim, Writing};
use crate::run::{RunOptions, taking};
use crate::workers::side_by_side;
use crate::{Error, Loaded, case};
use std::collections::{HashMap, HashSet};
use std::io;
use std::path::{Component, Path, PathBuf};
use std::time::Instant;

/// What to verify.
#[derive(Clone, Debug)]
pub struct Request {
    /// Case files, and folders of them.
    pub paths: Vec<PathBuf>,
    /// Whether slow cases are solved, and those in folders of benchmarks.
    pub all: bool,
    /// A folder for the results of every case, below it; none are written without one.
    pub output: Option<PathBuf>,
    /// Whether results replace those of earlier runs.
    pub force: bool,
    /// Cases that are solved at the same time; as many as there are cores if not given.
    pub threads: Option<u16>,
    /// Largest memory of a case, bytes.
    pub max_memory: Option<u64>,
    /// How far the files may lie that cases name.
    pub reach: Reach,
}

/// Makes the checks of all cases; their outcomes come in the order of the files. `is_interrupted` is asked before each.
///
/// # Errors
/// A path is not there, or two cases would have their results in one folder.
pub fn verify(request: &Request, is_interrupted: &(dyn Fn() -> bool + Sync)) -> io::Result<Vec<Outcome>> {
    let mut files = Vec::new();
    for path in &request.paths {
        find::collect(path, request.all, &mut files)?;
    }
    let mut known = HashSet::new();
    files.retain(|file| known.insert(file.clone()));
    if request.output.is_some() {
        apart(&files)?;
    }
    let outcome = |k: usize| (!is_interrupted()).then(|| outcome(&files[k], request));
    Ok(side_by_side(request.threads, files.len(), outcome).into_iter().flatten().collect())
}

/// The path of a case without its root and its steps upwards, so that results stay in the folder that was asked for.
fn inside(case: &Path) -> PathBuf {
    let case = case.with_extension("");
    case.components().filter(|c| matches!(c, Component::Normal(_))).collect()
}

/// Whether no two cases would have their results in one folder.
fn apart(files: &[PathBuf]) -> io::Result<()> {
    let mut folders: HashMap<PathBuf, &PathBuf> = HashMap::new();
    for path in files {
        if let Some(other) = folders.insert(inside(path), path) {
            let message = format!(
                "{} and {} would have their results in one folder\nhint: verify them one by one, into folders of their own",
                other.display(),
                path.display()
            );
            return Err(io::Error::new(io::ErrorKind::InvalidInput, message));
        }
    }
    Ok(())
}

fn outcome(case: &Path, request: &Request) -> Outcome {
    let begin = Instant::now();
    let found = found(case, request).unwrap_or_else(Found::Fault);
    Outcome { case: case.into(), seconds: begin.elapsed().as_secs_f64(), found }
}

/// Solves a case. Of files that nobody named, slow cases and those that are none are skipped.
fn found(file: &Path, request: &Request) -> Result<Found, Error> {
    let named = request.paths.iter().any(|path| path == file);
    let max_memory = request.max_memory;
    if let Some(other) = find::other_than_case(file, max_memory).filter(|_| !named) {
        return Ok(Found::Skipped(other));
    }
    let folder = Folder::of(file, request.reach);
    let source = case::read(file, &[], &folder, max_memory)?;
    let loaded = Loaded::from_source(source, folder, max_memory)?;
    if loaded.scene.case().slow && !request.all && !named {
        return Ok(Found::Skipped(SLOW));
    }
    let options = RunOptions { recover: request.output.is_some(), max_memory, compare: true };
    let summary = match &request.output {
        Some(folder) => {
            let claim = Claim::new(&below(folder, &inside(file))?, request.force, None)?;
            let mut writing = Writing::new(&loaded.scene, claim);
            let summary = loaded.run(&options, None, &mut writing)?.measured();
            writing.finish(&summary)?;
            summary
        }
        None => loaded.run(&options, None, &mut taking(|_| Ok(())))?,
    };
    Ok(Found::Solved(Box::new(summary)))
}
