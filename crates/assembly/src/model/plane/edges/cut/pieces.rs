//! The triangles that a bond passes.

use crate::body::Cell;

/// A triangle that a bond passes, and how much of the bond it has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Piece {
    /// Its block, from that whose lower left cell is that of the first point.
    pub(super) block: Cell,
    /// Which of the four of the block.
    pub(super) triangle: usize,
    /// Part of the bond: over all triangles they sum to one.
    pub(super) share: f64,
}

/// The triangles that the bond of an offset passes. Either diagonal divides a block into two of them, and has half of the bond;
/// what lies on a side belongs to the triangles on both sides of it alike.
pub(super) fn pieces(offset: Cell) -> Vec<Piece> {
    let [a, b, _] = offset.map(f64::from);
    let mut found: Vec<Piece> = Vec::new();
    for rises in [true, false] {
        for ends in places(offset, rises).windows(2) {
            let middle = 0.5 * (ends[0] + ends[1]);
            for beside in [1e-6, -1e-6] {
                let at = [a * middle - b * beside, b * middle + a * beside];
                let (block, triangle) = triangle_at(at, rises);
                let share = 0.25 * (ends[1] - ends[0]);
                match found.iter_mut().find(|p| p.block == block && p.triangle == triangle) {
                    Some(known) => known.share += share,
                    None => found.push(Piece { block, triangle, share }),
                }
            }
        }
    }
    found
}

/// Where a bond crosses rows, columns and diagonals, in parts of its length, with both ends.
fn places([a, b, _]: Cell, rises: bool) -> Vec<f64> {
    let diagonal = if rises { a - b } else { a + b };
    let mut places = vec![0.0, 1.0];
    for steps in [a, b, diagonal].map(i32::abs) {
        places.extend((1..steps).map(|k| f64::from(k) / f64::from(steps)));
    }
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    places
}

/// The block of a position, in spacings from a point, and the triangle there that one of the diagonals makes.
pub(super) fn triangle_at(at: [f64; 2], rises: bool) -> (Cell, usize) {
    let low = at.map(|x| x.floor());
    let [x, y] = [0, 1].map(|k| at[k] - low[k]);
    let triangle = match rises {
        true => 1 + usize::from(x < y),
        false => 3 * usize::from(x + y > 1.0),
    };
    ([low[0] as i32, low[1] as i32, 0], triangle)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_triangle_inside_has_a_quarter_of_each_offset() {
        for offset in
            [[1, 0], [0, 2], [1, 1], [-1, 1], [2, 1], [-1, 3], [3, 2], [-4, 1]].map(|[a, b]| [a, b, 0])
        {
            let found = pieces(offset);
            assert!((found.iter().map(|p| p.share).sum::<f64>() - 1.0).abs() < 1e-12);
            // One bond begins at every point, so that a triangle meets all pieces of its kind.
            for triangle in 0..4 {
                let all: f64 = found.iter().filter(|p| p.triangle == triangle).map(|p| p.share).sum();
                assert!((all - 0.25).abs() < 1e-12, "{offset:?} {triangle} {all}");
            }
        }
    }

    #[test]
    fn a_side_belongs_to_both_sides() {
        let blocks: Vec<Cell> = pieces([1, 0, 0]).iter().map(|p| p.block).collect();
        assert!(blocks.contains(&[0, 0, 0]) && blocks.contains(&[0, -1, 0]));
        assert!(pieces([1, 1, 0]).iter().all(|p| p.block == [0, 0, 0]));
    }
}
