//! How much memory a solid takes that is solved by iterations.
//!
//! Measured on cubes of 4096 to 262 144 points and bars of 8:1 with horizons of two to four spacings: the estimate is 1.0 to 1.9 times what
//! a run takes.

use crate::model::About;
use peristat_assembly::body::SquareLattice;

/// Of a point: bonds, levels, vectors, fields and their files, bytes.
const POINT: usize = 750;
/// Of what completes the border before a side of a cell, per cubed spacing of the horizon, bytes.
const SIDE: usize = 100;
/// The same where points feel the families of their neighbours.
const SIDE_OF_FAMILIES: usize = 1100;
/// Of a point of the coarsest lattice with its factor, bytes.
const COARSEST: usize = 30_000;
/// That of a run in which stress intensities are found, over that of one without: they take a second model. Measured 1.36 to 1.41.
const WITH_CRACK_FRONTS: f64 = 1.45;
/// Points of a coarsest lattice per length of a bar over its width.
const COARSEST_POINTS: usize = 600;

/// Memory of a solid on a lattice, images included, bytes; `has_fronts` if stress intensities are asked for.
pub(super) fn of(lattice: &SquareLattice, about: &About, has_fronts: bool) -> usize {
    let mut sides = [lattice.columns().len(), lattice.rows().len(), lattice.layers().len()];
    let [a, b, c] = sides;
    // Runs that begin or end inside of the box have two sides there, and what they border on has as many along each axis.
    let inner = 6 * lattice.runs().len().saturating_sub(b * c);
    let faces = 2 * (a * b + b * c + c * a) + inner;
    let per_side = if about.has_families { SIDE_OF_FAMILIES } else { SIDE };
    let border = (faces * per_side) as f64 * about.horizon_ratio.powi(3);
    sides.sort_unstable();
    // Plates go on to become coarser.
    let is_plate = sides[1] >= 4 * sides[0];
    let slenderness = if is_plate { 1 } else { (sides[2] / sides[0].max(1)).max(1) };
    let coarsest = (COARSEST_POINTS * slenderness).min(lattice.points());
    let bytes = POINT * lattice.points() + border as usize + COARSEST * coarsest.min(5000);
    if has_fronts { (WITH_CRACK_FRONTS * bytes as f64) as usize } else { bytes }
}
