//! In which order unknowns are eliminated.

use crate::FactorError;
use sprs::CsMat;

/// The order of elimination of a sparse factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ordering<'a> {
    /// Approximate minimum degree, from the pattern of the matrix.
    #[default]
    MinimumDegree,
    /// A given order of points, such as that of a [`Dissection`](crate::Dissection); the unknowns of a point are
    /// eliminated together. Unknowns that are coupled with no other come first and cost nothing.
    Points {
        /// Every point once.
        order: &'a [usize],
        /// Unknowns of each point, numbered in component planes: unknown = component · points + point.
        components: usize,
    },
}

/// The unknowns of a matrix in the order of their points, those without couplings first.
///
/// # Errors
///
/// [`FactorError::Shape`] if the points are no permutation or their unknowns are not those of the matrix.
pub(super) fn unknowns(
    pattern: &CsMat<f64>,
    points: &[usize],
    components: usize,
) -> Result<Vec<usize>, FactorError> {
    let wrong = |reason: String| Err(FactorError::Shape { reason });
    if points.len() * components != pattern.rows() {
        let (rows, count) = (pattern.rows(), points.len());
        return wrong(format!("{rows} rows, but {count} points of {components} components"));
    }
    let mut seen = vec![false; points.len()];
    for p in points {
        match seen.get_mut(*p) {
            Some(seen) if !*seen => *seen = true,
            _ => return wrong(format!("the order has point {p} twice, or there is no such point")),
        }
    }
    let coupled = coupled(pattern);
    let all = || points.iter().flat_map(|p| (0..components).map(|c| c * points.len() + *p));
    let free = all().filter(|i| !coupled[*i]);
    Ok(free.chain(all().filter(|i| coupled[*i])).collect())
}

/// Whether the row or the column of an unknown has an entry off the diagonal; entries above it are not read.
pub(crate) fn coupled(pattern: &CsMat<f64>) -> Vec<bool> {
    let (rows, columns) = (pattern.proper_indptr(), pattern.indices());
    let mut coupled = vec![false; pattern.rows()];
    for row in 0..pattern.rows() {
        for column in columns[rows[row]..rows[row + 1]].iter().take_while(|j| **j < row) {
            coupled[row] = true;
            coupled[*column] = true;
        }
    }
    coupled
}
