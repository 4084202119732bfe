//! Cases and studies as the Python half hands them over.

use peristat::case::{self, Source};
use peristat::input::{Folder, Reach};
use peristat::study::Plan;
use peristat::{Error, Loaded};
use pyo3::prelude::*;
use std::path::PathBuf;

/// A case, or a study.
#[derive(Clone, FromPyObject)]
pub(crate) struct CaseInput {
    /// Its text.
    text: String,
    /// What messages call it; files that it names are relative to it.
    file: PathBuf,
    /// The text of the base case of a study that brings it along.
    base: Option<String>,
    /// `path=value` for each value that is replaced.
    overrides: Vec<String>,
    /// Largest memory, bytes.
    pub(crate) max_memory: Option<u64>,
    /// Whether it may name files outside its folder.
    allow_outside: bool,
}

impl CaseInput {
    fn reach(&self) -> Reach {
        if self.allow_outside { Reach::Anywhere } else { Reach::Inside }
    }

    /// The case as it is read.
    pub(crate) fn read(&mut self) -> Result<Source, Error> {
        let text = std::mem::take(&mut self.text);
        let folder = Folder::of(&self.file, self.reach());
        Ok(case::from_text(&self.file.display().to_string(), text, &self.overrides, &folder)?)
    }

    /// The case that was read, resolved.
    pub(crate) fn resolve(&self, source: Source) -> Result<Loaded, Error> {
        Loaded::from_source(source, Folder::of(&self.file, self.reach()), self.max_memory)
    }

    /// The case, read and resolved.
    pub(crate) fn load(mut self) -> Result<Loaded, Error> {
        let source = self.read()?;
        self.resolve(source)
    }

    /// The plan of the study.
    pub(crate) fn plan(self) -> Result<Plan, Error> {
        let reach = self.reach();
        Plan::from_text(&self.file, self.text, self.base, &self.overrides, reach)
    }
}
