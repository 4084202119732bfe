//! For tests: tractions of uniform stresses on straight borders.

use super::PlaneModel;
use crate::body::in_space;
use crate::quadrature::GAUSS;

/// A straight border from one end to the other, with its normal.
pub(in super::super) type Side = ([[f64; 2]; 2], [f64; 2]);

/// Forces of the tractions of a uniform stress `[σ_xx, σ_yy, σ_xy]` on some sides, by unknowns.
pub(in super::super) fn through_border(
    model: &dyn PlaneModel,
    sides: &[Side],
    [xx, yy, xy]: [f64; 3],
) -> Vec<f64> {
    let (n, lattice) = (model.points(), model.lattice().expect("a lattice").0);
    let shares = model.border_shares().expect("a border that is completed");
    let mut force = vec![0.0; model.components().len() * n];
    for &([from, to], normal) in sides {
        let traction = [xx * normal[0] + xy * normal[1], xy * normal[0] + yy * normal[1]];
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        for ends in lattice.crossings(from, to).windows(2) {
            for (share, weight) in GAUSS {
                let along = ends[0] + share * (ends[1] - ends[0]);
                let at = [0, 1].map(|k| from[k] + along * (to[k] - from[k]));
                let length = weight * (ends[1] - ends[0]) * length * model.length_across(at[0]);
                for (p, share) in shares(in_space(at), in_space(normal)).expect("a place on the border") {
                    (0..2).for_each(|k| force[k * n + p] += share * length * traction[k]);
                }
            }
        }
    }
    force
}
