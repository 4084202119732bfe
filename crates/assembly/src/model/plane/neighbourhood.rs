//! Neighbours of a point of a lattice and the bonds to them.

use crate::body::{Cell, minus};

/// Rows, columns and layers up to which offsets always can be sides of triangles.
const NEXT: i32 = 2;

/// One of each pair of opposite offsets to the neighbours of a point, with `M` moduli each.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Neighbourhood<const M: usize> {
    /// To a higher layer, upwards in the same one, or to the right in the same row; those of the next two rows and columns always
    /// belong to it.
    pub(in super::super) offsets: Vec<Cell>,
    /// Moduli of the bonds, Pa, per offset; what multiplies them is in the bond. None is negative.
    pub(in super::super) weights: Vec<[f64; M]>,
    /// Part of the neighbour's volume that counts.
    pub(in super::super) parts: Vec<f64>,
}

impl<const M: usize> Neighbourhood<M> {
    /// The offsets that have bonds or can be sides of triangles.
    pub(in super::super) fn new(offsets: &[Cell], weights: &[[f64; M]], parts: &[f64]) -> Self {
        let is_kept = |k: usize| weights[k].iter().any(|&w| w > 0.0) || is_next(offsets[k]);
        let kept: Vec<usize> = (0..offsets.len()).filter(|&k| is_kept(k)).collect();
        Self {
            offsets: kept.iter().map(|&k| offsets[k]).collect(),
            weights: kept.iter().map(|&k| weights[k]).collect(),
            parts: kept.iter().map(|&k| parts[k]).collect(),
        }
    }

    /// Indices of the offsets that have bonds.
    pub(in super::super) fn bonded(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.offsets.len()).filter(|&k| self.has_bonds(k))
    }

    /// Whether there are bonds of an offset.
    pub(in super::super) fn has_bonds(&self, offset: usize) -> bool {
        self.weights[offset].iter().any(|&w| w > 0.0)
    }

    /// Largest offset of a bond, rows, columns or layers.
    pub(in super::super) fn reach(&self) -> i32 {
        self.bonded().flat_map(|k| self.offsets[k].map(i32::abs)).max().unwrap_or(0)
    }

    /// Index of the offset between two neighbours and which of them is the lower one.
    pub(in super::super) fn between(&self, from: Cell, to: Cell) -> Option<(usize, bool)> {
        let step = minus(to, from);
        let up = is_up(step);
        let step = if up { step } else { step.map(|k| -k) };
        Some((self.offsets.iter().position(|o| *o == step)?, up))
    }
}

/// One of each pair of opposite offsets of at most `reach` spacings in a lattice of some layers, and those of the next two rows,
/// columns and layers: layer by layer and row by row. In one layer they are those of a plane.
pub(in super::super) fn half_offsets(reach: f64, layers: i32) -> Vec<Cell> {
    let most = reach.floor().max(f64::from(NEXT)) as i32;
    let across = 0..=most.min(layers - 1);
    let lines = across.flat_map(|c| (-most..=most).map(move |b| [b, c]));
    let all = lines.flat_map(|[b, c]| (-most..=most).map(move |a| [a, b, c]));
    all.filter(|&step| is_up(step) && (is_within(step, reach) || is_next(step))).collect()
}

/// Whether an offset is at most `reach` spacings long.
pub(in super::super) fn is_within(step: Cell, reach: f64) -> bool {
    f64::from(squared(step)) <= reach * reach * (1.0 + 1e-9)
}

/// Whether an offset goes to a higher layer, upwards in the same one, or to the right in the same row.
pub(in super::super) fn is_up([a, b, c]: Cell) -> bool {
    [c, b, a] > [0; 3]
}

fn is_next(step: Cell) -> bool {
    step.iter().all(|k| k.abs() <= NEXT)
}

/// Length of an offset, spacings.
pub(in super::super) fn length(step: Cell) -> f64 {
    f64::from(squared(step)).sqrt()
}

/// Square of the length of an offset, spacings².
fn squared(step: Cell) -> i32 {
    step.iter().map(|k| k * k).sum()
}

/// `N = (n_x², n_y², n_x n_y)` of the direction of an offset in the plane, in the axes of its lattice: the stretch of a bond is
/// `N·[ε_xx, ε_yy, γ_xy]`.
pub(in super::super) fn direction_product([a, b, _]: Cell) -> [f64; 3] {
    let squared = f64::from(a * a + b * b);
    [f64::from(a * a) / squared, f64::from(b * b) / squared, f64::from(a * b) / squared]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn offsets_of_a_solid_are_half_of_a_ball() {
        for reach in [1.0, 2.0, 3.0, 3.5] {
            let found = half_offsets(reach, 9);
            let inside = |step: &Cell| is_within(*step, reach) || is_next(*step);
            let all = (-4..=4).flat_map(|c| (-4..=4).flat_map(move |b| (-4..=4).map(move |a| [a, b, c])));
            assert_eq!(2 * found.len() + 1, all.filter(inside).count());
            assert!(found.iter().all(|step| inside(step) && !found.contains(&step.map(|k| -k))));
            // A plane has those of one layer, and few layers have no steps beyond them.
            let plane: Vec<Cell> = found.iter().copied().filter(|step| step[2] == 0).collect();
            assert_eq!(half_offsets(reach, 1), plane);
            let two: Vec<Cell> = found.iter().copied().filter(|step| step[2] < 2).collect();
            assert_eq!(half_offsets(reach, 2), two);
        }
    }

    #[test]
    fn offsets_between_cells_go_up() {
        let offsets = half_offsets(2.0, 4);
        let neighbourhood =
            Neighbourhood::new(&offsets, &vec![[1.0]; offsets.len()], &vec![1.0; offsets.len()]);
        for (from, to, up) in
            [([1, 1, 1], [0, 0, 2], true), ([0, 0, 2], [1, 1, 1], false), ([3, 0, 0], [2, 0, 0], false)]
        {
            let (k, found) = neighbourhood.between(from, to).unwrap();
            let step = minus(to, from);
            assert_eq!((neighbourhood.offsets[k], found), (if up { step } else { step.map(|k| -k) }, up));
        }
        assert_eq!(neighbourhood.reach(), 2);
    }
}
