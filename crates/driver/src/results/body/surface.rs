//! Pictures of a state of a solid: its surface as it is seen from in front, from the right and from above, isometrically.
//!
//! Sides of cells become rhombi of two triangles each on a grid that all layers share, so that of several sides which hide each other
//! the nearest one is kept, exactly. Large bodies are drawn by blocks of several cells.

use super::plots::{range, size_of};
use crate::case::FieldName;
use crate::output::plot::{Map, Patch, write_map};
use crate::results::factor::magnification;
use crate::run::body::BodyResult;
use crate::scene::body::BodyScene;
use peristat_assembly::body::{Cell, SquareLattice, plus};
use std::collections::HashMap;
use std::io;
use std::path::Path;

/// Triangles of a picture, at most, about.
const MOST: usize = 40_000;

/// Writes the pictures of a state into a folder.
///
/// # Errors
/// The folder cannot be written.
pub(super) fn write(
    folder: &Path,
    (scene, lattice): (&BodyScene, &SquareLattice),
    result: &BodyResult,
    title: &str,
) -> io::Result<()> {
    let u =
        [FieldName::Ux, FieldName::Uy, FieldName::Uz].map(|f| result.values(scene, f).unwrap_or_default());
    let size: Vec<f64> = (0..lattice.points()).map(|p| u[0][p].hypot(u[1][p]).hypot(u[2][p])).collect();
    let blocks = Blocks::new(lattice);
    let factor = magnification(size_of(scene), range(scene, &size).0[1]);
    let moved = blocks.moved([&u[0], &u[1], &u[2]], factor);
    let draw = |file: &str, label: String, values: &[f64], note: &str, corners: &Corners| {
        let (range, more) = range(scene, values);
        let map = Map {
            title: title.into(),
            note: format!("{note}{more}"),
            label,
            range,
            patches: blocks.patches(&blocks.means(values), corners),
            ..Map::default()
        };
        write_map(&folder.join(format!("{file}.svg")), &map)
    };
    let units = scene.units;
    let label = units.label("displacement", units.length());
    draw("displacement", label, &size, &format!("deformed shape, displacements times {factor}; "), &moved)?;
    match result.values(scene, FieldName::VonMises) {
        Some(values) => {
            let label = units.label("von Mises stress", units.stress());
            draw("von_mises", label, &values, "", &|node| blocks.place(node))
        }
        None => Ok(()),
    }
}

/// Where the corner of a block is, m.
type Corners<'a> = dyn Fn(Cell) -> [f64; 3] + 'a;

/// Blocks of cells.
struct Blocks<'a> {
    lattice: &'a SquareLattice,
    /// Cells along a side.
    step: i32,
    /// Number of every block that has a point.
    numbers: HashMap<Cell, usize>,
    /// Block of every point.
    of: Vec<usize>,
    counts: Vec<f64>,
}

