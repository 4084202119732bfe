//! From a study to its tasks: cases that differ from the base case by overrides.

use super::check::check;
use super::faults::TaskFaults;
use super::file::{Refine, Study};
use super::refined::{self, Level, Unfit, steps};
use crate::case::{self, Case, Source};
use crate::diagnostic::{Diagnostic, Faults, JsonPath, Report, case_for_study, decode, parse};
use crate::input::{self, Folder, Reach};
use crate::memory;
use crate::run::{RunOptions, sizes};
use crate::scene::Scene;
use crate::{Error, Loaded};
use serde_json::{Map, Value};
use std::path::{Path, PathBuf};

/// One case to solve.
#[derive(Clone, Debug)]
pub struct Task {
    /// Number, from 1.
    pub number: usize,
    /// Values that are varied, by their paths.
    pub settings: Map<String, Value>,
    /// Size of the discretisation, over that of the base case or relative to the horizon; what orders are of.
    pub size: Option<f64>,
    /// All overrides of the case file, as `--set` takes them.
    pub overrides: Vec<String>,
    /// What differs from what the study asks for.
    pub remarks: Vec<String>,
    /// Hash of all that the result depends on, hexadecimal.
    pub key: String,
    /// The case.
    pub source: Source,
}

impl Task {
    /// Whether it can be solved: its case is resolved and put together, without a solution. `folder` is where files that the
    /// case names are.
    ///
    /// # Errors
    /// Faults of the case, or that it needs more memory than it may use.
    pub fn check(&self, folder: &Folder, max_memory: Option<u64>) -> Result<(), Error> {
        let loaded = Loaded::from_source(self.source.clone(), folder.clone(), max_memory)?;
        let options = RunOptions { recover: false, max_memory, compare: false };
        sizes(&loaded.scene, &options).map(|_| ()).map_err(|error| loaded.explain(error))
    }
}

/// The tasks of a study.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The study.
    pub study: Study,
    /// Case file of all tasks.
    pub case_file: PathBuf,
    /// Its folder.
    pub folder: Folder,
    /// Tasks, those of a series from coarse to fine one after the other.
    pub tasks: Vec<Task>,
}

/// Memory of a task per byte of its case: its text with overrides, and what is made of it.
const PER_BYTE: f64 = 6.0;

impl Plan {
    /// Reads a study and makes its tasks; `overrides` of the command line come behind those of the study, `reach` is how far
    /// its base case may lie, and the files that this one names.
    ///
    /// # Errors
    /// All faults of the study, or those of all its tasks whose case cannot be read.
    pub fn read(file: &Path, overrides: &[String], reach: Reach) -> Result<Self, Error> {
        let name = file.display().to_string();
        let bytes = input::file::read(file, None).map_err(|refusal| {
            let message = match file.is_dir() {
                true => "this is a folder, not a study".into(),
                false => format!("the study {}", refusal.reason),
            };
            let mut diagnostic = Diagnostic::error(JsonPath::default(), message);
            diagnostic.hint = refusal.hint.map(Into::into);
            Report::of(&name, String::new(), diagnostic)
        })?;
        Self::from_text(file, decode(&name, bytes)?, None, overrides, reach)
    }

    /// The same of the text of a study; `file` is what messages call it and what paths are relative to, and `base` the text of the base
    /// case if it is not to be read.
    ///
    /// # Errors
    /// As [`Plan::read`].
    pub fn from_text(
        file: &Path,
        text: String,
        base: Option<String>,
        overrides: &[String],
        reach: Reach,
    ) -> Result<Self, Error> {
        let name = file.display().to_string();
        let study: Study = parse(&name, &text).map_err(|report| case_for_study(&name, &text, report))?;
        let mut faults = Faults::default();
        let series = check(&study, &mut faults);
        if faults.has_errors() {
            return Err(faults.into_report(name, text).into());
        }
        let case_file = file.parent().unwrap_or(Path::new("")).join(&study.case);
        let base = base.map_or_else(|| base_of(file, &study, &text, reach), Ok)?;
        let folder = Folder::of(&case_file, reach);
        let levels = study.refine.as_ref().map_or(1, |refine| steps(refine).len());
        let tasks = series.len().saturating_mul(levels);
        let what = format!("{tasks} tasks, each with its case");
        let needed = PER_BYTE * base.len() as f64 * tasks as f64;
        let place = JsonPath::default().key("vary");
        if !memory::fits(needed, (&what, "vary fewer values"), None, place, &mut faults) {
            return Err(faults.into_report(name, text).into());
        }
        let of_refinement = |unfit: Unfit| {
            let mut diagnostic = Diagnostic::error(JsonPath::default().key("refine"), unfit.message);
            diagnostic.hint = unfit.hint;
            Report::of(&name, text.clone(), diagnostic)
        };
        let fixed: Vec<String> = study.set.iter().map(assignment).chain(overrides.iter().cloned()).collect();
        let mut made = Vec::new();
        for settings in series {
            let own = fixed.iter().cloned().chain(settings.iter().map(assignment)).collect();
            for level in levels_of(&study, (&case_file, &folder, &base), own, &of_refinement) {
                let made_of =
                    |level| task((&case_file, &folder), &base, settings.clone(), level, made.len() + 1);
                made.push(level.and_then(made_of));
            }
        }
        let faults = (1..).zip(&made).filter_map(|(k, task)| Some((k, task.as_ref().err()?.clone().into())));
        let faults = TaskFaults::new(tasks, faults.collect());
        if !faults.is_empty() {
            return Err(Error::Tasks(faults));
        }
        Ok(Self { study, case_file, folder, tasks: made.into_iter().flatten().collect() })
    }

