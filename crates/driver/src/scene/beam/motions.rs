//! Free motions, and what acts one way, in words.

use super::frame_layout;
use super::one_way::Origin;
use super::scene::BeamScene;
use crate::diagnostic::{JsonPath, root, tidy};
use peristat_assembly::system::{FreeMotion, PartMotion};

/// Names of members that a message lists, at most.
const MOST_NAMES: usize = 6;

impl BeamScene {
    /// What nothing holds, and how it would move.
    pub(crate) fn describe_motion(&self, motion: &FreeMotion) -> String {
        match &self.frame {
            None => format!("{}: no support or link prevents it", of_lines(self, motion)),
            Some(_) => format!("{}; no support or joint prevents it", of_members(self, motion)),
        }
    }

    /// Where something that acts one way stands in the case.
    pub(crate) fn path_of(&self, origin: Origin) -> JsonPath {
        match origin {
            Origin::Support(number) => self.held[number].path.clone(),
            Origin::Foundation(number) => root("foundation").index(number),
            Origin::Member(number) => frame_layout::path().key("members").index(number),
        }
    }

    /// What it is called.
    pub(crate) fn name_of(&self, origin: Origin) -> String {
        match origin {
            Origin::Support(number) => format!("the support at {}", self.held[number].name),
            Origin::Foundation(_) => "the foundation".into(),
            Origin::Member(number) => {
                let name = self.frame.as_ref().map_or("", |frame| frame.members[number].name.as_str());
                format!("the member `{name}`")
            }
        }
    }

    /// What would hold it.
    pub(crate) fn remedy(&self) -> &'static str {
        match (&self.frame, self.has_axial) {
            (None, false) => {
                "a beam needs at least a deflection and a rotation, or two deflections, held by supports or links"
            }
            (None, true) => {
                "a beam with axial displacements needs `ux` on one support, beside what holds `w` and `phi`"
            }
            (Some(_), _) => {
                "supports must hold `ux`, `uy` and the rotation of the frame, and hinges must not make a mechanism of it"
            }
        }
    }
}

/// `the beam from x = 0 to 1 is free to move along w`; a part is a line, with the ghost points beyond its ends.
fn of_lines(scene: &BeamScene, motion: &FreeMotion) -> String {
    let line = |point: usize| scene.beam.chains()[scene.beam.chain_of(point)].line();
    let parts: Vec<String> = motion
        .parts
        .iter()
        .map(|&[first, last]| {
            let (first, last) = (line(first), line(last));
            format!("x = {} to {}", tidy(first.from), tidy(last.from + last.length))
        })
        .collect();
    let how = motion.moves.first().map(|part| match velocity(scene, part) {
        ([x, _], 0.0) if x != 0.0 => "move along x".to_string(),
        (_, 0.0) => "move along w".to_string(),
        ([_, y], turn) => {
            format!("rotate about x = {}", tidy(clean(part.centre[0] - y / turn, part.centre[0])))
        }
    });
    format!("the beam from {} is free to {}", parts.join(" and from "), how.unwrap_or_default())
}

/// Translation and rotation of a part about its centre.
fn velocity(scene: &BeamScene, part: &PartMotion) -> ([f64; 2], f64) {
    match (scene.has_axial, part.amounts.as_slice()) {
        (true, &[x, y, turn]) => ([x, y], turn),
        (_, &[y, turn]) => ([0.0, y], turn),
        _ => ([0.0; 2], 0.0),
    }
}

/// A value, zero where it is rounding beside another one.
fn clean(value: f64, other: f64) -> f64 {
    if value.abs() < 1e-9 * other.abs() { 0.0 } else { value }
}

/// `move along x`, or `rotate about (1, 2)`.
fn in_the_plane(scene: &BeamScene, part: &PartMotion) -> String {
    let ([x, y], turn) = velocity(scene, part);
    if turn != 0.0 {
        let centre = [part.centre[0] - y / turn, part.centre[1] + x / turn];
        let [a, b] = [clean(centre[0], part.centre[0]), clean(centre[1], part.centre[1])];
        return format!("rotate about ({}, {})", tidy(a), tidy(b));
    }
    match (clean(x, y), clean(y, x)) {
        (_, 0.0) => "move along x".into(),
        (0.0, _) => "move along y".into(),
        (x, y) => {
            let size = x.hypot(y);
            let round = |v: f64| (v / size * 1e6).round() / 1e6;
            format!("move along ({}, {})", round(x), round(y))
        }
    }
}

/// `the members `a` and `b` are free to move along x`; where they move differently, each motion is reported.
fn of_members(scene: &BeamScene, motion: &FreeMotion) -> String {
    let Some(frame) = &scene.frame else { return String::new() };
    let mut groups: Vec<(String, Vec<&str>)> = Vec::new();
    for (&[first, _], part) in motion.parts.iter().zip(&motion.moves) {
        let name = frame.members[scene.beam.chain_of(first)].name.as_str();
        let how = in_the_plane(scene, part);
        match groups.iter_mut().find(|g| g.0 == how) {
            Some(group) => group.1.push(name),
            None => groups.push((how, vec![name])),
        }
    }
    let is = |names: &[&str]| if names.len() == 1 { "is" } else { "are" };
    match groups.as_slice() {
        [(how, names)] => format!("the {} {} free to {how}", members(names), is(names)),
        _ => {
            let all: Vec<&str> = groups.iter().flat_map(|g| g.1.iter().copied()).collect();
            let each: Vec<String> = groups
                .iter()
                .take(MOST_NAMES)
                .map(|(how, names)| format!("{} would {how}", listed(names)))
                .collect();
            format!("the {} are free to move: {}", members(&all), each.join(", "))
        }
    }
}

fn members(names: &[&str]) -> String {
    let s = if names.len() == 1 { "" } else { "s" };
    format!("member{s} {}", listed(names))
}

/// `a`, `b` and `c`, or the first of them and how many there are more.
fn listed(names: &[&str]) -> String {
    let quoted: Vec<String> = names.iter().take(MOST_NAMES).map(|n| format!("`{n}`")).collect();
    if names.len() > MOST_NAMES {
        let rest = names.len() - MOST_NAMES;
        return format!("{} and {rest} other{}", quoted.join(", "), if rest == 1 { "" } else { "s" });
    }
    match quoted.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
