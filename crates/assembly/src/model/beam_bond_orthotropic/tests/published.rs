//! Bonds as published: their constants, their moduli, when they do not exist.

use super::*;
use crate::model::beam_bond_orthotropic::material::turned;

/// Constants in N, mm, with the spacing h and thickness t in mm, for fibre bonds of the lengths in spacings, m = 3.
fn constants(material: &OrthotropicMaterial, fibre_lengths: &[f64], h: f64, t: f64) -> [f64; 4] {
    let c = PublishedConstants::new(material, 3.0, fibre_lengths);
    let (axial, bending) = (1.0 / (MPA * h.powi(3) * t), 1.0 / (MPA * h * t));
    [c.matrix_axial * axial, c.fibre_axial * axial, c.matrix_bending * bending, c.fibre_bending * bending]
}

#[test]
fn constants_are_those_of_the_formulas() {
    // c_m, c_f, d_m, d_f at horizon ratio 3 by an independent NumPy implementation of the published formulas.
    let diagonal = [2.0_f64.sqrt(), 8.0_f64.sqrt()];
    let table: [(_, f64, f64, &[f64], [f64; 4]); 4] = [
        (A, 1.0, 1.0, &[1.0, 2.0, 3.0], [960.7374, 5203.481, 74.819_81, 448.6504]),
        (A, 1.0, 1.0, &diagonal, [960.7374, 7358.833, 74.819_81, 638.2799]),
        (B, 0.5, 0.6, &[1.0, 2.0, 3.0], [10_543.92, 216_439.7, 46.838_65, 7723.602]),
        (B, 0.5, 0.6, &diagonal, [10_543.92, 306_092.0, 46.838_65, 10_937.35]),
    ];
    for (material, h, t, lengths, expected) in table {
        for (found, value) in constants(&material, lengths, h, t).iter().zip(expected) {
            assert!((found / value - 1.0).abs() < 1e-6, "{found} {value}");
        }
    }
}

#[test]
fn moduli_of_lattices_are_off_by_what_was_measured() {
    // Ratios to the material's C11, C22, C12, C66 where points turn with the body, and of C66 where they are free: measured
    // with an independent NumPy implementation.
    let table = [
        (A, 0.0, 3.0, [1.0125, 1.0492, 1.0112, 1.0099, 0.9699]),
        (A, 45.0, 3.0, [1.0077, 1.0302, 1.0790, 1.0568, 1.0167]),
        (B, 0.0, 3.0, [1.0041, 1.0518, 1.0066, 1.0049, 0.7618]),
        (B, 0.0, 3.015, [1.0029, 1.0363, 0.9915, 0.9942, 0.7509]),
        (B, 90.0, 3.015, [1.0029, 1.0363, 0.9915, 0.9942, 0.7509]),
        (B, 45.0, 3.015, [1.0011, 1.0140, 1.0609, 1.0413, 0.7980]),
    ];
    for (material, degrees, m, expected) in table {
        let bonds = BeamNeighbourhood::new(&as_published(material, degrees, m)).unwrap();
        let (s, c) = f64::to_radians(degrees).sin_cos();
        let own = turned(&bonds.moments().stiffness, [c, -s]);
        let exact = material.stiffness();
        let pairs = [(0, 0), (1, 1), (0, 1), (2, 2)];
        let mut found: Vec<f64> = pairs.iter().map(|&(i, j)| own[i][j] / exact[i][j]).collect();
        found.push(bonds.effective_shear_modulus() / material.shear_modulus_12);
        for (ratio, value) in found.iter().zip(expected) {
            assert!((ratio - value).abs() < 1e-4, "{degrees} {m}: {found:?} {expected:?}");
        }
        assert!(!bonds.is_consistent());
        assert_eq!(bonds.start(), None);
    }
}

#[test]
fn the_loss_in_shear_is_that_of_the_continuum() {
    // C66 − F²/(16 (C66 − C12)) with F = 4 C66 − 2 C22 + 2 C12, MPa.
    for (material, expected) in [(A, 4126.60), (B, 3026.73)] {
        let [[_, c12, _], [_, c22, _], [_, _, c66]] = material.stiffness();
        let extra = 4.0 * c66 - 2.0 * c22 + 2.0 * c12;
        let loss = extra * extra / (16.0 * (c66 - c12));
        assert!(((c66 - loss) / (MPA * expected) - 1.0).abs() < 2e-6, "{}", (c66 - loss) / MPA);
        // A fine lattice comes close: 7.6e-5 and 1.9e-5 off here.
        let bonds = BeamNeighbourhood::new(&as_published(material, 0.0, 100.0)).unwrap();
        let found = bonds.moments().stiffness[2][2] - bonds.effective_shear_modulus();
        assert!((found / loss - 1.0).abs() < 2e-4, "{}", found / loss);
    }
}

#[test]
fn bonds_of_negative_stiffness_are_refused_with_a_way_out() {
    let error = |p: OrthotropicParameters| BeamNeighbourhood::new(&p).unwrap_err();
    let wide = OrthotropicMaterial { poisson_ratio_12: 0.36, ..A };
    let soft = OrthotropicMaterial { shear_modulus_12: 3500.0 * MPA, ..A };
    let (wide, soft) = (error(as_published(wide, 0.0, 3.0)), error(as_published(soft, 0.0, 3.0)));
    assert!(matches!(wide, OrthotropicError::NegativeMatrixShear { .. }));
    assert!(matches!(soft, OrthotropicError::NegativeFibreShear { .. }));
    for error in [&wide, &soft] {
        assert!(error.to_string().ends_with("`published`; take the calibration `matched`"), "{error}");
    }
    // The least shear modulus that is named is enough, and no less is.
    let OrthotropicError::NegativeFibreShear { least, .. } = soft else { unreachable!() };
    let with = |shear_modulus_12| as_published(OrthotropicMaterial { shear_modulus_12, ..A }, 0.0, 3.0);
    assert!(BeamNeighbourhood::new(&with(least * (1.0 + 1e-9))).is_ok());
    assert!(matches!(error(with(least * (1.0 - 1e-9))), OrthotropicError::NegativeFibreShear { .. }));
    // ν12 = 1/3 has none of the matrix; negative Poisson ratios are no trouble.
    for nu in [1.0 / 3.0, -0.3] {
        let material = OrthotropicMaterial { poisson_ratio_12: nu, shear_modulus_12: 7000.0 * MPA, ..A };
        let bonds = BeamNeighbourhood::new(&as_published(material, 0.0, 3.0)).unwrap();
        assert!(bonds.weights().iter().flatten().all(|w| *w >= 0.0));
    }
    assert!(matches!(error(as_published(A, 15.0, 3.0)), OrthotropicError::NoFibreBonds { .. }));
    let overlay = OrthotropicParameters { edges: Edges::Overlay, ..as_published(A, 0.0, 3.0) };
    assert_eq!(error(overlay), OrthotropicError::OverlayNeedsMatched);
    let start = OrthotropicParameters { start: Some(Start::Oblique), ..as_published(A, 0.0, 3.0) };
    assert_eq!(error(start), OrthotropicError::StartNeedsMatched);
}
