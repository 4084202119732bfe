//! Triangles of constant curvature: what bonds lack for Poisson's ratios other than 1/3.
//!
//! Each cell has four, of one of its corners and the two next ones, a quarter of its area each. They act on rotations alone, so
//! that they cannot lock. All cells are alike: one matrix is kept, of the rotations of three corners relative to the first, for every
//! set of triangles that a cell may have left where bonds break.

use super::free::FreeCurvature;
use super::nodes::{Inside, PlateNodes};
use super::{PHI_X, PHI_Y, PlateSection};
use crate::bonds::Mat;
use std::array::from_fn;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Rotations of three corners relative to the first, `[corner][axis]` in a row.
pub(super) const MEASURES: usize = 6;
/// Sets of triangles that a cell may have.
const SETS: usize = 16;
/// All triangles of a cell.
pub(super) const WHOLE: Set = 0b1111;

/// The triangles of all cells of a plate.
#[derive(Clone, Debug)]
pub(super) struct Triangles {
    pub(super) points: usize,
    /// Cells of every row by the numbers of their lower and their upper left corners, rows from below.
    pub(super) rows: Vec<Vec<[u32; 2]>>,
    /// Row of the first of them.
    first: i32,
    /// How many these are.
    pub(super) cells: usize,
    /// Cells that have lost triangles, by their lower left corners: their upper left ones, and the triangles that are left.
    torn: BTreeMap<u32, (u32, Set)>,
    /// Conjugate to the measures, N m, by what a cell has left.
    moduli: Arc<[Mat<MEASURES, MEASURES>; SETS]>,
}

/// Triangles of a cell, a bit for the corner `a + 2b` of each.
pub(super) type Set = u8;

/// The triangles of all cells that are `inside`; none where bonds have all of the stiffness.
pub(super) fn triangles((nodes, inside): (&PlateNodes, Inside), section: &PlateSection) -> Option<Triangles> {
    let rest = section.rest();
    if rest.iter().all(|c| *c <= f64::EPSILON * section.bending) {
        return None;
    }
    let first = nodes.cells().rows().start;
    let mut rows = vec![Vec::new(); nodes.cells().rows().len()];
    for cell in nodes.all_cells().filter(|&cell| inside(cell)) {
        if let Some([lower, _, upper, _]) = nodes.corners(cell) {
            rows[(cell[1] - first) as usize].push([lower as u32, upper as u32]);
        }
    }
    let cells = rows.iter().map(Vec::len).sum();
    let moduli = Arc::new(from_fn(|left| modulus(rest, left as Set)));
    Some(Triangles { points: nodes.points(), rows, first, cells, torn: BTreeMap::new(), moduli })
}

