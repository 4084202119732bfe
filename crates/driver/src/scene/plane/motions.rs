//! Free motions of a body in the plane in words.

use super::super::words::tidy;
use super::PlaneScene;
use peristat_assembly::system::{FreeMotion, PartMotion};

/// What nothing holds, and how it would move.
pub(super) fn describe(scene: &PlaneScene, motion: &FreeMotion) -> String {
    let model = &scene.model;
    let parts = model.parts();
    // Number and sum of the positions of the real points of every part that moves.
    let mut sums = vec![(0_usize, [0.0; 2]); motion.parts.len()];
    let moving: Vec<usize> = motion.parts.iter().map(|span| parts.of(span[0])).collect();
    for point in scene.real_points() {
        if let Some(k) = moving.iter().position(|&part| part == parts.of(point)) {
            sums[k].0 += 1;
            (0..2).for_each(|c| sums[k].1[c] += model.place(point)[c]);
        }
    }
    let mut told: Vec<(usize, String)> = Vec::new();
    for (&(count, sum), part) in sums.iter().zip(&motion.moves).filter(|(s, _)| s.0 > 0) {
        let how = how(part);
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

/// The same of a shell, whose motions are those of a body in space.
fn on_cylinder(amounts: &[f64]) -> &'static str {
    let acts =
        |kinds: std::ops::Range<usize>| amounts.get(kinds).is_some_and(|a| a.iter().any(|v| *v != 0.0));
    match [acts(0..1), acts(1..2), acts(2..4), acts(4..6)] {
        [_, _, _, true] => "tilt its axis",
        [_, _, true, _] => "move across its axis",
        [_, true, _, _] => "turn about its axis",
        _ => "move along its axis",
    }
}

/// `move along x`, or `turn about (1, 2)`.
fn how(part: &PartMotion) -> String {
    let &[x, y, turn] = part.amounts.as_slice() else {
        // Of a body of revolution one motion is left.
        return if part.amounts.len() == 1 { "move along y" } else { on_cylinder(&part.amounts) }.into();
    };
    let clean = |value: f64, other: f64| if value.abs() < 1e-9 * other.abs() { 0.0 } else { value };
    if turn != 0.0 {
        let centre = [part.centre[0] - y / turn, part.centre[1] + x / turn];
        let size = centre[0].abs().max(centre[1].abs());
        let [a, b] = centre.map(|c| tidy(clean(c, size)));
        return format!("turn about ({a}, {b})");
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
