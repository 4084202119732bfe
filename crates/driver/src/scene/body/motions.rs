//! Free motions of a body in the plane in words.

use super::scene::BodyScene;
use crate::diagnostic::tidy;
use peristat_assembly::model::{Model, RigidMotion};
use peristat_assembly::system::{FreeMotion, PartMotion};

/// What nothing holds, and how it would move.
pub(crate) fn describe<const D: usize>(
    scene: &BodyScene,
    model: &dyn Model<D>,
    motion: &FreeMotion,
) -> String {
    let (parts, motions) = (model.connected(), model.rigid_motions());
    // Number and sum of the positions of the real points of every part that moves.
    let mut sums = vec![(0_usize, [0.0; 2]); motion.parts.len()];
    let moving: Vec<usize> = motion.parts.iter().map(|span| parts.of(span[0])).collect();
    for point in scene.real_points() {
        if let Some(k) = moving.iter().position(|&part| part == parts.of(point)) {
            sums[k].0 += 1;
            (0..2).for_each(|c| sums[k].1[c] += model.position(point)[c]);
        }
    }
    let mut told: Vec<(usize, String)> = Vec::new();
    for (&(count, sum), part) in sums.iter().zip(&motion.moves).filter(|(s, _)| s.0 > 0) {
        let how = how(part, motions);
        let what = match count == scene.body().points() {
            true => "the body".to_string(),
            false => {
                let [x, y] = sum.map(|s| tidy(s / count as f64));
                let points = if count == 1 { "1 point".into() } else { format!("{count} points") };
                format!("the part of the body around ({x}, {y}), {points},")
            }
        };
        told.push((count, format!("{what} is free to {how}")));
    }
    // The largest part first, two at most.
    told.sort_by_key(|t| std::cmp::Reverse(t.0));
    let more = told.len().saturating_sub(2);
    let mut text = told.into_iter().take(2).map(|t| t.1).collect::<Vec<_>>().join(", and ");
    if more > 0 {
        text += &format!(", and {more} more part{} with them", if more == 1 { "" } else { "s" });
    }
    format!("{text}: no support prevents it")
}

/// The last of the motions that it is made of, in words: a turn about some centre is one of translations, too.
fn how(part: &PartMotion, motions: &[RigidMotion]) -> String {
    let last = part.amounts.iter().rposition(|amount| *amount != 0.0).unwrap_or(0);
    let verb = motions[last].verb;
    let verb = verb.replace("{centre}", &centre(part, last));
    verb.replace("{direction}", &direction(part))
}

fn clean(value: f64, other: f64) -> f64 {
    if value.abs() < 1e-9 * other.abs() { 0.0 } else { value }
}

/// The place that a motion of the plane, the last of whose amounts is a turn, leaves where it is.
fn centre(part: &PartMotion, turn: usize) -> String {
    let (&[x, y, ..], amount) = (part.amounts.as_slice(), part.amounts[turn]) else { return String::new() };
    let centre = [part.centre[0] - y / amount, part.centre[1] + x / amount];
    let size = centre[0].abs().max(centre[1].abs());
    let [a, b] = centre.map(|c| tidy(clean(c, size)));
    format!("({a}, {b})")
}

/// The direction of translations together.
fn direction(part: &PartMotion) -> String {
    // Of a body of revolution the one along the axis is left.
    let [x, y] = match part.amounts.as_slice() {
        &[along] => [0.0, along],
        &[x, y, ..] => [x, y],
        [] => [0.0; 2],
    };
    match (clean(x, y), clean(y, x)) {
        (_, 0.0) => "x".into(),
        (0.0, _) => "y".into(),
        (x, y) => {
            let size = x.hypot(y);
            let round = |v: f64| (v / size * 1e6).round() / 1e6;
            format!("({}, {})", round(x), round(y))
        }
    }
}
