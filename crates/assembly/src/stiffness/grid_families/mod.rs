//! Families of a square lattice by offset: what a point and all neighbours within its horizon make together.
//!
//! A family has two measures: `ϑ_k = Σ_o d_o·(u_{k+o} − u_k)` with rows d per offset, and `h_k = a_k u_x,k`; its energy is
//! `½ V_k s·C s`. Most points share one set of rows, so that inner loops run over stretches of points with nothing but
//! displacements to be read. What two points of one family share couples all points two bonds apart: that pattern is made
//! only if somebody assembles it.

mod assemble;
mod blocks;
mod evaluate;
#[cfg(test)]
mod tests;

use super::{BlockMatrix, Parts, Survey, Term};
use crate::body::{Cell, SquareLattice};
use crate::bonds::Mat;
use blocks::Blocks;
use std::ops::Range;
use std::sync::Arc;

/// The rows `d` of a family, `[x, y]` per step.
pub type FamilyRows = Vec<[f64; 2]>;

/// What the families of a lattice are.
#[derive(Clone, Debug)]
pub struct GridFamily {
    /// From a point to its neighbours, cells, in both directions.
    pub steps: Vec<Cell>,
    /// Sets of rows that points share.
    pub sets: Vec<FamilyRows>,
    /// Set of every point; none where a point has no family.
    pub set_of: Vec<Option<u32>>,
    /// Volume of every point, m³.
    pub volume: Vec<f64>,
    /// Coefficient of u_x in the second measure per point, 1/m; empty if there is none.
    pub own: Vec<f64>,
    /// Conjugate to the measures, Pa.
    pub modulus: Mat<2, 2>,
    /// Modulus of the mean of `ϑ + h` over blocks of two by two cells, Pa, beside that.
    pub mean_modulus: f64,
}

/// Consecutive points of one row with the same rows.
#[derive(Clone, Debug)]
struct Stretch {
    first: usize,
    row: i32,
    columns: Range<i32>,
    set: u32,
}

/// Consecutive rows: of two bands that are not next to each other no two families share a point.
#[derive(Clone, Debug)]
struct Band {
    /// Points of its rows.
    points: Range<usize>,
    /// Points of its rows and of those that its families reach.
    reached: Range<usize>,
    stretches: Range<usize>,
}

/// Energy of the families of a lattice, `E = Σ ½ V s·C s`.
#[derive(Clone, Debug)]
pub struct GridFamilies {
    lattice: Arc<SquareLattice>,
    family: GridFamily,
    stretches: Vec<Stretch>,
    bands: Vec<Band>,
    blocks: Option<Blocks>,
}

impl GridFamilies {
    /// The families of the points that have a set.
    pub fn new(lattice: Arc<SquareLattice>, mut family: GridFamily) -> Self {
        let without = family.volume.iter_mut().zip(&family.set_of).filter(|(_, set)| set.is_none());
        without.for_each(|(volume, _)| *volume = 0.0);
        let reach = family.steps.iter().flat_map(|s| s.map(i32::abs)).max().unwrap_or(0);
        let stretches = stretches(&lattice, &family.set_of);
        let bands = bands(&lattice, &stretches, reach);
        let blocks = (family.mean_modulus != 0.0).then(|| Blocks::new(&lattice, &family));
        Self { lattice, family, stretches, bands, blocks }
    }

    /// Offsets of points that a family, or those of a block, can have in common, upwards or to the right.
    fn couplings_by_step(&self) -> Vec<Cell> {
        let members = || std::iter::once([0, 0]).chain(self.family.steps.iter().copied());
        let near: &[Cell] = match self.blocks {
            Some(_) => &[[0, 0], [1, 0], [0, 1], [1, 1], [-1, 1], [-1, 0], [0, -1], [-1, -1], [1, -1]],
            None => &[[0, 0]],
        };
        let mut steps: Vec<Cell> = members()
            .flat_map(|a| members().map(move |b| [b[0] - a[0], b[1] - a[1]]))
            .flat_map(|d| near.iter().map(move |n| [d[0] + n[0], d[1] + n[1]]))
            .filter(|&[a, b]| b > 0 || (b == 0 && a > 0))
            .collect();
        steps.sort_unstable();
        steps.dedup();
        steps
    }
}

fn stretches(lattice: &SquareLattice, set_of: &[Option<u32>]) -> Vec<Stretch> {
    let mut stretches: Vec<Stretch> = Vec::new();
    for run in lattice.runs() {
        let mut open: Option<Stretch> = None;
        for column in run.columns.clone() {
            let point = run.number(column);
            match (&mut open, set_of[point]) {
                (Some(stretch), Some(set)) if stretch.set == set => stretch.columns.end = column + 1,
                (_, set) => {
                    stretches.extend(open.take());
                    open = set.map(|set| Stretch {
                        first: point,
                        row: run.row,
                        columns: column..column + 1,
                        set,
                    });
                }
            }
        }
        stretches.extend(open);
    }
    stretches
}

fn bands(lattice: &SquareLattice, stretches: &[Stretch], reach: i32) -> Vec<Band> {
    let rows = lattice.rows();
    // Number of the first point at or behind a row.
    let from = |row: i32| {
        let runs = lattice.runs();
        runs.get(runs.partition_point(|r| r.row < row)).map_or(lattice.points(), |r| r.first)
    };
    let height = (2 * reach).max(8);
    let mut bands = Vec::new();
    for start in rows.clone().step_by(height as usize) {
        let end = (start + height).min(rows.end);
        let first = stretches.partition_point(|s| s.row < start);
        let behind = stretches.partition_point(|s| s.row < end);
        bands.push(Band {
            points: from(start)..from(end),
            reached: from(start - reach)..from(end + reach),
            stretches: first..behind,
        });
    }
    bands
}

impl Term<2> for GridFamilies {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for step in self.couplings_by_step() {
            for run in self.lattice.runs() {
                self.lattice.shifted(run.row, &run.columns, step, |columns, other| {
                    let first = run.number(columns.start);
                    (0..columns.len()).for_each(|k| visit(first + k, other + k));
                });
            }
        }
    }

    fn reach(&self) -> usize {
        let mut reach = 0;
        for step in self.couplings_by_step() {
            for run in self.lattice.runs() {
                self.lattice.shifted(run.row, &run.columns, step, |columns, other| {
                    reach = reach.max(other - run.number(columns.start));
                });
            }
        }
        reach
    }

    /// Families join what their bonds join.
    fn join(&self, _: &mut Parts) {}

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let [theta, hoop] = self.measures(u);
        self.push(&self.stresses(&theta, &hoop), force);
    }

    fn survey(&self, u: &[f64]) -> Survey<2> {
        self.survey_families(u)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<2>) {
        self.assemble(tangent);
    }

    fn add_diagonal(&self, blocks: &mut [Mat<2, 2>]) {
        self.assemble_diagonal(blocks);
    }

    fn elements(&self) -> usize {
        self.stretches.iter().map(|s| s.columns.len()).sum()
    }

    fn stored_factors(&self) -> usize {
        let rows: usize = self.family.sets.iter().map(|set| 2 * set.len()).sum();
        rows + self.family.volume.len() + self.family.own.len() + self.family.set_of.len()
    }
}
