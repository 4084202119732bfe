//! Round holes, beside which fields of their own take the place of polynomials.
//!
//! These are in equilibrium with what acts on the hole, and with each other: they lack something only where polynomials meet them.

use super::grid::Node;
use crate::recovery::hole::{Ellipse, HoleFit};

/// What is around a hole that has fields of its own.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HoleZone {
    /// The hole.
    pub ellipse: Ellipse,
    /// The largest ellipse, relative to it, within which its fields are taken.
    pub level: f64,
}

impl HoleZone {
    /// Number of the hole whose fields a position has.
    pub(super) fn at(zones: &[Self], position: [f64; 2]) -> Option<u32> {
        zones.iter().position(|zone| zone.ellipse.level(position) < zone.level).map(|k| k as u32)
    }
}

/// A place at which the stress of the fields of a hole acts on points.
#[derive(Clone, Debug)]
pub(super) struct HolePull {
    pub(super) hole: u32,
    /// Position, m.
    pub(super) at: [f64; 2],
    /// Normal times area, m².
    pub(super) area: [f64; 2],
    pub(super) shares: Vec<(Node, f64)>,
}

impl HolePull {
    /// Adds its forces on points, N, in two planes of so many.
    pub(super) fn add(&self, holes: &[HoleFit], points: usize, force: &mut [f64]) {
        let Some(fit) = holes.get(self.hole as usize) else { return };
        let ([xx, yy, xy], [x, y]) = (fit.at(self.at).stress, self.area);
        let traction = [xx * x + xy * y, xy * x + yy * y];
        for (node, share) in self.shares.iter().filter(|(node, _)| node.is_real) {
            (0..2).for_each(|c| force[c * points + node.number as usize] += share * traction[c]);
        }
    }
}
