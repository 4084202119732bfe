//! The two roles a matrix plays in an iterative solve.

/// A symmetric linear map from vectors of length `size` to such vectors.
pub trait LinearOperator {
    /// Length of the vectors.
    fn size(&self) -> usize;

    /// Writes `A x` over `y`; both have length [`size`](Self::size).
    fn apply(&self, x: &[f64], y: &mut [f64]);

    /// Writes `A X` over `Y` for several vectors stored one after the other.
    ///
    /// Both slices have length `size * columns`. The default goes through them
    /// one by one; an operator that reads a lot of data per product should do
    /// better.
    fn apply_many(&self, x: &[f64], y: &mut [f64], columns: usize) {
        let size = self.size();
        assert_eq!(x.len(), size * columns, "one vector per column");
        assert_eq!(y.len(), size * columns, "one vector per column");
        if size == 0 {
            return;
        }
        for (x, y) in x.chunks_exact(size).zip(y.chunks_exact_mut(size)) {
            self.apply(x, y);
        }
    }
}

/// An approximate inverse of a [`LinearOperator`], symmetric positive definite.
pub trait Preconditioner {
    /// Length of the vectors.
    fn size(&self) -> usize;

    /// Writes `M^-1 r` over `z`; both have length [`size`](Self::size).
    ///
    /// The receiver is mutable so that it may keep scratch space.
    fn apply(&mut self, r: &[f64], z: &mut [f64]);
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Double;

    impl LinearOperator for Double {
        fn size(&self) -> usize {
            2
        }
        fn apply(&self, x: &[f64], y: &mut [f64]) {
            for (y, x) in y.iter_mut().zip(x) {
                *y = 2.0 * x;
            }
        }
    }

    #[test]
    fn many_columns_are_one_product_each() {
        let mut y = [0.0; 6];
        Double.apply_many(&[1.0, 2.0, 3.0, 4.0, 5.0, 6.0], &mut y, 3);
        assert_eq!(y, [2.0, 4.0, 6.0, 8.0, 10.0, 12.0]); // twice the input
    }
}
