//! Families that feel changes of volume, `ϑ_k = Σ (3w/q) |ξ| e`, with what tetrahedra measure in place of missing bonds.

use super::body::Reach;
use super::corners::Overlay;
use super::{SolidLaw, TENSOR};
use crate::body::{Cell, SquareLattice, plus};
use crate::stiffness::{FamilyRows, GridFamilies, GridFamily};
use std::collections::HashMap;
use std::sync::Arc;

/// The families of the real points of a lattice; none of a law without dilatation. Points that lack nothing share their rows.
pub(super) fn families(
    lattice: &Arc<SquareLattice>,
    law: &SolidLaw,
    reach: &Reach,
    overlay: &Overlay,
    (near, ghosts): (&[usize], &[u32]),
    cuts: &[(usize, usize)],
) -> Option<GridFamilies<3>> {
    let dilatation = law.dilatation.as_ref()?;
    let spacing = lattice.spacing();
    // (3w/q) |ξ| n, lengths in spacings but for the last: per m.
    let row = |(k, step): (usize, &Cell)| {
        let share = dilatation.shares[reach.offset_of(k)] / spacing;
        step.map(|x| share * f64::from(x))
    };
    let plain: FamilyRows<3> = reach.steps.iter().enumerate().map(row).collect();
    let mut gone: HashMap<usize, Vec<bool>> =
        near.iter().map(|&p| (p, reach.missing(lattice, lattice.cell(p)))).collect();
    for &(offset, lower) in cuts {
        let upper = lattice.number(plus(lattice.cell(lower), law.hood.offsets[offset]));
        for (point, is_lower) in [(Some(lower), true), (upper, false)] {
            let Some(point) = point else { continue };
            let own = gone.entry(point).or_insert_with(|| vec![false; reach.steps.len()]);
            own[reach.step_of(offset, is_lower)] = true;
        }
    }
    let mut sets = vec![plain];
    let mut known: HashMap<(Vec<bool>, Option<usize>), u32> = HashMap::new();
    let mut set_of = vec![Some(0); lattice.points()];
    for (point, gone) in gone {
        let kind = overlay.of_point.get(&point).copied();
        let set = known.entry((gone, kind)).or_insert_with_key(|(gone, kind)| {
            let set = rows((&sets[0], gone), reach, overlay, *kind);
            sets.push(set);
            sets.len() as u32 - 1
        });
        set_of[point] = Some(*set);
    }
    ghosts.iter().for_each(|&ghost| set_of[ghost as usize] = None);
    let volume = |point: usize| spacing.powi(3) * lattice.fraction(point);
    let family = GridFamily {
        steps: reach.steps.clone(),
        sets,
        set_of,
        volume: (0..lattice.points()).map(volume).collect(),
        own: Vec::new(),
        modulus: [[dilatation.modulus, 0.0], [0.0; 2]],
        mean_modulus: 0.0,
    };
    Some(GridFamilies::new(lattice.clone(), family))
}

/// The rows of a family without some of its bonds and with its tetrahedra.
fn rows(
    (plain, gone): (&FamilyRows<3>, &[bool]),
    reach: &Reach,
    overlay: &Overlay,
    kind: Option<usize>,
) -> FamilyRows<3> {
    let mut rows: FamilyRows<3> =
        plain.iter().zip(gone).map(|(row, &gone)| if gone { [0.0; 3] } else { *row }).collect();
    if let Some(kind) = kind.map(|kind| &overlay.kinds[kind]) {
        for (other, strain) in kind.others.iter().zip(kind.strain.chunks_exact(3)) {
            let step = reach.steps.iter().position(|step| step == other);
            let row = &mut rows[step.expect("corners of tetrahedra are at offsets")];
            (0..3)
                .for_each(|c| row[c] += (0..TENSOR).map(|q| kind.dilatation[q] * strain[c][q]).sum::<f64>());
        }
    }
    rows
}
