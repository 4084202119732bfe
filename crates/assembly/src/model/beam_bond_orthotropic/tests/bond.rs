//! The bond is a beam with shear.

use super::*;
use crate::body::SquareLattice;
use crate::bonds::{BondGeometry, BondModel, block};
use crate::model::BodyModel;
use crate::model::plane::{Mirrors, Solvable};
use std::sync::Arc;

/// Beam of length ξ along the angle φ with the stiffness densities c and d and the shear flexibility β, unknowns
/// `u, v, θ` of both ends: the textbook matrix in the axes of the bond, turned.
fn beam(c: f64, d: f64, beta: f64, xi: f64, phi: f64) -> [[f64; 6]; 6] {
    let mut own = [[0.0; 6]; 6];
    for (i, j, sign) in [(0, 0, 1.0), (0, 3, -1.0), (3, 0, -1.0), (3, 3, 1.0)] {
        own[i][j] = sign * c / xi;
    }
    let bending = [
        [12.0, 6.0 * xi, -12.0, 6.0 * xi],
        [6.0 * xi, (4.0 + beta) * xi * xi, -6.0 * xi, (2.0 - beta) * xi * xi],
        [-12.0, -6.0 * xi, 12.0, -6.0 * xi],
        [6.0 * xi, (2.0 - beta) * xi * xi, -6.0 * xi, (4.0 + beta) * xi * xi],
    ];
    let places = [1, 2, 4, 5];
    for (r, row) in bending.iter().enumerate() {
        (0..4).for_each(|k| own[places[r]][places[k]] = d / ((1.0 + beta) * xi.powi(3)) * row[k]);
    }
    let (s, c) = phi.sin_cos();
    let turn = |i: usize, j: usize| match (i % 3, j % 3) {
        _ if i / 3 != j / 3 => 0.0,
        (0, 0) | (1, 1) => c,
        (0, 1) => s,
        (1, 0) => -s,
        (2, 2) => 1.0,
        _ => 0.0,
    };
    std::array::from_fn(|r| {
        std::array::from_fn(|q| (0..36).map(|k| turn(k / 6, r) * own[k / 6][k % 6] * turn(k % 6, q)).sum())
    })
}

/// The bond with the weights of that beam; unknowns `u, v, hθ`.
fn bond(c: f64, d: f64, beta: f64, xi: f64, phi: f64, model: BeamBond) -> [[f64; 6]; 6] {
    let v = model.volume;
    let weights = [c * xi * v, 12.0 * d * v / ((1.0 + beta) * xi), d * v / xi];
    let geometry = BondGeometry { xi: [xi * phi.cos(), xi * phi.sin(), 0.0] };
    let rows = model.rows(&geometry);
    let moduli = model.moduli(&geometry);
    let modulus: [f64; 3] = std::array::from_fn(|k| weights[k] * moduli[k] / (v * v));
    let ends = [rows.first(), rows.second()];
    std::array::from_fn(|r| {
        std::array::from_fn(|q| block(&ends[r / 3], &modulus, &ends[q / 3])[r % 3][q % 3])
    })
}

#[test]
fn three_squares_are_the_beam() {
    // (c, d, β, ξ, φ, h)
    for case in [
        [3.1, 0.7, 0.4, 1.3, 0.3, 1.0],
        [0.2, 5.0, 8.0, 0.01, 2.2, 0.004],
        [7.0, 1.1, 0.02, 40.0, -1.1, 20.0],
    ] {
        let [c, d, beta, xi, phi, h] = case;
        let found = bond(c, d, beta, xi, phi, BeamBond { volume: 0.37, turning: h });
        let expected = beam(c, d, beta, xi, phi);
        let scale = |i: usize| if i % 3 == 2 { 1.0 / h } else { 1.0 };
        for (r, q) in (0..36).map(|k| (k / 6, k % 6)) {
            let (value, unit) = (expected[r][q] * scale(r) * scale(q), scale(r) * scale(q));
            let largest = (expected[r][r] * expected[q][q]).sqrt() * unit;
            assert!((found[r][q] - value).abs() <= 1e-13 * largest, "{case:?} {r} {q}");
        }
    }
}

#[test]
fn only_rigid_motions_are_free() {
    let (xi, phi, h) = (1.7, 0.8, 0.6);
    let k = bond(2.0, 0.5, 1.5, xi, phi, BeamBond { volume: 0.2, turning: h });
    let (x, y) = (xi * f64::cos(phi), xi * f64::sin(phi));
    let motions = [[1.0, 0.0, 0.0, 1.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0, 1.0, 0.0], [0.0, 0.0, h, -y, x, h]];
    for motion in motions {
        for row in k {
            let force: f64 = row.iter().zip(motion).map(|(k, u)| k * u).sum();
            assert!(force.abs() < 1e-14, "{force}");
        }
    }
    let matrix = nalgebra::DMatrix::from_fn(6, 6, |r, c| k[r][c]);
    let values = matrix.symmetric_eigenvalues();
    assert_eq!(values.iter().filter(|v| **v > 1e-6).count(), 3, "{values}");
}

#[test]
fn a_coarser_body_is_the_body_of_coarser_cells() {
    for parameters in [parameters(A, 0.0, 3.0), as_published(B, 0.0, 3.0)] {
        let parameters = OrthotropicParameters { edges: Edges::None, ..parameters };
        let of = |h: f64, size: [i32; 2]| {
            let lattice = Arc::new(SquareLattice::rectangle(h, [1.0, 2.0], size));
            BeamBondOrthotropic::on_lattice(lattice, Mirrors::NONE, parameters, &[]).unwrap()
        };
        let coarse = of(0.5, [12, 8]).coarser(&|_, _| Vec::new()).unwrap();
        let u: Vec<f64> = (0..3 * 24).map(|k| f64::from(k * 7919 % 1013) / 1013.0 - 0.5).collect();
        // The third unknown stays a rotation times the spacing of the finest body.
        let expected: Vec<f64> = (0..72).map(|k| if k < 48 { u[k] } else { 2.0 * u[k] }).collect();
        let [found, expected] = [(&*coarse, u), (&of(1.0, [6, 4]) as &dyn Solvable<3>, expected)]
            .map(|(body, u)| body.terms().iter().map(|term| term.survey(&u).energy).sum::<f64>());
        assert!((found / expected - 1.0).abs() < 1e-14, "{found} {expected}");
    }
}

#[test]
fn bonds_that_never_joined_are_no_damage() {
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [12, 8]));
    let parameters = as_published(A, 0.0, 3.0);
    let offsets = BeamNeighbourhood::new(&parameters).unwrap().offsets().to_vec();
    let all = (0..lattice.points()).flat_map(|point| (0..offsets.len()).map(move |k| (k, point)));
    let is_cut = |&(k, point): &(usize, usize)| {
        let [_, row, _] = lattice.cell(point);
        (row < 4) != (row + offsets[k][1] < 4)
    };
    let cuts: Vec<(usize, usize)> = all.filter(is_cut).collect();
    let mut plate =
        BeamBondOrthotropic::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &cuts).unwrap();
    assert!(plate.damage().iter().any(|&d| d > 0.2));
    plate.never_joined(&cuts);
    assert!(plate.damage().iter().all(|&d| d == 0.0));
}
