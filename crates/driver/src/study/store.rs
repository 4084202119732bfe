//! The folder of a study: a file for every finished task, named by its hash, so that it is never solved again.

use super::record::Record;
use crate::output::atomic;
use crate::results::MARK;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// What a study writes beside its tasks.
const OWN: [&str; 6] = [MARK, "tasks", "plots", "study.csv", "study.json", "report.html"];

/// Records of finished tasks.
#[derive(Debug)]
pub struct Store {
    folder: PathBuf,
}

impl Store {
    /// Opens the folder of a study, made if it is not there.
    ///
    /// # Errors
    /// It cannot be made, or holds something that is no study, and `force` is not given.
    pub fn open(folder: &Path, force: bool) -> io::Result<Self> {
        if folder.is_dir() && !force {
            let names = fs::read_dir(folder)?
                .map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned()))
                .collect::<io::Result<Vec<String>>>()?;
            let is_study = names.iter().any(|name| name == MARK);
            let own = |name: &String| is_study && (OWN.contains(&name.as_str()) || name.ends_with(".part"));
            if let Some(name) = names.iter().find(|name| !own(name)) {
                let message = format!(
                    "{} holds `{name}`, which no study wrote\nhint: choose another folder with `-o`, or add `--force`",
                    folder.display()
                );
                return Err(io::Error::new(io::ErrorKind::AlreadyExists, message));
            }
        }
        let describe = |error: io::Error| {
            io::Error::new(error.kind(), format!("cannot write {}: {error}", folder.display()))
        };
        // The mark comes first: what is in a folder without it is not ours.
        fs::create_dir_all(folder).map_err(describe)?;
        fs::write(folder.join(MARK), "results of peristat\n").map_err(describe)?;
        fs::create_dir_all(folder.join("tasks")).map_err(describe)?;
        Ok(Self::at(folder))
    }

    /// The folder of a study, to be read only; it need not be there.
    pub fn at(folder: &Path) -> Self {
        Self { folder: folder.into() }
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    fn file(&self, key: &str) -> PathBuf {
        self.folder.join("tasks").join(format!("{key}.json"))
    }

    /// The record of a task, if it is finished. A file that is no such record counts as none.
    pub fn get(&self, key: &str) -> Option<Record> {
        let record: Record = serde_json::from_slice(&fs::read(self.file(key)).ok()?).ok()?;
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
