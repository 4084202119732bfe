//! Clamps on edges of which the cells make steps.
//!
//! Were the points of the steps held, the plate would be clamped up to a cell inside of its true edge, or outside. From a clamp on,
//! rotations grow with the distance s from it, deflections with its square. So a point at s has the part `s/(s + d)` of the rotations a
//! distance d deeper in the plate, and the square of that part of the deflection.

use super::border::Side;
use super::site::Site;
use crate::scene::body::site::interpolate::{Interpolation, Weights};
use std::collections::{BTreeMap, BTreeSet};

/// How much deeper in the plate a point looks, spacings: beyond the steps.
const DEEPER: f64 = 3.0;
/// Places are the same within this, in spacings.
const SAME: f64 = 1e-6;
/// Shares below this are rounding. On a line of symmetry, which holds points of its own, what is left of an equation would be such a
/// share alone, and hold a point beside the line.
const ROUNDING: f64 = 1e-12;

/// What a point of the steps follows.
#[derive(Clone, Debug)]
pub(super) struct Followed {
    /// Points around the place deeper in the plate, with their shares of it.
    pub(super) shares: Weights,
    /// Part of the rotations there that the point has; negative outside of the true edge.
    pub(super) part: f64,
}

/// The points of steps that follow the plate behind them. Where it is too narrow they do not, nor where a straight edge begins.
pub(super) fn followed(site: &Site, points: &[u32], sides: &[Side]) -> BTreeMap<u32, Followed> {
    let points_of = |is_true: bool| {
        let of_kind = sides.iter().filter(move |side| side.is_true == is_true);
        of_kind.flat_map(|side| side.segment.points).collect::<BTreeSet<u32>>()
    };
    let [steps, straight] = [points_of(false), points_of(true)];
    let (nodes, h) = (site.nodes, site.nodes.spacing());
    let interpolation = Interpolation { body: site.ground.body, cracks: &[], reach: 1 };
    let follow = |&point: &u32| {
        let place = nodes.place(point as usize);
        let (way, outwards) = site.border.way(sides, place);
        let depth = way[0] * outwards[0] + way[1] * outwards[1];
        let deeper = [0, 1].map(|k| place[k] - DEEPER * h * outwards[k]);
        let mut shares = interpolation.at([deeper[0], deeper[1], 0.0], point);
        shares.retain(|(_, share)| share.abs() > ROUNDING);
        let middle = |k: usize| shares.iter().map(|&(p, s)| s * nodes.place(p as usize)[k]).sum::<f64>();
        let is_there = (0..2).all(|k| (middle(k) - deeper[k]).abs() < SAME * h);
        let is_free = shares.iter().all(|(p, _)| points.binary_search(p).is_err());
        (is_there && is_free).then(|| (point, Followed { shares, part: depth / (depth + DEEPER * h) }))
    };
    steps.difference(&straight).filter_map(follow).collect()
}
