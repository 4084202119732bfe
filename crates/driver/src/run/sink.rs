//! Where the results of a run go.

use super::StateResult;
use super::fracture::Event;
use super::path::PathPoint;
use super::restart::Restart;
use std::io;

/// A state in equilibrium that was found on the way.
#[derive(Clone, Copy, Debug)]
pub enum Advance<'a> {
    /// Of a body that breaks.
    Break(&'a Event),
    /// Of a body that softens.
    Path(&'a PathPoint),
}

/// Takes results as they come, one after another, and is asked whether to go on. A result may come from another thread than the one that
/// solves, while that solves the next state: a sink must not wait in a thread pool for what another run with the same lock does.
pub trait Sink: Send {
    /// Takes the result of a state.
    ///
    /// # Errors
    /// The result cannot be taken, for instance written; the run ends with this error. One of the kind
    /// [`io::ErrorKind::Interrupted`] is none: the result is taken, and the run ends after it.
    fn take(&mut self, result: StateResult) -> io::Result<()>;

    /// An equilibrium of a body that breaks or softens was found; `restart` makes what it takes to go on from there, with as many
    /// states as were taken before this call. There is none for the last equilibrium: the run is at its end.
    ///
    /// # Errors
    /// As [`Sink::take`].
    fn advance(&mut self, _event: Advance<'_>, _restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        Ok(())
    }

    /// Whether the run is to end after the current equilibrium or state.
    fn is_interrupted(&self) -> bool {
        false
    }
}

/// A sink of a function that takes each result.
struct Taking<F>(F);

impl<F: FnMut(StateResult) -> io::Result<()> + Send> Sink for Taking<F> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        (self.0)(result)
    }
}

/// A sink that hands every result to a function and is never interrupted.
pub fn taking(take: impl FnMut(StateResult) -> io::Result<()> + Send) -> impl Sink {
    Taking(take)
}
