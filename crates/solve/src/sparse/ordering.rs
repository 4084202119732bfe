//! In which order unknowns are eliminated.

use super::analysis::{buffer, out_of_memory};
use crate::{FactorError, PointGraph};
use faer::dyn_stack::MemStack;
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;
use sprs::CsMat;

/// The order of elimination of a sparse factor.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Ordering<'a> {
    /// Approximate minimum degree, from the pattern of the matrix.
    #[default]
    MinimumDegree,
    /// Approximate minimum degree of points, from their couplings; the unknowns of a point are eliminated together. As good as that of the
    /// unknowns where those of two coupled points are nearly all coupled, in a part of the time.
    MinimumDegreeOfPoints {
        /// Unknowns of each point, numbered in component planes: unknown = component · points + point.
        components: usize,
    },
    /// A given order of points, such as that of a [`Dissection`](crate::Dissection); the unknowns of a point are
    /// eliminated together. Unknowns that are coupled with no other come first and cost nothing.
    Points {
        /// Every point once.
        order: &'a [usize],
        /// Unknowns of each point, numbered in component planes: unknown = component · points + point.
        components: usize,
    },
}

/// The points of a matrix in an order of approximate minimum degree.
///
/// # Errors
///
/// [`FactorError::Shape`] if its rows are not those of points, [`FactorError::OutOfMemory`].
pub(super) fn by_degree(pattern: &CsMat<f64>, components: usize) -> Result<Vec<usize>, FactorError> {
    let rows = pattern.rows();
    if components == 0 || !rows.is_multiple_of(components) {
        return Err(FactorError::Shape {
            reason: format!("{rows} rows of points of {components} components"),
        });
    }
    let graph = PointGraph::from_matrix(pattern, components);
    let (mut starts, mut above) = (vec![0], Vec::new());
    for point in 0..graph.points() {
        above.extend(graph.neighbours(point).iter().map(|q| *q as usize).filter(|q| *q < point));
        starts.push(above.len());
    }
    let count = graph.points();
    let upper = SymbolicSparseColMatRef::new_unsorted_checked(count, count, &starts, None, &above);
    let (mut order, mut places) = (vec![0; count], vec![0; count]);
    let mut memory = buffer(amd::order_maybe_unsorted_scratch::<usize>(count, above.len()))?;
    amd::order_maybe_unsorted(&mut order, &mut places, upper, Default::default(), MemStack::new(&mut memory))
        .map_err(|error| out_of_memory(&error, 0))?;
    Ok(order)
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
