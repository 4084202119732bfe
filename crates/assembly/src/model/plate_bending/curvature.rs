//! Triangles of constant curvature: what bonds lack for Poisson's ratios other than 1/3.
//!
//! Each cell has four, of one of its corners and the two next ones, a quarter of its area each. They act on rotations alone, so
//! that they cannot lock. All cells are alike: one matrix is kept, of the rotations of three corners relative to the first.

use super::free::FreeCurvature;
use super::nodes::{Inside, PlateNodes};
use super::{PHI_X, PHI_Y, PlateSection};
use crate::bonds::{Mat, add};
use crate::stiffness::{BlockMatrix, Survey, Term};
use rayon::prelude::*;
use std::array::from_fn;

/// Rotations of three corners relative to the first, `[corner][axis]` in a row.
const MEASURES: usize = 6;
/// Cells below which threads cost more than they bring.
const FEW: usize = 4096;

/// The triangles of all cells of a plate.
#[derive(Clone, Debug)]
pub(super) struct Triangles {
    points: usize,
    /// Cells of every row by the numbers of their lower and their upper left corners, rows from below.
    rows: Vec<Vec<[u32; 2]>>,
    cells: usize,
    /// Conjugate to the measures, N m.
    modulus: Mat<MEASURES, MEASURES>,
}

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
    Some(Triangles { points: nodes.points(), rows, cells, modulus: modulus(rest) })
}

/// `Σ ¼ (c_tr t tᵀ/2 + c_dev (d dᵀ/2 + 2 s sᵀ))` over the triangles of a cell, with the rows t, d and s of the trace, the difference
/// of the normal curvatures and the twist; the area h² of a cell and the slopes over h cancel.
fn modulus([trace, deviator]: [f64; 2]) -> Mat<MEASURES, MEASURES> {
    let mut modulus = [[0.0; MEASURES]; MEASURES];
    let mut take = |factor: f64, row: [f64; MEASURES]| {
        for (r, line) in modulus.iter_mut().enumerate() {
            line.iter_mut().zip(row).for_each(|(sum, c)| *sum += factor * row[r] * c);
        }
    };
    for (a, b) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
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
    fn corners([lower, upper]: [u32; 2]) -> [usize; 4] {
        [lower as usize, lower as usize + 1, upper as usize, upper as usize + 1]
    }

    /// Measures and what is conjugate to them.
    #[inline(always)]
    fn response(&self, cell: [u32; 2], u: &[f64]) -> ([f64; MEASURES], [f64; MEASURES]) {
        let [first, others @ ..] = Self::corners(cell);
        let planes = [&u[PHI_X * self.points..], &u[PHI_Y * self.points..]];
        let s: [f64; MEASURES] = from_fn(|m| planes[m % 2][others[m / 2]] - planes[m % 2][first]);
        (s, from_fn(|m| (0..MEASURES).map(|k| self.modulus[m][k] * s[k]).sum()))
    }

    /// The block of two corners.
    fn block(&self, a: usize, b: usize) -> Mat<3, 3> {
        let of = |corner: usize| if corner == 0 { 0..3 } else { corner - 1..corner };
        let sign = if (a == 0) == (b == 0) { 1.0 } else { -1.0 };
        let entry = |r: usize, c: usize| -> f64 {
            let sums = of(a).flat_map(|i| of(b).map(move |j| (i, j)));
            sums.map(|(i, j)| sign * self.modulus[2 * i + r][2 * j + c]).sum()
        };
        let mut block = [[0.0; 3]; 3];
        for (r, row) in [PHI_X, PHI_Y].into_iter().enumerate() {
            for (c, column) in [PHI_X, PHI_Y].into_iter().enumerate() {
                block[row][column] = entry(r, c);
            }
        }
        block
    }

    fn each(&self) -> impl Iterator<Item = [u32; 2]> + '_ {
        self.rows.iter().flatten().copied()
    }

    /// Adds the load of a curvature that cells are free at.
    pub(super) fn add_free(
        &self,
        nodes: &PlateNodes,
        free: &FreeCurvature,
        unit: [f64; 3],
        force: &mut [f64],
    ) {
        let ([xx, yy, xy], h, n) = (unit, nodes.spacing(), self.points);
        // Rotations of the corners relative to the first where the curvature is the unit.
        let s = [xx, xy, xy, yy, xx + xy, xy + yy].map(|c| h * c);
        let unit: [f64; MEASURES] = from_fn(|m| (0..MEASURES).map(|k| self.modulus[m][k] * s[k]).sum());
        for cell in self.each().filter(|cell| free.is_in(nodes, nodes.node(cell[0] as usize))) {
            let [own, others @ ..] = Self::corners(cell);
            let sum: f64 = others.iter().map(|&point| free.values[point]).sum();
            let value = 0.25 * (free.values[own] + sum);
            for (c, plane) in [PHI_X, PHI_Y].into_iter().enumerate() {
                force[plane * n + own] -= value * (unit[c] + unit[2 + c] + unit[4 + c]);
                others.iter().enumerate().for_each(|(k, &p)| force[plane * n + p] += value * unit[2 * k + c]);
            }
        }
    }

    /// Adds the forces of the cells of a row to the rotations of points from `first` on.
    fn add_row(&self, row: &[[u32; 2]], u: &[f64], first: usize, mut rotations: [&mut [f64]; 2]) {
        for &cell in row {
            let (_, sigma) = self.response(cell, u);
            let [own, others @ ..] = Self::corners(cell);
            for (c, values) in rotations.iter_mut().enumerate() {
                values[own - first] -= sigma[c] + sigma[2 + c] + sigma[4 + c];
                others.iter().enumerate().for_each(|(k, &other)| values[other - first] += sigma[2 * k + c]);
            }
        }
    }
}

