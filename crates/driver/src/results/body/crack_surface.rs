//! The surface of the cracks of a solid that breaks, as a grid: the sides between neighbouring cells whose bond has broken.

use crate::case::FieldName;
use crate::output::vtu::{self, CellType, Cells, DataArray, Grid};
use crate::run::body::BodyResult;
use crate::scene::body::BodyScene;
use peristat_assembly::body::{Cell, SquareLattice, plus};
use std::collections::BTreeMap;
use std::io;
use std::path::Path;

/// Corners of the side above a cell along an axis, around, as steps from its lowest corner.
const CORNERS: [[Cell; 4]; 3] = [
    [[1, 0, 0], [1, 1, 0], [1, 1, 1], [1, 0, 1]],
    [[0, 1, 0], [0, 1, 1], [1, 1, 1], [1, 1, 0]],
    [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
];

/// Writes it with what its faces have moved apart, `jump`, and the part of that along its normal, `opening`.
///
/// # Errors
/// The file cannot be written.
pub(super) fn write(
    file: &Path,
    (scene, lattice): (&BodyScene, &SquareLattice),
    result: &BodyResult,
) -> io::Result<()> {
    let u =
        [FieldName::Ux, FieldName::Uy, FieldName::Uz].map(|f| result.values(scene, f).unwrap_or_default());
    let mut sides = sides(lattice, result.parted(scene));
    sides.sort_unstable();
    let (mut numbers, mut points): (BTreeMap<Cell, u32>, Vec<[f64; 3]>) = Default::default();
    let (mut quads, mut jumps, mut openings) = (Vec::new(), Vec::new(), Vec::new());
    for (axis, [below, above]) in sides {
        let cell = lattice.cell(below);
        for corner in CORNERS[axis].map(|step| plus(cell, step)) {
            let number = *numbers.entry(corner).or_insert_with(|| {
                let centre = lattice.centre(corner);
                points.push(centre.map(|x| x - 0.5 * lattice.spacing()));
                points.len() as u32 - 1
            });
            quads.push(number);
        }
        let jump = u.each_ref().map(|u| u[above] - u[below]);
        jumps.extend(jump);
        openings.push(jump[axis]);
    }
    let grid = Grid {
        points: &points,
        cells: &[Cells { cell_type: CellType::Quad, connectivity: &quads }],
        point_data: &[],
        cell_data: &[
            DataArray { name: "jump", components: 3, values: &jumps, unit: scene.units.length() },
            DataArray { name: "opening", components: 1, values: &openings, unit: scene.units.length() },
        ],
    };
    vtu::write(file, &grid)
}

/// Pairs of neighbouring points with the axis along which they follow each other, the lower one first.
fn sides(lattice: &SquareLattice, pairs: Vec<[usize; 2]>) -> Vec<(usize, [usize; 2])> {
    let side = |[a, b]: [usize; 2]| {
        let [low, high] = [a, b].map(|point| lattice.cell(point));
        let axis = (0..3).find(|&k| low[k] != high[k])?;
        Some((axis, if low[axis] < high[axis] { [a, b] } else { [b, a] }))
    };
    pairs.into_iter().filter_map(side).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sides_lie_between_their_cells() {
        let lattice = SquareLattice::cuboid(0.5, [0.0; 3], [3, 3, 3]);
        let number = |cell: Cell| lattice.number(cell).expect("a cell of the block");
        for (axis, step) in [[1, 0, 0], [0, 1, 0], [0, 0, 1]].into_iter().enumerate() {
            let cell = [1, 1, 1];
            let pair = [number(cell), number(plus(cell, step))];
            assert_eq!(sides(&lattice, vec![[pair[1], pair[0]]]), [(axis, pair)]);
            // Its four corners are those that both cells have, around: of neighbours one index differs.
            let corners = CORNERS[axis];
            for k in 0..4 {
                assert_eq!(corners[k][axis], 1);
                let next = corners[(k + 1) % 4];
                assert_eq!((0..3).filter(|&c| corners[k][c] != next[c]).count(), 1);
            }
        }
    }
}
