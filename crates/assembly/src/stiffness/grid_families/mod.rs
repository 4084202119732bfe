//! Families of a lattice by offset: what a point and all neighbours within its horizon make together, in the plane or in a solid.
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

use super::{BlockMatrix, ConnectedParts, Survey, Term};
use crate::body::{Cell, Run, SquareLattice, minus};
use crate::bonds::Mat;
use blocks::Blocks;
use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

/// The rows `d` of a family, `[x, y]` per step, in a solid `[x, y, z]`.
pub type FamilyRows<const D: usize = 2> = Vec<[f64; D]>;

/// What the families of a lattice are.
#[derive(Clone, Debug)]
pub struct GridFamily<const D: usize = 2> {
    /// From a point to its neighbours, cells, in both directions.
    pub steps: Vec<Cell>,
    /// Sets of rows that points share.
    pub sets: Vec<FamilyRows<D>>,
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

/// A point of a family: its offset, cells, and its index among the steps; none of the point itself.
type Measured = (Cell, Option<usize>);

/// Consecutive points of one row with the same rows.
#[derive(Clone, Debug)]
struct Stretch {
    first: usize,
    /// Row and layer.
    line: [i32; 2],
    columns: Range<i32>,
    set: u32,
}

/// Consecutive rows, or where there are several consecutive layers: of two bands that are not next to each other no two families share a point.
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
pub struct GridFamilies<const D: usize = 2> {
    lattice: Arc<SquareLattice>,
    family: GridFamily<D>,
    stretches: Vec<Stretch>,
    bands: Vec<Band>,
    blocks: Option<Blocks>,
    /// Sets of a solid whose rows at opposite steps, half of all steps apart, are opposite.
    odd: Vec<bool>,
}

impl<const D: usize> GridFamilies<D> {
    /// The families of the points that have a set.
    pub fn new(lattice: Arc<SquareLattice>, mut family: GridFamily<D>) -> Self {
        let without = family.volume.iter_mut().zip(&family.set_of).filter(|(_, set)| set.is_none());
        without.for_each(|(volume, _)| *volume = 0.0);
        let reach = family.steps.iter().flat_map(|s| s.map(i32::abs)).max().unwrap_or(0);
        let stretches = stretches(&lattice, &family.set_of);
        let bands = bands(&lattice, &stretches, reach);
        let blocks = (family.mean_modulus != 0.0).then(|| Blocks::new(&lattice, &family));
        let odd = family.sets.iter().map(|set| is_odd(&family.steps, set)).collect();
        Self { lattice, family, stretches, bands, blocks, odd }
    }

    /// Rows of the first measure of a point by the steps of [`GridFamily::steps`]; none where there is no family.
    pub fn rows(&self, point: usize) -> Option<&FamilyRows<D>> {
        self.family.set_of[point].map(|set| &self.family.sets[set as usize])
    }

    /// Index of a step among those of all families.
    pub fn step(&self, step: Cell) -> Option<usize> {
        self.family.steps.iter().position(|own| *own == step)
    }

    /// Gives some points rows of their own, those that have a family.
    pub fn set_rows(&mut self, rows: &[(usize, FamilyRows<D>)]) {
        for (point, rows) in rows {
            if let Some(set) = &mut self.family.set_of[*point] {
                *set = self.family.sets.len() as u32;
                self.odd.push(is_odd(&self.family.steps, rows));
                self.family.sets.push(rows.clone());
            }
        }
        self.stretches = stretches(&self.lattice, &self.family.set_of);
        let reach = self.family.steps.iter().flat_map(|s| s.map(i32::abs)).max().unwrap_or(0);
        self.bands = bands(&self.lattice, &self.stretches, reach);
    }

    /// The same with an energy of the other sign: with what was before a change it makes what the change took.
    #[must_use]
    pub fn negated(mut self) -> Self {
        self.family.modulus.iter_mut().flatten().for_each(|c| *c = -*c);
        self.family.mean_modulus = -self.family.mean_modulus;
        self
    }

    /// The first measure ϑ of every point; zero where there is no family.
    pub fn dilatations(&self, u: &[f64]) -> Vec<f64> {
        let [theta, _] = self.measures(u);
        theta
    }

    /// Adds the forces that do the work of the stresses of measures ϑ and h, of all points.
    pub fn add_work_of(&self, [theta, hoop]: [&[f64]; 2], force: &mut [f64]) {
        self.push(&self.stresses(theta, hoop), force);
    }

    /// Adds the forces that do the work of stresses, times volumes, of the points with their dilatations and, if there are any
    /// of these, with their second measures.
    pub fn add_measure_work(&self, stress: [Vec<f64>; 2], force: &mut [f64]) {
        self.push(&stress, force);
    }