/// The sides that are seen: the step to the block before one, and its corners around, beginning with the nearest.
const SEEN: [(Cell, [Cell; 4]); 3] = [
    ([1, 0, 0], [[1, 1, 1], [1, 0, 1], [1, 0, 0], [1, 1, 0]]),
    ([0, 1, 0], [[1, 1, 1], [1, 1, 0], [0, 1, 0], [0, 1, 1]]),
    ([0, 0, 1], [[1, 1, 1], [0, 1, 1], [0, 0, 1], [1, 0, 1]]),
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

impl<'a> Blocks<'a> {
    fn new(lattice: &'a SquareLattice) -> Self {
        let sides = [lattice.columns().len(), lattice.rows().len(), lattice.layers().len()];
        let triangles = |step: usize| {
            let [a, b, c] = sides.map(|side| side.div_ceil(step));
            2 * (a * b + b * c + c * a)
        };
        let step = (1..).find(|&step| triangles(step) <= MOST).unwrap_or(1) as i32;
        let first = [lattice.columns().start, lattice.rows().start, lattice.layers().start];
        let mut blocks = Self { lattice, step, numbers: HashMap::new(), of: Vec::new(), counts: Vec::new() };
        for run in lattice.runs() {
            for column in run.columns.clone() {
                let cell = run.cell(column);
                let block = [0, 1, 2].map(|k| (cell[k] - first[k]) / step);
                let next = blocks.numbers.len();
                let number = *blocks.numbers.entry(block).or_insert(next);
                blocks.of.push(number);
                blocks.counts.resize(blocks.numbers.len(), 0.0);
                blocks.counts[number] += 1.0;
            }
        }
        blocks
    }

    /// The mean of values of points in every block.
    fn means(&self, values: &[f64]) -> Vec<f64> {
        let mut means = vec![0.0; self.counts.len()];
        self.of.iter().zip(values).for_each(|(&block, value)| means[block] += value / self.counts[block]);
        means
    }

    /// Where the corner before a block is, m; blocks at the end may be cut off.
    fn place(&self, node: Cell) -> [f64; 3] {
        let lattice = self.lattice;
        let ranges = [lattice.columns(), lattice.rows(), lattice.layers()];
        let corner = lattice.corner();
        [0, 1, 2].map(|k| {
            let line = (ranges[k].start + node[k] * self.step).min(ranges[k].end);
            corner[k] + f64::from(line) * lattice.spacing()
        })
    }

    /// Corners that move with the blocks around them, by some multiple.
    fn moved(&self, u: [&[f64]; 3], factor: f64) -> impl Fn(Cell) -> [f64; 3] + use<'_, 'a> {
        let means = u.map(|values| self.means(values));
        move |node| {
            let around = (0..8).filter_map(|corner| {
                let step = [0, 1, 2].map(|k| -(corner >> k & 1));
                self.numbers.get(&plus(node, step)).copied()
            });
            let own: Vec<usize> = around.collect();
            let at = self.place(node);
            let mean = |k: usize| own.iter().map(|&b| means[k][b]).sum::<f64>() / own.len().max(1) as f64;
            [0, 1, 2].map(|k| at[k] + factor * mean(k))
        }
    }

    /// The triangles that are seen, each with the value of its block.
    fn patches(&self, values: &[f64], corners: &Corners) -> Vec<Patch> {
        // By the sum of their shadows, which no two triangles share: the nearest one.
        let mut seen: HashMap<[i32; 2], (i32, [Cell; 3], usize)> = HashMap::new();
        for (&block, &number) in &self.numbers {
            for (step, around) in SEEN {
                if self.numbers.contains_key(&plus(block, step)) {
                    continue;
                }
                let [a, b, c, d] = around.map(|corner| plus(block, corner));
                for triangle in [[a, b, c], [a, c, d]] {
                    let sum = |k: usize| triangle.iter().map(|node| shadow(*node)[k]).sum::<i32>();
                    let near = triangle.iter().map(|node| nearness(*node)).sum::<i32>();
                    let known = seen.entry([sum(0), sum(1)]).or_insert((near, triangle, number));
                    if near > known.0 {
                        *known = (near, triangle, number);
                    }
                }
            }
        }
        let mut all: Vec<(i32, [Cell; 3], usize)> = seen.into_values().collect();
        all.sort_unstable();
        let patch = |(_, [a, b, c], number): (i32, [Cell; 3], usize)| {
            let [a, b, c] = [a, b, c].map(|node| projected(corners(node)));
            Patch { corners: [a, b, c, c], value: values[number] }
        };
        all.into_iter().map(patch).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn three_sides_of_a_block_are_seen_and_nothing_behind_them() {
        let lattice = SquareLattice::cuboid(0.5, [0.0; 3], [4, 3, 2]);
        let blocks = Blocks::new(&lattice);
        let values = blocks.means(&[1.0; 24]);
        let seen = blocks.patches(&values, &|node| blocks.place(node));
        assert_eq!(seen.len(), 2 * (4 * 3 + 3 * 2 + 2 * 4));
        // Their area is that of the hexagon: each side of a cell has 0.25·√3/2 in the picture.
        let area = |p: &Patch| {
            let [a, b, c, _] = p.corners;
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
        };
        let whole: f64 = seen.iter().map(area).sum();
        assert!((whole - 26.0 * 0.25 * 0.75_f64.sqrt()).abs() < 1e-12, "{whole}");
        // A hollow in the middle of the front shows its bottom, and hides no more than it covers.
        let hollow = SquareLattice::new(0.5, [0.0; 3], [0..4, 0..3, 0..2], |cell| cell != [1, 1, 1]);
        let blocks = Blocks::new(&hollow);
        let seen = blocks.patches(&blocks.means(&[1.0; 23]), &|node| blocks.place(node));
        let whole: f64 = seen.iter().map(area).sum();
        assert!((whole - 26.0 * 0.25 * 0.75_f64.sqrt()).abs() < 1e-12, "{whole}");
    }
}
