//! Weights, constants and critical stretches of lattices of central bonds.

use super::super::solid::tests::BONDS;
use super::super::solid::toughness::{critical_stretch, published_critical_stretch};
use super::super::solid::{TENSOR, direction_product};
use super::*;

/// Stiffness of a lattice per Young's modulus: C11, C12, C44.
fn moduli(parameters: BondSolidParameters) -> [f64; 3] {
    let neighbourhood = parameters.law().unwrap().neighbourhood;
    let mut c = [[0.0; TENSOR]; TENSOR];
    for ([a], &step) in neighbourhood.weights.iter().zip(&neighbourhood.offsets) {
        let n = direction_product(step);
        (0..TENSOR).for_each(|r| (0..TENSOR).for_each(|q| c[r][q] += a * n[r] * n[q]));
    }
    for (r, q) in [(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5)] {
        let same = if r < 3 { c[0][0] } else { c[3][3] };
        assert!((c[r][q] - same).abs() < 1e-14);
    }
    [c[0][0], c[0][1], c[3][3]]
}

#[test]
fn matched_lattices_have_the_moduli_of_the_material() {
    for horizon_ratio in [1.5, 1.75, 2.0, 2.5, 3.0, 3.015, 4.0, 5.0] {
        for influence in [Influence::Constant, Influence::Inverse, Influence::Linear] {
            let found = moduli(BondSolidParameters { horizon_ratio, influence, ..BONDS });
            for (found, expected) in found.iter().zip([1.2, 0.4, 0.4]) {
                // 8e-16 measured.
                assert!((found - expected).abs() < 1e-14, "{horizon_ratio} {influence:?} {found}");
            }
        }
    }
    // Six neighbours resist no shear.
    let refused = BondSolidParameters { horizon_ratio: 1.2, ..BONDS }.law();
    assert!(matches!(refused, Err(SolidError::NotRepresentable { .. })));
}

/// An offset and its weight.
type Known = ([i32; 3], f64);

/// Weights per Young's modulus that an independent Python implementation finds.
#[test]
fn matched_weights_are_those_of_the_reference() {
    let table: [(Influence, f64, &[Known]); 4] = [
        (
            Influence::Constant,
            2.0,
            &[
                ([1, 0, 0], 0.2216554020),
                ([1, 1, 0], 0.3665092500),
                ([1, 1, 1], 0.4876770937),
                ([2, 0, 0], 0.3950899730),
            ],
        ),
        (
            Influence::Constant,
            3.0,
            &[
                ([1, 0, 0], 0.0493691091),
                ([1, 1, 1], 0.0618991631),
                ([2, 1, 0], 0.1042699997),
                ([2, 2, 1], 0.1042538133),
                ([3, 0, 0], 0.1918865762),
            ],
        ),
        (Influence::Inverse, 3.0, &[([1, 0, 0], 0.1187924571), ([2, 2, 1], 0.0899620180)]),
        (
            Influence::Linear,
            3.0,
            &[([1, 1, 1], 0.1937868312), ([2, 2, 0], 0.0397372509), ([2, 2, 1], 0.0003074265)],
        ),
    ];
    for (influence, horizon_ratio, weights) in table {
        let neighbourhood =
            BondSolidParameters { horizon_ratio, influence, ..BONDS }.law().unwrap().neighbourhood;
        for (offset, expected) in weights {
            let same = |step: &[i32; 3]| {
                let mut kind = step.map(i32::abs);
                kind.sort_unstable_by(|a, b| b.cmp(a));
                kind == *offset
            };
            let of = neighbourhood.offsets.iter().zip(&neighbourhood.weights).filter(|(step, _)| same(step));
            let found: Vec<f64> = of.map(|(_, [a])| *a).collect();
            assert!(found.iter().all(|a| (a - expected).abs() < 1e-9), "{influence:?} {offset:?} {found:?}");
        }
    }
}

/// Moduli over those of the material, to four digits.
#[test]
fn published_constants_have_the_moduli_that_are_known() {
    let table = [
        (VolumeFactor::Full, 3.0, [1.0564, 1.2175]),
        (VolumeFactor::Full, 4.0, [0.9343, 0.9566]),
        (VolumeFactor::Clip, 3.0, [0.8649, 0.9532]),
        (VolumeFactor::Ramp, 2.0, [1.1654, 1.0741]),
        (VolumeFactor::Ramp, 3.0, [1.0703, 1.0500]),
        (VolumeFactor::Area, 2.0, [1.0589, 1.0054]),
        (VolumeFactor::Area, 3.0, [1.0224, 1.0109]),
    ];
    for (volume_factor, horizon_ratio, [c11, c12]) in table {
        let parameters = BondSolidParameters {
            horizon_ratio,
            volume_factor,
            calibration: Calibration::Published,
            edges: SolidEdges::None,
            ..BONDS
        };
        let [found11, found12, found44] = moduli(parameters);
        assert!((found11 / 1.2 - c11).abs() < 6e-5, "{volume_factor:?} {horizon_ratio} {}", found11 / 1.2);
        assert!((found12 / 0.4 - c12).abs() < 6e-5, "{volume_factor:?} {horizon_ratio} {}", found12 / 0.4);
        assert!((found12 - found44).abs() < 1e-14);
        let refused = BondSolidParameters { edges: SolidEdges::Overlay, ..parameters }.law();
        assert_eq!(refused.unwrap_err(), SolidError::EdgesNeedMatched);
    }
}

