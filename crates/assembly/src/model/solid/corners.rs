//! The overlay: tetrahedra with the stiffness of missing bonds.
//!
//! A point k that lacks bonds lacks `D = ½ Σ_missing a N Nᵀ` of the stiffness, and `d = Σ_missing (3w/q) |ξ|² N` of its
//! dilatation. It gets them back from the n tetrahedra with constant strains E_t that it makes with three points next to it: as
//! the energy `V_k/n Σ ½ E_tᵀ D E_t` and the dilatation `1/n Σ d·E_t`. So every point has exactly the stiffness of the material
//! in every uniform strain, and nothing becomes indefinite. What lacks the same bonds and has the same tetrahedra shares them.

use super::body::Reach;
use super::tetrahedra::{Corners, rows_of_cells, tetrahedra};
use super::{SolidLaw, TENSOR};
use crate::body::{Cell, SquareLattice, plus};
use crate::bonds::Mat;
use crate::stiffness::{Exception, SharedFamilies, SharedKind};
use nalgebra::DMatrix;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// What points have in common that lack the same bonds.
#[derive(Clone, Debug)]
pub(super) struct CornerKind {
    /// `D`, Pa.
    pub(super) lack: Mat<TENSOR, TENSOR>,
    /// `d`.
    pub(super) dilatation: [f64; TENSOR],
    /// Steps to the corners of the tetrahedra.
    pub(super) others: Vec<Cell>,
    /// Mean strain of the tetrahedra per measure of the family, 1/m.
    pub(super) strain: Vec<[f64; TENSOR]>,
}

/// The tetrahedra of all points.
#[derive(Clone, Debug)]
pub(super) struct Overlay {
    pub(super) families: Arc<SharedFamilies<3>>,
    pub(super) kinds: Vec<CornerKind>,
    /// Kind of every point that has tetrahedra.
    pub(super) of_point: HashMap<usize, usize>,
    /// Points that lack bonds and have no tetrahedron.
    pub(super) uncorrected: usize,
}

impl Overlay {
    /// That of some points of a lattice; `cuts` part the corners of tetrahedra. Bonds of `gaps` are missing, too, although both of
    /// their points are there.
    pub(super) fn new(
        lattice: &SquareLattice,
        law: &SolidLaw,
        reach: &Reach,
        points: &[usize],
        cuts: &HashSet<(usize, usize)>,
        gaps: &[Exception],
    ) -> Self {
        let mut families = SharedFamilies::new(lattice.points());
        let (mut kinds, mut of_point, mut uncorrected) = (Vec::new(), HashMap::new(), 0);
        let mut known: HashMap<(Vec<bool>, Vec<Corners>), usize> = HashMap::new();
        let across = across(lattice, law, reach, gaps);
        for &point in points {
            let cell = lattice.cell(point);
            let mut missing = reach.missing(lattice, cell);
            across.get(&point).into_iter().flatten().for_each(|&step| missing[step] = true);
            if !missing.contains(&true) {
                continue;
            }
            let corners = tetrahedra(lattice, &law.neighbourhood, cuts, cell);
            if corners.is_empty() {
                uncorrected += 1;
                continue;
            }
            let kind = *known.entry((missing, corners)).or_insert_with_key(|(missing, corners)| {
                let kind = CornerKind::new(law, reach, missing, corners, lattice.spacing());
                let root = kind.root(corners, lattice.spacing());
                kinds.push(kind);
                families.add_kind(root)
            });
            let others = kinds[kind].others.iter().filter_map(|&step| lattice.number(plus(cell, step)));
            families.push(point, kind, lattice.fraction(point), others);
            of_point.insert(point, kind);
        }
        Self { families: Arc::new(families), kinds, of_point, uncorrected }
    }
}

