//! What a run gives as it goes.

use crate::background::Stop;
use peristat::results::Writing;
use peristat::run::fracture::Event;
use peristat::run::path::PathPoint;
use peristat::run::{Advance, Restart, RestartFrom, Sink, StateResult};
use pyo3::prelude::*;
use serde::Serialize;
use std::io;
use std::sync::atomic::Ordering;

/// An equilibrium that was found on the way.
#[derive(Clone, Serialize)]
#[serde(untagged)]
pub(crate) enum Equilibrium {
    /// Of a body that breaks.
    Break(Event),
    /// Of a body that softens.
    Path(Box<PathPoint>),
}

impl Equilibrium {
    /// Those before a restart.
    pub(crate) fn before(from: &RestartFrom) -> Vec<Self> {
        match from {
            RestartFrom::Break(kept) => kept.events.iter().copied().map(Self::Break).collect(),
            RestartFrom::Path(kept) => kept.points.iter().cloned().map(|p| Self::Path(Box::new(p))).collect(),
        }
    }

    /// The same as sinks take it.
    pub(crate) fn as_advance(&self) -> Advance<'_> {
        match self {
            Self::Break(event) => Advance::Break(event),
            Self::Path(point) => Advance::Path(point),
        }
    }
}

/// Keeps every state, writes them where a folder is given, and asks Python whether to go on.
pub(crate) struct States<'a> {
    pub(crate) kept: Vec<StateResult>,
    pub(crate) curve: Vec<Equilibrium>,
    pub(crate) writing: Option<Writing<'a>>,
    pub(crate) on_state: Option<Py<PyAny>>,
    pub(crate) stop: &'a Stop,
    /// Whether the run asks after every equilibrium whether to go on; others are ended by an error.
    pub(crate) is_asked: bool,
    /// Whether it was ended so.
    pub(crate) ended: bool,
    /// What a function of Python raised.
    pub(crate) raised: Option<PyErr>,
}

impl States<'_> {
    /// Ends a run that does not ask by itself.
    fn end_if_stopped(&mut self) -> io::Result<()> {
        self.ended = self.is_interrupted() && !self.is_asked;
        if self.ended { Err(io::Error::other("the run was stopped")) } else { Ok(()) }
    }
}

impl Sink for States<'_> {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        self.end_if_stopped()?;
        let record = result.record();
        let (name, load_factor) = (record.name.clone(), record.load_factor);
        if let Some(writing) = &mut self.writing {
            writing.state(&result)?;
        }
        self.kept.push(result);
        let Some(on_state) = self.on_state.as_ref().filter(|_| !self.is_interrupted()) else { return Ok(()) };
        let asked = Python::try_attach(|py| {
            let answer = on_state.call1(py, (name, load_factor))?;
            Ok(answer.is_none(py) || answer.is_truthy(py)?)
        });
        // Without an interpreter nobody is left to wait.
        let answer = asked.unwrap_or(Ok(false));
        match answer {
            Ok(true) => Ok(()),
            Ok(false) => {
                self.stop.store(true, Ordering::Relaxed);
                self.end_if_stopped()
            }
            Err(error) => {
                self.raised = Some(error);
                Err(io::Error::other("`on_state` failed"))
            }
        }
    }

    fn advance(&mut self, event: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        self.curve.push(match event {
            Advance::Break(event) => Equilibrium::Break(*event),
            Advance::Path(point) => Equilibrium::Path(Box::new(point.clone())),
        });
        let ends = self.is_interrupted();
        match &mut self.writing {
            Some(writing) => writing.advance_to(event, restart, ends),
            None => Ok(()),
        }
    }

    fn is_interrupted(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}
