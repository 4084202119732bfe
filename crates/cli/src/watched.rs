//! A run that writes its folder, shows how far it has come, and hears of signals.

use super::interrupt::Interrupt;
use super::progress::Progress;
use peristat::results::Writing;
use peristat::run::{Advance, Restart, Sink, StateResult};
use std::io;

/// A sink that writes a results folder under the eyes of its user.
pub(super) struct Watched<'a> {
    pub(super) writing: Writing<'a>,
    pub(super) progress: Progress,
    pub(super) interrupt: Interrupt,
}

impl Sink for Watched<'_> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        self.writing.take(result)
    }

    fn advance(&mut self, event: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.progress.advance(event);
        self.writing.advance_to(event, restart, self.interrupt.is_asked())
    }

    fn is_interrupted(&self) -> bool {
        self.interrupt.is_asked()
    }
}
