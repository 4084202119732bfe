//! Inextensional motions of a cylinder, which a membrane does not resist, and whether its ends prevent them.
//!
//! `u = U(s), v = V(s) − x U'(s), w = R (x U''(s) − V'(s))` has no strain. On a whole circumference x = c an end that holds u
//! makes U' zero, one that holds v or w makes `V − c U'` zero (but for rigid motions): two independent such conditions
//! prevent all of them, one leaves `[U', V] = [a, b] g(s)` with any function g.

use super::ShellMembrane;
use crate::model::plane::PlaneModel;
use std::f64::consts::{PI, TAU};

/// Conditions `α U' + β V = 0` that hold on all generators.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EndConditions {
    found: Vec<[f64; 2]>,
}

impl EndConditions {
    /// Nothing holds the axial displacement of a circumference from varying: U' = 0 if that is added.
    pub fn hold_axial(&mut self) {
        self.add([1.0, 0.0]);
    }

    /// The circumference at x keeps its shape: v or w is held on it.
    pub fn hold_shape(&mut self, x: f64) {
        self.add([-x, 1.0]);
    }

    fn add(&mut self, condition: [f64; 2]) {
        let new = |[a, b]: &[f64; 2]| {
            let cross = a * condition[1] - b * condition[0];
            cross.abs() > 1e-9 * a.hypot(*b) * condition[0].hypot(condition[1])
        };
        if self.found.len() < 2 && self.found.iter().all(new) {
            self.found.push(condition);
        }
    }

    /// Whether no inextensional motion is left.
    pub fn are_complete(&self) -> bool {
        self.found.len() == 2
    }

    /// `[a, b]` of the motions that are left.
    fn left(&self) -> Vec<[f64; 2]> {
        match self.found[..] {
            [] => vec![[1.0, 0.0], [0.0, 1.0]],
            [[a, b]] => vec![[-b, a]],
            _ => Vec::new(),
        }
    }
}

/// The inextensional motions that the ends of a shell leave.
#[derive(Debug)]
pub struct Inextensional<'a> {
    shell: &'a ShellMembrane,
    ends: EndConditions,
}

/// Of every row: its s, and the sums of `f_u`, `f_v`, `x f_v`, `f_w`, `x f_w` and of their magnitudes.
struct RowForces {
    s: f64,
    sums: [f64; 5],
    sizes: [f64; 5],
}

impl<'a> Inextensional<'a> {
    /// Those that some conditions leave, and the mirrors and joined ends of the shell.
    pub fn new(shell: &'a ShellMembrane, mut ends: EndConditions) -> Self {
        let mirrors = &shell.mirrors;
        // A mirror makes u odd; joined ends make it, and v, the same on both.
        if mirrors.columns != [None; 2] {
            ends.hold_axial();
        }
        Self { shell, ends }
    }

    /// Whether forces, N, by component planes, do work on a motion that is left, by more than rounding.
    pub fn is_worked_on(&self, force: &[f64]) -> bool {
        let left = self.ends.left();
        if left.is_empty() || self.shell.curvature.is_some() {
            return false;
        }
        let rows = self.row_forces(force);
        let (wave_numbers, parities, slack) = self.waves(&rows);
        wave_numbers.into_iter().any(|wave| {
            parities
                .iter()
                .any(|&is_odd| left.iter().any(|&[a, b]| self.works([a, b], wave, is_odd, slack, &rows)))
        })
    }

    fn row_forces(&self, force: &[f64]) -> Vec<RowForces> {
        let (shell, n) = (self.shell, self.shell.point_count());
        let mut rows: Vec<RowForces> = Vec::new();
        let mut last = None;
        for p in shell.real_points() {
            let (row, [x, s]) = (shell.lattice.cell(p)[1], shell.place(p));
            if last.replace(row) != Some(row) {
                rows.push(RowForces { s, sums: [0.0; 5], sizes: [0.0; 5] });
            }
            let Some(of) = rows.last_mut() else { continue };
            let [u, v, w] = [0, 1, 2].map(|c| force[c * n + p]);
            for (k, value) in [u, v, x * v, w, x * w].into_iter().enumerate() {
                of.sums[k] += value;
                of.sizes[k] += value.abs();
            }
        }
        rows
    }

    /// Wave numbers, 1/m, whether waves are even or odd or both about the first side, and what counts as rounding.
    fn waves(&self, rows: &[RowForces]) -> (Vec<f64>, Vec<bool>, f64) {
        /// Work per its size that is rounding, where sums over a period cancel, and where they do so up to the spacing.
        const SLACK: [f64; 2] = [1e-8, 1e-2];
        let mirrors = &self.shell.mirrors;
        let arc = rows.len() as f64 * self.shell.lattice.spacing();
        let (unit, parities, slack) = match (mirrors.joined[1], mirrors.rows) {
            (true, _) => (TAU / arc, vec![false, true], SLACK[0]),
            (_, [Some(_), Some(_)]) => (PI / arc, vec![true], SLACK[0]),
            (_, [None, None]) => (PI / arc, vec![false, true], SLACK[1]),
            _ => (PI / arc, vec![true], SLACK[1]),
        };
        // Waves with one period around the cylinder are rigid motions.
        let rigid = (1.0 + 1e-2) / self.shell.closed_radius;
        let most = rows.len() / if mirrors.joined[1] { 2 } else { 1 };
        let waves = (1..=most).map(|k| unit * k as f64).filter(|wave| *wave > rigid || slack == SLACK[1]);
        (waves.collect(), parities, slack)
    }

    fn works(&self, [a, b]: [f64; 2], wave: f64, is_odd: bool, slack: f64, rows: &[RowForces]) -> bool {
        let r = self.shell.closed_radius;
        let origin = rows.first().map_or(0.0, |row| row.s - 0.5 * self.shell.lattice.spacing());
        let most = [a / wave, b, a, b * r * wave, a * r * wave].map(f64::abs);
        let (mut work, mut size) = (0.0, 0.0);
        for row in rows {
            let (sin, cos) = (wave * (row.s - origin)).sin_cos();
            // G' = g.
            let [integral, g, slope] =
                if is_odd { [-cos / wave, sin, wave * cos] } else { [sin / wave, cos, -wave * sin] };
            let shares = [a * integral, b * g, -a * g, -b * r * slope, a * r * slope];
            for k in 0..5 {
                work += shares[k] * row.sums[k];
                size += most[k] * row.sizes[k];
            }
        }
        work.abs() > slack * size
    }
}