/// `Σ ¼ (c_tr t tᵀ/2 + c_dev (d dᵀ/2 + 2 s sᵀ))` over some triangles of a cell, with the rows t, d and s of the trace, the difference
/// of the normal curvatures and the twist; the area h² of a cell and the slopes over h cancel.
fn modulus([trace, deviator]: [f64; 2], left: Set) -> Mat<MEASURES, MEASURES> {
    let mut modulus = [[0.0; MEASURES]; MEASURES];
    let mut take = |factor: f64, row: [f64; MEASURES]| {
        for (r, line) in modulus.iter_mut().enumerate() {
            line.iter_mut().zip(row).for_each(|(sum, c)| *sum += factor * row[r] * c);
        }
    };
    for (a, b) in [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter().filter(|(a, b)| left >> (a + 2 * b) & 1 == 1) {
        let corner = |a: usize, b: usize| a + 2 * b;
        let [along, across] = [corner(1 - a, b), corner(a, 1 - b)];
        let ends = [(along, if a == 0 { 1.0 } else { -1.0 }), (across, if b == 0 { 1.0 } else { -1.0 })];
        // h ∂φ_c/∂x_k as a row.
        let slope = |c: usize, k: usize| {
            let mut row = [0.0; MEASURES];
            let (other, sign) = ends[k];
            for (point, sign) in [(other, sign), (corner(a, b), -sign)] {
                if point > 0 {
                    row[2 * (point - 1) + c] += sign;
                }
            }
            row
        };
        let [xx, yy, xy, yx] = [slope(0, 0), slope(1, 1), slope(0, 1), slope(1, 0)];
        take(0.125 * trace.max(0.0), from_fn(|k| xx[k] + yy[k]));
        take(0.125 * deviator.max(0.0), from_fn(|k| xx[k] - yy[k]));
        take(0.125 * deviator.max(0.0), from_fn(|k| xy[k] + yx[k]));
    }
    modulus
}

impl Triangles {
    pub(super) fn corners([lower, upper]: [u32; 2]) -> [usize; 4] {
        [lower as usize, lower as usize + 1, upper as usize, upper as usize + 1]
    }

    /// Measures and what is conjugate to them.
    #[inline(always)]
    pub(super) fn response(
        &self,
        (cell, left): ([u32; 2], Set),
        u: &[f64],
    ) -> ([f64; MEASURES], [f64; MEASURES]) {
        let [first, others @ ..] = Self::corners(cell);
        let planes = [&u[PHI_X * self.points..], &u[PHI_Y * self.points..]];
        let s: [f64; MEASURES] = from_fn(|m| planes[m % 2][others[m / 2]] - planes[m % 2][first]);
        (s, self.conjugate(left, &s))
    }

    #[inline(always)]
    fn modulus(&self, left: Set) -> &Mat<MEASURES, MEASURES> {
        // Without a check.
        &self.moduli[usize::from(left) % SETS]
    }

    /// What is conjugate to measures of a cell with the triangles that are left.
    #[inline(always)]
    fn conjugate(&self, left: Set, s: &[f64; MEASURES]) -> [f64; MEASURES] {
        let modulus = self.modulus(left);
        from_fn(|m| (0..MEASURES).map(|k| modulus[m][k] * s[k]).sum())
    }

    /// The block of two corners of a cell with the triangles that are left.
    pub(super) fn block(&self, left: Set, a: usize, b: usize) -> Mat<3, 3> {
        let modulus = self.modulus(left);
        let of = |corner: usize| if corner == 0 { 0..3 } else { corner - 1..corner };
        let sign = if (a == 0) == (b == 0) { 1.0 } else { -1.0 };
        let entry = |r: usize, c: usize| -> f64 {
            let sums = of(a).flat_map(|i| of(b).map(move |j| (i, j)));
            sums.map(|(i, j)| sign * modulus[2 * i + r][2 * j + c]).sum()
        };
        let mut block = [[0.0; 3]; 3];
        for (r, row) in [PHI_X, PHI_Y].into_iter().enumerate() {
            for (c, column) in [PHI_X, PHI_Y].into_iter().enumerate() {
                block[row][column] = entry(r, c);
            }
        }
        block
    }

    /// All cells with the triangles that they have.
    pub(super) fn each(&self) -> impl Iterator<Item = ([u32; 2], Set)> + '_ {
        self.rows.iter().flatten().map(|&cell| (cell, WHOLE)).chain(self.torn())
    }

    /// How many cells there are.
    pub(super) fn count(&self) -> usize {
        self.cells + self.torn.len()
    }

    /// The cells that have lost some of them.
    pub(super) fn torn(&self) -> impl Iterator<Item = ([u32; 2], Set)> + '_ {
        self.torn.iter().map(|(&lower, &(upper, left))| ([lower, upper], left))
    }

    /// Takes out the triangles that have a bond between next points as a side.
    pub(super) fn tear(&mut self, nodes: &PlateNodes, ends: [usize; 2]) {
        for (cell, lost) in beside(nodes, ends) {
            let row = &mut self.rows[(nodes.node(cell[0] as usize)[1] - self.first) as usize];
            if let Ok(place) = row.binary_search(&cell) {
                row.remove(place);
                self.cells -= 1;
                self.torn.insert(cell[0], (cell[1], WHOLE));
            }
            let Some((_, left)) = self.torn.get_mut(&cell[0]) else { continue };
            *left &= !lost;
            if *left == 0 {
                self.torn.remove(&cell[0]);
            }
        }
    }

    /// The triangles that would go with some bonds between next points.
    pub(super) fn beside(&self, nodes: &PlateNodes, bonds: &[[usize; 2]]) -> Self {
        let mut torn = BTreeMap::new();
        for (cell, lost) in bonds.iter().flat_map(|&ends| beside(nodes, ends)) {
            let row = &self.rows[(nodes.node(cell[0] as usize)[1] - self.first) as usize];
            let whole = row.binary_search(&cell).ok().map(|_| WHOLE);
            let left = whole.or_else(|| Some(self.torn.get(&cell[0])?.1)).unwrap_or(0);
            if left & lost != 0 {
                torn.entry(cell[0]).or_insert((cell[1], 0)).1 |= left & lost;
            }
        }
        let (points, first, moduli) = (self.points, self.first, self.moduli.clone());
        Self { points, rows: Vec::new(), first, cells: 0, torn, moduli }
    }

    /// Hands the load of a curvature that cells are free at to `add`.
    pub(super) fn add_free(
        &self,
        nodes: &PlateNodes,
        free: &FreeCurvature,
        unit: [f64; 3],
        add: &mut dyn FnMut(usize, f64),
    ) {
        let ([xx, yy, xy], h, n) = (unit, nodes.spacing(), self.points);
        // Rotations of the corners relative to the first where the curvature is the unit.
        let s = [xx, xy, xy, yy, xx + xy, xy + yy].map(|c| h * c);
        for (cell, left) in self.each() {
            if !free.is_in(nodes, nodes.node(cell[0] as usize)) {
                continue;
            }
            let unit = self.conjugate(left, &s);
            let [own, others @ ..] = Self::corners(cell);
            let sum: f64 = others.iter().map(|&point| free.values[point]).sum();
            let value = 0.25 * (free.values[own] + sum);
            for (c, plane) in [PHI_X, PHI_Y].into_iter().enumerate() {
                add(plane * n + own, -value * (unit[c] + unit[2 + c] + unit[4 + c]));
                others.iter().enumerate().for_each(|(k, &p)| add(plane * n + p, value * unit[2 * k + c]));
            }
        }
    }
}

/// The cells with a bond between next points on a side or a diagonal, by the numbers of their left corners, and the triangles in them
/// that have it as a side.
fn beside(nodes: &PlateNodes, ends: [usize; 2]) -> impl Iterator<Item = ([u32; 2], Set)> + '_ {
    let [[i, j], [k, l]] = ends.map(|point| nodes.node(point));
    let around = [[i - 1, j - 1], [i, j - 1], [i - 1, j], [i, j]].into_iter().filter(move |&[a, b]| {
        let is_corner = |[x, y]: [i32; 2]| (0..2).contains(&(x - a)) && (0..2).contains(&(y - b));
        is_corner([k, l]) && nodes.has_cell([a, b])
    });
    around.filter_map(move |cell| {
        let corners = nodes.corners(cell)?;
        // A triangle has all corners of the cell but that opposite to its own.
        let others = (0..4).filter(|&corner| !ends.contains(&corners[corner]));
        let lost = others.fold(0, |lost, corner| lost | 1 << (3 - corner));
        Some(([corners[0] as u32, corners[2] as u32], lost))
    })
}
