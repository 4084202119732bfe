//! Connected parts of a body.

/// Disjoint sets of points, joined by whatever couples them.
#[derive(Clone, Debug)]
pub struct Parts {
    parent: Vec<u32>,
}

impl Parts {
    /// Every point by itself.
    ///
    /// # Panics
    /// More than `u32::MAX` points.
    pub fn new(points: usize) -> Self {
        let end = u32::try_from(points).expect("points are numbered by u32");
        Self { parent: (0..end).collect() }
    }

    fn root(&mut self, point: usize) -> usize {
        let mut p = point;
        while self.parent[p] as usize != p {
            let grandparent = self.parent[self.parent[p] as usize];
            self.parent[p] = grandparent;
            p = grandparent as usize;
        }
        p
    }

    /// Points `i` and `j` hang together.
    pub fn join(&mut self, i: usize, j: usize) {
        let (a, b) = (self.root(i), self.root(j));
        // The lower number is the root, so that a chain joined in order stays flat.
        if a != b {
            self.parent[a.max(b)] = a.min(b) as u32;
        }
    }

    /// Part number of every point, parts numbered in the order of their first point, and their count.
    pub fn labels(self) -> (Vec<u32>, usize) {
        let mut label = self.parent;
        // A parent has a lower number, so one pass in order makes every parent a root.
        for p in 0..label.len() {
            label[p] = label[label[p] as usize];
        }
        let mut count = 0;
        for p in 0..label.len() {
            // The entry of a root below is its label already.
            label[p] = if label[p] as usize == p {
                count += 1;
                count as u32 - 1
            } else {
                label[label[p] as usize]
            };
        }
        (label, count)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_numbered_by_their_first_point() {
        let mut parts = Parts::new(6);
        parts.join(5, 1);
        parts.join(2, 3);
        parts.join(3, 5);
        assert_eq!(parts.labels(), (vec![0, 1, 1, 1, 2, 1], 3));
    }
}