    /// What differs from what the study asks for, each once.
    pub fn remarks(&self) -> Vec<String> {
        let mut all: Vec<String> = Vec::new();
        for remark in self.tasks.iter().flat_map(|task| &task.remarks) {
            if !all.contains(remark) {
                all.push(remark.clone());
            }
        }
        all
    }

    /// Ranges of tasks that differ by their refinement only, coarse to fine.
    pub fn series(&self) -> impl Iterator<Item = &[Task]> {
        self.tasks.chunk_by(|a, b| a.settings == b.settings && a.size.is_some() && b.size.is_some())
    }
}

/// The levels of a series with overrides of its own, one where nothing is refined, or why it has none.
fn levels_of(
    study: &Study,
    (file, folder, base): (&Path, &Folder, &str),
    own: Vec<String>,
    fault: &dyn Fn(Unfit) -> Report,
) -> Vec<Result<Level, Report>> {
    let Some(refine) = &study.refine else { return vec![Ok(Level::alone(own))] };
    let start = case::from_text(&file.display().to_string(), base.into(), &own, folder);
    let ratio = start.and_then(|source| Ok((ratio_of(refine, &source, folder)?, source.case)));
    let (ratio, case) = match ratio {
        Ok(both) => both,
        Err(report) => return vec![Err(report); steps(refine).len()],
    };
    let with_own = |level: Level| Level { overrides: [own.clone(), level.overrides].concat(), ..level };
    refined::levels(refine, &case, ratio)
        .into_iter()
        .map(|level| level.map(with_own).map_err(fault))
        .collect()
}

/// Horizon over spacing of a base case, where a refinement starts from it: what the case says, or else its model.
fn ratio_of(refine: &Refine, source: &Source, folder: &Folder) -> Result<f64, Report> {
    match (refine, source.case.horizon_ratio) {
        (Refine::DeltaConvergence(_) | Refine::Values(_), _) => Ok(1.0),
        (Refine::MConvergence(_) | Refine::JointConvergence(_), Some(ratio)) if ratio > 0.0 => Ok(ratio),
        (Refine::MConvergence(_) | Refine::JointConvergence(_), _) => {
            let Source { case, file, text } = source.clone();
            Ok(Scene::new(case, folder, &file, &text, None)?.horizon_ratio())
        }
    }
}

/// An override as `--set` takes it.
fn assignment((path, value): (&String, &Value)) -> String {
    format!("{path}={value}")
}

/// The text of the base case of a study.
fn base_of(file: &Path, study: &Study, text: &str, reach: Reach) -> Result<String, Report> {
    let name = file.with_file_name(&study.case).display().to_string();
    match Folder::of(file, reach).read(&study.case, None) {
        Ok(bytes) => decode(&name, bytes),
        Err(refusal) => {
            let mut faults = Faults::default();
            let message = format!("the case {} {}", study.case, refusal.reason);
            let fault = faults.error(JsonPath::default().key("case"), message);
            fault.hint(refusal.hint.unwrap_or("the path is relative to the study"));
            Err(faults.into_report(file.display().to_string(), text))
        }
    }
}

fn task(
    (file, folder): (&Path, &Folder),
    base: &str,
    settings: Map<String, Value>,
    Level { size, overrides, remarks, .. }: Level,
    number: usize,
) -> Result<Task, Report> {
    let source = case::from_text(&file.display().to_string(), base.into(), &overrides, folder)?;
    let key = key(&source.case, folder);
    Ok(Task { number, settings, size, overrides, remarks, key, source })
}

/// Hash of a case without its words, of the files it names, and of the version of this program.
fn key(case: &Case, folder: &Folder) -> String {
    let mut case = case.clone();
    (case.schema, case.about, case.title) = (None, None, String::new());
    let mut hasher = blake3::Hasher::new();
    hasher.update(env!("CARGO_PKG_VERSION").as_bytes());
    hasher.update(serde_json::to_string(&case).unwrap_or_default().as_bytes());
    for file in case.files_mut() {
        // What cannot be read is a fault of the case, told when it is solved.
        hasher.update(&folder.read(file, None).unwrap_or_default());
    }
    hasher.finalize().to_hex()[..32].into()
}
