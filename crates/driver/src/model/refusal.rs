//! Why a body cannot be made.

use crate::diagnostic::{Faults, root};
use std::fmt;

/// Why a model cannot make a body.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub struct Refusal {
    /// The reason.
    pub message: String,
    /// What to do about it.
    pub hint: Option<String>,
    /// What of the case is at fault.
    pub at: Place,
}

/// What of a case is at fault where a body cannot be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A key of the model.
    Key(&'static str),
    /// The horizon, by whichever key gives it.
    Horizon,
    /// The body.
    Body,
    /// The critical strains of bonds that break.
    Critical,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.message)?;
        self.hint.as_ref().map_or(Ok(()), |hint| write!(f, "; {hint}"))
    }
}

impl Refusal {
    /// A refusal in the words of an error, whose hint stands behind a semicolon.
    pub(super) fn new(error: &dyn fmt::Display, at: Place) -> Self {
        let text = error.to_string();
        match text.split_once("; ") {
            Some((message, hint)) => Self { message: message.into(), hint: Some(hint.into()), at },
            None => Self { message: text, hint: None, at },
        }
    }

    /// That of a model that there is on lattices alone.
    pub(super) fn needs_lattice(model: &str) -> Self {
        Self {
            message: format!("the model `{model}` needs a body that fills a lattice"),
            hint: Some("use `rectangle` or `outline`".into()),
            at: Place::Body,
        }
    }

    /// The fault of a case, whose model has a name and whose horizon is given by a key.
    pub(crate) fn tell(self, model: &str, horizon_key: &str, faults: &mut Faults) {
        let path = match self.at {
            Place::Key(key) => root("model").key(model).key(key),
            Place::Horizon => root(horizon_key),
            Place::Body => root("body"),
            Place::Critical => root("fracture").key("critical"),
        };
        let fault = faults.error(path, self.message);
        if let Some(hint) = self.hint {
            fault.hint(hint);
        }
    }
}
