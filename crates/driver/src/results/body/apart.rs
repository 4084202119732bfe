//! Where the blocks of a map have come apart, by cracks from the start or by bonds that broke.

use super::raster::{AROUND, Raster};
use peristat_assembly::body::{Crack, in_space};
use std::collections::{BTreeMap, HashSet};

/// A side of a block: the block, and 0 for its side on the right, 1 for that above.
pub(super) type Side = [usize; 2];

impl Raster {
    /// Sides that cracks part from the block beyond.
    pub(super) fn torn(&self, cracks: &[&Crack]) -> Vec<Side> {
        if cracks.is_empty() {
            return Vec::new();
        }
        let is_torn = |&side: &Side| {
            self.beyond(side).is_some_and(|other| {
                let (a, b) = (self.middle(side[0]), self.middle(other));
                cracks.iter().any(|crack| crack.cuts(in_space(a), in_space(b), 0.0))
            })
        };
        (0..self.blocks.len()).flat_map(|block| [[block, 0], [block, 1]]).filter(is_torn).collect()
    }

    /// Sides along which at least half of the pairs of neighbours across them are among some.
    pub(super) fn between(&self, pairs: &[[usize; 2]]) -> Vec<Side> {
        let Some(grid) = &self.grid else { return Vec::new() };
        let mut counts: BTreeMap<Side, usize> = BTreeMap::new();
        for pair in pairs {
            let mut blocks = pair.map(|point| self.of[point] as usize);
            blocks.sort_unstable();
            let [[i, j], [k, l]] = blocks.map(|block| grid.cells[block]);
            match [k - i, l - j] {
                [1, 0] => *counts.entry([blocks[0], 0]).or_default() += 1,
                [0, 1] => *counts.entry([blocks[0], 1]).or_default() += 1,
                _ => {}
            }
        }
        counts.into_iter().filter(|(_, count)| 2 * count >= self.step).map(|(side, _)| side).collect()
    }

    /// The block beyond a side.
    fn beyond(&self, [block, side]: Side) -> Option<usize> {
        self.beside(block, if side == 0 { [1, 0] } else { [0, 1] })
    }

    /// The ends of both faces of a side that has come apart, from the corners of all blocks.
    pub(super) fn faces(&self, side: Side, corners: &[[[f64; 2]; 4]]) -> Vec<Vec<[f64; 2]>> {
        let [own, others] = if side[1] == 0 { [[1, 2], [0, 3]] } else { [[3, 2], [0, 1]] };
        let face = |block: usize, ends: [usize; 2]| ends.map(|end| corners[block][end]).to_vec();
        let beyond = self.beyond(side).map(|other| face(other, others));
        std::iter::once(face(side[0], own)).chain(beyond).collect()
    }

    /// Corners of all blocks moved by `factor` times the displacements, means over the blocks. A corner moves with the mean
    /// of the blocks around it that hang together with its own.
    pub(super) fn deformed(&self, mean: &[Vec<f64>; 2], factor: f64, apart: &[Side]) -> Vec<[[f64; 2]; 4]> {
        let mut all: Vec<[[f64; 2]; 4]> = self.corners().collect();
        let apart: HashSet<Side> = apart.iter().copied().collect();
        // A neighbour along a row or a column, or the block itself.
        let joined = |block: usize, [i, j]: [i32; 2]| {
            let other = self.beside(block, [i, j])?;
            let side = [block.min(other), usize::from(j != 0)];
            (other == block || !apart.contains(&side)).then_some(other)
        };
        for (block, corners) in all.iter_mut().enumerate() {
            for (corner, [right, up]) in corners.iter_mut().zip(AROUND) {
                let (mut sum, mut count) = ([0.0; 2], 0.0);
                for [i, j] in AROUND.map(|[i, j]| [right - i, up - j]) {
                    // One way around the corner, or the other.
                    let ways = [[[i, 0], [0, j]], [[0, j], [i, 0]]];
                    let found = ways.into_iter().find_map(|[a, b]| joined(joined(block, a)?, b));
                    if let Some(other) = found {
                        (0..2).for_each(|k| sum[k] += mean[k][other]);
                        count += 1.0;
                    }
                }
                (0..2).for_each(|k| corner[k] += factor * sum[k] / count);
            }
        }
        all
    }
}

#[cfg(test)]
mod tests {
    use super::super::raster::tests::raster;
    use super::*;

    #[test]
    fn a_side_is_apart_where_half_of_the_neighbours_are() {
        // Points 6 to 8 of the second row, and 12 to 14 above them; and 1 and 2 beside each other.
        let pairs = [[6, 12], [13, 7], [8, 14], [1, 2], [0, 1]];
        let mut raster = raster();
        raster.step = 2;
        assert_eq!(raster.between(&pairs), [[0, 0], [0, 1], [1, 1]]);
        let faces = raster.faces([0, 1], &raster.corners().collect::<Vec<_>>());
        assert_eq!(faces, [[[0.0, 1.0], [1.0, 1.0]], [[0.0, 1.0], [1.0, 1.0]]]);
        raster.step = 4;
        assert_eq!(raster.between(&pairs), [[0, 1]]);
    }

    #[test]
    fn corners_move_with_their_neighbours_but_not_across_a_crack() {
        let raster = raster();
        let up = vec![0.0, 0.0, 0.0, 1.0, 1.0, 1.0];
        let moved = |apart: &[Side]| raster.deformed(&[vec![0.0; 6], up.clone()], 2.0, apart);
        let whole = moved(&[]);
        assert_eq!((whole[0][2], whole[4][0], whole[4][2]), ([1.0, 2.0], [1.0, 2.0], [2.0, 4.0]));
        let crack = Crack::new(vec![[-1.0, 1.0], [4.0, 1.0]]).unwrap();
        let torn = raster.torn(&[&crack]);
        assert_eq!(torn, [[0, 1], [1, 1], [2, 1]]);
        let open = moved(&torn);
        assert_eq!((open[0][2], open[4][0]), ([1.0, 1.0], [1.0, 3.0]));
        // Beyond its tip the body hangs together.
        let tip = moved(&torn[..1]);
        assert_eq!((tip[1][2], tip[4][1]), (whole[1][2], whole[4][1]));
        assert_eq!((tip[0][3], tip[3][0]), ([0.0, 1.0], [0.0, 3.0]));
    }
}
