//! A preconditioner that is exact on a few smooth vectors, of which the rest of it may know nothing.

use crate::band::{BandCholesky, BandMatrix};
use crate::{FactorError, LinearOperator, Preconditioner};
use peristat_vector::{add, subtract_from};

/// Vectors `W` that a preconditioner gets exactly right.
pub trait SmoothVectors {
    /// How many.
    fn count(&self) -> usize;

    /// Largest difference of the numbers of two that the matrix couples.
    fn reach(&self) -> usize;

    /// Adds `W factors` to `x`.
    fn add(&self, factors: &[f64], x: &mut [f64]);

    /// Writes `Wᵀ r` over `products`, of vectors `r` that are zero where all of `W` are.
    fn project(&self, r: &[f64], products: &mut [f64]);
}

/// The preconditioner `M` of a matrix `A`, deflated by smooth vectors `W`:
///
/// ```text
/// z = C r + (1 − C A) M (1 − A C) r,   C = W (Wᵀ A W)⁻¹ Wᵀ
/// ```
///
/// It is the two-level balancing preconditioner of Mandel (1993). Where `M` is the factor of a rounded matrix, which has lost the
/// softest motions in the rounding of the stiffest, `C` is exact on them and conjugate gradients see the others alone.
pub struct Deflated<'a> {
    operator: Box<dyn LinearOperator + 'a>,
    rest: Box<dyn Preconditioner + 'a>,
    coarse: Coarse<'a>,
    residual: Vec<f64>,
    correction: Vec<f64>,
}

/// `C`, with room for products and factors of the vectors.
struct Coarse<'a> {
    vectors: Box<dyn SmoothVectors + 'a>,
    factor: BandCholesky,
    products: Vec<f64>,
    factors: Vec<f64>,
}

impl Coarse<'_> {
    /// Adds `sign C r` to `x`.
    fn add(&mut self, sign: f64, r: &[f64], x: &mut [f64]) {
        self.vectors.project(r, &mut self.products);
        self.products.iter_mut().for_each(|product| *product *= sign);
        self.factor.apply(&self.products, &mut self.factors);
        self.vectors.add(&self.factors, x);
    }
}

impl<'a> Deflated<'a> {
    /// Deflates `rest`, a preconditioner of the operator, by at least one vector.
    ///
    /// # Errors
    /// [`FactorError`] with the preconditioner if `Wᵀ A W` has no factor.
    pub fn new(
        operator: Box<dyn LinearOperator + 'a>,
        rest: Box<dyn Preconditioner + 'a>,
        vectors: Box<dyn SmoothVectors + 'a>,
    ) -> Result<Self, (FactorError, Box<dyn Preconditioner + 'a>)> {
        let (size, count) = (operator.size(), vectors.count());
        let (mut residual, mut correction) = (vec![0.0; size], vec![0.0; size]);
        let matrix = coarse_matrix(&*operator, &*vectors, [&mut residual, &mut correction]);
        let factor = match BandCholesky::factor(matrix, 1) {
            Ok(factor) => factor,
            Err(error) => return Err((error, rest)),
        };
        let coarse = Coarse { vectors, factor, products: vec![0.0; count], factors: vec![0.0; count] };
        Ok(Self { operator, rest, coarse, residual, correction })
    }
}

/// `Wᵀ A W`. Vectors whose numbers differ by more than twice the reach couple to none in common, so that one product with `A` serves
/// all of these.
fn coarse_matrix(
    operator: &dyn LinearOperator,
    vectors: &dyn SmoothVectors,
    [x, image]: [&mut [f64]; 2],
) -> BandMatrix {
    let (count, reach) = (vectors.count(), vectors.reach());
    let (width, stride) = (reach + 1, 2 * reach + 1);
    let mut values = vec![0.0; count * width];
    let mut products = vec![0.0; count];
    for first in 0..stride.min(count) {
        let factors: Vec<f64> = (0..count).map(|k| f64::from(u8::from(k % stride == first))).collect();
        x.fill(0.0);
        vectors.add(&factors, x);
        operator.apply(x, image);
        vectors.project(image, &mut products);
        for k in (first..count).step_by(stride) {
            let rows = &products[k..(k + width).min(count)];
            values[k * width..][..rows.len()].copy_from_slice(rows);
        }
    }
    BandMatrix { order: count, half_bandwidth: reach, values }
}

impl Preconditioner for Deflated<'_> {
    fn size(&self) -> usize {
        self.operator.size()
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        let Self { operator, rest, coarse, residual, correction } = self;
        z.fill(0.0);
        coarse.add(1.0, r, z);
        operator.apply(z, residual);
        subtract_from(r, residual);
        rest.apply(residual, correction);
        operator.apply(correction, residual);
        coarse.add(-1.0, residual, correction);
        add(z, 1.0, correction);
    }
}

#[cfg(test)]
mod tests;
