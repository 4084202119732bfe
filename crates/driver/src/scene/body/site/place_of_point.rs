//! Positions at which supports are asked for, and the points that they take.

use super::ground::{Ground, NamedPoints};
use crate::case::At;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::words;

/// A position is that of a point whose distance from it is no more, in spacings.
const AT_POINT: f64 = 1e-3;

/// A doubt where the point that a support takes at a position is not there: a reaction beside its place has another moment.
pub(crate) fn doubt(ground: &Ground, at: &At, taken: &NamedPoints, path: &JsonPath, faults: &mut Faults) {
    let (Some(x), Some(y), [point]) = (at.x, at.y, &taken.points[..]) else { return };
    let (asked, position) = ([x, y, at.z.unwrap_or(0.0)], ground.body.position(*point as usize));
    let moved = (0..3).map(|k| (asked[k] - position[k]).powi(2)).sum::<f64>().sqrt();
    if moved > AT_POINT * ground.body.spacing() {
        let position = words::place(position, ground.body);
        faults
            .warning(path.clone(), format!("the support at {} holds the point at {position}", taken.words))
            .hint("give the position of that point, or a region");
    }
}
