//! Areas of the cells of a body that its outline cuts.

use super::cover::{Covered, area_within, partly_covered, stadium};
use super::geometry::{Point, dot, left_normal, moved, side};
use super::lattice::{Cell, SquareLattice, TriangleParts, plus};
use super::outline::Outline;
use std::collections::BTreeMap;

/// Samples along each side of a cell that several borders cut.
const SAMPLES: i32 = 64;
/// How far the part of a cell without a point may be from the point that it goes to, rows and columns.
const REACH: i32 = 6;
/// Parts are alike if they differ by less, cells.
const ALIKE: f64 = 1e-6;
/// Part of a cell that a point has at least: what belongs to less would be next to nothing in the equations.
const LEAST: f64 = 0.05;

/// Parts of cells nearer to none or all are that: borders between cells are known no better.
const WHOLE: f64 = 1e-6;
/// Those of blocks, whose borders seldom run along them.
const WHOLE_BLOCK: f64 = 1e-10;

/// Corners of a block from its lower left one, in the order of [`TriangleParts`].
const CORNERS: [[i32; 2]; 4] = [[0, 0], [1, 0], [0, 1], [1, 1]];

impl Outline {
    /// Areas of the points of a lattice that it fills, per cell, where they differ from one: the part of their own cells
    /// that lies in the body, and those of cells without points. Such a part goes to the fullest of the next points, those
    /// to the side before those across a corner, and is shared by equals.
    ///
    /// The areas sum to that of the body, but for cells that several borders cut, which are sampled, and for tips so sharp
    /// that no point is near.
    pub(super) fn areas(&self, lattice: &SquareLattice, size: [i32; 2]) -> Vec<(Cell, f64)> {
        let cut = self.cut_cells(lattice, size);
        let own = |cell: Cell| match (lattice.number(cell), cut.get(&cell)) {
            (None, _) => None,
            (Some(_), part) => Some(part.copied().unwrap_or(1.0)),
        };
        let mut areas: BTreeMap<Cell, f64> =
            cut.iter().filter_map(|(&cell, _)| Some((cell, own(cell)?))).collect();
        let rings = rings();
        for (&cell, &part) in cut.iter().filter(|(cell, _)| lattice.number(**cell).is_none()) {
            let near = rings.iter().map(|ring| {
                let cells = ring.iter().map(|step| plus(cell, *step));
                cells.filter_map(|c| Some((c, own(c)?))).collect::<Vec<_>>()
            });
            let Some(near) = near.into_iter().find(|near| !near.is_empty()) else { continue };
            let most = near.iter().map(|n| n.1).fold(0.0, f64::max);
            let fullest: Vec<_> = near.into_iter().filter(|n| n.1 > most - ALIKE).collect();
            let share = part / fullest.len() as f64;
            fullest.iter().for_each(|&(c, own)| *areas.entry(c).or_insert(own) += share);
        }
        areas.into_iter().map(|(cell, area)| (cell, area.max(LEAST))).collect()
    }

    /// Parts in the body of the cells that borders cut.
    fn cut_cells(&self, lattice: &SquareLattice, size: [i32; 2]) -> BTreeMap<Cell, f64> {
        let cut = self.crossed(lattice, ([0.0; 2], size), WHOLE);
        cut.into_iter()
            .map(|(cell, borders)| (cell, self.part(lattice.place_of(cell), lattice, &borders)))
            .collect()
    }

    /// The triangles of the blocks of a lattice that it fills, where borders cut a block.
    pub(super) fn blocks(
        &self,
        lattice: &SquareLattice,
        [columns, rows]: [i32; 2],
    ) -> Vec<(Cell, TriangleParts)> {
        // A block is a cell between four points; the first ones lie before the first points.
        let cut = self.crossed(lattice, ([0.5; 2], [columns + 1, rows + 1]), WHOLE_BLOCK);
        let block = |(cell, borders): (Cell, Vec<(usize, Covered)>)| {
            let [column, row, layer] = cell;
            let centre = lattice.node([column, row]);
            ([column - 1, row - 1, layer], self.triangles(centre, lattice, &borders))
        };
        cut.into_iter().map(block).collect()
    }

