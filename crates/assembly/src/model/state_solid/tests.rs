//! Weights and moduli of state-based families.

use super::super::bond_solid::BondSolidParameters;
use super::super::solid::tests::{BONDS, STATE};
use super::super::solid::{TENSOR, direction_product};
use super::*;

/// Stiffness of a lattice over that of the material: C11 − C12, C44, and C11 + 2 C12.
fn ratios(parameters: StateSolidParameters) -> [f64; 3] {
    let law = parameters.law().unwrap();
    let mut c = [[0.0; TENSOR]; TENSOR];
    let mut d = [0.0; TENSOR];
    for (k, &step) in law.neighbourhood.offsets.iter().enumerate() {
        let n = direction_product(step);
        let [a] = law.neighbourhood.weights[k];
        (0..TENSOR).for_each(|r| (0..TENSOR).for_each(|q| c[r][q] += a * n[r] * n[q]));
        let share = law.dilatation.as_ref().map_or(0.0, |of| of.shares[k]);
        (0..TENSOR).for_each(|q| d[q] += 2.0 * share * squared(step) * n[q]);
    }
    let modulus = law.dilatation.as_ref().map_or(0.0, |of| of.modulus);
    (0..TENSOR).for_each(|r| (0..TENSOR).for_each(|q| c[r][q] += modulus * d[r] * d[q]));
    let (shear, bulk) = (law.material.shear_modulus(), law.material.bulk_modulus());
    [(c[0][0] - c[0][1]) / (2.0 * shear), c[3][3] / shear, (c[0][0] + 2.0 * c[0][1]) / (3.0 * bulk)]
}

#[test]
fn matched_families_have_the_moduli_of_the_material() {
    for horizon_ratio in [1.5, 2.0, 2.5, 3.0, 3.015, 4.0] {
        for influence in [Influence::Constant, Influence::Inverse, Influence::Linear] {
            for poisson_ratio in [-0.9, 0.0, 0.25, 0.3, 0.499] {
                let found = ratios(StateSolidParameters { horizon_ratio, influence, poisson_ratio, ..STATE });
                // 2e-13 measured, of the bulk modulus at −0.9.
                assert!(
                    found.iter().all(|r| (r - 1.0).abs() < 1e-12),
                    "{horizon_ratio} {influence:?} {found:?}"
                );
            }
        }
    }
}

/// q, c₀ and c₁ that an independent Python implementation finds.
#[test]
fn matched_weights_have_two_constants() {
    for (influence, horizon_ratio, q, c0, c1) in [
        (Influence::Constant, 2.0, 78.0, 1.0198449612, -0.4837209302),
        (Influence::Constant, 3.0, 708.0, 1.0545783148, 1.2385079136),
        (Influence::Inverse, 3.0, 855.6644399783, 1.0322680642, 0.9354715293),
        (Influence::Linear, 4.0, 432.3727177202, 1.0003312422, 0.1040262014),
    ] {
        let parameters = StateSolidParameters { horizon_ratio, influence, ..STATE };
        let offsets = half_offsets(horizon_ratio, i32::MAX);
        let parts: Vec<f64> = offsets.iter().map(|&step| parameters.part_of(step)).collect();
        let found = parameters.weights(&offsets, &parts).unwrap();
        assert!((found.q / q - 1.0).abs() < 1e-12);
        for (step, w) in offsets.iter().zip(&found.of).filter(|(step, _)| is_within(**step, horizon_ratio)) {
            let plain = influence.at(length(*step) / horizon_ratio);
            assert!((w - plain * (c0 + c1 * cubic(*step))).abs() < 1e-8 * plain.max(1e-3), "{step:?}");
        }
    }
}

/// Shear moduli of the published weights over those of the material, to three digits; the bulk modulus is exact.
#[test]
fn published_families_have_the_moduli_that_are_known() {
    for (influence, volume_factor, horizon_ratio, [first, second]) in [
        (Influence::Constant, VolumeFactor::Full, 2.0, [1.154, 0.897]),
        (Influence::Constant, VolumeFactor::Full, 3.0, [0.835, 1.110]),
        (Influence::Inverse, VolumeFactor::Full, 3.0, [0.871, 1.086]),
        (Influence::Constant, VolumeFactor::Ramp, 3.0, [1.017, 0.989]),
        (Influence::Constant, VolumeFactor::Area, 2.0, [1.029, 0.981]),
    ] {
        let parameters = StateSolidParameters {
            influence,
            volume_factor,
            horizon_ratio,
            calibration: Calibration::Published,
            edges: SolidEdges::None,
            ..STATE
        };
        let found = ratios(parameters);
        assert!((found[0] - first).abs() < 6e-4, "{influence:?} {volume_factor:?} {horizon_ratio} {found:?}");
        assert!(
            (found[1] - second).abs() < 6e-4,
            "{influence:?} {volume_factor:?} {horizon_ratio} {found:?}"
        );
        assert!((found[2] - 1.0).abs() < 1e-13, "{found:?}");
    }
}

#[test]
fn at_one_quarter_families_are_bonds() {
    let law = StateSolidParameters { poisson_ratio: 0.25, horizon_ratio: 3.0, ..STATE }.law().unwrap();
    assert!(law.dilatation.is_none());
    // Inverse influence has the bond weights nearest to its own: they differ, the moduli do not.
    let bonds =
        BondSolidParameters { horizon_ratio: 3.0, influence: Influence::Inverse, ..BONDS }.law().unwrap();
    assert_eq!(law.neighbourhood.offsets, bonds.neighbourhood.offsets);
    let sum = |law: &SolidLaw| law.neighbourhood.weights.iter().map(|[a]| a).sum::<f64>();
    assert!((sum(&law) / sum(&bonds) - 1.0).abs() < 1e-14);
}

#[test]
fn ratios_of_no_material_are_refused() {
    for poisson_ratio in [-1.0, 0.5, f64::NAN] {
        let refused = StateSolidParameters { poisson_ratio, ..STATE }.law();
        assert!(matches!(refused, Err(SolidError::PoissonRatio { .. })));
    }
    let refused = StateSolidParameters { horizon_ratio: 1.2, ..STATE }.law();
    assert!(matches!(refused, Err(SolidError::NotRepresentable { .. })));
}