    /// Offsets of points that a family can have in common, those to points behind, each with the offsets of both from the
    /// point of the family.
    fn shared_steps(&self) -> BTreeMap<Cell, Vec<[Measured; 2]>> {
        let others = || self.family.steps.iter().enumerate().map(|(k, step)| (*step, Some(k)));
        let members = || std::iter::once(([0; 3], None)).chain(others());
        let mut shared: BTreeMap<Cell, Vec<[Measured; 2]>> = BTreeMap::new();
        for a in members() {
            for b in members() {
                let step = minus(b.0, a.0);
                if [step[2], step[1], step[0]] > [0; 3] {
                    shared.entry(step).or_default().push([a, b]);
                }
            }
        }
        // Families in the middle of both are the most likely ones.
        let far = |pair: &[Measured; 2]| pair.iter().flat_map(|member| member.0).map(|k| k * k).sum::<i32>();
        shared.values_mut().for_each(|pairs| pairs.sort_by_key(far));
        shared
    }

    /// Whether the family of a cell measures two points, by their indices.
    fn has_members(&self, cell: Cell, points: [Option<usize>; 2]) -> bool {
        let Some(set) = self.lattice.number(cell).and_then(|p| self.family.set_of[p]) else {
            return false;
        };
        // A point without neighbours measures nothing, itself neither.
        let rows = &self.family.sets[set as usize];
        points.into_iter().all(|point| match point {
            Some(k) => rows[k] != [0.0; D],
            None => rows.iter().any(|row| *row != [0.0; D]),
        })
    }
}

/// Whether rows at opposite steps are opposite; in a plane nobody asks.
fn is_odd<const D: usize>(steps: &[Cell], set: &FamilyRows<D>) -> bool {
    let half = steps.len() / 2;
    let opposite = |k: usize| steps[k] == steps[k + half].map(|x| -x) && set[k] == set[k + half].map(|x| -x);
    D > 2 && steps.len() == 2 * half && (0..half).all(opposite)
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
                        line: run.line(),
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
    // Points are numbered layer by layer.
    let (axis, rows) = if lattice.is_plane() { (0, lattice.rows()) } else { (1, lattice.layers()) };
    // Number of the first point at or behind a row, or a layer.
    let from = |row: i32| {
        let runs = lattice.runs();
        runs.get(runs.partition_point(|r| r.line()[axis] < row)).map_or(lattice.points(), |r| r.first)
    };
    let height = (2 * reach).max(8);
    let mut bands = Vec::new();
    for start in rows.clone().step_by(height as usize) {
        let end = (start + height).min(rows.end);
        let first = stretches.partition_point(|s| s.line[axis] < start);
        let behind = stretches.partition_point(|s| s.line[axis] < end);
        bands.push(Band {
            points: from(start)..from(end),
            reached: from(start - reach)..from(end + reach),
            stretches: first..behind,
        });
    }
    bands
}

impl<const D: usize> Term<D> for GridFamilies<D> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for (step, pairs) in self.shared_steps() {
            for run in self.lattice.runs() {
                self.lattice.shifted(run.line(), &run.columns, step, |columns, other| {
                    for (k, column) in columns.clone().enumerate() {
                        let shared = pairs.iter().any(|&[(from, a), (_, b)]| {
                            self.has_members(minus(run.cell(column), from), [a, b])
                        });
                        if shared {
                            visit(run.number(column), other + k);
                        }
                    }
                });
            }
        }
        for block in self.blocks.iter().flat_map(Blocks::iter) {
            let (members, _) = self.mean_members(block);
            for (k, (i, _)) in members.iter().enumerate() {
                members[k + 1..].iter().for_each(|(j, _)| visit(*i, *j));
            }
        }
    }

    /// Members of two families that share a point, or a block, are at most so far apart.
    fn reach(&self) -> usize {
        let most = self.family.steps.iter().flat_map(|s| s.map(i32::abs)).max().unwrap_or(0);
        let rows = 2 * most + i32::from(self.blocks.is_some());
        let layers = if self.lattice.is_plane() { 0 } else { rows };
        let runs = self.lattice.runs();
        let reach = |run: &Run| {
            let behind = runs.partition_point(|r| [r.layer, r.row] <= [run.layer + layers, run.row + rows]);
            runs[behind - 1].points().end - run.first
        };
        runs.iter().map(reach).max().unwrap_or(0)
    }

    fn join(&self, parts: &mut ConnectedParts) {
        self.for_each_family(|point, members| {
            members.iter().for_each(|(member, _)| parts.join(point, *member))
        });
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let [theta, hoop] = self.measures(u);
        self.push(&self.stresses(&theta, &hoop), force);
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        self.survey_families(u)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.assemble(tangent);
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        self.assemble_diagonal(blocks);
    }

    fn elements(&self) -> usize {
        self.stretches.iter().map(|s| s.columns.len()).sum()
    }

    fn joins_many(&self) -> bool {
        true
    }

    fn stored_factors(&self) -> usize {
        let rows: usize = self.family.sets.iter().map(|set| D * set.len()).sum();
        rows + self.family.volume.len() + self.family.own.len() + self.family.set_of.len()
    }
}
