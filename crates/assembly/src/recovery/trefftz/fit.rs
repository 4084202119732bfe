//! The polynomial that is nearest to what is known around a place.

use super::Basis;
use nalgebra::{DMatrix, DVector};

/// Combinations of fields that the equations see less, relative to the one that they see best, are left out.
const TOLD: f64 = 1e-8;

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
        Some(Self::weighted(inverse(matrix)?, &weights))
    }

    /// The same of some combinations of the fields alone, one column each.
    pub fn within(combinations: &DMatrix<f64>, basis: &Basis, radius: f64, known: &[Known]) -> Option<Self> {
        let (matrix, weights) = equations(basis, radius, known);
        Some(Self::weighted(combinations * inverse(matrix * combinations)?, &weights))
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
}

/// The equations of what is known, and what its numbers are multiplied by.
fn equations(basis: &Basis, radius: f64, known: &[Known]) -> (DMatrix<f64>, DVector<f64>) {
    let mut matrix = DMatrix::zeros(2 * known.len(), basis.count());
    let mut weights = DVector::zeros(2 * known.len());
    for (k, one) in known.iter().enumerate() {
        let (Known::Displacement(at) | Known::Border { at, .. }) = *one;
        let weight = (-at[0] * at[0] - at[1] * at[1]).exp();
        let mut enter = |c: usize, row: nalgebra::RowDVector<f64>, unit: f64| {
            matrix.row_mut(2 * k + c).copy_from(&(row * weight));
            weights[2 * k + c] = weight * unit;
        };
        let moved = || basis.displacements(at);
        match *one {
            Known::Displacement(_) => {
                let rows = moved();
                (0..2).for_each(|c| enter(c, rows.row(c).into_owned(), 1.0));
            }
            Known::Border { normal: [x, y], held, .. } => {
                let stress = basis.stresses(at);
                let traction = [stress.row(0) * x + stress.row(2) * y, stress.row(2) * x + stress.row(1) * y];
                for (c, row) in traction.into_iter().enumerate() {
                    match held[c] {
                        true => enter(c, moved().row(c).into_owned(), 1.0),
                        false => enter(c, row, radius / basis.unit()),
                    }
                }
            }
        }
    }
    (matrix, weights)
}

/// The inverse in the sense of least squares: of the triangle of a factor, which is small.
fn inverse(matrix: DMatrix<f64>) -> Option<DMatrix<f64>> {
    let (rows, columns) = matrix.shape();
    let tall = if rows < columns { matrix.resize_vertically(columns, 0.0) } else { matrix };
    let factor = tall.qr();
    let svd = factor.r().svd(true, true);
    let triangle = svd.pseudo_inverse(TOLD * factor.r().norm()).ok()?;
    let all = triangle * factor.q().transpose();
    all.iter().all(|x| x.is_finite()).then(|| all.columns(0, rows).into_owned())
}
