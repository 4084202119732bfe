//! The assembled matrix and its factor by themselves: good for some digits, and honest about negative weights.

use crate::support::chain::{Body, Calibration};
use crate::support::standard::{SECTIONS, Standard};
use crate::support::{error, refusal, run, scene};
use peristat::run::{RunOptions, prepare};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::timoshenko_beam::{VolumeFactor, bond_weights};
use peristat_assembly::stiffness::Override;
use peristat_assembly::system::System;
use peristat_solve::{BandCholesky, BandMatrix, FactorError, Preconditioner};
use serde_json::json;

fn band(system: &System<2>) -> BandMatrix {
    let (half_bandwidth, values) = system.assemble_band();
    BandMatrix { order: system.size(), half_bandwidth, values }
}

#[test]
fn the_plain_band_factor_keeps_some_digits_and_the_finish_the_rest() {
    let (standard, section) = (Standard::named("cantilever under a uniform load"), SECTIONS[1]);
    for (cells, bound) in [(100, 1e-9), (1000, 1e-7)] {
        let mut case = standard.case(&section, "exact", cells);
        case["solver"] = json!("band");
        let scene = scene(&case);
        let (system, _) = prepare::<2>(&scene, &RunOptions::default()).expect("a system");
        let mut load = vec![0.0; system.size()];
        scene.states[0].loads.add_to(&scene.beam, &mut load);
        system.constraints().restrict(&mut load);
        let mut factor = BandCholesky::factor(band(&system), 2).expect("positive definite");
        let mut u = vec![0.0; system.size()];
        factor.apply(&load, &mut u);
        let exact = standard.exact(&section);
        let expected: Vec<f64> = (0..=cells).map(|k| exact(k as f64 / cells as f64).0).collect();
        let plain = error(&u[..=cells], &expected);
        // A5, measured 5e-11 and 9e-9: the rounding of the entries of the matrix.
        assert!(plain <= bound, "{cells} cells: {plain:e}");
        let certificate = run(&case).states[0].record.certificate.clone();
        let told = certificate.first_correction;
        assert!(plain > 1e-12, "the finish would have nothing to do: {plain:e}");
        // The energy of the first correction tells how wrong the plain answer was: measured a tenth of it.
        assert!(told > 0.01 * plain && told < 10.0 * plain, "{told:e} for {plain:e}");
    }
}

/// Full-volume weights for m = 3 topped up until every cell is crossed by bonds of total weight one.
///
/// An interior cell is crossed by 1·α₁ + 2·α₂ + 3·α₃ = 4/3, so its own bond gets α₁ − 1/3 = −1/9.
fn negative_cover(points: usize) -> Body {
    let alpha = bond_weights(3.0, VolumeFactor::Full);
    let crossing = |cell: usize| -> f64 {
        (1..=3)
            .map(|n| {
                let first = cell.saturating_sub(n - 1);
                let last = cell.min(points - 1 - n);
                alpha[n - 1] * (last + 1 - first) as f64
            })
            .sum()
    };
    let usual = alpha[0] + 1.0 - 4.0 / 3.0;
    let mut bonds = Calibration {
        bending: 1.0,
        shear: 1000.0,
        spacing: 1.0 / (points - 1) as f64,
        law: "exact",
        weights: alpha.clone(),
    };
    bonds.weights[0] = usual;
    let cells = (0..points - 1).filter(|&c| c < 3 || c + 4 > points - 1);
    let overrides: Vec<Override> = cells
        .map(|lower| Override { class: 0, lower, factor: (alpha[0] + 1.0 - crossing(lower)) / usual })
        .collect();
    assert!((usual + 1.0 / 9.0).abs() < 1e-15);
    let clamp = |component| Equation {
        terms: vec![(Unknown { component, point: 0 }, 1.0)],
        value: 0.0,
        origin: "clamp".into(),
    };
    Body {
        points,
        bonds: bonds.bonds(points, &overrides),
        spacing: bonds.spacing,
        relations: vec![clamp(0), clamp(1)],
    }
}

#[test]
fn negative_weights_are_reported_as_pivots_that_are_not_positive() {
    let body = negative_cover(61);
    let system = System::new(&body, Vec::new(), Vec::new()).expect("no contradiction");
    assert_eq!(system.independent(), 120);
    match BandCholesky::factor(band(&system), 2) {
        // A28: 30 negative eigenvalues, counted in quadruple precision with the same matrix.
        Err(FactorError::NonPositivePivot { count, .. }) => assert_eq!(count, 30),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_case_with_negative_weights_is_refused_when_the_scene_is_built() {
    let mut case = Standard::named("cantilever under a tip force").case(&SECTIONS[1], "exact", 60);
    case["model"]["timoshenko_beam"]["volume_factor"] = json!("full");
    let message = refusal(&case);
    assert!(message.contains("need the weight -0.1111"), "{message}");
    // Two spacings are the limit: α₁ − 1/2 = 0 is no bond either.
    case["horizon_ratio"] = json!(2);
    assert!(refusal(&case).contains("must not be negative"));
    case["horizon_ratio"] = json!(1);
    run(&case);
}