/// `G/(E s² h)` of a plane across an axis, counted bond by bond by a Python implementation.
#[test]
fn critical_stretches_release_the_energy_that_is_counted() {
    for (influence, rates) in [
        (Influence::Constant, [2.214290, 3.560050, 4.627668]),
        (Influence::Inverse, [2.145902, 3.370593, 4.355995]),
        (Influence::Linear, [1.933469, 2.858826, 3.925461]),
    ] {
        for (rate, horizon_ratio) in rates.into_iter().zip([2.0, 3.0, 4.0]) {
            let parameters = BondSolidParameters { horizon_ratio, influence, ..BONDS };
            let s = critical_stretch(rate * 0.5, &parameters, 0.5, [0.0, 0.0, 1.0]).unwrap();
            assert!((s - 1.0).abs() < 1e-6, "{influence:?} {horizon_ratio} {s}");
            // The continuum is within 8 %: 3.6e-2 of G in the mean.
            let published = published_critical_stretch(rate * 0.5, 2.0 / 3.0, influence, horizon_ratio * 0.5);
            assert!((published - 1.0).abs() < 0.05, "{influence:?} {horizon_ratio} {published}");
        }
    }
    // √(5·12/(9·3·0.7)).
    let known = published_critical_stretch(12.0, 3.0, Influence::Constant, 0.7);
    assert!((known / 1.781_741_612_749_496 - 1.0).abs() < 1e-12);
}

/// A displacement of the fourth degree in equilibrium without body forces, of Papkovich and Neuber:
/// `4 (1 − ν) B − ∇(x·B + C)` with `B = (h, 0, 0)`, and harmonic h and C.
fn in_equilibrium([x, y, z]: [f64; 3]) -> [f64; 3] {
    let h = x.powi(4) - 6.0 * x * x * z * z + z.powi(4);
    let of_h = [4.0 * x.powi(3) - 12.0 * x * z * z, 0.0, 4.0 * z.powi(3) - 12.0 * x * x * z];
    // ∇(x (y⁴ − 6 y² z² + z⁴))
    let of_c = [
        y.powi(4) - 6.0 * y * y * z * z + z.powi(4),
        x * (4.0 * y.powi(3) - 12.0 * y * z * z),
        x * (4.0 * z.powi(3) - 12.0 * y * y * z),
    ];
    let of_b = [h + x * of_h[0], x * of_h[1], x * of_h[2]];
    [3.0 * h - of_b[0] - of_c[0], -of_b[1] - of_c[1], -of_b[2] - of_c[2]]
}

/// The force that all bonds of a point put on it under that displacement, over the largest of one of them.
fn force(parameters: BondSolidParameters) -> f64 {
    let neighbourhood = parameters.law().unwrap().neighbourhood;
    let (mut sum, mut largest) = ([0.0; 3], 0.0_f64);
    for ([a], step) in neighbourhood.weights.iter().zip(&neighbourhood.offsets) {
        let square = step.map(|x| f64::from(x * x)).iter().sum::<f64>();
        for sign in [1.0, -1.0] {
            let at = step.map(|x| sign * f64::from(x));
            let along = in_equilibrium(at).iter().zip(at).map(|(u, x)| u * x).sum::<f64>();
            let force = at.map(|x| a * along * x / (square * square));
            largest = force.iter().fold(largest, |most, f| most.max(f.abs()));
            sum = [0, 1, 2].map(|k| sum[k] + force[k]);
        }
    }
    sum.iter().fold(0.0_f64, |most, f| most.max(f.abs())) / largest
}

#[test]
fn isotropic_bonds_keep_polynomials_in_equilibrium() {
    for horizon_ratio in [2.0, 2.5, 3.0, 4.0, 5.0] {
        let parameters = BondSolidParameters { horizon_ratio, weights: Weights::Isotropic, ..BONDS };
        // 3e-14 measured at m = 5.
        assert!(force(parameters) < 1e-13, "{horizon_ratio}: {:e}", force(parameters));
        let nearest = BondSolidParameters { weights: Weights::Nearest, ..parameters };
        assert!(force(nearest) > 1e-3, "{horizon_ratio}: {:e}", force(nearest));
        for (found, expected) in moduli(parameters).iter().zip([1.2, 0.4, 0.4]) {
            assert!((found - expected).abs() < 1e-14, "{horizon_ratio} {found}");
        }
    }
}

#[test]
fn isotropic_weights_are_those_of_the_reference() {
    // The only ones with two spacings: an independent Python implementation.
    let parameters = BondSolidParameters { horizon_ratio: 2.0, weights: Weights::Isotropic, ..BONDS };
    let neighbourhood = parameters.law().unwrap().neighbourhood;
    for (step, [a]) in neighbourhood.offsets.iter().zip(&neighbourhood.weights) {
        let expected = match step.iter().map(|x| x * x).sum::<i32>() {
            1 => 4.0 / 15.0,
            2 => 8.0 / 15.0,
            3 => 0.3,
            4 => 4.0 / 15.0,
            _ => 0.0,
        };
        assert!((a - expected).abs() < 1e-12, "{step:?} {a}");
    }
}
