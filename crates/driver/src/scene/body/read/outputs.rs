//! Lines through a body.

use crate::diagnostic::{Faults, root};
use crate::memory;
use crate::scene::body::site::ground::Ground;
use crate::scene::body::site::interpolate::{Interpolation, Weights};
use crate::scene::body::site::regions;
use crate::scene::words;
use std::collections::HashSet;

/// A line along which all fields are written.
#[derive(Clone, Debug)]
pub struct OutputLine {
    /// Name.
    pub name: String,
    /// Positions from end to end.
    pub points: Vec<LinePoint>,
}

/// A position on a line.
#[derive(Clone, Debug)]
pub struct LinePoint {
    /// Distance from the start, m.
    pub s: f64,
    /// Where it is, m.
    pub position: [f64; 3],
    /// Points of the model and their shares; none outside of the body.
    pub weights: Option<Weights>,
}

/// Memory of a position with the shares of the points around it, bytes.
const PER_POSITION: f64 = (size_of::<LinePoint>() + 8 * size_of::<(u32, f64)>()) as f64;

/// Most positions of a line.
const MOST: usize = 100_000;

/// Longest name of a line, bytes: file systems allow 255, of which some are for the number of the step.
const LONGEST: usize = 200;

/// Lines of the case; `number` makes the number in the model of that in the body.
pub(crate) fn lines(
    ground: &Ground,
    interpolation: &Interpolation,
    number: &dyn Fn(u32) -> u32,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Vec<OutputLine> {
    let all: f64 = ground.case.lines.iter().map(|line| line.points.min(MOST) as f64).sum();
    let what = format!("{all:e} positions on lines");
    if !memory::fits(all * PER_POSITION, (&what, "ask for fewer points"), max_memory, root("lines"), faults) {
        return Vec::new();
    }
    let mut names = HashSet::new();
    let mut lines = Vec::new();
    for (k, line) in ground.case.lines.iter().enumerate() {
        let path = root("lines").index(k);
        if !names.insert(&line.name) {
            faults.error(path.key("name"), format!("there are two lines `{}`", line.name));
        }
        if line.name.len() > LONGEST {
            faults
                .error(
                    path.key("name"),
                    format!("a name of {} bytes is too long for a file", line.name.len()),
                )
                .hint(format!("use at most {LONGEST} letters without accents"));
            continue;
        }
        let fits = |c: char| c.is_alphanumeric() || " _-+.".contains(c);
        if line.name.is_empty() || !line.name.chars().all(fits) {
            faults
                .error(path.key("name"), format!("`{}` cannot be part of the name of a file", line.name))
                .hint("use letters, digits, blanks and - _ + .");
        }
        if !(2..=MOST).contains(&line.points) {
            faults.error(
                path.key("points"),
                format!("`points` must be from 2 to {MOST}, found {}", line.points),
            );
            continue;
        }
        let ends = [("from", line.from), ("to", line.to)];
        let ends = ends.map(|(key, end)| regions::position(end, ground.body, path.key(key), faults));
        let [Some(from), Some(to)] = ends else { continue };
        let length = (0..3).map(|k| (to[k] - from[k]).powi(2)).sum::<f64>().sqrt();
        if length == 0.0 {
            faults.error(path.key("to"), "this line has no length: `from` and `to` are the same");
            continue;
        }
        let point = |k: usize| {
            let q = k as f64 / (line.points - 1) as f64;
            let position = [0, 1, 2].map(|c| from[c] + q * (to[c] - from[c]));
            let nearest = ground.point_at(position, &path, "", &mut Faults::default());
            let inside = ground.outline.is_none_or(|o| o.contains([position[0], position[1]]));
            let weights = nearest.filter(|_| inside).map(|p| interpolation.at(position, number(p)));
            LinePoint { s: q * length, position, weights }
        };
        let points: Vec<LinePoint> = (0..line.points).map(point).collect();
        if points.iter().all(|p| p.weights.is_none()) {
            let [from, to] = [from, to].map(|at| words::place(at, ground.body));
            faults.error(path, format!("the line from {from} to {to} does not meet the body"));
            continue;
        }
        lines.push(OutputLine { name: line.name.clone(), points });
    }
    lines
}
