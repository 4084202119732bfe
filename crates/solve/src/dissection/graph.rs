//! Which points are coupled.

use sprs::CsMat;

/// Neighbours of points in compressed rows; symmetric, without loops and repetitions.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PointGraph {
    starts: Vec<usize>,
    neighbours: Vec<u32>,
}

impl PointGraph {
    /// Couplings of the points of a matrix whose unknowns are numbered in component planes, unknown =
    /// component · points + point. Entries above the diagonal are not read.
    ///
    /// # Panics
    ///
    /// If the matrix is not square or its order is no multiple of `components`.
    #[must_use]
    pub fn from_matrix(matrix: &CsMat<f64>, components: usize) -> Self {
        let points = matrix.rows().checked_div(components).unwrap_or(0);
        assert_eq!((matrix.rows(), matrix.cols()), (points * components, points * components));
        Self::symmetric(&Lists::from_rows(matrix, points, components))
    }

    /// Number of points.
    #[must_use]
    pub fn points(&self) -> usize {
        self.starts.len() - 1
    }

    /// The points that a point is coupled with.
    #[must_use]
    pub fn neighbours(&self, point: usize) -> &[u32] {
        &self.neighbours[self.starts[point]..self.starts[point + 1]]
    }

    /// Both ends of a pair list it, no matter which of them did.
    fn symmetric(lists: &Lists) -> Self {
        let other = lists.transposed();
        let points = lists.points();
        let mut seen = vec![u32::MAX; points];
        let mut starts = Vec::with_capacity(points + 1);
        let mut neighbours = Vec::with_capacity(2 * lists.items.len());
        starts.push(0);
        for p in 0..points {
            for q in lists.of(p).iter().chain(other.of(p)) {
                if std::mem::replace(&mut seen[*q as usize], p as u32) != p as u32 {
                    neighbours.push(*q);
                }
            }
            starts.push(neighbours.len());
        }
        Self { starts, neighbours }
    }
}

/// Lists of points, one for each point.
struct Lists {
    starts: Vec<usize>,
    items: Vec<u32>,
}

impl Lists {
    /// The other points in the rows of each point, once each.
    fn from_rows(matrix: &CsMat<f64>, points: usize, components: usize) -> Self {
        let (rows, columns) = (matrix.proper_indptr(), matrix.indices());
        let mut seen = vec![u32::MAX; points];
        let (mut starts, mut items) = (Vec::with_capacity(points + 1), Vec::new());
        starts.push(0);
        for p in 0..points {
            seen[p] = p as u32;
            for c in 0..components {
                let row = c * points + p;
                let mut plane = 0;
                for j in columns[rows[row]..rows[row + 1]].iter().take_while(|j| **j <= row) {
                    while j - plane >= points {
                        plane += points;
                    }
                    let q = j - plane;
                    if std::mem::replace(&mut seen[q], p as u32) != p as u32 {
                        items.push(q as u32);
                    }
                }
            }
            starts.push(items.len());
        }
        Self { starts, items }
    }

    fn points(&self) -> usize {
        self.starts.len() - 1
    }

    fn of(&self, point: usize) -> &[u32] {
        &self.items[self.starts[point]..self.starts[point + 1]]
    }

    fn transposed(&self) -> Self {
        let points = self.points();
        let mut starts = vec![0; points + 1];
        for q in &self.items {
            starts[*q as usize + 1] += 1;
        }
        for p in 0..points {
            starts[p + 1] += starts[p];
        }
        let mut next = starts.clone();
        let mut items = vec![0; self.items.len()];
        for p in 0..points {
            for q in self.of(p) {
                items[next[*q as usize]] = p as u32;
                next[*q as usize] += 1;
            }
        }
        Self { starts, items }
    }
}
