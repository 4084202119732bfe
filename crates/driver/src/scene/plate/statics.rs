//! Resultants of what acts on a plate.

use crate::scene::Resultant;
use peristat_assembly::model::plate_bending::{PHI_X, PHI_Y, PlateNodes, W};

/// Adds a force along z and the moments that do work with the two rotations, at a place. A slope along x is a turn about −y.
pub(super) fn act(sum: &mut Resultant, [force, along_x, along_y]: [f64; 3], [x, y]: [f64; 2]) {
    if force != 0.0 {
        sum.add([0.0, 0.0, force], [x, y, 0.0]);
    }
    if along_y != 0.0 {
        sum.add_moment(0, along_y);
    }
    if along_x != 0.0 {
        sum.add_moment(1, -along_x);
    }
}

/// Resultant of forces on some unknowns, by number.
pub(super) fn resultant(nodes: &PlateNodes, forces: impl Iterator<Item = (usize, f64)>) -> Resultant {
    let (n, mut sum) = (nodes.points(), Resultant::default());
    for (unknown, value) in forces.filter(|force| force.1 != 0.0) {
        let mut parts = [0.0; 3];
        parts[unknown / n] = value;
        act(&mut sum, [parts[W], parts[PHI_X], parts[PHI_Y]], nodes.place(unknown % n));
    }
    sum
}
