//! Bending rows: the resistance of a shell to changes of the curvature of its circumference.
//!
//! `κ_i = 4 Σ_j r_ij (w_j − w_i) + λ w_i` with the energy `½ D A Σ κ_i²`: the Laplacian part of bending, right for inextensional
//! ovalling, without the twist of a plate and without the conditions of free edges. `λ = 1/R²` but for rounding makes
//! `w = cos(s/R)` of a full family free of curvature; at edges weights are such that all rigid motions are.

use super::super::plane::{Mirrors, at, near_points};
use super::family::{ShellFamilies, ShellOffset};
use super::weights::corrected;
use super::{ShellMembrane, ShellParameters};
use crate::body::SquareLattice;
use crate::bonds::Mat;
use crate::stiffness::{BlockMatrix, Survey, Term};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Energy of the changes of curvature of all real points.
#[derive(Clone, Debug)]
pub struct Curvature {
    lattice: Arc<SquareLattice>,
    mirrors: Mirrors,
    offsets: Vec<ShellOffset>,
    /// Weights of the points that lack bonds, per offset, upwards and downwards, 1/m²; none where no weights know a rigid
    /// motion from bending: such a point has no row.
    special: BTreeMap<u32, Vec<[f64; 2]>>,
    /// λ, 1/m².
    own: f64,
    /// `D A`, N m³.
    modulus: f64,
}

/// What weights are to sum up: with `Δ = ds/R`, `[cos Δ − 1, sin Δ, dx cos Δ, dx sin Δ, dx²]`, each of size one.
fn sums([x, s]: [f64; 2], radius: f64, horizon: f64) -> [f64; 5] {
    let (sin, cos) = (s / radius).sin_cos();
    let (ratio, x) = (radius / horizon, x / horizon);
    [ratio * ratio * (cos - 1.0), ratio * sin, x * cos, ratio * x * sin, x * x]
}

impl Curvature {
    /// The rows of a lattice whose points have these families.
    pub(super) fn new(
        lattice: &Arc<SquareLattice>,
        mirrors: &Mirrors,
        parameters: &ShellParameters,
        families: &ShellFamilies,
    ) -> Self {
        let spacing = lattice.spacing();
        let (radius, horizon) = (parameters.radius, parameters.horizon_ratio * spacing);
        let offsets = families.offsets.clone();
        let own: f64 = offsets.iter().map(|o| 8.0 * o.weight * (1.0 - (o.xi[1] / radius).cos())).sum();
        let mut target = [0.0; 5];
        for offset in &offsets {
            let of = sums(offset.xi, radius, horizon);
            [0, 4].into_iter().for_each(|q| target[q] += 2.0 * offset.weight * of[q]);
        }
        let mut special = BTreeMap::new();
        for point in near_points(lattice, families.reach()) {
            let cell = lattice.cell(point);
            let present =
                |offset: &ShellOffset, up: bool| lattice.number(at(cell, offset.step, up)).is_some();
            let is_full = offsets.iter().all(|o| present(o, true) && present(o, false));
            if mirrors.is_real(cell) && !is_full {
                special.insert(point as u32, completed(&offsets, &present, target, [radius, horizon]));
            }
        }
        let modulus = parameters.bending_stiffness() * spacing * spacing;
        Self { lattice: lattice.clone(), mirrors: *mirrors, offsets, special, own, modulus }
    }

    /// λ, 1/m².
    pub fn own(&self) -> f64 {
        self.own
    }

    /// The deflections that make the curvature of a real point, with their coefficients, that of the point itself first.
    fn row(&self, point: usize) -> Vec<(usize, f64)> {
        let (cell, special) = (self.lattice.cell(point), self.special.get(&(point as u32)));
        if special.is_some_and(Vec::is_empty) {
            return Vec::new();
        }
        let mut row = vec![(point, self.own)];
        for (k, offset) in self.offsets.iter().enumerate() {
            for side in [0, 1] {
                if let Some(other) = self.lattice.number(at(cell, offset.step, side == 0)) {
                    let weight = 4.0 * special.map_or(offset.weight, |s| s[k][side]);
                    row.push((other, weight));
                    row[0].1 -= weight;
                }
            }
        }
        row
    }

