//! A run that writes its folder.

use super::interrupt::Interrupt;
use super::progress::Progress;
use peristat::results::{Claim, Results, finite};
use peristat::run::fracture::Restart;
use peristat::run::{Advance, Sink, StateResult};
use peristat::scene::Scene;
use peristat::summary::Summary;
use std::io;

/// A sink that writes a results folder, shows how far the run has come, and hears of signals.
pub(super) struct Writing<'a> {
    scene: &'a Scene,
    claim: Claim,
    results: Option<Results>,
    progress: Progress,
    interrupt: Interrupt,
}

impl<'a> Writing<'a> {
    /// Writes a scene into a folder, where an earlier run stays until the first result; silent and deaf.
    pub(super) fn new(scene: &'a Scene, claim: Claim) -> Self {
        Self { scene, claim, results: None, progress: Progress::Silent, interrupt: Interrupt::default() }
    }

    /// The same with what goes on beside a run that takes long.
    pub(super) fn watched(self, progress: Progress, interrupt: Interrupt) -> Self {
        Self { progress, interrupt, ..self }
    }

    /// Goes on with what is in the folder.
    ///
    /// # Errors
    /// The folder cannot be read or written.
    pub(super) fn resume(&mut self, restart: &Restart) -> io::Result<()> {
        let results = Results::resume(&self.claim, self.scene, restart).map_err(|e| self.at(e))?;
        self.results = Some(results);
        Ok(())
    }

    /// Writes the record of the finished run.
    ///
    /// # Errors
    /// The folder cannot be written.
    pub(super) fn finish(mut self, summary: &Summary) -> io::Result<()> {
        match self.results.take() {
            Some(results) => results.finish(summary, self.scene.case()).map_err(|e| self.at(e)),
            None => Ok(()),
        }
    }

    fn at(&self, error: io::Error) -> io::Error {
        io::Error::new(error.kind(), format!("cannot write {}: {error}", self.claim.folder().display()))
    }

    /// What the folder holds, begun if nothing was written yet.
    fn results(&mut self) -> io::Result<&mut Results> {
        let begun = match self.results.take() {
            Some(results) => results,
            None => Results::begin(&self.claim, self.scene).map_err(|e| self.at(e))?,
        };
        Ok(self.results.insert(begun))
    }
}

impl Sink for Writing<'_> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        if !finite(&result) {
            return Err(io::Error::new(
                io::ErrorKind::InvalidData,
                "the results do not fit into double precision\nhint: choose units in which all numbers are moderate",
            ));
        }
        let scene = self.scene;
        let written = self.results()?.take(scene, &result);
        written.map_err(|e| self.at(e))
    }

    fn advance(&mut self, event: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.progress.advance(event);
        let ends = self.interrupt.is_asked();
        let written = self.results()?.advance(event, restart, ends);
        written.map_err(|e| self.at(e))
    }

    fn is_interrupted(&self) -> bool {
        self.interrupt.is_asked()
    }
}