    /// What the polygon, 0, and holes, from 1, cover of the cells that their borders cut, on a grid that is moved by parts of a
    /// cell.
    fn crossed(
        &self,
        lattice: &SquareLattice,
        (moved, size): (Point, [i32; 2]),
        whole: f64,
    ) -> BTreeMap<Cell, Vec<(usize, Covered)>> {
        let mut cut: BTreeMap<Cell, Vec<(usize, Covered)>> = BTreeMap::new();
        for border in 0..=self.holes().len() {
            for ([i, j], covered) in partly_covered(size, &self.in_cells(lattice, border, moved), whole) {
                cut.entry([i, j, 0]).or_default().push((border, covered));
            }
        }
        cut
    }

    /// The polygon, 0, or a hole, from 1, as a polygon in cells.
    pub(super) fn in_cells(&self, lattice: &SquareLattice, border: usize, moved: Point) -> Vec<Point> {
        let in_cells =
            |p: &Point| [0, 1].map(|k| (p[k] - lattice.corner()[k]) / lattice.spacing() + moved[k]);
        let polygon = |vertices: &[Point]| vertices.iter().map(in_cells).collect();
        let Some(hole) = border.checked_sub(1).map(|k| &self.holes()[k].shape) else {
            return polygon(self.border().vertices());
        };
        match (hole.polygon(), hole.stadium()) {
            (_, Some((from, to, radius))) => {
                stadium(in_cells(&from), in_cells(&to), radius / lattice.spacing())
            }
            (Some(hole), _) => polygon(hole.vertices()),
            _ => Vec::new(),
        }
    }

    /// Part in the body of a cell, from the parts of it that are in the polygon, 0, or in holes, from 1, which cut it.
    fn part(&self, centre: Point, lattice: &SquareLattice, borders: &[(usize, Covered)]) -> f64 {
        let in_hole = |but: usize| {
            let mut others = self.holes().iter().enumerate().filter(|(k, _)| k + 1 != but);
            others.any(|(_, hole)| hole.shape.removes(centre))
        };
        match borders {
            [(0, covered)] => f64::from(u8::from(!in_hole(0))) * covered.part,
            [(hole, covered)] => match self.border().contains(centre) && !in_hole(*hole) {
                true => 1.0 - covered.part,
                false => 0.0,
            },
            _ => self.sampled(centre, lattice, |_| 1.0),
        }
    }

    /// Parts in the body of the triangles of a block.
    fn triangles(
        &self,
        centre: Point,
        lattice: &SquareLattice,
        borders: &[(usize, Covered)],
    ) -> TriangleParts {
        let sampled = || {
            CORNERS.map(|[a, b]| {
                let side = |[x, y]: Point| f64::from(2 * a - 1) * x + f64::from(2 * b - 1) * y;
                // What lies on the diagonal belongs to both halves alike.
                let weight = |step: Point| match side(step) {
                    s if s > 0.0 => 1.0,
                    s if s < 0.0 => 0.0,
                    _ => 0.5,
                };
                2.0 * self.sampled(centre, lattice, weight)
            })
        };
        match borders {
            [(border, covered)] => {
                let whole = self.part(centre, lattice, borders);
                // Of a hole it is what the hole leaves.
                let [below, above] = covered.right.map(|r| match (whole, border) {
                    (0.0, _) => 0.0,
                    (_, 0) => r,
                    _ => 1.0 - r,
                });
                [2.0 * whole - above, below, 2.0 * whole - below, above].map(|part| part.clamp(0.0, 1.0))
            }
            [(0, _), (hole, _)] => match self.lines_through(centre, lattice) {
                Some(lines) => self.between(centre, lattice, (&lines, *hole)),
                None => sampled(),
            },
            _ => sampled(),
        }
    }

