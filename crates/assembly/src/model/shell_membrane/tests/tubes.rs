//! Tubes and helpers of the tests.

use super::super::*;
use crate::body::SquareLattice;
use crate::condition::Constraints;
use crate::model::plane::{Calibration, Mirrors};
use crate::model::{Model, Points};
use crate::stiffness::BlockMatrix;
use nalgebra::{DMatrix, DVector};
use std::f64::consts::TAU;
use std::sync::Arc;

pub(super) const E: f64 = 2e11;
pub(super) const H: f64 = 0.01;

/// Bonds of a cylinder of circumference one.
pub(super) fn parameters(kinematics: ShellKinematics, calibration: Calibration) -> ShellParameters {
    ShellParameters {
        youngs_modulus: E,
        thickness: H,
        radius: 1.0 / TAU,
        horizon_ratio: 3.0,
        kinematics,
        calibration,
        ends: ShellEnds::Weights,
        bending: false,
    }
}

pub(super) fn chords() -> ShellParameters {
    parameters(ShellKinematics::Chord, Calibration::Matched)
}

/// A lattice of `[columns, rows]` cells whose sides are joined along x, along s.
pub(super) fn shell(
    size: [i32; 2],
    spacing: f64,
    joined: [bool; 2],
    parameters: ShellParameters,
) -> ShellMembrane {
    let real = SquareLattice::rectangle(spacing, [0.0; 2], size);
    let mut mirrors = Mirrors { joined: [joined[0], joined[1], false], ..Mirrors::NONE };
    for side in (0..4).filter(|side| joined[side / 2]) {
        mirrors.set_line(side, if side % 2 == 0 { 0 } else { size[side / 2] });
    }
    let lattice = mirrors.extended(&real, parameters.horizon_ratio.floor() as i32);
    ShellMembrane::with_any_horizon(Arc::new(lattice), mirrors, parameters).unwrap()
}

/// A closed tube of circumference one with some rows, half as many columns.
pub(super) fn tube(rows: i32, parameters: ShellParameters) -> ShellMembrane {
    shell([rows / 2, rows], 1.0 / f64::from(rows), [false, true], parameters)
}

/// Unknowns of all points, images included, from values at real positions and, of the images, at those of their points.
pub(super) fn state(shell: &ShellMembrane, at: impl Fn([f64; 2]) -> [f64; 3]) -> Vec<f64> {
    let n = shell.points();
    let mut u = vec![0.0; 3 * n];
    for p in 0..n {
        let (cell, signs) = shell.mirrors.image(shell.lattice.cell(p));
        let value = at(shell.lattice.place_of(cell));
        let signs = [signs[0], signs[1], 1.0];
        (0..3).for_each(|c| u[c * n + p] = signs[c] * value[c]);
    }
    u
}

/// Forces on real points; those on images are brought back.
pub(super) fn force(shell: &ShellMembrane, u: &[f64]) -> Vec<f64> {
    let mut f = vec![0.0; u.len()];
    shell.terms().iter().for_each(|term| term.add_force(u, &mut f));
    restricted(shell, f)
}

pub(super) fn restricted(shell: &ShellMembrane, mut f: Vec<f64>) -> Vec<f64> {
    Constraints::new(shell.points(), &shell.relations()).unwrap().restrict(&mut f);
    f
}

pub(super) fn energy(shell: &ShellMembrane, u: &[f64]) -> f64 {
    shell.terms().iter().map(|term| term.survey(u).energy).sum()
}

pub(super) fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |a, v| a.max(v.abs()))
}

/// Numbers of the unknowns of real points: all u, all v, all w.
pub(super) fn unknowns(shell: &ShellMembrane) -> Vec<usize> {
    let n = shell.points();
    (0..3).flat_map(|c| shell.real_points().map(move |p| c * n + p).collect::<Vec<_>>()).collect()
}

/// The stiffness on the unknowns of real points.
pub(super) fn matrix(shell: &ShellMembrane) -> DMatrix<f64> {
    let n = shell.points();
    let terms = shell.terms();
    let mut blocks = BlockMatrix::sparse(n, &terms);
    terms.iter().for_each(|term| term.add_tangent(&mut blocks));
    let real = unknowns(shell);
    let constraints = Constraints::new(n, &shell.relations()).unwrap();
    let mut place = vec![(0, 1.0); 3 * n];
    real.iter().enumerate().for_each(|(k, &unknown)| place[unknown] = (k, 1.0));
    for row in constraints.rows() {
        let (master, sign) = row.masters[0];
        place[row.unknown] = (place[master].0, sign);
    }
    let mut k = DMatrix::zeros(real.len(), real.len());
    blocks.for_each_entry(|[i, r], [j, c], value| {
        let ((a, s), (b, t)) = (place[r * n + i], place[c * n + j]);
        k[(a, b)] += s * t * value;
        if (i, r) != (j, c) {
            k[(b, a)] += s * t * value;
        }
    });
    k
}

/// The solution with some unknowns of real points, by their numbers among them, at rest.
pub(super) fn solve(shell: &ShellMembrane, f: &[f64], held: impl Fn(usize) -> bool) -> Vec<f64> {
    let (real, k) = (unknowns(shell), matrix(shell));
    let free: Vec<usize> = (0..real.len()).filter(|&k| !held(k)).collect();
    let inner = DMatrix::from_fn(free.len(), free.len(), |a, b| k[(free[a], free[b])]);
    let rhs = DVector::from_fn(free.len(), |a, _| f[real[free[a]]]);
    let found = inner.cholesky().unwrap().solve(&rhs);
    let mut all = vec![0.0; real.len()];
    free.iter().enumerate().for_each(|(a, &k)| all[k] = found[a]);
    all
}

#[test]
fn joined_rows_close_with_the_radius_of_their_turns() {
    let spacing = std::f64::consts::TAU * 2.0 / 20.0 * (1.0 + 1e-6);
    let exact = 2.0 * (1.0 + 1e-6);
    // Once around, half and a quarter of it, twice around.
    for rows in [20, 10, 5, 40] {
        let found = ShellMembrane::closed_radius(2.0, spacing, Some(rows));
        assert!((found / exact - 1.0).abs() < 1e-14, "{rows}: {found}");
    }
    // No part of a circumference, a single row, an open shell: the radius as given.
    for rows in [Some(19), Some(30), Some(1), None] {
        assert_eq!(ShellMembrane::closed_radius(2.0, spacing, rows), 2.0);
    }
    let parts = |arc: f64| ShellMembrane::parts_of_circumference(2.0, std::f64::consts::TAU * arc);
    assert_eq!([parts(2.0), parts(0.5), parts(0.75), parts(4.0)], [Some(1.0), Some(4.0), None, None]);
}
