//! Where the parts of blocks are that lie in a body: bodies of revolution need their radii.

use super::cover::left_of;
use super::geometry::{Point, minus};
use super::lattice::{self, Cell, Centres, SquareLattice, TriangleParts, plus};
use super::outline::Outline;

/// Corners of a block from its lower left one, in the order of [`TriangleParts`].
const CORNERS: [Cell; 4] = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]];
/// How far areas by clipping may be from the parts of triangles, cells, before borders are taken to overlap.
const ALIKE: f64 = 1e-8;
/// Area that has no place, cells: rounding moves it.
const LEAST: f64 = 1e-10;
/// Samples along each side of a block in which borders overlap.
const SAMPLES: i32 = 64;

/// Area of a region and its first moments.
type Moments = [f64; 3];

impl Outline {
    /// A lattice that it fills, with the centres of the parts of its blocks. Where several borders cross within a block they
    /// are sampled, as their parts are.
    pub fn with_centres(&self, lattice: SquareLattice) -> SquareLattice {
        let borders: Vec<Vec<Point>> =
            (0..=self.holes().len()).map(|border| self.in_cells(&lattice, border, [-0.5; 2])).collect();
        let of = |&(block, parts): &(Cell, TriangleParts)| {
            let near: Vec<Vec<Point>> = borders.iter().map(|border| around(border, block)).collect();
            [0, 1, 2, 3].map(|t| match parts[t] > 0.0 {
                true => self.centre(&lattice, block, (t, parts[t]), &near),
                false => middle(t),
            })
        };
        let centres = lattice.blocks().iter().map(of).collect();
        lattice.with_centres(centres)
    }

    /// Centre of the part of a triangle of a block, from what of the borders is near the block.
    fn centre(
        &self,
        lattice: &SquareLattice,
        block: Cell,
        (triangle, part): (usize, f64),
        borders: &[Vec<Point>],
    ) -> Point {
        let sides = sides(block, triangle);
        let all = borders.iter().enumerate().map(|(border, polygon)| {
            let sign = if border == 0 { 1.0 } else { -1.0 };
            within(polygon, &sides).map(|moment| sign * moment)
        });
        let [area, x, y] = all.fold([0.0; 3], |sum: Moments, own| [0, 1, 2].map(|k| sum[k] + own[k]));
        if area < LEAST {
            return middle(triangle);
        }
        if (2.0 * area - part).abs() < ALIKE {
            return [x / area - f64::from(block[0]), y / area - f64::from(block[1])];
        }
        self.sampled_centre(lattice, block, triangle)
    }

    fn sampled_centre(&self, lattice: &SquareLattice, block: Cell, triangle: usize) -> Point {
        let at = |k: i32| (f64::from(k) + 0.5) / f64::from(SAMPLES);
        let [a, b, _] = CORNERS[triangle].map(|k| f64::from(1 - 2 * k));
        let mut sum = [0.0; 3];
        for [x, y] in (0..SAMPLES).flat_map(|i| (0..SAMPLES).map(move |j| [at(i), at(j)])) {
            let is_within = a * (x - 0.5) + b * (y - 0.5) <= 0.0;
            let place = [x, y].map(|k| k + 0.5);
            let place =
                [0, 1].map(|k| lattice.corner()[k] + lattice.spacing() * (f64::from(block[k]) + place[k]));
            if is_within && self.contains(place) {
                (0..3).for_each(|k| sum[k] += [1.0, x, y][k]);
            }
        }
        if sum[0] > 0.0 { [sum[1] / sum[0], sum[2] / sum[0]] } else { middle(triangle) }
    }
}

impl SquareLattice {
    /// The lattice of whole cells with the blocks along its border, of which its cells have quarters, and their centres.
    #[must_use]
    pub fn with_whole_blocks(self) -> Self {
        let mut blocks = Vec::new();
        for run in self.runs() {
            for block in
                run.columns.clone().flat_map(|i| CORNERS.map(|corner| lattice::minus(run.cell(i), corner)))
            {
                let has = CORNERS.map(|corner| self.number(plus(block, corner)).is_some());
                if has != [true; 4] {
                    blocks.push((block, has));
                }
            }
        }
        blocks.sort_unstable();
        blocks.dedup();
        let (parts, centres) =
            blocks.iter().map(|&(block, has)| ((block, quarters(has).0), quarters(has).1)).unzip();
        self.with_blocks(parts).with_centres(centres)
    }
}

/// Parts of the triangles of a block and their centres, of cells that are there or not. A cell has the square around its corner,
/// all of which belongs to the triangle with its right angle there, and half of it to either of the next ones.
fn quarters(has: [bool; 4]) -> (TriangleParts, Centres) {
    let of = |triangle: usize| {
        let square = |corner: usize| [0, 1].map(|k| f64::from(CORNERS[corner][k]).mul_add(0.5, 0.25));
        // Half of a square on one side of a diagonal has its centre a third of the way to the corner between.
        let half = |corner: usize| {
            let own = CORNERS[triangle].map(|k| f64::from(2 * k - 1));
            let toward = square(corner);
            [0, 1].map(|k| toward[k] + own[k] / 12.0)
        };
        let pieces = [(triangle, 0.5, square(triangle))]
            .into_iter()
            .chain([triangle ^ 1, triangle ^ 2].map(|corner| (corner, 0.25, half(corner))));
        let mut sum = [0.0; 3];
        for (_, share, at) in pieces.filter(|piece| has[piece.0]) {
            (0..3).for_each(|k| sum[k] += share * [1.0, at[0], at[1]][k]);
        }
        let centre = if sum[0] > 0.0 { [sum[1] / sum[0], sum[2] / sum[0]] } else { middle(triangle) };
        (sum[0], centre)
    };
    let all = [0, 1, 2, 3].map(of);
    (all.map(|a| a.0), all.map(|a| a.1))
}

