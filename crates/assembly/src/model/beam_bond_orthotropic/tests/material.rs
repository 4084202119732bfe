//! Stiffness, and which materials are refused.

use super::*;

#[test]
fn turned_stiffness_and_compliance_are_inverse() {
    for degrees in [0.0, 15.0, 45.0, 90.0, -70.0] {
        let angle = f64::to_radians(degrees);
        let (c, s) = (B.stiffness_at(angle), B.compliance_at(angle));
        for (i, j) in (0..9).map(|k| (k / 3, k % 3)) {
            let product: f64 = (0..3).map(|k| c[i][k] * s[k][j]).sum();
            assert!((product - f64::from(i == j)).abs() < 1e-13, "{degrees} {i} {j}: {product}");
        }
    }
}

#[test]
fn modulus_of_a_turned_bar_is_that_of_textbooks() {
    // 1/E = c⁴/E1 + s⁴/E2 + (1/G12 − 2 ν12/E1) s² c² (R. M. Jones, Mechanics of composite materials).
    let (s, c) = 0.4_f64.sin_cos();
    let (e1, e2) = (A.youngs_modulus_1, A.youngs_modulus_2);
    let mixed = 1.0 / A.shear_modulus_12 - 2.0 * A.poisson_ratio_12 / e1;
    let expected = c.powi(4) / e1 + s.powi(4) / e2 + mixed * s * s * c * c;
    assert!((A.compliance_at(0.4)[0][0] / expected - 1.0).abs() < 1e-14);
    // A stretch along fibres that point up is along y.
    assert!((A.stiffness_at(90f64.to_radians())[1][1] / A.stiffness()[0][0] - 1.0).abs() < 1e-14);
    // Fibres that rise to the right are sheared by a stretch along x as if they straightened: C16 > 0.
    assert!(A.stiffness_at(0.4)[0][2] > 0.0);
}

#[test]
fn impossible_materials_are_refused_with_what_to_do() {
    let text = |material: OrthotropicMaterial| material.check().unwrap_err().to_string();
    let refusals = [
        (text(OrthotropicMaterial { youngs_modulus_2: -1.0, ..A }), "must be a positive number"),
        (text(OrthotropicMaterial { thickness: f64::NAN, ..A }), "must be a positive number"),
        (text(OrthotropicMaterial { poisson_ratio_12: f64::INFINITY, ..A }), "must be a finite number"),
        (text(OrthotropicMaterial { poisson_ratio_12: 2.0, ..A }), "root of E1/E2, 1.985525"),
        (text(OrthotropicMaterial { poisson_ratio_12: 0.4, shear_modulus_12: 4100.0 * MPA, ..A }), "4.335"),
        (text(OrthotropicMaterial { shear_modulus_12: 2900.0 * MPA, ..A }), "2.97"),
        (text(OrthotropicMaterial::isotropic(1e9, 1.0 / 3.0, 0.1)), "a Poisson ratio below 1/3"),
        (text(OrthotropicMaterial::isotropic(1e9, -1.0, 0.1)), "shear modulus is inf"),
    ];
    for (message, part) in refusals {
        assert!(message.contains(part) && message.contains("; "), "{message} / {part}");
    }
    let exchanged = OrthotropicMaterial { youngs_modulus_1: 10e9, youngs_modulus_2: 40e9, ..A };
    let message = text(exchanged);
    assert!(message.contains("exchange the moduli") && message.contains("1.12"), "{message}");
    assert!([A, B].iter().all(|material| material.check().is_ok()));
}