impl CornerKind {
    fn new(law: &SolidLaw, reach: &Reach, missing: &[bool], corners: &[Corners], spacing: f64) -> Self {
        let (mut lack, mut dilatation) = ([[0.0; TENSOR]; TENSOR], [0.0; TENSOR]);
        for (k, step) in reach.steps.iter().enumerate().filter(|(k, _)| missing[*k]) {
            let (n, offset) = (super::direction_product(*step), reach.offset_of(k));
            let weight = 0.5 * law.neighbourhood.weights[offset][0];
            (0..TENSOR).for_each(|r| (0..TENSOR).for_each(|c| lack[r][c] += weight * n[r] * n[c]));
            if let Some(of) = &law.dilatation {
                let squared = f64::from(step.iter().map(|k| k * k).sum::<i32>());
                (0..TENSOR).for_each(|q| dilatation[q] += of.shares[offset] * squared * n[q]);
            }
        }
        let mut others: Vec<Cell> = corners.iter().flatten().copied().collect();
        others.sort_unstable();
        others.dedup();
        let mut strain = vec![[0.0; TENSOR]; 3 * others.len()];
        for tetrahedron in corners {
            for (measure, rows) in spread(&others, *tetrahedron, rows_of_cells(*tetrahedron, spacing)) {
                (0..TENSOR).for_each(|q| strain[measure][q] += rows[q] / corners.len() as f64);
            }
        }
        Self { lack, dilatation, others, strain }
    }

    /// The root of `V/n Σ Bᵀ D B` of a whole cell.
    fn root(&self, corners: &[Corners], spacing: f64) -> SharedKind {
        let side = 3 * self.others.len();
        let lack = DMatrix::from_fn(TENSOR, TENSOR, |r, c| self.lack[r][c]).symmetric_eigen();
        let part = spacing.powi(3) / corners.len() as f64;
        let mut stack = DMatrix::zeros(TENSOR * corners.len(), side);
        for (t, tetrahedron) in corners.iter().enumerate() {
            for (measure, strain) in spread(&self.others, *tetrahedron, rows_of_cells(*tetrahedron, spacing))
            {
                for k in 0..TENSOR {
                    let along: f64 = (0..TENSOR).map(|q| lack.eigenvectors[(q, k)] * strain[q]).sum();
                    stack[(TENSOR * t + k, measure)] = (part * lack.eigenvalues[k].max(0.0)).sqrt() * along;
                }
            }
        }
        SharedKind::new(self.others.len(), stack)
    }

    /// Mean strain of the tetrahedra of a family with some measures.
    pub(super) fn strain_of(&self, measures: &[f64]) -> [f64; TENSOR] {
        let mut strain = [0.0; TENSOR];
        for (rows, s) in self.strain.iter().zip(measures) {
            (0..TENSOR).for_each(|q| strain[q] += rows[q] * s);
        }
        strain
    }
}

/// Steps from points to those that gaps part them from.
fn across(
    lattice: &SquareLattice,
    law: &SolidLaw,
    reach: &Reach,
    gaps: &[Exception],
) -> HashMap<usize, Vec<usize>> {
    let mut across: HashMap<usize, Vec<usize>> = HashMap::new();
    for gap in gaps {
        let upper = lattice.number(plus(lattice.cell(gap.lower), law.neighbourhood.offsets[gap.offset]));
        for (point, is_lower) in [(Some(gap.lower), true), (upper, false)] {
            let Some(point) = point else { continue };
            across.entry(point).or_default().push(reach.step_of(gap.offset, is_lower));
        }
    }
    across
}

/// Measures of a family that a tetrahedron moves with, by their indices, and its strains per unit of them.
fn spread(others: &[Cell], corners: Corners, rows: [Mat<TENSOR, 3>; 3]) -> Vec<(usize, [f64; TENSOR])> {
    let mut all = Vec::with_capacity(9);
    for (step, rows) in corners.iter().zip(rows) {
        let other = others.iter().position(|o| o == step).expect("corners are among the others");
        all.extend((0..3).map(|c| (3 * other + c, rows.map(|row| row[c]))));
    }
    all
}