/// Takes some values from what is left of a plane, behind others that are skipped.
fn cut<'a>(plane: &mut &'a mut [f64], skipped: usize, count: usize) -> &'a mut [f64] {
    let (_, rest) = std::mem::take(plane).split_at_mut(skipped);
    let (own, rest) = rest.split_at_mut(count);
    *plane = rest;
    own
}

impl Term<3> for Triangles {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for corners in self.each().map(Self::corners) {
            for (k, &i) in corners.iter().enumerate() {
                corners[k + 1..].iter().for_each(|&j| visit(i, j));
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let n = self.points;
        // Every second row of cells shares no point with another one.
        for parity in 0..2 {
            let (mut x, mut y) = force[PHI_X * n..].split_at_mut(n);
            let (mut at, mut parts) = (0, Vec::new());
            for row in self.rows.iter().skip(parity).step_by(2) {
                let (Some(&[first, _]), Some(&[_, last])) = (row.first(), row.last()) else { continue };
                let [first, end] = [first as usize, last as usize + 2];
                let own = [&mut x, &mut y].map(|plane| cut(plane, first - at, end - first));
                parts.push((row, first, own));
                at = end;
            }
            let add = |(row, first, own): (&Vec<[u32; 2]>, usize, [&mut [f64]; 2])| {
                self.add_row(row, u, first, own);
            };
            match self.cells < FEW {
                true => parts.into_iter().for_each(add),
                false => parts.into_par_iter().for_each(add),
            }
        }
    }

    fn survey(&self, u: &[f64]) -> Survey<3> {
        let of_cell = |cell: [u32; 2]| {
            let (s, sigma) = self.response(cell, u);
            let largest = |c: usize| (0..3).fold(0.0, |most: f64, k| most.max(sigma[2 * k + c].abs()));
            let energy = s.iter().zip(sigma).map(|(s, sigma)| 0.5 * s * sigma).sum();
            Survey { energy, largest_action: [0.0, largest(0), largest(1)] }
        };
        // Row by row: the error of a long sum grows with its number of terms.
        let of_row = |row: &Vec<[u32; 2]>| row.iter().copied().map(of_cell).fold(Survey::EMPTY, Survey::join);
        self.rows.iter().map(of_row).fold(Survey::EMPTY, Survey::join)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<3>) {
        // The numbers of corners ascend.
        let blocks: [[Mat<3, 3>; 4]; 4] = from_fn(|a| from_fn(|b| self.block(a, b)));
        for corners in self.each().map(Self::corners) {
            for (a, &i) in corners.iter().enumerate() {
                (a..4).for_each(|b| tangent.add(i, corners[b], &blocks[a][b]));
            }
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<3, 3>]) {
        let own: [Mat<3, 3>; 4] = from_fn(|a| self.block(a, a));
        for corners in self.each().map(Self::corners) {
            corners.iter().zip(&own).for_each(|(&point, block)| add(&mut blocks[point], block));
        }
    }

    fn elements(&self) -> usize {
        self.cells
    }

    fn joins_many(&self) -> bool {
        true
    }

    fn stored_factors(&self) -> usize {
        MEASURES * MEASURES + self.cells
    }
}
