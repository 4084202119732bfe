//! The folder of a study: a file for every finished task, named by its hash, so that it is never solved again.

use super::plan::Plan;
use super::record::Record;
use crate::input::file;
use crate::output::lock::{Hold, Lock};
use crate::output::{self, atomic};
use crate::results::{MARK, plain, sweep};
use serde_json::Value;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What a study writes beside its tasks.
const OWN: [&str; 6] = [MARK, "tasks", "plots", "study.csv", "study.json", "report.html"];

/// Records of finished tasks.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
    /// Keeps others out for as long as this is there; none of a folder that is only read.
    _mark: Option<Lock>,
}

/// A task that this process solves, and no other one until this is dropped.
#[derive(Debug)]
pub struct Claimed(Lock);

impl Drop for Claimed {
    fn drop(&mut self) {
        // A file that stays is locked by nobody, and is no record.
        let _ = fs::remove_file(self.0.path());
    }
}

impl Store {
    /// Opens the folder of a study, made if it is not there: alone, or together with others that solve other tasks.
    ///
    /// # Errors
    /// It cannot be made, or holds something that is no study, and `force` is not given; others work in it.
    pub fn open(folder: &Path, force: bool, hold: Hold) -> io::Result<Self> {
        if folder.is_dir() && !force {
            let names = fs::read_dir(folder)?
                .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
                .collect::<io::Result<Vec<String>>>()?;
            let is_study = names.iter().any(|name| name == MARK);
            let own = |name: &String| is_study && (OWN.contains(&name.as_str()) || name.ends_with(".part"));
            if let Some(name) = names.iter().find(|name| !own(name)) {
                return refuse(format!(
                    "{} holds `{name}`, which no study wrote\nhint: choose another folder with `-o`, or add `--force`",
                    folder.display()
                ));
            }
        }
        let describe = |error: io::Error| {
            io::Error::new(error.kind(), format!("cannot write {}: {error}", folder.display()))
        };
        // The mark comes first: what is in a folder without it is not ours.
        fs::create_dir_all(folder).map_err(describe)?;
        let Some(mark) = Lock::take(&folder.join(MARK), hold).map_err(describe)? else {
            return refuse(format!(
                "another peristat is writing into {}\nhint: wait until it has ended; with `--task` several share a study",
                folder.display()
            ));
        };
        let parts = ["tasks", "plots"].map(|part| folder.join(part));
        output::folder::make(&parts[0]).map_err(describe)?;
        if hold == Hold::Alone {
            // Nobody else is writing: what is there in part was left when a study was killed.
            let own = parts.iter().filter(|part| part.is_dir() && !part.is_symlink());
            own.map(PathBuf::as_path).try_for_each(sweep).map_err(describe)?;
        }
        Ok(Self { folder: folder.into(), _mark: Some(mark) })
    }

    /// The folder of a study, to be read only; it need not be there.
    pub fn at(folder: &Path) -> Self {
        Self { folder: folder.into(), _mark: None }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether tables of the tasks of a plan may take the place of those that are there: nothing is lost if every task in
    /// those is one of the plan.
    ///
    /// # Errors
    /// They are of another study.
    pub fn admit(&self, plan: &Plan) -> io::Result<()> {
        let tables = file::read(&self.folder.join("study.json"), Some(file::LARGEST_RECORD));
        let Ok(text) = tables else { return Ok(()) };
        let tables: Value = serde_json::from_slice(&text).unwrap_or_default();
        let all = |value: &Value, key: &str| value[key].as_array().cloned().unwrap_or_default();
        let levels = all(&tables, "series").into_iter().flat_map(|series| all(&series, "levels"));
        let other = levels.filter(|level| !plan.tasks.iter().any(|task| level["key"] == task.key)).count();
        if other == 0 {
            return Ok(());
        }
        refuse(format!(
            "{} holds tables of `{}` with {other} tasks that this study has not\n\
             hint: choose another folder with `-o`, or add `--force` to replace the tables; finished tasks stay",
            self.folder.display(),
            plain(tables["title"].as_str().unwrap_or_default()),
        ))
    }

    /// A task to be solved here; `None` if another process solves it.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn claim(&self, key: &str) -> io::Result<Option<Claimed>> {
        let file = self.folder.join("tasks").join(format!(".{key}.lock"));
        let describe = |error: io::Error| {
            io::Error::new(error.kind(), format!("cannot write {}: {error}", file.display()))
        };
        Ok(Lock::take(&file, Hold::Alone).map_err(describe)?.map(Claimed))
    }

    fn file(&self, key: &str) -> PathBuf {
        self.folder.join("tasks").join(format!("{key}.json"))
    }

    /// The record of a task, if it is finished. A file that is no such record counts as none.
    pub fn get(&self, key: &str) -> Option<Record> {
        let record: Record =
            serde_json::from_slice(&file::read(&self.file(key), Some(file::LARGEST_RECORD)).ok()?).ok()?;
        (record.key == key).then_some(record)
    }

    /// Keeps the record of a finished task.
    ///
    /// # Errors
    /// The file cannot be written.
    pub fn put(&self, record: &Record) -> io::Result<()> {
        let text = serde_json::to_string_pretty(record)?;
        let file = self.file(&record.key);
        let describe = |error: io::Error| {
            io::Error::new(error.kind(), format!("cannot write {}: {error}", file.display()))
        };
        atomic::write_atomically(&file, format!("{text}\n").as_bytes()).map_err(describe)
    }
}

fn refuse<T>(message: String) -> io::Result<T> {
    Err(io::Error::new(io::ErrorKind::AlreadyExists, message))
}
