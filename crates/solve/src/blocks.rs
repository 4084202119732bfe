//! The block diagonal matrix `B` of a factor `L B L^T`.

/// One or two neighbouring rows of `B` that are coupled with no others.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Block {
    pub(crate) first: usize,
    pub(crate) rows: usize,
    /// Size of the pivot: the entry of a single row, the determinant over the off-diagonal entry of two.
    pub(crate) pivot: f64,
    /// Numbers of eigenvalues below and above zero.
    pub(crate) negative: usize,
    pub(crate) positive: usize,
}

/// The blocks of a matrix given by its diagonal and the entries below it, which are zero between blocks.
pub(crate) fn blocks<'a>(diagonal: &'a [f64], below: &'a [f64]) -> impl Iterator<Item = Block> + 'a {
    let mut next = 0;
    std::iter::from_fn(move || {
        let first = next;
        let a = *diagonal.get(first)?;
        let block = match (below[first], diagonal.get(first + 1)) {
            (b, Some(c)) if b != 0.0 => pair(first, a, b, *c),
            _ => Block {
                first,
                rows: 1,
                pivot: a.abs(),
                negative: usize::from(a < 0.0),
                positive: usize::from(a > 0.0),
            },
        };
        next += block.rows;
        Some(block)
    })
}

fn pair(first: usize, a: f64, b: f64, c: f64) -> Block {
    // In this order nothing overflows.
    let determinant = (a / b) * (c / b) - 1.0;
    let (negative, positive) = match determinant {
        d if d < 0.0 => (1, 1),
        d if d > 0.0 && a < 0.0 => (2, 0),
        d if d > 0.0 => (0, 2),
        _ => (usize::from(a + c < 0.0), usize::from(a + c > 0.0)),
    };
    Block { first, rows: 2, pivot: (determinant * b).abs(), negative, positive }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn signs_of_single_rows_and_pairs() {
        let diagonal = [2.0, -3.0, 0.0, 1.0, 1.0, 5.0, 1.0, -5.0, -1.0, 1.0, 1.0];
        let below = [0.0, 0.0, 0.0, 2.0, 0.0, 2.0, 0.0, 2.0, 0.0, 1.0, 0.0];
        let found: Vec<_> =
            blocks(&diagonal, &below).map(|b| (b.first, b.rows, b.negative, b.positive)).collect();
        // Determinants of the pairs: 1 - 4, 5 - 4, 5 - 4, 1 - 1.
        let pairs = [(3, 2, 1, 1), (5, 2, 0, 2), (7, 2, 2, 0), (9, 2, 0, 1)];
        assert_eq!(found[..3], [(0, 1, 0, 1), (1, 1, 1, 0), (2, 1, 0, 0)]);
        assert_eq!(found[3..], pairs);
        let pivots: Vec<f64> = blocks(&diagonal, &below).map(|b| b.pivot).collect();
        assert_eq!(pivots, [2.0, 3.0, 0.0, 1.5, 0.5, 0.5, 0.0]);
    }
}
