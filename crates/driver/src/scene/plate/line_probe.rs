//! Probes of what supports do to a plate along lines that they hold.

use super::held_line::HeldLine;
use super::restraints::Restraints;
use super::site::Site;
use crate::case::{FieldName, Probe, Reduction};
use crate::diagnostic::{Faults, JsonPath};
use std::collections::BTreeSet;

/// The fields along such lines, and at their ends.
pub(super) const FIELDS: [FieldName; 3] =
    [FieldName::ReactionPerLength, FieldName::ReactionMomentPerLength, FieldName::CornerForce];

/// A place is on a line within this, spacings.
const SAME: f64 = 1e-6;

/// How such a probe is found.
#[derive(Clone, Debug, PartialEq)]
pub enum OnLine {
    /// At a place of a line: its index, and shares of its points.
    At(usize, Vec<(usize, f64)>),
    /// What is made of the values at all points of some lines.
    Reduced {
        /// What is made of them.
        of: Reduction,
        /// Indices of the lines.
        lines: Vec<usize>,
    },
    /// The sum of the forces at ends of lines, by their points.
    Corners(Vec<u32>),
}

/// How a probe is found, and its place in words.
pub(super) fn of(
    probe: &Probe,
    site: &Site,
    (held, lines): (&Restraints, &[HeldLine]),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(OnLine, String)> {
    let (points, words) = match probe.at.is_nowhere() {
        true => ((0..site.nodes.points() as u32).collect(), "the plate".to_string()),
        false => {
            let spot = site.spot(&probe.at, &path.key("at"), "the probe", faults)?;
            (spot.points, spot.words)
        }
    };
    let is_in = |point: &u32| points.binary_search(point).is_ok();
    let own: Vec<usize> = (0..lines.len()).filter(|&line| lines[line].points.iter().all(is_in)).collect();
    if probe.field == FieldName::CornerForce {
        return corners(probe, lines, (&points, words), path, faults);
    }
    let is_whole = probe.at.is_nowhere() || covers(lines, &own, held, &points);
    let own = if is_whole { own } else { Vec::new() };
    let found = match (probe.of, probe.at.x.zip(probe.at.y)) {
        (None, Some((x, y))) => at_place(site, lines, [x, y]),
        (Some(of), None) if !own.is_empty() => Some(OnLine::Reduced { of, lines: own }),
        (None, None) if !own.is_empty() => {
            let message = format!("`{}` is different along {words}", probe.field.name());
            faults.error(path.key("at"), message).hint(
                "give `of`: `largest`, `smallest`, `mean` or `integral`; or a place on the line by `x` and `y`",
            );
            return None;
        }
        _ => None,
    };
    if found.is_none() {
        let hint = match probe.at.x {
            Some(_) => {
                "give a place on one edge, between its corners, or name the edge by `region` with `of`"
            }
            None => {
                "name edges along x or y that supports hold, or a row of points: elsewhere, as on the steps of other edges, there are forces of points alone, and their sum is `reaction_force`"
            }
        };
        faults.error(path.key("at"), format!("no straight line of points along {words} is held")).hint(hint);
    }
    Some((found?, words))
}

/// Whether some lines have all of the points among some that supports hold.
fn covers(lines: &[HeldLine], own: &[usize], held: &Restraints, points: &[u32]) -> bool {
    let on_lines: BTreeSet<u32> = own.iter().flat_map(|&line| lines[line].points.iter().copied()).collect();
    let supports = held.supports.iter().zip(&held.points).filter(|(support, _)| !support.is_mirror);
    let mut all = supports.flat_map(|(_, points)| points.iter().copied());
    all.all(|point| points.binary_search(&point).is_err() || on_lines.contains(&point))
}

/// Forces at the ends of lines among some points.
fn corners(
    probe: &Probe,
    lines: &[HeldLine],
    (points, words): (&[u32], String),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(OnLine, String)> {
    if probe.of.is_some() {
        faults.error(path.key("of"), "`corner_force` is a sum of forces").hint("leave `of` out");
        return None;
    }
    let ends = lines.iter().flat_map(HeldLine::free_ends);
    let mut ends: Vec<u32> = ends.filter(|end| points.binary_search(end).is_ok()).collect();
    ends.sort_unstable();
    ends.dedup();
    if ends.is_empty() {
        faults
            .error(path.key("at"), format!("no line that a support holds ends at {words}"))
            .hint("give the place of a corner, or a region with corners, such as `all`");
        return None;
    }
    Some((OnLine::Corners(ends), words))
}

/// A place on exactly one line.
fn at_place(site: &Site, lines: &[HeldLine], place: [f64; 2]) -> Option<OnLine> {
    let h = site.nodes.spacing();
    let on = |line: &HeldLine| {
        let [from, to] = line.ends().map(|point| site.nodes.place(point as usize));
        let axis = usize::from(from[0] == to[0]);
        let s = (place[axis] - from[axis]) / h;
        let is_on = (place[1 - axis] - from[1 - axis]).abs() < SAME * h;
        let last = line.points.len() - 1;
        let s = (is_on && s > -SAME && s < last as f64 + SAME).then_some(s)?;
        let lower = (s.floor().max(0.0) as usize).min(last - 1);
        let part = s - lower as f64;
        Some(vec![(lower, 1.0 - part), (lower + 1, part)])
    };
    let mut found = lines.iter().enumerate().filter_map(|(k, line)| Some((k, on(line)?)));
    match (found.next(), found.next()) {
        (Some((line, shares)), None) => Some(OnLine::At(line, shares)),
        _ => None,
    }
}
