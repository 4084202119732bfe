//! A bond: its geometry, its linear measures, and what a model says of both.

use std::array::from_fn;

/// Position of a point, m.
pub type Point = [f64; 3];

/// Relative position of the points of a bond.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BondGeometry {
    /// Vector from the first point to the second, m.
    pub xi: Point,
}

impl BondGeometry {
    /// Length of the undeformed bond, m.
    pub fn length(&self) -> f64 {
        self.xi.iter().map(|v| v * v).sum::<f64>().sqrt()
    }
}

/// Dense matrix of `R` rows and `C` columns.
pub type Mat<const R: usize, const C: usize> = [[f64; C]; R];

/// Measures of a bond from point i to point j, `s = difference·(u_j − u_i) + mean·(u_i + u_j)/2`.
///
/// Every bond of every model has this form. Written with the difference first, a rigid motion costs no digits:
/// `b_i·u_i + b_j·u_j` loses one or more on slender bodies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rows<const D: usize, const M: usize> {
    /// Coefficients of the relative displacement, `[measure][component]`.
    pub difference: Mat<M, D>,
    /// Coefficients of the mean displacement, `[measure][component]`.
    pub mean: Mat<M, D>,
}

impl<const D: usize, const M: usize> Rows<D, M> {
    /// Half of the coefficients of the mean displacement: those of the sum.
    pub fn half_mean(&self) -> Mat<M, D> {
        self.mean.map(|row| row.map(|v| 0.5 * v))
    }

    /// The M × D matrix that multiplies the first point's unknowns.
    pub fn first(&self) -> Mat<M, D> {
        from_fn(|m| from_fn(|c| 0.5 * self.mean[m][c] - self.difference[m][c]))
    }

    /// The M × D matrix that multiplies the second point's unknowns.
    pub fn second(&self) -> Mat<M, D> {
        from_fn(|m| from_fn(|c| 0.5 * self.mean[m][c] + self.difference[m][c]))
    }
}

/// `Aᵀ diag(modulus) B`, the D × D block of one pair of points.
pub fn block<const D: usize, const M: usize>(a: &Mat<M, D>, modulus: &[f64; M], b: &Mat<M, D>) -> Mat<D, D> {
    from_fn(|r| from_fn(|c| (0..M).map(|m| a[m][r] * modulus[m] * b[m][c]).sum()))
}

/// Adds a matrix to another.
pub fn add<const R: usize, const C: usize>(sum: &mut Mat<R, C>, part: &Mat<R, C>) {
    sum.iter_mut().flatten().zip(part.iter().flatten()).for_each(|(s, p)| *s += p);
}

/// Measures and moduli of one bond: the whole of a simple linear bond model.
///
/// The energy of a bond is `½ α s·diag(moduli)·s` with `s` as in [`Rows`] and the weight α that the discretisation
/// gives it.
pub trait BondModel<const D: usize, const M: usize>: Send + Sync + 'static {
    /// Entries of `Rows::difference` that can be non-zero; known when compiling, so that loops never multiply by zero.
    const DIFFERENCE: [[bool; D]; M];
    /// Entries of `Rows::mean` that can be non-zero.
    const MEAN: [[bool; D]; M];

    /// Measures of the bond.
    fn rows(&self, bond: &BondGeometry) -> Rows<D, M>;

    /// Moduli conjugate to the measures, >= 0.
    fn moduli(&self, bond: &BondGeometry) -> [f64; M];
}
