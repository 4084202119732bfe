//! Pictures of a state of a solid: its surface as it is seen from in front, from the right and from above, isometrically, and slices.
//!
//! Sides of cells become rhombi of two triangles each on a grid that all layers share, so that of several sides which hide each other
//! the nearest one is kept, exactly. Large bodies are drawn by blocks of several cells.

use super::blocks::Blocks;
use super::plots::{range, size_of};
use super::slices::slices;
use crate::case::FieldName;
use crate::output::plot::{Light, Map, Patch, write_map};
use crate::results::factor::magnification;
use crate::run::body::BodyResult;
use crate::scene::body::BodyScene;
use peristat_assembly::body::{Cell, plus};
use std::collections::HashMap;
use std::io;
use std::path::Path;

/// Triangles of a picture, at most, about.
const MOST: usize = 40_000;

/// Writes the pictures of a state into a folder.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(folder: &Path, scene: &BodyScene, result: &BodyResult, title: &str) -> io::Result<()> {
    let u =
        [FieldName::Ux, FieldName::Uy, FieldName::Uz].map(|f| result.values(scene, f).unwrap_or_default());
    let size: Vec<f64> = (0..scene.body().points()).map(|p| u[0][p].hypot(u[1][p]).hypot(u[2][p])).collect();
    let blocks = Blocks::new(scene.body(), fits);
    let factor = magnification(size_of(scene), range(scene, &size).0[1]);
    let moved = blocks.moved([&u[0], &u[1], &u[2]], factor);
    let draw = |file: &str, label: &str, values: &[f64], note: &str, patches: Vec<Patch>| {
        let map = Map {
            title: title.into(),
            note: note.into(),
            label: label.into(),
            range: range(scene, values).0,
            patches,
            ..Map::default()
        };
        write_map(&folder.join(format!("{file}.svg")), &map)
    };
    let units = scene.units;
    let label = units.label("displacement", units.length());
    let note = format!("deformed shape, displacements times {factor}; {}", range(scene, &size).1);
    draw("displacement", &label, &size, &note, patches(&blocks, &blocks.means(&size), &moved))?;
    let Some(values) = result.values(scene, FieldName::VonMises) else { return Ok(()) };
    let (label, means) = (units.label("von Mises stress", units.stress()), blocks.means(&values));
    let note = range(scene, &values).1;
    draw("von_mises", &label, &values, &note, patches(&blocks, &means, &|node| blocks.place(node)))?;
    slices(&blocks, &means).into_iter().try_for_each(|slice| {
        draw(&format!("von_mises_{}", slice.name), &label, &values, &slice.note, slice.patches)
    })
}

/// Where the corner of a block is, m.
type Corners<'a> = dyn Fn(Cell) -> [f64; 3] + 'a;

/// The sides that are seen: the step to the block before one, its corners around, beginning with the nearest, and its light, which
/// comes from above on the left.
const SEEN: [(Cell, [Cell; 4], Light); 3] = [
    ([1, 0, 0], [[1, 1, 1], [1, 0, 1], [1, 0, 0], [1, 1, 0]], Light::Low),
    ([0, 1, 0], [[1, 1, 1], [1, 1, 0], [0, 1, 0], [0, 1, 1]], Light::Full),
    ([0, 0, 1], [[1, 1, 1], [0, 1, 1], [0, 0, 1], [1, 0, 1]], Light::Half),
];

/// Corners that lie behind each other in the picture have the same.
fn shadow([i, j, k]: Cell) -> [i32; 2] {
    [i - j, j - k]
}

/// How near a corner is to who looks.
fn nearness([i, j, k]: Cell) -> i32 {
    i + j + k
}

/// A position in the picture.
fn projected([x, y, z]: [f64; 3]) -> [f64; 2] {
    [0.5 * 3.0_f64.sqrt() * (x - z), y - 0.5 * (x + z)]
}

/// Few enough for a drawing.
fn fits(blocks: &Blocks) -> bool {
    let [a, b, c] = blocks.size.map(|side| side as usize);
    2 * (a * b + b * c + c * a) <= MOST
}

/// A triangle: how near it is, its corners, its block, its light.
type Seen = (i32, [Cell; 3], usize, Light);

/// The triangles that are seen, each with the value of its block.
fn patches(blocks: &Blocks, values: &[f64], corners: &Corners) -> Vec<Patch> {
    // By the sum of their shadows, which no two triangles share: the nearest one.
    let mut seen: HashMap<[i32; 2], Seen> = HashMap::new();
    for (number, &block) in blocks.cells.iter().enumerate() {
        for (step, around, light) in SEEN {
            if blocks.number(plus(block, step)).is_some() {
                continue;
            }
            let [a, b, c, d] = around.map(|corner| plus(block, corner));
            for triangle in [[a, b, c], [a, c, d]] {
                let sum = |k: usize| triangle.iter().map(|node| shadow(*node)[k]).sum::<i32>();
                let near = triangle.iter().map(|node| nearness(*node)).sum::<i32>();
                let known = seen.entry([sum(0), sum(1)]).or_insert((near, triangle, number, light));
                if near > known.0 {
                    *known = (near, triangle, number, light);
                }
            }
        }
    }
    let mut all: Vec<Seen> = seen.into_values().collect();
    all.sort_unstable();
    let patch = |(_, [a, b, c], number, light): Seen| {
        let [a, b, c] = [a, b, c].map(|node| projected(corners(node)));
        Patch { corners: [a, b, c, c], value: values[number], light }
    };
    all.into_iter().map(patch).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::body::{PointBody, SquareLattice};

    #[test]
    fn three_sides_of_a_block_are_seen_and_nothing_behind_them() {
        let lattice = SquareLattice::cuboid(0.5, [0.0; 3], [4, 3, 2]);
        let blocks = Blocks::new(&PointBody::Solid(lattice), fits);
        let values = blocks.means(&[1.0; 24]);
        let seen = patches(&blocks, &values, &|node| blocks.place(node));
        assert_eq!(seen.len(), 2 * (4 * 3 + 3 * 2 + 2 * 4));
        // Those in front are 4 × 3, those on the right 3 × 2, those above 2 × 4.
        let of = |light| seen.iter().filter(|p| p.light == light).count();
        assert_eq!([Light::Half, Light::Low, Light::Full].map(of), [24, 12, 16]);
        // Their area is that of the hexagon: each side of a cell has 0.25·√3/2 in the picture.
        let area = |p: &Patch| {
            let [a, b, c, _] = p.corners;
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
        };
        let whole: f64 = seen.iter().map(area).sum();
        assert!((whole - 26.0 * 0.25 * 0.75_f64.sqrt()).abs() < 1e-12, "{whole}");
        // A hollow in the middle of the front shows its bottom, and hides no more than it covers.
        let hollow = SquareLattice::new(0.5, [0.0; 3], [0..4, 0..3, 0..2], |cell| cell != [1, 1, 1]);
        let blocks = Blocks::new(&PointBody::Solid(hollow), fits);
        let seen = patches(&blocks, &blocks.means(&[1.0; 23]), &|node| blocks.place(node));
        let whole: f64 = seen.iter().map(area).sum();
        assert!((whole - 26.0 * 0.25 * 0.75_f64.sqrt()).abs() < 1e-12, "{whole}");
    }
}
