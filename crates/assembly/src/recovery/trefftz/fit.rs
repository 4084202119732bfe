//! The polynomial that is nearest to what is known around a place.

use super::Basis;
use nalgebra::{DMatrix, DVector};

/// Combinations of fields that the equations see less, relative to the one that they see best, are left out.
const TOLD: f64 = 1e-8;
/// Displacements whose strained part is smaller, relative to them, are those of a rigid body.
const ROUNDING: f64 = 1e-12;

/// Something that is known at a place, relative to the centre of a fit over its radius.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Known {
    /// The displacement of a point.
    Displacement([f64; 2]),
    /// On a border with this outward normal, along each axis the displacement where it is held, the traction elsewhere.
    Border {
        /// The place.
        at: [f64; 2],
        /// Unit normal.
        normal: [f64; 2],
        /// Along which axes the displacement is known.
        held: [bool; 2],
    },
}

/// How the coefficients of the fields follow from what is known: two numbers of each, in the order of the axes.
#[derive(Clone, Debug)]
pub struct LocalFit {
    solution: DMatrix<f64>,
}

impl LocalFit {
    /// The least squares of equations that count less the farther away they are, by exp(−r²) over the radius; tractions count
    /// as the displacements of half a radius that they strain. None if the equations are not finite.
    pub fn new(basis: &Basis, radius: f64, known: &[Known]) -> Option<Self> {
        let (matrix, weights) = equations(basis, radius, known);
        Some(Self::weighted(pseudo_inverse(matrix)?, &weights))
    }

    /// The same of some combinations of the fields alone, one column each.
    pub fn within(combinations: &DMatrix<f64>, basis: &Basis, radius: f64, known: &[Known]) -> Option<Self> {
        let (matrix, weights) = equations(basis, radius, known);
        Some(Self::weighted(combinations * pseudo_inverse(matrix * combinations)?, &weights))
    }

    fn weighted(mut solution: DMatrix<f64>, weights: &DVector<f64>) -> Self {
        solution.column_iter_mut().zip(weights.iter()).for_each(|(mut column, w)| column *= *w);
        Self { solution }
    }

    /// Coefficients of the fields, of what is known.
    ///
    /// # Panics
    /// These are not as many numbers as there are equations.
    pub fn coefficients(&self, known: &[f64]) -> DVector<f64> {
        &self.solution * DVector::from_column_slice(known)
    }

    /// What the fields miss of some numbers: the norm, in which all count as in the fit.
    pub fn missed(&self, basis: &Basis, radius: f64, known: &[Known], values: &[f64]) -> f64 {
        let (matrix, weights) = equations(basis, radius, known);
        let missed =
            DVector::from_column_slice(values).component_mul(&weights) - matrix * self.coefficients(values);
        missed.norm()
    }

    /// The displacements among some numbers less their rigid motion, in the same norm; 0 where that is rounding.
    pub fn strained(&self, basis: &Basis, known: &[Known], values: &[f64]) -> f64 {
        let coefficients = self.coefficients(values);
        let centre = [0.0; 2];
        let shift = basis.displacements(centre).tr_mul(&coefficients);
        let turn = basis.rotations(centre).dot(&coefficients);
        let (mut moved, mut strained) = (0.0, 0.0);
        for (one, values) in known.iter().zip(values.chunks_exact(2)) {
            let Known::Displacement([x, y]) = *one else { continue };
            let rigid = [shift[0] - turn * y, shift[1] + turn * x];
            for c in 0..2 {
                moved += (weight([x, y]) * values[c]).powi(2);
                strained += (weight([x, y]) * (values[c] - rigid[c])).powi(2);
            }
        }
        if strained > ROUNDING * ROUNDING * moved { strained.sqrt() } else { 0.0 }
    }
}

/// What an equation counts, by its place.
fn weight([x, y]: [f64; 2]) -> f64 {
    (-x * x - y * y).exp()
}

/// The equations of what is known, and what its numbers are multiplied by.
fn equations(basis: &Basis, radius: f64, known: &[Known]) -> (DMatrix<f64>, DVector<f64>) {
    let fields = basis.count();
    // One column per equation, as all fields of one lie together.
    let mut matrix = DMatrix::zeros(fields, 2 * known.len());
    let mut weights = DVector::zeros(2 * known.len());
    let columns = matrix.as_mut_slice().chunks_exact_mut(2 * fields);
    for ((one, columns), weights) in known.iter().zip(columns).zip(weights.as_mut_slice().chunks_exact_mut(2))
    {
        let (Known::Displacement(at) | Known::Border { at, .. }) = *one;
        let weight = weight(at);
        weights.fill(weight);
        columns.copy_from_slice(basis.displacements(at).as_slice());
        if let Known::Border { normal: [x, y], held, .. } = *one {
            let stress = basis.stresses(at);
            let free = columns.chunks_exact_mut(fields).enumerate().filter(|(c, _)| !held[*c]);
            for (c, column) in free {
                let [along_x, along_y] = [stress.column(2 * c), stress.column(2 - c)];
                column.iter_mut().zip(0..).for_each(|(t, k)| *t = along_x[k] * x + along_y[k] * y);
                weights[c] *= radius / basis.unit();
            }
        }
        columns.iter_mut().for_each(|x| *x *= weight);
    }
    (matrix.transpose(), weights)
}

/// The inverse in the sense of least squares: of the triangle of a factor, which is small.
fn pseudo_inverse(matrix: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let (rows, columns) = matrix.shape();
    let tall = if rows < columns { matrix.resize_vertically(columns, 0.0) } else { matrix };
    let factor = tall.qr();
    let triangle = factor.r();
    let least = TOLD * triangle.norm();
    // The smallest singular value is at least one over the norm of the inverse: mostly none is to be left out.
    let whole = triangle
        .solve_upper_triangular(&DMatrix::identity(columns, columns))
        .filter(|inverse| inverse.norm() * least < 1.0);
    let of_triangle = whole.or_else(|| triangle.svd(true, true).pseudo_inverse(least).ok())?;
    let all = of_triangle * factor.q().transpose();
    all.iter().all(|x| x.is_finite()).then(|| all.columns(0, rows).into_owned())
}
