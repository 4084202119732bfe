//! Points that bear load: the displacement of local elasticity is infinite there.

use super::supports::FreeMotions;
use crate::diagnostic::{Faults, root, tidy};
use crate::scene::Resultant;
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::scene::BodyState;
use nalgebra::DVector;

/// Part of the loads that points may bear: what loads of four or five digits lack of balance. A strip of 21 rows with a point that bears
/// as much is 4e-6 of the largest displacement off beside it.
const LITTLE: f64 = 1e-4;
/// Singular values of what holds rigid motions that are smaller, relative to the largest, are zero.
const NONE: f64 = 1e-9;

/// Adds a fault where points take more than a little of the loads of a state, given with their resultants: by statics, because points
/// hold no more than the rigid motions that are left.
pub(super) fn check(
    site: &HeldBody,
    free: &FreeMotions,
    states: &[(&BodyState, Resultant)],
    faults: &mut Faults,
) {
    let (works, places) = free.works(site);
    if places.is_empty() || faults.has_errors() {
        return;
    }
    let svd = works.transpose().svd(true, true);
    for (state, load) in states {
        let work =
            DVector::from_iterator(free.motions.len(), free.motions.iter().map(|m| -free.work(*m, load)));
        let Ok(forces) = svd.solve(&work, NONE) else { continue };
        let [size, _] = load.sizes();
        let worst = places.iter().zip(forces.iter()).max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
        let Some(([x, y], force)) = worst.filter(|(_, force)| force.abs() > LITTLE * size) else { continue };
        let [x, y] = [*x, *y].map(tidy);
        // Two digits.
        let percent = format!("{:.1e}", 100.0 * force.abs() / size).parse().map_or(String::new(), tidy);
        let of = if states.len() > 1 { format!(" of `{}`", state.name) } else { String::new() };
        faults
            .error(
                root("supports"),
                format!("the limit `local` has no displacement where a point bears load: at ({x}, {y}) it would be infinite under {percent} % of the loads{of}"),
            )
            .hint("hold an edge, or let tractions on the border balance the loads, and points hold the rigid motions alone");
        return;
    }
}
