//! Winkler foundations of a scene: springs against deflection on the points above them.

use super::place::{Layout, Place, tidy};
use super::{profile, root, spot};
use crate::case::{Case, Foundation};
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::material::Profile;
use peristat_assembly::model::timoshenko_beam::{TimoshenkoBeam, W};
use peristat_assembly::stiffness::Spring;

/// A foundation under a part of a line.
#[derive(Clone, Debug)]
pub(super) struct Bed {
    /// Line.
    pub(super) chain: usize,
    /// Start and end, in the line's own coordinate.
    pub(super) extent: [f64; 2],
    /// Force per length and deflection, by the distance from the start.
    pub(super) stiffness: Profile,
}

/// The foundations of the case.
pub(super) fn beds(case: &Case, layout: &Layout, faults: &mut Faults) -> Vec<Bed> {
    let each = case.foundation.iter().enumerate();
    each.filter_map(|(k, foundation)| bed(foundation, layout, &root("foundation").index(k), faults)).collect()
}

fn bed(foundation: &Foundation, layout: &Layout, path: &JsonPath, faults: &mut Faults) -> Option<Bed> {
    let (chain, [from, to]) = match layout.frame {
        Some(_) => under_member(foundation, layout, path, faults),
        None => under_line(foundation, layout, path, faults),
    }?;
    if from >= to {
        faults.error(path.key("to"), format!("`to` must be greater than `from`, found {from} to {to}"));
        return None;
    }
    let at = path.key("stiffness");
    let stiffness = foundation.stiffness.clone();
    let fine =
        profile::is_well_formed(&stiffness, &at, faults) && can_carry(&stiffness, to - from, &at, faults);
    fine.then_some(Bed { chain, extent: [from, to], stiffness })
}

/// Line and extent of a foundation under lines.
fn under_line(
    foundation: &Foundation,
    layout: &Layout,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(usize, [f64; 2])> {
    if foundation.member.is_some() {
        faults
            .error(path.key("member"), "`member` is for frames")
            .hint("a foundation under a line has `from` and `to`");
        return None;
    }
    if layout.lines.len() > 1 && (foundation.from.is_none() || foundation.to.is_none()) {
        faults
            .error(path.clone(), "`from` and `to` are needed where the body has several lines")
            .hint("a foundation is under one line");
        return None;
    }
    let from = foundation.from.unwrap_or(layout.lines[0].from);
    let to = foundation.to.unwrap_or(layout.lines[0].to());
    let [start, end] = [(from, "from"), (to, "to")]
        .map(|(x, key)| layout.place(x, &path.key(key), "the end of the foundation", faults));
    let (chain, other) = (start.as_ref().map(Place::chain)?, end.as_ref().map(Place::chain)?);
    if chain != other {
        faults
            .error(path.clone(), format!("a foundation from x = {from} to {to} spans a gap between lines"))
            .hint("give one foundation per line");
        return None;
    }
    Some((chain, [from, to]))
}

/// Member and extent of a foundation under a frame: all of the member if nothing else is said.
fn under_member(
    foundation: &Foundation,
    layout: &Layout,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(usize, [f64; 2])> {
    let frame = layout.frame.as_ref()?;
    let Some(name) = &foundation.member else {
        faults
            .error(path.clone(), "`member` is missing")
            .hint("a foundation is under one member of a frame, by its name");
        return None;
    };
    let chain = spot::member(name, frame, &path.key("member"), faults)?;
    let line = &layout.lines[chain];
    let extent = [foundation.from.unwrap_or(0.0), foundation.to.unwrap_or(line.length)];
    for (key, x) in ["from", "to"].into_iter().zip(extent) {
        if !line.holds(x) {
            faults
                .error(
                    path.key(key),
                    format!("the end of the foundation at x = {x} is off the member `{name}`"),
                )
                .hint(format!("x runs from 0 to {} on this member", tidy(line.length)));
            return None;
        }
    }
    Some((chain, extent))
}

/// A foundation must not push, and must hold something.
fn can_carry(stiffness: &Profile, length: f64, path: &JsonPath, faults: &mut Faults) -> bool {
    let (s, least) = profile::lowest(stiffness, length);
    if least < 0.0 {
        let place = match stiffness.uniform() {
            Some(_) => String::new(),
            None => format!(" at {} from its start", tidy(s)),
        };
        faults.error(
            path.clone(),
            format!("the stiffness of a foundation must not be negative, found {}{place}", tidy(least)),
        );
        return false;
    }
    let carries = profile::places(&[stiffness], length).into_iter().any(|s| stiffness.value(s) > 0.0);
    if !carries {
        faults
            .error(path.clone(), "this foundation has no stiffness anywhere")
            .hint("it is a force per length and deflection, > 0 somewhere between its ends");
    }
    carries
}

/// The springs of foundations: the value at a point times the part of its length that is on the foundation.
pub(super) fn springs(beds: &[Bed], beam: &TimoshenkoBeam) -> Vec<Spring> {
    let mut springs = Vec::new();
    for bed in beds {
        let (chain, [from, to]) = (&beam.chains()[bed.chain], bed.extent);
        let (first, last) = (chain.nearest(from), chain.nearest(to));
        for k in first.saturating_sub(1)..=(last + 1).min(chain.points - 1) {
            let (a, b) = chain.tributary(k);
            let (a, b) = (a.max(from), b.min(to));
            if b <= a {
                continue;
            }
            let x = chain.position(chain.ghosts[0] + k);
            // Beyond the ends of the foundation it has no value at the point itself.
            let at = if x >= a && x <= b { x } else { 0.5 * (a + b) };
            let stiffness = bed.stiffness.value(at - from) * (b - a);
            if stiffness > 0.0 {
                springs.push(Spring { component: W, point: beam.first_real(bed.chain) + k, stiffness });
            }
        }
    }
    springs
}
