//! Areas of the cells of a body that its outline cuts.

use super::cover::{partly_covered, stadium};
use super::geometry::{Point, moved};
use super::lattice::{Cell, SquareLattice};
use super::outline::{Outline, Shape};
use std::collections::BTreeMap;

/// Samples along each side of a cell that several borders cut.
const SAMPLES: i32 = 64;
/// How far the part of a cell without a point may be from the point that it goes to, rows and columns.
const REACH: i32 = 6;
/// Parts are alike if they differ by less, cells.
const ALIKE: f64 = 1e-6;
/// Part of a cell that a point has at least: what belongs to less would be next to nothing in the equations.
const LEAST: f64 = 0.05;

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
                let cells = ring.iter().map(|[a, b]| [cell[0] + a, cell[1] + b]);
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
        let in_cells = |p: &Point| [0, 1].map(|k| (p[k] - lattice.corner()[k]) / lattice.spacing());
        let polygon = |vertices: &[Point]| vertices.iter().map(in_cells).collect::<Vec<_>>();
        let mut cut: BTreeMap<Cell, Vec<(usize, f64)>> = BTreeMap::new();
        let mut enter = |border: usize, corners: &[Point]| {
            for (cell, part) in partly_covered(size, corners) {
                cut.entry(cell).or_default().push((border, part));
            }
        };
        enter(0, &polygon(self.border().vertices()));
        for (k, hole) in self.holes().iter().enumerate() {
            match (&hole.shape, hole.shape.stadium()) {
                (_, Some((from, to, radius))) => {
                    enter(k + 1, &stadium(in_cells(&from), in_cells(&to), radius / lattice.spacing()));
                }
                (Shape::Polygon(hole), _) => enter(k + 1, &polygon(hole.vertices())),
                _ => {}
            }
        }
        cut.into_iter().map(|(cell, borders)| (cell, self.part(lattice, cell, &borders))).collect()
    }

    /// Part in the body of a cell, from the parts of it that are in the polygon, 0, or in holes, from 1, which cut it.
    fn part(&self, lattice: &SquareLattice, cell: Cell, borders: &[(usize, f64)]) -> f64 {
        let centre = lattice.centre(cell);
        let in_hole = |but: usize| {
            let mut others = self.holes().iter().enumerate().filter(|(k, _)| k + 1 != but);
            others.any(|(_, hole)| hole.shape.removes(centre))
        };
        match *borders {
            [(0, part)] => {
                if in_hole(0) {
                    0.0
                } else {
                    part
                }
            }
            [(hole, part)] => {
                if self.border().contains(centre) && !in_hole(hole) {
                    1.0 - part
                } else {
                    0.0
                }
            }
            _ => {
                let at = |k: i32| ((f64::from(k) + 0.5) / f64::from(SAMPLES) - 0.5) * lattice.spacing();
                let all = (0..SAMPLES).flat_map(|i| (0..SAMPLES).map(move |j| [at(i), at(j)]));
                let inside = all.filter(|step| self.contains(moved(centre, 1.0, *step))).count();
                inside as f64 / f64::from(SAMPLES * SAMPLES)
            }
        }
    }
}

/// Steps to other cells, the next ones first, equally far ones together.
fn rings() -> Vec<Vec<Cell>> {
    let mut rings: BTreeMap<i32, Vec<Cell>> = BTreeMap::new();
    for step in (-REACH..=REACH).flat_map(|a| (-REACH..=REACH).map(move |b| [a, b])) {
        rings.entry(step[0] * step[0] + step[1] * step[1]).or_default().push(step);
    }
    rings.into_values().skip(1).collect()
}

#[cfg(test)]
mod tests;
