//! Neighbours of a point of a lattice and the bonds to them.

use crate::body::Cell;

/// Square of the length of offsets that always can be sides of triangles, spacings: two rows and columns.
const NEXT: i32 = 8;

/// One of each pair of opposite offsets to the neighbours of a point, with `M` moduli each.
#[derive(Clone, Debug, PartialEq)]
pub(in super::super) struct Neighbourhood<const M: usize> {
    /// Upwards, or to the right in the same row; those of the next two rows and columns always belong to it.
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

    /// Largest offset of a bond, rows or columns.
    pub(in super::super) fn reach(&self) -> i32 {
        self.bonded().flat_map(|k| self.offsets[k].map(i32::abs)).max().unwrap_or(0)
    }

    /// Index of the offset between two neighbours and which of them is the lower one.
    pub(in super::super) fn between(&self, from: Cell, to: Cell) -> Option<(usize, bool)> {
        let [a, b] = [to[0] - from[0], to[1] - from[1]];
        let up = b > 0 || (b == 0 && a > 0);
        let step = if up { [a, b] } else { [-a, -b] };
        Some((self.offsets.iter().position(|o| *o == step)?, up))
    }
}

/// One of each pair of opposite offsets of at most `reach` spacings and those of the next
/// two rows and columns, row by row.
pub(in super::super) fn half_offsets(reach: f64) -> Vec<Cell> {
    let most = reach.floor().max(2.0) as i32;
    let all = (0..=most).flat_map(|b| (-most..=most).map(move |a| [a, b]));
    all.filter(|&step| step[1] > 0 || step[0] > 0).filter(|&s| is_within(s, reach) || is_next(s)).collect()
}

/// Whether an offset is at most `reach` spacings long.
pub(in super::super) fn is_within([a, b]: Cell, reach: f64) -> bool {
    f64::from(a * a + b * b) <= reach * reach * (1.0 + 1e-9)
}

fn is_next([a, b]: Cell) -> bool {
    a * a + b * b <= NEXT
}

/// Length of an offset, spacings.
pub(in super::super) fn length([a, b]: Cell) -> f64 {
    f64::from(a * a + b * b).sqrt()
}

/// `N = (n_x², n_y², n_x n_y)` of the direction of an offset in the axes of its lattice: the stretch of a bond is
/// `N·[ε_xx, ε_yy, γ_xy]`.
pub(in super::super) fn direction_product([a, b]: Cell) -> [f64; 3] {
    let squared = f64::from(a * a + b * b);
    [f64::from(a * a) / squared, f64::from(b * b) / squared, f64::from(a * b) / squared]
}
