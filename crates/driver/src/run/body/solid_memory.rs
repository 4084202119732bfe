//! How much memory a solid takes.
//!
//! Solved by iterations: measured on cubes of 4096 to 262 144 points and bars of 8:1 with horizons of two to four spacings: the estimate is 1.0 to 1.9 times what
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

/// Entries of a factor over `9 m² P^(4/3)` with P points: what separates half of a cube from the other is m layers of `P^(2/3)`.
const FILL: f64 = 5.0;
/// Of an entry of a factor and what it is made from, bytes.
const ENTRY: f64 = 16.0;
/// Of a neighbour of a point in the stiffness, as it is put together, bytes.
const NEIGHBOUR: f64 = 80.0;
/// Horizons to which families couple a point, and what fills up as if bonds were as long.
const FAMILIES: [f64; 2] = [2.0, 1.4];

/// Memory of the stiffness of a solid on a lattice and of its factor, bytes. Measured on cubes of 512 to 4096 points, bars of 8:1 and
/// plates of three and four layers, horizons of two and three spacings, bonds and families: the estimate is 1.1 to 1.8 times what a run
/// takes.
pub(super) fn of_factor(lattice: &SquareLattice, about: &About) -> usize {
    let mut sides = [lattice.columns().len(), lattice.rows().len(), lattice.layers().len()];
    sides.sort_unstable();
    let section = (sides[0] * sides[1]) as f64;
    let points = lattice.points() as f64;
    of_matrix(points, about, |reach| points * (reach + 1.0) * section)
}

/// The same of listed points, whatever their shape: of bars of 3:1 with horizons of two to four spacings 1.7 to 2.4 times what a run takes.
pub(super) fn of_listed_factor(points: usize, about: &About) -> usize {
    of_matrix(points as f64, about, |_| f64::INFINITY)
}

/// The same solved with the blocks of its points, bytes: vectors and blocks, and what bonds take while they are made. Measured 517 MB for
/// 41 472 points with three spacings per horizon, of which the estimate is 1.2 times as much.
pub(super) fn of_listed(points: usize, bonds: usize) -> usize {
    270 * points + 60 * bonds
}

/// Memory of a stiffness and its factor, bytes, which has no more blocks than in a band by the reach.
fn of_matrix(points: f64, about: &About, banded: impl Fn(f64) -> f64) -> usize {
    let [couples, fills] = if about.has_families { FAMILIES } else { [1.0; 2] };
    let reach = fills * about.horizon_ratio;
    let dissected = FILL * (reach * points.powf(2.0 / 3.0)).powi(2);
    let entries = 9.0 * dissected.min(banded(reach)).min(0.5 * points * points);
    let ball = 4.0 / 3.0 * std::f64::consts::PI * (couples * about.horizon_ratio).powi(3);
    (ENTRY * entries + NEIGHBOUR * ball.min(points) * points) as usize
}

/// Memory of a solid on a lattice solved by iterations, images included, bytes; `has_fronts` if stress intensities are asked for.
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