/// Centre of a whole triangle, in cells from the first point of its block.
pub(crate) fn middle(triangle: usize) -> Point {
    [0, 1].map(|k| f64::from(1 + CORNERS[triangle][k]) / 3.0)
}

/// Sides of a triangle of a block, the triangle on their left.
fn sides(block: Cell, triangle: usize) -> [[Point; 2]; 3] {
    let at = |k: usize| [0, 1].map(|c| f64::from(block[c] + CORNERS[k][c]));
    let [a, b, c] = [triangle, triangle ^ 1, triangle ^ 2].map(at);
    let [b, c] = if triangle == 0 || triangle == 3 { [b, c] } else { [c, b] };
    [[a, b], [b, c], [c, a]]
}

/// A polygon without what is on one side of a block, which no clipping by the block sees.
fn around(polygon: &[Point], block: Cell) -> Vec<Point> {
    let beyond = |p: Point| {
        let far = |k: usize| {
            let x = p[k] - f64::from(block[k]);
            (u8::from(x < 0.0) + 2 * u8::from(x > 1.0)) << (2 * k)
        };
        far(0) | far(1)
    };
    let mut kept: Vec<Point> = Vec::new();
    let mut common = 0;
    for (k, &p) in polygon.iter().enumerate() {
        common &= beyond(p);
        // All since the last one kept, and the next, on one side: the way between them stays there.
        let next = polygon.get(k + 1).map_or(0, |next| beyond(*next));
        if common & next == 0 {
            kept.push(p);
            common = beyond(p);
        }
    }
    kept
}

/// Area and first moments of the part of a polygon on the left of all of some lines.
fn within(polygon: &[Point], lines: &[[Point; 2]; 3]) -> Moments {
    let left = left_of(polygon, lines);
    let mut sum = [0.0; 3];
    let Some(&from) = left.first() else { return sum };
    for k in 0..left.len() {
        let (a, b) = (minus(left[k], from), minus(left[(k + 1) % left.len()], from));
        let area = 0.5 * (a[0] * b[1] - a[1] * b[0]);
        sum[0] += area;
        (0..2).for_each(|c| sum[1 + c] += area * (from[c] + (a[c] + b[c]) / 3.0));
    }
    let sign = if sum[0] < 0.0 { -1.0 } else { 1.0 };
    sum.map(|moment| sign * moment)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::body::{Hole, Shape};
    use std::f64::consts::PI;

    /// Volumes of bodies of revolution per 2π, by Pappus, from the parts and centres of all blocks.
    #[test]
    fn moments_of_parts_are_those_of_the_body() {
        let mut ring = Outline::rectangle([0.0; 2], [9.0, 7.0]).unwrap();
        ring.cut(Hole { name: None, shape: Shape::Circle { centre: [4.2, 3.1], radius: 2.3 } }).unwrap();
        let circle = PI * 2.3 * 2.3;
        let cone = Outline::polygon(vec![[0.0, 0.0], [6.3, 0.0], [2.1, 8.2], [0.0, 8.2]]).unwrap();
        let frustum = 8.2 / 6.0 * (6.3 * 6.3 + 6.3 * 2.1 + 2.1 * 2.1);
        for (outline, volume) in [(ring, 0.5 * 81.0 * 7.0 - 4.2 * circle), (cone, frustum)] {
            let lattice = outline.with_centres(outline.fill(1.0).unwrap());
            let listed = lattice.blocks();
            let mut sum = 0.0;
            for block in (-1..12).flat_map(|j| (-1..12).map(move |i| [i, j, 0])) {
                let whole = CORNERS.iter().all(|c| lattice.number(plus(block, *c)).is_some());
                let found = listed.binary_search_by_key(&block, |b| b.0);
                let of = |t: usize| match found {
                    Ok(k) => listed[k].1[t] * (f64::from(block[0]) + 0.5 + lattice.centres()[k][t][0]),
                    Err(_) => f64::from(u8::from(whole)) * (f64::from(block[0]) + 0.5 + middle(t)[0]),
                };
                sum += 0.25 * (0..4).map(of).sum::<f64>();
            }
            // A circle is one of chords with its area.
            assert!((sum / volume - 1.0).abs() < 1e-8, "{sum} {volume}");
        }
    }

    #[test]
    fn quarters_of_a_block_are_its_cells() {
        let (parts, centres) = quarters([true; 4]);
        for t in 0..4 {
            assert!((parts[t] - 1.0).abs() < 1e-15);
            (0..2).for_each(|k| assert!((centres[t][k] - middle(t)[k]).abs() < 1e-15));
        }
        let (parts, centres) = quarters([true, false, false, false]);
        assert_eq!(parts, [0.5, 0.25, 0.25, 0.0]);
        // The part of the lower right triangle is the half of the square towards the right side.
        assert_eq!(centres[1], [0.25 + 1.0 / 12.0, 0.25 - 1.0 / 12.0]);
    }
}
