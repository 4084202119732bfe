//! Inextensional motions of a cylinder, which a membrane does not resist, and whether its ends prevent them.
//!
//! `u = U(s), v = V(s) − x U'(s), w = R (x U''(s) − V'(s))` has no strain. On a whole circumference x = c an end that holds u
//! makes U' zero, one that holds v or w makes `V − c U'` zero (but for rigid motions): two independent such conditions
//! prevent all of them, one leaves `[U', V] = [a, b] g(s)` with any function g.

use super::super::plane::Mirrors;
use super::ShellParameters;
use crate::body::SquareLattice;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};

/// Conditions `α U' + β V = 0` that hold on all generators.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EndConditions {
    found: Vec<[f64; 2]>,
}

impl EndConditions {
    /// The axial displacement of a circumference is held and cannot vary: U' = 0.
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
    parameters: &'a ShellParameters,
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    ends: EndConditions,
}

/// Of a row: its s, and the sums of `f_u`, `f_v`, `x f_v`, `f_w` and `x f_w`.
struct RowForces {
    s: f64,
    sums: [f64; 5],
}

/// Waves `g(s)` along the circumference.
struct Waves {
    /// 1/m.
    numbers: Vec<f64>,
    /// Whether waves are even or odd or both about the first side.
    parities: &'static [bool],
    /// Work per load and amplitude that is rounding or comes from the spacing.
    slack: f64,
}

impl<'a> Inextensional<'a> {
    /// Those that some conditions leave, and the mirrors and joined ends of a shell; its lattice has images.
    pub fn new(
        parameters: &'a ShellParameters,
        (lattice, mirrors): (&'a SquareLattice, &'a Mirrors),
        mut ends: EndConditions,
    ) -> Self {
        // A mirror makes u odd; joined ends make it, and v, the same on both.
        if mirrors.lines[0] != [None; 2] {
            ends.hold_axial();
        }
        Self { parameters, lattice, mirrors, ends }
    }

    /// Whether forces, N, by component planes, do work on a motion that is left, by more than rounding.
    pub fn is_worked_on(&self, force: &[f64]) -> bool {
        let left = self.ends.left();
        if left.is_empty() || self.parameters.bending {
            return false;
        }
        let (rows, waves) = (self.row_forces(force), self.waves());
        let load: f64 = force.iter().map(|f| f.abs()).sum();
        let each = waves.numbers.iter().flat_map(|&wave| waves.parities.iter().map(move |&odd| (wave, odd)));
        each.flat_map(|wave| left.iter().map(move |&motion| (motion, wave)))
            .any(|(motion, wave)| self.work(motion, wave, &rows).abs() > waves.slack * load)
    }

    /// Forces by rows; those on images are brought back to their points.
    fn row_forces(&self, force: &[f64]) -> Vec<RowForces> {
        let n = self.lattice.points();
        let mut rows: BTreeMap<i32, RowForces> = BTreeMap::new();
        for p in 0..n {
            let (cell, signs) = self.mirrors.image(self.lattice.cell(p));
            let [x, s] = self.lattice.place_of(cell);
            let [u, v, w] = [0, 1, 2].map(|c| force[c * n + p]);
            let (u, v) = (signs[0] * u, signs[1] * v);
            let row = rows.entry(cell[1]).or_insert(RowForces { s, sums: [0.0; 5] });
            let parts = [u, v, x * v, w, x * w];
            row.sums.iter_mut().zip(parts).for_each(|(sum, part)| *sum += part);
        }
        rows.into_values().collect()
    }

    fn waves(&self) -> Waves {
        /// Where sums over a period cancel, and where they do so up to the spacing.
        const SLACK: [f64; 2] = [1e-8, 3e-2];
        /// Waves between free sides that are tried: shorter ones see the spacing.
        const FEW: usize = 4;
        let (mirrors, radius) = (self.mirrors, self.parameters.radius);
        let rows = mirrors.real(self.lattice).rows().len();
        let arc = rows as f64 * self.lattice.spacing();
        // Waves with one period around the cylinder are rigid motions.
        let beyond_rigid = |unit: f64, most: usize| {
            let all = (1..=most).map(|k| unit * k as f64);
            all.filter(|wave| *wave > 1.01 / radius).collect()
        };
        match (mirrors.joined[1], mirrors.lines[1]) {
            (true, _) => {
                let numbers = beyond_rigid(TAU / arc, rows / 2);
                Waves { numbers, parities: &[false, true], slack: SLACK[0] }
            }
            (_, [Some(_), Some(_)]) => {
                Waves { numbers: beyond_rigid(PI / arc, rows), parities: &[true], slack: SLACK[0] }
            }
            (_, sides) => {
                let parities: &[bool] = if sides == [None; 2] { &[false, true] } else { &[true] };
                let numbers = (1..=FEW).map(|k| PI / arc * k as f64).collect();
                Waves { numbers, parities, slack: SLACK[1] }
            }
        }
    }

    /// Work per amplitude on the motion `[U', V] = [a, b] g(s)`.
    fn work(&self, [a, b]: [f64; 2], (wave, is_odd): (f64, bool), rows: &[RowForces]) -> f64 {
        let r = self.parameters.radius;
        let origin = rows.first().map_or(0.0, |row| row.s - 0.5 * self.lattice.spacing());
        let of_row = |row: &RowForces| {
            let (sin, cos) = (wave * (row.s - origin)).sin_cos();
            // G' = g.
            let [integral, g, slope] =
                if is_odd { [-cos / wave, sin, wave * cos] } else { [sin / wave, cos, -wave * sin] };
            let shares = [a * integral, b * g, -a * g, -b * r * slope, a * r * slope];
            shares.iter().zip(&row.sums).map(|(share, sum)| share * sum).sum::<f64>()
        };
        let places = self.lattice.columns();
        let far = [places.start, places.end].map(|column| self.lattice.place_of([column, 0, 0])[0].abs());
        let most = b.abs() + a.abs() * far[0].max(far[1]);
        let amplitude = most.max(a.abs() / wave).max(r * wave * most);
        rows.iter().map(of_row).sum::<f64>() / amplitude
    }
}