    fn rows(&self) -> impl Iterator<Item = Vec<(usize, f64)>> + '_ {
        let real = (0..self.lattice.points()).filter(|&p| self.mirrors.is_real(self.lattice.cell(p)));
        real.map(|p| self.row(p)).filter(|row| !row.is_empty())
    }

    /// κ of a row, 1/m, differences first.
    fn curvature(&self, row: &[(usize, f64)], u: &[f64]) -> f64 {
        let w = &u[2 * self.lattice.points()..];
        let Some(own) = row.first().map(|first| w[first.0]) else { return 0.0 };
        self.own * own + row[1..].iter().map(|&(p, c)| c * (w[p] - own)).sum::<f64>()
    }

    /// Energy of a real point, J.
    pub(super) fn energy(&self, point: usize, u: &[f64]) -> f64 {
        0.5 * self.modulus * self.curvature(&self.row(point), u).powi(2)
    }

    /// Visits the pairs of the members of every row, each with the product of their coefficients.
    fn for_each_pair(&self, mut visit: impl FnMut(usize, usize, f64)) {
        for row in self.rows() {
            for (k, &(i, a)) in row.iter().enumerate() {
                row[k..].iter().for_each(|&(j, b)| visit(i.min(j), i.max(j), self.modulus * a * b));
            }
        }
    }
}

/// Weights of a point that lacks bonds with which the sums are those of a full family; none where there are no such ones.
fn completed(
    offsets: &[ShellOffset],
    present: &dyn Fn(&ShellOffset, bool) -> bool,
    target: [f64; 5],
    [radius, horizon]: [f64; 2],
) -> Vec<[f64; 2]> {
    let sides = || offsets.iter().flat_map(|o| [(o, true), (o, false)]);
    let family: Vec<(&ShellOffset, f64)> =
        sides().filter(|(o, up)| present(o, *up)).map(|(o, up)| (o, if up { 1.0 } else { -1.0 })).collect();
    let begin: Vec<f64> = family.iter().map(|(o, _)| o.weight).collect();
    let g: Vec<[f64; 5]> =
        family.iter().map(|(o, sign)| sums(o.xi.map(|x| sign * x), radius, horizon)).collect();
    let found = corrected(&begin, &g, &g, target);
    let misses = |q: usize| {
        let sum: f64 = found.iter().zip(&g).map(|(w, g)| w * g[q]).sum();
        (sum - target[q]).abs() > 1e-9 * target[0].abs()
    };
    if (0..5).any(misses) {
        return Vec::new();
    }
    let mut found = found.into_iter();
    let mut next = |o: &ShellOffset, up: bool| if present(o, up) { found.next().unwrap_or(0.0) } else { 0.0 };
    offsets.iter().map(|o| [next(o, true), next(o, false)]).collect()
}

impl Term<3> for Curvature {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.for_each_pair(|i, j, _| {
            if i != j {
                visit(i, j);
            }
        });
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let n = self.lattice.points();
        for row in self.rows() {
            let sigma = self.modulus * self.curvature(&row, u);
            row.iter().for_each(|&(p, c)| force[2 * n + p] += c * sigma);
        }
    }

    fn survey(&self, u: &[f64]) -> Survey<3> {
        let of = |row: Vec<(usize, f64)>| {
            let kappa = self.curvature(&row, u);
            let largest = row.iter().fold(0.0, |a: f64, (_, c)| a.max((c * self.modulus * kappa).abs()));
            Survey { energy: 0.5 * self.modulus * kappa * kappa, largest_action: [0.0, 0.0, largest] }
        };
        self.rows().map(of).fold(Survey::EMPTY, Survey::join)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<3>) {
        self.for_each_pair(|i, j, product| {
            let mut block = [[0.0; 3]; 3];
            block[2][2] = product;
            tangent.add(i, j, &block);
        });
    }

    fn add_diagonal(&self, blocks: &mut [Mat<3, 3>]) {
        for row in self.rows() {
            row.iter().for_each(|&(p, c)| blocks[p][2][2] += self.modulus * c * c);
        }
    }

    fn elements(&self) -> usize {
        self.rows().count()
    }
}

impl ShellMembrane {
    /// The bending rows, where there are any.
    pub fn curvature(&self) -> Option<&Curvature> {
        self.curvature.as_deref()
    }
}
