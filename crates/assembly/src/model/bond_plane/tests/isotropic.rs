//! Exact bonds whose higher moments have no direction.

use super::super::*;
use super::bodies::*;
use crate::model::bond_plane::neighbourhood::neighbourhood;
use nalgebra::Complex;

fn isotropic(m: f64, state: PlaneState) -> PlaneParameters {
    let mut parameters = PlaneParameters { weights: Weights::Isotropic, ..parameters(m, [1.0; 3]) };
    parameters.material.state = state;
    parameters
}

/// Displacements `2μ (u + i v) = κ φ − z conj(φ') − conj(ψ)` of the potentials `φ = a z^p`, `ψ = b z^p`, in equilibrium without body
/// forces.
fn kolosov(kappa: f64, p: i32, [a, b]: [Complex<f64>; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    let z = Complex::new(x, y);
    let slope = a * f64::from(p) * z.powi(p - 1);
    let u = a * kappa * z.powi(p) - z * slope.conj() - (b * z.powi(p)).conj();
    [u.re, u.im]
}

/// The force that all bonds of a point put on it, over the largest of one of them, under polynomials of degree p.
fn force(parameters: &PlaneParameters, p: i32) -> f64 {
    // (3 − ν)/(1 + ν) with ν = 1/3 in plane stress, 3 − 4 ν with 1/4 in plane strain.
    let kappa = 2.0;
    let neighbourhood = neighbourhood(parameters).unwrap();
    let (mut sum, mut largest) = ([0.0; 2], 0.0_f64);
    let potentials = [Complex::new(0.3, -0.7), Complex::new(0.4, 0.9)];
    for k in neighbourhood.bonded() {
        let [x, y, _] = neighbourhood.offsets[k].map(f64::from);
        let square = x * x + y * y;
        for sign in [1.0, -1.0] {
            let [u, v] = kolosov(kappa, p, potentials, [sign * x, sign * y]);
            let along = neighbourhood.weights[k][0] * (x * u + y * v) / (square * square);
            largest = largest.max((along * x).abs()).max((along * y).abs());
            sum = [sum[0] + along * x, sum[1] + along * y];
        }
    }
    sum[0].hypot(sum[1]) / largest
}

#[test]
fn polynomials_in_equilibrium_stay_in_it() {
    for state in [PlaneState::Stress, PlaneState::Strain] {
        for m in [2.0, 2.5, 3.0, 3.015, 4.0, 5.0, 6.0] {
            let parameters = isotropic(m, state);
            // 5e-15 measured at m = 6.
            assert!(force(&parameters, 4) < 2e-14, "{m}: {:e}", force(&parameters, 4));
            let nearest = PlaneParameters { weights: Weights::Nearest, ..parameters };
            assert!(force(&nearest, 4) > 1e-3, "{m}: {:e}", force(&nearest, 4));
            if m >= 3.0 {
                assert!(force(&parameters, 6) < 2e-14, "{m}: {:e}", force(&parameters, 6));
            }
        }
    }
}

#[test]
fn moduli_are_exact() {
    for m in [2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0] {
        for influence in [Influence::Constant, Influence::Inverse, Influence::Linear] {
            let parameters = PlaneParameters { influence, ..isotropic(m, PlaneState::Strain) };
            let (c, exact) = (super::lattice::moduli(&parameters), parameters.material.stiffness());
            let worst = (0..9).map(|e| (c[e / 3][e % 3] - exact[e / 3][e % 3]).abs() / exact[0][0]);
            let worst = worst.fold(0.0, f64::max);
            assert!(worst < 2e-15, "{m} {influence:?}: {worst:e}");
        }
    }
}

#[test]
fn weights_are_those_of_the_reference() {
    // An independent Python implementation: weights over E of (1,0), (1,1), (2,0), (2,1), (2,2), (3,0) in plane stress.
    let table: [(f64, &[f64]); 2] = [
        (2.0, &[0.5, 0.75, 0.25]),
        (3.0, &[0.081_305_667_5, 0.216_749_137_0, 0.35, 0.364_531_789_4, 0.066_650_172_6, 0.056_231_444_2]),
    ];
    let orbits = [[1, 0], [1, 1], [2, 0], [2, 1], [2, 2], [3, 0]];
    for (m, expected) in table {
        let neighbourhood = neighbourhood(&isotropic(m, PlaneState::Stress)).unwrap();
        for k in neighbourhood.bonded() {
            let [a, b, _] = neighbourhood.offsets[k].map(i32::abs);
            let orbit = orbits.iter().position(|orbit| *orbit == [a.max(b), a.min(b)]);
            // Sides of triangles, too, which are no bonds.
            let expected = orbit.and_then(|orbit| expected.get(orbit)).copied().unwrap_or(0.0);
            assert!((neighbourhood.weights[k][0] - expected).abs() < 1e-9, "{m} {a} {b}");
        }
    }
}

#[test]
fn a_horizon_with_too_few_bonds_is_refused() {
    for m in [1.5, 1.9] {
        let refused = BondPlane::offsets(&isotropic(m, PlaneState::Stress)).unwrap_err();
        assert!(matches!(refused, BondPlaneError::NotRepresentable { .. }), "{m}");
    }
}