    /// The sides of the polygon that pass a block, the body on their left, where they enclose it as a convex part.
    fn lines_through(&self, centre: Point, lattice: &SquareLattice) -> Option<Vec<[Point; 2]>> {
        let half = 0.5 * lattice.spacing();
        let [low, high] = [-half, half].map(|step| centre.map(|x| x + step));
        let passes = |[from, to]: &[Point; 2]| {
            let along = |k: usize, at: f64| (at - from[k]) / (to[k] - from[k]);
            let ends = (0..2).filter(|&k| from[k] != to[k]).fold([0.0, 1.0], |[start, end]: [f64; 2], k| {
                let (one, other) = (along(k, low[k]), along(k, high[k]));
                [start.max(one.min(other)), end.min(one.max(other))]
            });
            let is_beside = (0..2).any(|k| from[k] == to[k] && !(low[k] < from[k] && from[k] < high[k]));
            !is_beside && ends[1] - ends[0] > WHOLE_BLOCK
        };
        let passing = self.edges().iter().filter(|edge| passes(&[edge.from, edge.to]));
        let lines: Vec<[Point; 2]> = passing
            .map(|edge| match dot(left_normal(edge.from, edge.to), edge.normal) < 0.0 {
                true => [edge.from, edge.to],
                false => [edge.to, edge.from],
            })
            .collect();
        // Every line has the other ends on its left.
        let is_left = |[from, to]: &[Point; 2], p: Point| side(*from, *to, p) >= 0.0;
        let is_convex = lines.iter().all(|line| lines.iter().flatten().all(|end| is_left(line, *end)));
        is_convex.then_some(lines)
    }

    /// Parts of the triangles of a block on the left of some lines and outside of a hole.
    fn between(
        &self,
        centre: Point,
        lattice: &SquareLattice,
        (lines, hole): (&[[Point; 2]], usize),
    ) -> TriangleParts {
        let in_cells = |p: Point| [0, 1].map(|k| (p[k] - lattice.corner()[k]) / lattice.spacing());
        let lines: Vec<[Point; 2]> = lines.iter().map(|line| line.map(in_cells)).collect();
        let (centre, border) = (in_cells(centre), self.in_cells(lattice, hole, [0.0; 2]));
        [0, 1, 2, 3].map(|t: usize| {
            let at = |t: usize| [0, 1].map(|k| centre[k] + f64::from(CORNERS[t][k]) - 0.5);
            let corners = [at(t), at(t ^ 1), at(t ^ 2)];
            // Counter-clockwise.
            let corners = if t == 0 || t == 3 { corners } else { [corners[0], corners[2], corners[1]] };
            let sides = [[corners[0], corners[1]], [corners[1], corners[2]], [corners[2], corners[0]]];
            let inside = area_within(&corners, &lines) - area_within(&border, &[&sides[..], &lines].concat());
            (2.0 * inside).clamp(0.0, 1.0)
        })
    }

    /// Part of the samples of a cell that are in the body, each by its weight at its step from the centre.
    fn sampled(&self, centre: Point, lattice: &SquareLattice, weight: impl Fn(Point) -> f64) -> f64 {
        let at = |k: i32| ((f64::from(k) + 0.5) / f64::from(SAMPLES) - 0.5) * lattice.spacing();
        let all = (0..SAMPLES).flat_map(|i| (0..SAMPLES).map(move |j| [at(i), at(j)]));
        let inside = all.filter(|step| self.contains(moved(centre, 1.0, *step))).map(weight).sum::<f64>();
        inside / f64::from(SAMPLES * SAMPLES)
    }
}

/// Steps to other cells, the next ones first, equally far ones together.
fn rings() -> Vec<Vec<Cell>> {
    let mut rings: BTreeMap<i32, Vec<Cell>> = BTreeMap::new();
    for step in (-REACH..=REACH).flat_map(|a| (-REACH..=REACH).map(move |b| [a, b, 0])) {
        rings.entry(step[0] * step[0] + step[1] * step[1]).or_default().push(step);
    }
    rings.into_values().skip(1).collect()
}

#[cfg(test)]
mod tests;
