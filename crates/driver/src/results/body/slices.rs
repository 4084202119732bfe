//! Pictures of the inside of a solid: slices through its middle across the axes.

use super::blocks::Blocks;
use crate::output::plot::{Patch, short};
use peristat_assembly::body::Cell;

/// A slice of blocks across an axis.
pub(super) struct Slice {
    /// Name of the axis.
    pub(super) name: &'static str,
    /// Where it is, and how it is seen.
    pub(super) note: String,
    /// Its blocks.
    pub(super) patches: Vec<Patch>,
}

/// How a slice across an axis is seen: the axes to the right and upwards, whether that to the right runs to the left, or that
/// upwards downwards, and all that in words.
const SEEN: [(&str, [usize; 2], [f64; 2], &str); 3] = [
    ("x", [2, 1], [-1.0, 1.0], "seen from the right: y upwards, z to the left"),
    ("y", [0, 2], [1.0, -1.0], "seen from above: x to the right, z downwards"),
    ("z", [0, 1], [1.0, 1.0], "seen from in front: x to the right, y upwards"),
];

/// The slices through the middle of the box across x, y and z, or the nearest cells to it; an axis along which there is one block has none.
pub(super) fn slices(blocks: &Blocks, values: &[f64]) -> Vec<Slice> {
    let axes = (0..3).filter(|&axis| blocks.size[axis] > 1);
    axes.map(|axis| slice(blocks, values, axis)).collect()
}

fn slice(blocks: &Blocks, values: &[f64], axis: usize) -> Slice {
    let (name, [across, up], signs, seen) = SEEN[axis];
    // The middle may be empty.
    let middle = blocks.size[axis] / 2;
    let from_middle = |cell: &Cell| (cell[axis] - middle).abs();
    let layer = blocks.cells.iter().min_by_key(|cell| from_middle(cell)).map_or(middle, |cell| cell[axis]);
    let corner = |cell: Cell, [right, above]: [i32; 2]| {
        let mut node = cell;
        node[across] += right;
        node[up] += above;
        let at = blocks.place(node);
        [signs[0] * at[across], signs[1] * at[up]]
    };
    // Around from the lower left of the picture, so that cells in a row join.
    let side = |k: usize, end: i32| if signs[k] > 0.0 { end } else { 1 - end };
    let around = [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[a, b]| [side(0, a), side(1, b)]);
    let own = blocks.cells.iter().zip(values).filter(|(cell, _)| cell[axis] == layer);
    let patch = |(cell, &value): (&Cell, &f64)| Patch::flat(around.map(|ends| corner(*cell, ends)), value);
    let mut patches: Vec<Patch> = own.map(patch).collect();
    patches.sort_by(|a, b| {
        let [a, b] = [a, b].map(|p| p.corners[0]);
        a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0]))
    });
    let mut next = [0; 3];
    next[axis] = layer;
    let from = blocks.place(next)[axis];
    next[axis] += 1;
    let at = short(0.5 * (from + blocks.place(next)[axis]));
    Slice { name, note: format!("cells at {name} = {at}, {seen}; colours of the whole body"), patches }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::body::{PointBody, SquareLattice};

    #[test]
    fn slices_show_the_middle_layer_the_right_way_round() {
        let lattice = SquareLattice::cuboid(1.0, [0.0; 3], [3, 2, 4]);
        let blocks = Blocks::new(&PointBody::Solid(lattice), |_| true);
        // 100 x + 10 y + z of the middle of a cell.
        let at = |cell: &Cell| [0, 1, 2].map(|k| f64::from(cell[k]) + 0.5);
        let value = |cell: &Cell| 100.0 * at(cell)[0] + 10.0 * at(cell)[1] + at(cell)[2];
        let values: Vec<f64> = blocks.cells.iter().map(value).collect();
        let all = slices(&blocks, &values);
        assert_eq!(all.iter().map(|s| s.patches.len()).collect::<Vec<_>>(), [8, 12, 6]);
        for (axis, slice) in all.iter().enumerate() {
            for p in &slice.patches {
                let [x, y] = [0, 1].map(|k| 0.5 * (p.corners[0][k] + p.corners[2][k]));
                // Around from the lower left.
                assert!(p.corners[1][0] > p.corners[0][0] && p.corners[3][1] > p.corners[0][1]);
                let place = [[1.5, y, -x], [x, 1.5, -y], [x, y, 2.5]][axis];
                assert_eq!(p.value, 100.0 * place[0] + 10.0 * place[1] + place[2]);
            }
        }
        assert!(all[0].note.starts_with("cells at x = 1.5, seen from the right"), "{}", all[0].note);
        let sheet = SquareLattice::cuboid(1.0, [0.0; 3], [3, 2, 1]);
        assert_eq!(slices(&Blocks::new(&PointBody::Solid(sheet), |_| true), &[0.0; 6]).len(), 2);
    }

    #[test]
    fn a_slice_where_the_middle_is_empty_is_beside_it() {
        let parted = SquareLattice::new(1.0, [0.0; 3], [0..5, 0..2, 0..2], |cell| cell[0] != 2);
        let blocks = Blocks::new(&PointBody::Solid(parted), |_| true);
        let all = slices(&blocks, &[1.0; 16]);
        assert_eq!(all.iter().map(|s| s.patches.len()).collect::<Vec<_>>(), [4, 8, 8]);
        assert!(all[0].note.starts_with("cells at x = 1.5"), "{}", all[0].note);
    }
}
