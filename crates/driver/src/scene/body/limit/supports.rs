//! Supports of bodies whose displacements are corrected.
//!
//! A body that points hold statically determinately has the stresses of its tractions alone: what it is corrected by moves it as
//! a rigid body at most, and that is taken back. Other supports have forces of their own, infinite stresses at points.

use crate::diagnostic::{Faults, root};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::hold::held_points::HeldPoints;
use nalgebra::DMatrix;
use peristat_assembly::bonds::Point;

/// Singular values of the work of supports on rigid motions that are smaller, relative to the largest, are zero.
const NONE: f64 = 1e-9;

/// Adds a fault for supports that hold more than rigid motions.
pub(super) fn check(site: &HeldBody, faults: &mut Faults) {
    let path = root("supports");
    let conditions = site.conditions;
    if !conditions.springs.is_empty() {
        faults
            .error(
                path,
                "the limit `local` knows no springs to the ground: their forces are not among its tractions",
            )
            .hint("hold the body at points, or leave `limit` out");
        return;
    }
    if conditions.holds.iter().any(HeldPoints::is_on_border) {
        faults
            .error(path, "the limit `local` has bodies that points hold: along a held edge the tractions are not known")
            .hint("hold two points, one of them in both directions, and load the edge by its tractions; or leave `limit` out");
        return;
    }
    let rows = works(site);
    let count = rows.nrows();
    let singular = rows.svd(false, false).singular_values;
    let least = NONE * singular.max();
    let rank = singular.iter().filter(|value| **value > least).count();
    if rank < count {
        faults
            .error(path, "the limit `local` needs supports that are statically determinate: at further points that are held stresses are infinite")
            .hint("hold no more than the rigid motions: one point in both directions and another in one; symmetry holds some of them");
    }
}

/// What every held motion is of the rigid motions that lines of symmetry leave, lengths over the size of the body.
fn works(site: &HeldBody) -> DMatrix<f64> {
    let [low, high] = site.outline.map_or([[0.0; 2]; 2], peristat_assembly::body::Outline::bounds);
    let size = (high[0] - low[0]).hypot(high[1] - low[1]);
    let mirrored = |axis: usize| site.inputs.symmetry.at[2 * axis..2 * axis + 2].iter().any(Option::is_some);
    let free = [!mirrored(0), !mirrored(1), !mirrored(0) && !mirrored(1)];
    let of = |direction: Point, point: u32| {
        let [x, y] = site.model.place(point as usize);
        let turn = direction[1] * (x - low[0]) - direction[0] * (y - low[1]);
        [direction[0], direction[1], turn / size]
    };
    let holds = site.conditions.holds.iter();
    let rows: Vec<[f64; 3]> = holds.flat_map(|h| h.points.iter().map(|p| of(h.direction, *p))).collect();
    DMatrix::from_fn(rows.len(), 3, |r, c| if free[c] { rows[r][c] } else { 0.0 })
}
