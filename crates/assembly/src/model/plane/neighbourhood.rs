//! Neighbours of a point of a lattice and the bonds to them.

use super::mixture::Blend;
use crate::body::{Cell, minus};
use std::array::from_fn;

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
    /// The same of points with bonds of their own, table by table from one on.
    pub(in super::super) others: Vec<Vec<[f64; M]>>,
    /// What the materials of all tables resist to the measures of the bonds of an offset in uniform states, up to a factor; none where
    /// there is one table.
    pub(in super::super) along: Vec<Vec<[f64; M]>>,
    /// Part of the neighbour's volume that counts.
    pub(in super::super) parts: Vec<f64>,
}

/// What a material has for the bonds of an offset.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct OfMaterial<const M: usize> {
    pub(in super::super) weights: [f64; M],
    /// What it resists to their measures in uniform states, up to a factor.
    pub(in super::super) along: [f64; M],
}

impl<const M: usize> Neighbourhood<M> {
    /// The offsets that have bonds or can be sides of triangles.
    pub(in super::super) fn new(offsets: &[Cell], weights: &[[f64; M]], parts: &[f64]) -> Self {
        Self::of_tables(offsets, (weights, &[]), &[], parts)
    }

    /// The same where some points have other weights.
    pub(in super::super) fn of_tables(
        offsets: &[Cell],
        (weights, others): (&[[f64; M]], &[Vec<[f64; M]>]),
        along: &[Vec<[f64; M]>],
        parts: &[f64],
    ) -> Self {
        let all = || others.iter().map(Vec::as_slice).chain([weights]);
        let has_bonds = |k: usize| all().any(|weights| weights[k].iter().any(|&w| w > 0.0));
        let kept: Vec<usize> = (0..offsets.len()).filter(|&k| has_bonds(k) || is_next(offsets[k])).collect();
        Self {
            offsets: kept.iter().map(|&k| offsets[k]).collect(),
            weights: kept.iter().map(|&k| weights[k]).collect(),
            others: others.iter().map(|other| kept.iter().map(|&k| other[k]).collect()).collect(),
            along: along.iter().map(|of| kept.iter().map(|&k| of[k]).collect()).collect(),
            parts: kept.iter().map(|&k| parts[k]).collect(),
        }
    }

    /// Indices of the offsets that have bonds.
    pub(in super::super) fn bonded(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.offsets.len()).filter(|&k| self.has_bonds(k))
    }

    /// Whether there are bonds of an offset.
    pub(in super::super) fn has_bonds(&self, offset: usize) -> bool {
        (0..=self.others.len()).any(|table| self.weights_of(table, offset).iter().any(|&w| w > 0.0))
    }

    /// Weights of an offset in a table.
    pub(in super::super) fn weights_of(&self, table: usize, offset: usize) -> &[f64; M] {
        if table == 0 { &self.weights[offset] } else { &self.others[table - 1][offset] }
    }

    /// The same where all points have the weights of a table.
    pub(in super::super) fn of_one(&self, table: usize) -> Self {
        let weights = (0..self.offsets.len()).map(|offset| *self.weights_of(table, offset)).collect();
        Self { weights, others: Vec::new(), along: Vec::new(), ..self.clone() }
    }

    /// Number of materials with tables of their own, less the blends among the tables.
    pub(in super::super) fn materials(&self, blends: usize) -> usize {
        self.others.len() + 1 - blends
    }

    /// The same with the tables of the first `materials` and of blends of these.
    pub(in super::super) fn with_blends(&self, materials: usize, blends: &[Blend]) -> Self {
        let of = |blend: &Blend, tables: &dyn Fn(usize, usize) -> [f64; M]| -> Vec<[f64; M]> {
            let sum = |offset: usize, m: usize| {
                blend.iter().enumerate().map(|(k, part)| part * tables(k, offset)[m]).sum()
            };
            (0..self.offsets.len()).map(|offset| from_fn(|m| sum(offset, m))).collect()
        };
        let (mut others, mut along) = (self.others.clone(), self.along.clone());
        others.truncate(materials - 1);
        others.extend(blends.iter().map(|blend| of(blend, &|table, offset| *self.weights_of(table, offset))));
        along.truncate(materials);
        along.extend(
            blends.iter().map(|blend| of(blend, &|table, offset| self.of_material(table, offset).along)),
        );
        Self { others, along, ..self.clone() }
    }

    /// What the material of a table has for an offset.
    pub(in super::super) fn of_material(&self, table: usize, offset: usize) -> OfMaterial<M> {
        let weights = *self.weights_of(table, offset);
        OfMaterial { weights, along: self.along.get(table).map_or(weights, |of| of[offset]) }
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
