//! Triangles of constant curvature as a part of the energy of a plate.

use super::PHI_X;
use super::curvature::{MEASURES, Set, Triangles, WHOLE};
use crate::bonds::{Mat, add};
use crate::stiffness::{BlockMatrix, Survey, Term};
use rayon::prelude::*;
use std::array::from_fn;

/// Cells below which threads cost more than they bring.
const FEW: usize = 4096;

impl Triangles {
    /// Adds the forces of the cells of a row to the rotations of points from `first` on.
    fn add_row(&self, row: &[[u32; 2]], u: &[f64], first: usize, mut rotations: [&mut [f64]; 2]) {
        for &cell in row {
            self.add_cell((cell, WHOLE), u, first, &mut rotations);
        }
    }

    #[inline(always)]
    fn add_cell(
        &self,
        (cell, left): ([u32; 2], Set),
        u: &[f64],
        first: usize,
        rotations: &mut [&mut [f64]; 2],
    ) {
        let (_, sigma) = self.response((cell, left), u);
        let [own, others @ ..] = Self::corners(cell);
        for (c, values) in rotations.iter_mut().enumerate() {
            values[own - first] -= sigma[c] + sigma[2 + c] + sigma[4 + c];
            others.iter().enumerate().for_each(|(k, &other)| values[other - first] += sigma[2 * k + c]);
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
        for (cell, left) in self.each() {
            let corners = Self::corners(cell);
            pairs(left).for_each(|(a, b)| visit(corners[a], corners[b]));
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
        let (x, y) = force[PHI_X * n..].split_at_mut(n);
        self.torn().for_each(|torn| self.add_cell(torn, u, 0, &mut [x, y]));
    }

    fn survey(&self, u: &[f64]) -> Survey<3> {
        let of_cell = |cell: ([u32; 2], Set)| {
            let (s, sigma) = self.response(cell, u);
            let largest = |c: usize| (0..3).fold(0.0, |most: f64, k| most.max(sigma[2 * k + c].abs()));
            let energy = s.iter().zip(sigma).map(|(s, sigma)| 0.5 * s * sigma).sum();
            Survey { energy, largest_action: [0.0, largest(0), largest(1)] }
        };
        // Row by row: the error of a long sum grows with its number of terms.
        let of_row = |row: &Vec<[u32; 2]>| {
            row.iter().map(|&cell| of_cell((cell, WHOLE))).fold(Survey::EMPTY, Survey::join)
        };
        let torn = self.torn().map(of_cell).fold(Survey::EMPTY, Survey::join);
        self.rows.iter().map(of_row).fold(torn, Survey::join)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<3>) {
        let blocks: [Mat<3, 3>; 16] = from_fn(|ab| self.block(WHOLE, ab / 4, ab % 4));
        // The numbers of corners ascend.
        for (cell, left) in self.each() {
            let corners = Self::corners(cell);
            for (a, b) in (0..4).map(|a| (a, a)).chain(pairs(left)) {
                match left {
                    WHOLE => tangent.add(corners[a], corners[b], &blocks[4 * a + b]),
                    _ => tangent.add(corners[a], corners[b], &self.block(left, a, b)),
                }
            }
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<3, 3>]) {
        let own: [Mat<3, 3>; 4] = from_fn(|a| self.block(WHOLE, a, a));
        for (cell, left) in self.each() {
            for (a, point) in Self::corners(cell).into_iter().enumerate() {
                match left {
                    WHOLE => add(&mut blocks[point], &own[a]),
                    _ => add(&mut blocks[point], &self.block(left, a, a)),
                }
            }
        }
    }

    fn elements(&self) -> usize {
        self.count()
    }

    fn joins_many(&self) -> bool {
        true
    }

    fn stored_factors(&self) -> usize {
        MEASURES * MEASURES + self.cells
    }
}

/// The corners of a cell, two by two, that its triangles join.
fn pairs(left: Set) -> impl Iterator<Item = (usize, usize)> {
    let all = (0..4).flat_map(|a| (a + 1..4).map(move |b| (a, b)));
    // A triangle has all corners but that opposite to its own.
    all.filter(move |&(a, b)| (0..4).any(|t| left >> t & 1 == 1 && ![a, b].contains(&(3 - t))))
}
