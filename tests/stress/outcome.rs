//! Solving a row and weighing what it says of itself.

use crate::row::{Kind, Row};
use peristat::results::finite;
use peristat::run::{RunOptions, taking};
use peristat::summary::Status;
use peristat::{Error, Loaded};
use std::path::Path;
use std::{fmt, io};

/// Errors and what the certificate says of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Told {
    /// Error of the displacements, and of the forces where they are probed.
    pub(crate) errors: [f64; 2],
    /// Bounds on both.
    pub(crate) bounds: [f64; 2],
    /// Whether the answer is given.
    pub(crate) given: bool,
}

/// What became of a row.
#[derive(Clone, Debug)]
pub(crate) enum Outcome {
    /// No result, and why.
    Refused(String),
    /// A result.
    Told(Told),
    /// A result that is no number.
    Lost(String),
}

/// Memory that a row may take, bytes.
const MEMORY: u64 = 8_000_000_000;

pub(crate) fn solve(row: &Row, folder: &Path) -> Outcome {
    let path = folder.join("case.json");
    let write = |path: &Path, text: &str| std::fs::write(path, text).expect("a file can be written");
    write(&path, &row.case.to_string());
    row.files.iter().for_each(|(name, text)| write(&folder.join(name), text));
    match told(row, &path) {
        Ok(told) => told,
        Err(error) => Outcome::Refused(reason(&error)),
    }
}

fn told(row: &Row, path: &Path) -> Result<Outcome, Error> {
    let loaded = Loaded::read(path, &[], Some(MEMORY))?;
    let options = RunOptions { recover: false, max_memory: Some(MEMORY) };
    let mut sink = taking(|state| match finite(&state) {
        true => Ok(()),
        false => Err(io::Error::other("does not fit")),
    });
    let summary = loaded.run(&options, None, &mut sink)?;
    let certificate = &summary.states.last().expect("a state").certificate;
    // Those of the last state come last.
    let found: Vec<f64> = summary.probes.iter().map(|p| p.value).collect();
    let found = &found[found.len() - row.truths.len()..];
    if let Some(k) = found.iter().position(|value| !value.is_finite()) {
        return Ok(Outcome::Lost(format!("probe {k} is {}", found[k])));
    }
    let error = |kind: Kind| {
        let of_kind = || row.truths.iter().zip(found).filter(|(t, _)| t.kind == kind);
        let size = of_kind().map(|(t, _)| (t.unit * t.expected).abs()).fold(0.0, f64::max);
        // A body that moves freely has no truth, and no answer is right.
        let off = of_kind().map(|(t, f)| (t.unit * (f - t.expected)).abs());
        let off = off.fold(0.0, |a: f64, b| if b.is_nan() { f64::INFINITY } else { a.max(b) });
        if off == 0.0 { 0.0 } else { off / size }
    };
    Ok(Outcome::Told(Told {
        errors: [Kind::Displacement, Kind::Force].map(error),
        bounds: [certificate.error, certificate.strain_error],
        given: certificate.converged && summary.status != Status::NotConverged,
    }))
}

/// The first line of an error.
fn reason(error: &Error) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    line.trim_start_matches("error: ").to_string()
}

impl fmt::Display for Outcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(why) => write!(f, "refused: {why}"),
            Self::Lost(what) => f.write_str(what),
            Self::Told(Told { errors: [u, s], bounds: [u_bound, s_bound], given }) => {
                let verdict = if *given { "" } else { "no digits: " };
                write!(f, "{verdict}off by {u:.1e} of {u_bound:.1e}, forces by {s:.1e} of {s_bound:.1e}")
            }
        }
    }
}

impl Outcome {
    /// Whether there is an answer.
    pub(crate) fn is_given(&self) -> bool {
        matches!(self, Self::Told(told) if told.given)
    }

    /// What is wrong with it although it is given as right.
    pub(crate) fn lie(&self) -> Option<String> {
        match self {
            Self::Refused(_) => None,
            Self::Lost(what) => Some(what.clone()),
            Self::Told(told) => {
                let exceeds = (0..2).any(|k| told.errors[k] > told.bounds[k]);
                (told.given && exceeds).then(|| self.to_string())
            }
        }
    }
}
