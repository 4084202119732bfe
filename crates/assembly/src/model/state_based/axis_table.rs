//! Weights and radii of the points next to the axis of a body of revolution.
//!
//! Across the axis a family is completed by images, so that its strains are exact; but the volume of a point is its radius,
//! and |r| has a kink at r = 0: a uniform stress is not in equilibrium at points nearer than a horizon. So the first 2m
//! columns of points get weights w_k per offset and energy radii R_k with which it is. In lattice units, column k at
//! r = k + ½, with `W = R w` the unknowns are linear:
//!
//! * (i) `Σ W ξ² (1, cos 2φ, cos 4φ) = R q (1, 0, 0)`: strains stay exact;
//! * (ii) `Σ_k ∂[R_k (E_rr + h)_k]/∂u_r,j = 0` and (iii) `Σ_k ∂[R_k E_zz,k]/∂u_r,j = 0` for every column j: equilibrium.
//!
//! (iii) cannot hold exactly for weights like these; it is met in the least-squares sense behind (i) and (ii), with the
//! smallest change of `W/(r w)` and of `R/r`, ten times dearer.

use super::moments::correct;
use crate::body::Cell;
use nalgebra::{DMatrix, DVector};

/// Weights of the equations (i), (ii) and (iii).
const IMPORTANCE: [f64; 3] = [1e3, 1e2, 1.0];
/// What a change of a radius costs beside one of a weight.
const RADIUS_COST: f64 = 10.0;
/// Singular values below this part of the largest one count as zero.
const RANK: f64 = 1e-13;

/// What the first columns have instead of the weights of all families and of their radii.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AxisTable {
    /// Per column and offset, in the order of the offsets.
    pub(super) weights: Vec<Vec<f64>>,
    /// Per column, spacings.
    pub(super) radii: Vec<f64>,
}

/// Where the equations and unknowns of the table stand.
struct Layout<'a> {
    offsets: &'a [Cell],
    weights: &'a [f64],
    q: f64,
    /// Columns that have entries.
    columns: usize,
    /// Columns whose equilibrium they can disturb.
    reached: usize,
}

impl AxisTable {
    /// The table of families with these corrected weights per offset and the weighted volume q. `None` if some weight would
    /// be negative.
    pub(super) fn new(offsets: &[Cell], weights: &[f64], q: f64) -> Option<Self> {
        let used = |k: &usize| weights[*k].abs() > 1e-14;
        let kept: Vec<usize> = (0..offsets.len()).filter(used).collect();
        let reach = offsets.iter().map(|o| o[0].unsigned_abs() as usize).max()?;
        let cells: Vec<Cell> = kept.iter().map(|&k| offsets[k]).collect();
        let values: Vec<f64> = kept.iter().map(|&k| weights[k]).collect();
        let layout = Layout { offsets: &cells, weights: &values, q, columns: 2 * reach, reached: 3 * reach };
        let found = layout.solve()?;
        let mut table = Self { weights: Vec::new(), radii: Vec::new() };
        for column in 0..layout.columns {
            let radius = found[layout.radius(column)] * (column as f64 + 0.5);
            let mut own = vec![0.0; offsets.len()];
            for (t, &k) in kept.iter().enumerate() {
                own[k] = found[layout.weight(column, t)] * (column as f64 + 0.5) * weights[k] / radius;
            }
            // The equations (i) hold to the rounding of the large system; this is that of a small one.
            correct(offsets, &mut own, q);
            if own.iter().any(|w| *w < 0.0) {
                return None;
            }
            table.weights.push(own);
            table.radii.push(radius);
        }
        Some(table)
    }
}

