//! The fields around a hole that are nearest to displacements of points.

use super::load::Outgoing;
use super::{Ellipse, Field, HoleFields, HoleLoad};
use nalgebra::{DMatrix, DVector};

/// Rows that are taken into the triangular factor at once.
const BLOCK: usize = 512;
/// Combinations of fields are left out whose size at the points is smaller than this share of the largest.
const TOLD: f64 = 1e-9;

/// Fields around a hole, fitted to displacements.
#[derive(Clone, Debug)]
pub struct HoleFit {
    fields: HoleFields,
    coefficients: Vec<f64>,
    outgoing: Outgoing,
    residual: f64,
}

impl HoleFit {
    /// Fits fields to the displacements of points, each a position and `[u_x, u_y]`, m, by least squares. `load` acts on
    /// the hole. None for fewer equations than three times the fields, or if nothing moves.
    pub fn new(
        fields: HoleFields,
        load: &HoleLoad,
        points: impl Iterator<Item = ([f64; 2], [f64; 2])>,
    ) -> Option<Self> {
        let (count, outgoing) = (fields.count(), fields.outgoing(load));
        let mut factor = Factor::new(count);
        let mut equations = 0;
        for (position, displacement) in points {
            let pulled = fields.field_of(&outgoing, position).displacement;
            let all = fields.at(position);
            for c in 0..2 {
                let values = [displacement[c] - pulled[c], displacement[c]];
                factor.add(all.iter().map(|field| field.displacement[c]), values);
            }
            equations += 2;
        }
        if equations < 3 * count {
            return None;
        }
        let (coefficients, misfit, strained) = factor.solve()?;
        let is_finite = coefficients.iter().all(|c| c.is_finite()) && strained > 0.0;
        is_finite.then_some(Self { fields, coefficients, outgoing, residual: misfit / strained })
    }

    /// The hole.
    pub fn ellipse(&self) -> &Ellipse {
        self.fields.ellipse()
    }

    /// What of the displacements the fields miss: its root of squares over that of the displacements without their mean.
    pub fn residual(&self) -> f64 {
        self.residual
    }

    /// Displacement, rotation and stress at a position outside of the hole or on its border.
    pub fn at(&self, position: [f64; 2]) -> Field {
        let mut sum = self.fields.field_of(&self.outgoing, position);
        for (field, share) in self.fields.at(position).iter().zip(&self.coefficients) {
            sum.add_multiple(*share, field);
        }
        sum
    }
}

/// Triangular factor of equations that come one by one; the last two columns are the right-hand side and the displacements.
struct Factor {
    count: usize,
    rows: usize,
    block: DMatrix<f64>,
}

impl Factor {
    fn new(count: usize) -> Self {
        Self { count, rows: 0, block: DMatrix::zeros(BLOCK + count + 2, count + 2) }
    }

    fn add(&mut self, shares: impl Iterator<Item = f64>, values: [f64; 2]) {
        if self.rows == self.block.nrows() {
            self.reduce();
        }
        let row = self.rows;
        shares.chain(values).enumerate().for_each(|(k, x)| self.block[(row, k)] = x);
        self.rows += 1;
    }

    fn reduce(&mut self) {
        let triangle = self.block.rows(0, self.rows).into_owned().qr().r();
        self.rows = triangle.nrows();
        self.block.rows_mut(0, self.rows).copy_from(&triangle);
    }

    /// Coefficients, the root of squares of what is missed, and that of the displacements without their parts along the last two
    /// fields.
    fn solve(mut self) -> Option<(Vec<f64>, f64, f64)> {
        self.reduce();
        let n = self.count;
        let mut matrix = self.block.view((0, 0), (self.rows, n)).into_owned();
        let [values, displacements] = [n, n + 1]
            .map(|column| DVector::from_iterator(self.rows, (0..self.rows).map(|k| self.block[(k, column)])));
        let translations = matrix.columns(n - 2, 2).into_owned();
        let moved = translations.clone().svd(true, true).solve(&displacements, TOLD).ok()?;
        let strained = (displacements - translations * moved).norm();
        let sizes: Vec<f64> = matrix.column_iter().map(|column| column.norm()).collect();
        matrix.column_iter_mut().zip(&sizes).for_each(|(mut column, size)| column /= *size);
        let svd = matrix.clone().svd(true, true);
        let largest = svd.singular_values.max();
        let scaled = svd.solve(&values, TOLD * largest).ok()?;
        let misfit = (&values - matrix * &scaled).norm();
        Some((scaled.iter().zip(&sizes).map(|(x, size)| x / size).collect(), misfit, strained))
    }
}
