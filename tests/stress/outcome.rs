//! Solving a row and weighing what it says of itself.

use crate::stress::row::{Kind, Resultant, Row, Wish};
use peristat::results::{Claim, FieldFiles, Results, finite};
use peristat::run::{RunOptions, StateResult, taking};
use peristat::summary::{Status, Summary};
use peristat::{Error, Loaded};
use serde_json::Value;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::{fmt, io};

/// An error, and the bound that it must keep.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pair {
    pub(crate) what: &'static str,
    pub(crate) error: f64,
    pub(crate) bound: f64,
}

/// Errors and what the certificate says of them.
#[derive(Clone, Debug)]
pub(crate) struct Told {
    /// Errors of what is asked for: displacements, forces, resultant.
    pub(crate) pairs: Vec<Pair>,
    /// Bound of the certificate on displacements.
    pub(crate) certified: f64,
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
    row.files.iter().for_each(|(name, text)| write(&folder.join(name), text));
    match catch_unwind(AssertUnwindSafe(|| told(row, folder))) {
        Ok(Ok(outcome)) => outcome,
        Ok(Err(error)) => Outcome::Refused(reason(&error)),
        Err(_) => Outcome::Lost("panicked".into()),
    }
}

fn write(path: &Path, text: &str) {
    std::fs::write(path, text).expect("a file can be written");
}

/// A solved case: its summary, the values of its probes and its last state.
struct Solved {
    summary: Summary,
    found: Vec<f64>,
    state: StateResult,
}

fn solved(case: &Value, count: usize, folder: &Path, is_written: bool) -> Result<Solved, Error> {
    let path = folder.join("case.json");
    write(&path, &case.to_string());
    let loaded = Loaded::read(&path, &[], Some(MEMORY))?;
    let mut results = match is_written {
        true => Some(Results::begin(
            &Claim::new(&folder.join("results"), true, None)?,
            &loaded.scene,
            FieldFiles::default(),
        )?),
        false => None,
    };
    let options = RunOptions { recover: is_written, max_memory: Some(MEMORY), compare: true };
    let mut last = None;
    let mut sink = taking(|state| {
        if !finite(&state) {
            return Err(io::Error::other("does not fit"));
        }
        results.iter_mut().try_for_each(|r| r.take(&loaded.scene, &state))?;
        last = Some(state);
        Ok(())
    });
    let summary = loaded.run(&options, None, &mut sink)?;
    drop(sink);
    // Those of the last state come last.
    let found: Vec<f64> = summary.probes.iter().map(|p| p.value).collect();
    let found = found[found.len() - count..].to_vec();
    Ok(Solved { summary, found, state: last.expect("a state") })
}

fn told(row: &Row, folder: &Path) -> Result<Outcome, Error> {
    let count = row.truths.len();
    let Solved { summary, found, state } = solved(&row.case, count, folder, row.is_written)?;
    if let Some(k) = found.iter().position(|value| !value.is_finite()) {
        return Ok(Outcome::Lost(format!("probe {k} is {}", found[k])));
    }
    if row.is_written
        && let Some(lost) = not_a_number(&folder.join("results/fields"))?
    {
        return Ok(Outcome::Lost(lost));
    }
    let truths: Vec<f64> = match &row.twin {
        Some(twin) => solved(twin, count, folder, false)?.found,
        None => row.truths.iter().map(|t| t.expected).collect(),
    };
    let certificate = &summary.states.last().expect("a state").certificate;
    let kinds = [
        ("off by", Kind::Displacement, certificate.error + row.known[0]),
        ("forces by", Kind::Force, certificate.strain_error + row.known[1]),
    ];
    let asked = kinds.into_iter().filter(|(_, kind, _)| row.truths.iter().any(|t| t.kind == *kind));
    let pair = |(what, kind, bound)| Pair { what, error: error(row, kind, &truths, &found), bound };
    let mut pairs: Vec<Pair> = asked.map(pair).collect();
    if let Some(resultant) = &row.resultant {
        pairs.push(Pair {
            what: "resultant by",
            error: imbalance(resultant, &state),
            bound: resultant.bound,
        });
    }
    Ok(Outcome::Told(Told {
        pairs,
        certified: certificate.error,
        given: certificate.converged && summary.status != Status::NotConverged,
    }))
}