impl Layout<'_> {
    fn weight(&self, column: usize, offset: usize) -> usize {
        column * self.offsets.len() + offset
    }

    fn radius(&self, column: usize) -> usize {
        self.columns * self.offsets.len() + column
    }

    fn unknowns(&self) -> usize {
        self.columns * (self.offsets.len() + 1)
    }

    /// Weights and radii per their plain values.
    fn solve(&self) -> Option<DVector<f64>> {
        let count = 3 * self.columns + 2 * self.reached;
        let mut matrix = DMatrix::zeros(count, self.unknowns());
        let mut wanted = DVector::zeros(count);
        self.strains(&mut matrix);
        self.equilibrium(&mut matrix, &mut wanted);
        // Unknowns as y = 1 + s t with the smallest t: columns of the matrix are scaled by the plain values.
        let plain = |k: usize| {
            let first = self.columns * self.offsets.len();
            if k < first {
                let (column, t) = (k / self.offsets.len(), k % self.offsets.len());
                (column as f64 + 0.5) * self.weights[t]
            } else {
                (k - first) as f64 + 0.5
            }
        };
        let scale = |k: usize| {
            if k < self.columns * self.offsets.len() { 1.0 } else { 1.0 / RADIUS_COST.sqrt() }
        };
        (0..self.unknowns()).for_each(|k| matrix.column_mut(k).scale_mut(plain(k)));
        let missing = wanted - matrix.column_sum();
        (0..self.unknowns()).for_each(|k| matrix.column_mut(k).scale_mut(scale(k)));
        let svd = matrix.svd(true, true);
        let change = svd.solve(&missing, RANK * svd.singular_values.max()).ok()?;
        Some(DVector::from_fn(self.unknowns(), |k, _| 1.0 + scale(k) * change[k]))
    }

    /// Equations (i).
    fn strains(&self, matrix: &mut DMatrix<f64>) {
        for column in 0..self.columns {
            for (t, &[a, b, _]) in self.offsets.iter().enumerate() {
                let (x, y) = (f64::from(a * a), f64::from(b * b));
                let square = x + y;
                let cos2 = (x - y) / square;
                let harmonics = [1.0, cos2, 2.0 * cos2 * cos2 - 1.0];
                for (row, value) in harmonics.into_iter().enumerate() {
                    let place = (3 * column + row, self.weight(column, t));
                    matrix[place] = IMPORTANCE[0] * square * value / self.q;
                }
            }
            matrix[(3 * column, self.radius(column))] = -IMPORTANCE[0];
        }
    }

    /// Equations (ii) and (iii); columns beyond the table have their plain weights.
    fn equilibrium(&self, matrix: &mut DMatrix<f64>, wanted: &mut DVector<f64>) {
        let first = 3 * self.columns;
        for j in 0..self.reached {
            match j < self.columns {
                true => matrix[(first + j, self.radius(j))] = IMPORTANCE[1] / (j as f64 + 0.5),
                false => wanted[first + j] -= IMPORTANCE[1],
            }
        }
        let reach = self.reached - self.columns;
        for k in 0..self.reached + reach {
            for (t, &[a, b, _]) in self.offsets.iter().enumerate() {
                let length = f64::from(a * a + b * b).sqrt();
                let n = [f64::from(a) / length, f64::from(b) / length];
                let across = k as i64 + i64::from(a);
                // The image of column j across the axis is column −1 − j, and moves the other way.
                let (other, sign) = if across < 0 { (-1 - across, -1.0) } else { (across, 1.0) };
                for (part, importance) in [(0, IMPORTANCE[1]), (1, IMPORTANCE[2])] {
                    // E_aa = Σ (w ξ/q)(4 n_a² − 1) e.
                    let value = importance * length / self.q * (4.0 * n[part] * n[part] - 1.0) * n[0];
                    for (j, value) in [(other as usize, sign * value), (k, -value)] {
                        if j >= self.reached {
                            continue;
                        }
                        let row = first + part * self.reached + j;
                        match k < self.columns {
                            true => matrix[(row, self.weight(k, t))] += value,
                            false => wanted[row] -= value * (k as f64 + 0.5) * self.weights[t],
                        }
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::super::bond_plane::Influence;
    use super::super::super::plane::{half_offsets, is_within, length};
    use super::super::moments::weighted_volume;
    use super::*;

    fn table(influence: Influence, m: f64) -> (Vec<Cell>, Vec<f64>, Option<AxisTable>) {
        let half: Vec<Cell> = half_offsets(m, 1).into_iter().filter(|&o| is_within(o, m)).collect();
        let offsets: Vec<Cell> = half.iter().copied().chain(half.iter().map(|o| o.map(|k| -k))).collect();
        let mut weights: Vec<f64> = offsets.iter().map(|&o| influence.at(length(o) / m)).collect();
        let q = weighted_volume(&offsets, &weights);
        correct(&offsets, &mut weights, q);
        let table = AxisTable::new(&offsets, &weights, q);
        (offsets, weights, table)
    }

    /// Radii and the smallest ratio `R w/(r w₀)` of an independent Python implementation.
    #[test]
    fn radii_are_those_of_an_independent_solution() {
        let expected = [
            (Influence::Linear, [0.358535, 1.335326, 2.513032, 3.439041, 4.519819, 5.521567], 0.361),
            (Influence::Inverse, [0.355974, 1.278310, 2.428366, 3.466862, 4.488920, 5.520397], 0.103),
        ];
        for (influence, radii, least) in expected {
            let (_, plain, table) = table(influence, 3.0);
            let table = table.unwrap();
            let off = table.radii.iter().zip(radii).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(off < 1e-6, "{off:e}");
            let ratio = |k: usize| {
                let of = |(w, p): (&f64, &f64)| table.radii[k] * w / ((k as f64 + 0.5) * p);
                let used = table.weights[k].iter().zip(&plain).filter(|(_, p)| p.abs() > 1e-14);
                used.map(of).fold(f64::INFINITY, f64::min)
            };
            let found = (0..6).map(ratio).fold(f64::INFINITY, f64::min);
            assert!((found - least).abs() < 1e-3, "{found}");
        }
    }

    #[test]
    fn weights_that_would_be_negative_are_refused() {
        // The smallest ratio would be −0.155 (an independent Python implementation).
        assert_eq!(table(Influence::Inverse, 4.0).2, None);
        assert!(table(Influence::Linear, 4.0).2.is_some());
    }
}
