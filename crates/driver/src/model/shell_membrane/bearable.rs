//! Loads that no membrane bears.

use super::super::Resolved;
use crate::diagnostic::{Faults, JsonPath};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::shell_membrane::{EndConditions, Inextensional, ShellParameters};
use std::collections::BTreeMap;

/// Adds a fault for every load that a membrane cannot bear.
pub(super) fn check(
    parameters: &ShellParameters,
    on: &Resolved,
    held: &mut dyn Iterator<Item = (&[u32], [f64; 3])>,
    loads: &mut dyn Iterator<Item = (JsonPath, Vec<f64>)>,
    faults: &mut Faults,
) {
    let Some((lattice, mirrors)) = on.model.lattice() else { return };
    let left = Inextensional::new(parameters, (lattice, mirrors), ends(on, held, lattice));
    for (path, force) in loads {
        if left.is_worked_on(&force) {
            faults
                .error(
                    path,
                    "a membrane whose ends are free cannot bear this load: it moves without any strain, and what a \
                     lattice answers depends on the spacing alone",
                )
                .hint(
                    "hold `uy` and `w` on both ends (diaphragms) or `ux`, `uy` and `w` on one, or take \"bending\": true",
                );
        }
    }
}

/// What supports hold on whole circumferences.
fn ends(
    on: &Resolved,
    held: &mut dyn Iterator<Item = (&[u32], [f64; 3])>,
    lattice: &SquareLattice,
) -> EndConditions {
    let Some(real) = on.lattice else { return EndConditions::default() };
    let rows = real.rows().len();
    // Points that are held along u, and along v or w, per column.
    let mut counts: BTreeMap<i32, [usize; 3]> = BTreeMap::new();
    for (points, direction) in held {
        for &point in points {
            let counts = counts.entry(lattice.cell(point as usize)[0]).or_default();
            (0..3).for_each(|c| counts[c] += usize::from(direction[c].abs() == 1.0));
        }
    }
    let mut ends = EndConditions::default();
    for (column, counts) in counts {
        let x = lattice.place_of([column, real.rows().start, 0])[0];
        if counts[0] >= rows {
            ends.hold_axial();
        }
        if counts[1] >= rows || counts[2] >= rows {
            ends.hold_shape(x);
        }
    }
    ends
}