/// Largest error of the probes of a kind, relative to the largest of their truths.
fn error(row: &Row, kind: Kind, truths: &[f64], found: &[f64]) -> f64 {
    let of_kind = || row.truths.iter().zip(truths.iter().zip(found)).filter(|(t, _)| t.kind == kind);
    let size = of_kind().map(|(t, (truth, _))| (t.unit * truth).abs()).fold(0.0, f64::max);
    // A body that moves freely has no truth, and no answer is right.
    let off = of_kind().map(|(t, (truth, found))| (t.unit * (found - truth)).abs());
    let off = off.fold(0.0, |a: f64, b| if b.is_nan() { f64::INFINITY } else { a.max(b) });
    if off == 0.0 { 0.0 } else { off / size }
}

/// What the reactions of a state lack of the load that is asked for, over its size.
fn imbalance(asked: &Resultant, state: &StateResult) -> f64 {
    let mut force = asked.force.map(|f| f.unwrap_or(0.0));
    let mut moment = asked.moment.unwrap_or(0.0);
    let mut add = |[x, y]: [f64; 2], own: f64, at: [f64; 2]| {
        force = [force[0] + x, force[1] + y];
        moment += own + at[0] * y - at[1] * x;
    };
    match state {
        StateResult::Beam(beam) => {
            for r in &beam.reactions {
                add([r.axial.unwrap_or(0.0), r.force], r.moment, [r.x, 0.0]);
            }
            beam.joint_reactions.iter().for_each(|r| add([r.force_x, r.force_y], r.moment, r.position));
            // Beyond the ends of a grid of cells ghosts take what a support does.
            let has_none = beam.reactions.is_empty() && beam.joint_reactions.is_empty();
            let held = beam.record.certificate.resultants.as_ref().filter(|_| has_none);
            if let Some(held) = held.map(|r| r.reactions) {
                let force = [held.force_x.unwrap_or(0.0), held.force_y.unwrap_or(0.0)];
                add(force, held.moment.unwrap_or(0.0), [0.0; 2]);
            }
        }
        // Rows of the table are beams and bodies.
        StateResult::Plate(_) => {}
        StateResult::Body(plane) => {
            for (k, r) in plane.reactions.iter().enumerate() {
                let centre = r.centre.map(|centre| centre.parts().0).map(|[x, y, _]| [x, y]);
                let at = centre.or(asked.places.get(k).copied()).unwrap_or_default();
                add([r.force_x, r.force_y], r.moment.unwrap_or(0.0), at);
            }
            for mirror in &plane.mirrors {
                let along_x = matches!(mirror.side.as_ref(), "left" | "right");
                add(if along_x { [mirror.force, 0.0] } else { [0.0, mirror.force] }, 0.0, [0.0; 2]);
            }
        }
    }
    let forces = force.into_iter().zip(asked.force).filter_map(|(f, asked)| asked.map(|_| f));
    let all = forces.chain(asked.moment.map(|_| moment / asked.length));
    all.fold(0.0, |a: f64, b| if b.is_nan() { f64::INFINITY } else { a.max(b.abs()) }) / asked.size
}

/// The first value of tables in a folder that is no finite number.
fn not_a_number(folder: &Path) -> io::Result<Option<String>> {
    for entry in std::fs::read_dir(folder)? {
        let path = entry?.path();
        if path.extension().is_none_or(|e| e != "csv") {
            continue;
        }
        let text = std::fs::read_to_string(&path)?;
        let wrong =
            |word: &&str| word.parse().map_or(true, |value: f64| !value.is_finite()) && !word.is_empty();
        if let Some(word) = text.lines().skip(1).flat_map(|line| line.split(',')).find(wrong) {
            return Ok(Some(format!("{} has {word}", path.display())));
        }
    }
    Ok(None)
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
            Self::Told(Told { pairs, given, .. }) => {
                let verdict = if *given { "" } else { "no digits: " };
                let pair = |p: &Pair| format!("{} {:.1e} of {:.1e}", p.what, p.error, p.bound);
                write!(f, "{verdict}{}", pairs.iter().map(pair).collect::<Vec<_>>().join(", "))
            }
        }
    }
}

impl Outcome {
    /// Whether there is an answer.
    pub(crate) fn is_given(&self) -> bool {
        matches!(self, Self::Told(told) if told.given)
    }

    /// What is wrong with it although it is given as right, or is not what is wished for.
    pub(crate) fn lie(&self, wish: Wish) -> Option<String> {
        let is_off = match self {
            Self::Lost(_) => true,
            Self::Told(told) => told.given && told.pairs.iter().any(|p| p.error > p.bound),
            Self::Refused(_) => false,
        };
        let is_unwished = match wish {
            Wish::Honest => false,
            Wish::Answer => !self.is_given(),
            Wish::Refusal => !matches!(self, Self::Refused(_)),
        };
        (is_off || is_unwished).then(|| self.to_string())
    }
}
