//! A run that writes its folder.

use super::being_written::{Results, finite};
use super::claim::Claim;
use super::kept::FieldFiles;
use crate::run::{Advance, Restart, Sink, StateResult};
use crate::scene::Scene;
use crate::summary::Summary;
use std::io;

/// A sink that writes a results folder.
#[derive(Debug)]
pub struct Writing<'a> {
    scene: &'a Scene,
    claim: Claim,
    kept: FieldFiles,
    results: Option<Results>,
}

impl<'a> Writing<'a> {
    /// Writes a scene into a folder, where an earlier run stays until the first result.
    pub fn new(scene: &'a Scene, claim: Claim) -> Self {
        Self { scene, claim, kept: FieldFiles::default(), results: None }
    }

    /// The same with other files of fields than all.
    #[must_use]
    pub fn with_fields(self, kept: FieldFiles) -> Self {
        Self { kept, ..self }
    }

    /// Goes on with what is in the folder.
    ///
    /// # Errors
    /// The folder cannot be read or written.
    pub fn resume(&mut self, restart: &Restart) -> io::Result<()> {
        let results = Results::resume(&self.claim, self.scene, restart, self.kept).map_err(|e| self.at(e))?;
        self.results = Some(results);
        Ok(())
    }

    /// Writes the record of the finished run.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn finish(mut self, summary: &Summary) -> io::Result<()> {
        match self.results.take() {
            Some(results) => results.finish(summary, self.scene.case()).map_err(|e| self.at(e)),
            None => Ok(()),
        }
    }

    /// Writes a state.
    ///
    /// # Errors
    /// The folder cannot be written, or a value does not fit into double precision.
    pub fn state(&mut self, result: &StateResult) -> io::Result<()> {
        if !finite(result) {
            return Err(io::Error::new(
                io::ErrorKind::InvalidData,
                "the results do not fit into double precision\nhint: choose units in which all numbers are moderate",
            ));
        }
        let scene = self.scene;
        let written = self.results()?.take(scene, result);
        written.map_err(|e| self.at(e))
    }

    /// Writes an equilibrium as [`Sink::advance`] does; the run ends after it if `ends`.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub fn advance_to(
        &mut self,
        event: Advance<'_>,
        restart: Option<&dyn Fn() -> Restart>,
        ends: bool,
    ) -> io::Result<()> {
        let written = self.results()?.advance(event, restart, ends);
        written.map_err(|e| self.at(e))
    }

    fn at(&self, error: io::Error) -> io::Error {
        io::Error::new(error.kind(), format!("cannot write {}: {error}", self.claim.folder().display()))
    }

    /// What the folder holds, begun if nothing was written yet.
    fn results(&mut self) -> io::Result<&mut Results> {
        let begun = match self.results.take() {
            Some(results) => results,
            None => Results::begin(&self.claim, self.scene, self.kept).map_err(|e| self.at(e))?,
        };
        Ok(self.results.insert(begun))
    }
}

impl Sink for Writing<'_> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        self.state(&result)
    }

    fn advance(&mut self, event: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.advance_to(event, restart, false)
    }
}
