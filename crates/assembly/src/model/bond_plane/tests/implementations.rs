//! Numbers of independent Python implementations.

use super::super::*;
use super::bodies::*;
use crate::model::Points;
use crate::model::bond_plane::neighbourhood::neighbourhood;
use crate::model::plane::{Calibration, Edges};

/// The rectangle of 18 × 13 cells with a hole, in some treatment, under the displacement `random`.
fn energy_of(calibration: Calibration, volume_factor: VolumeFactor, edges: Edges) -> (f64, BondPlane) {
    let (_, lattice) = &bodies(1.0)[0];
    let parameters = PlaneParameters { calibration, volume_factor, edges, ..parameters(3.0, MM_MPA) };
    let plane = plane(lattice, parameters);
    (energy(&plane, &random(2 * plane.points())), plane)
}

#[test]
fn published_bodies_have_the_energies_of_an_independent_implementation() {
    // `Body(X, 1, 3, 25, beta)`, `surface(kind, c, 73100, "stress")`, then ½ Σ c ω/ξ e². That implementation takes the full
    // volume of a family with ramp factors whatever the others are, so `volume` compares with `ramp` alone.
    let table = [
        (VolumeFactor::Full, Edges::None, 20_628_760.733_085_558),
        (VolumeFactor::Full, Edges::Energy, 26_537_647.039_350_85),
        (VolumeFactor::Clip, Edges::None, 19_166_245.199_777_58),
        (VolumeFactor::Clip, Edges::Energy, 29_474_504.799_941_603),
        (VolumeFactor::Ramp, Edges::None, 20_208_789.868_004_29),
        (VolumeFactor::Ramp, Edges::Volume, 26_448_081.528_839_64),
        (VolumeFactor::Ramp, Edges::Energy, 26_845_052.631_727_174),
    ];
    for (factor, edges, expected) in table {
        let (found, plane) = energy_of(Calibration::Published, factor, edges);
        assert!((found / expected - 1.0).abs() < 1e-12, "{factor:?} {edges:?}: {found}");
        let bonds: usize = crate::model::Model::terms(&plane).iter().map(|t| t.elements()).sum();
        assert_eq!(bonds, if factor == VolumeFactor::Ramp { 2778 } else { 2242 });
    }
}

#[test]
fn the_overlay_has_the_energy_of_an_independent_implementation() {
    // Deficits and quadrants as in overlay.py, summed over the same body with the weights below.
    let (found, plane) = energy_of(Calibration::Matched, VolumeFactor::Full, Edges::Overlay);
    assert!((found / 43_572_085.342_460_43 - 1.0).abs() < 1e-12, "{found}");
    assert_eq!(plane.triangles(), 632);
}

#[test]
fn matched_weights_are_those_of_an_independent_implementation() {
    // `project` of orthotropic/pdortho.py without transverse stiffness, E = 1, plane stress.
    type Expected<'a> = &'a [(Cell, f64)];
    let table: [(f64, Influence, Expected); 4] = [
        (
            2.0,
            Influence::Constant,
            &[([1, 0, 0], 0.285_924_551_796_591_7), ([2, 0, 0], 0.464_075_448_203_408), ([1, 1, 0], 0.75)],
        ),
        (
            3.0,
            Influence::Constant,
            &[
                ([1, 0, 0], 0.099_930_484_180_407_23),
                ([2, 0, 0], 0.195_845_243_723_588_94),
                ([3, 0, 0], 0.287_744_278_629_544_5),
                ([1, 1, 0], 0.148_472_150_292_068_62),
                ([2, 1, 0], 0.231_222_213_147_860_04),
                ([2, 2, 0], 0.305_563_416_878_670_56),
            ],
        ),
        (
            3.0,
            Influence::Inverse,
            &[
                ([1, 0, 0], 0.197_058_823_529_411_54),
                ([3, 0, 0], 0.197_058_823_529_411_65),
                ([2, 1, 0], 0.220_588_235_294_117_53),
                ([2, 2, 0], 0.233_823_529_411_764_6),
            ],
        ),
        // Bonds as long as the horizon have no stiffness to begin with, and get none here: a bound acts.
        (
            3.0,
            Influence::Linear,
            &[
                ([1, 0, 0], 0.282_858_054_790),
                ([2, 0, 0], 0.282_858_054_791),
                ([3, 0, 0], 0.0),
                ([2, 1, 0], 0.255_949_847_801),
                ([1, 1, 0], 0.349_776_999_086),
                ([2, 2, 0], 0.072_607_195_729),
            ],
        ),
    ];
    for (m, influence, expected) in table {
        let units = [1.0, 1.0, 1.0];
        let neighbourhood = neighbourhood(&PlaneParameters { influence, ..parameters(m, units) }).unwrap();
        for &(step, weight) in expected {
            let found = neighbourhood
                .offsets
                .iter()
                .position(|o| *o == step)
                .map_or(0.0, |k| neighbourhood.weights[k][0]);
            assert!((found - weight).abs() < 5e-12, "{m} {influence:?} {step:?}: {found}");
        }
    }
}
