//! Why a chain is split at an interior support: a plain constraint on an unsplit one is wrong by the horizon.

use crate::support::standard::{SECTIONS, steel};
use crate::support::{error, run};
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::timoshenko_beam::{
    Along, BeamLoads, BeamParameters, Distributed, Intensity, Line, TimoshenkoBeam, VolumeFactor, W,
    bond_law, end_treatment,
};
use peristat_assembly::system::System;
use peristat_solve::{Ordering, Preconditioner, SparseCholesky};
use serde_json::json;

const CELLS: usize = 96;

/// Deflections of a beam of length 1 on three supports under a uniform load: simple supports at the ends, less the
/// reaction of the middle one.
fn exact(x: f64, b: f64, s: f64, q: f64) -> f64 {
    let y = x.min(1.0 - x);
    let uniform =
        |x: f64| q * x * (1.0 - 2.0 * x * x + x.powi(3)) / (24.0 * b) + q * x * (1.0 - x) / (2.0 * s);
    let unit = |y: f64| y * (3.0 - 4.0 * y * y) / (48.0 * b) + y / (2.0 * s);
    uniform(x) - uniform(0.5) / unit(0.5) * unit(y)
}

/// Deflections with the constraints on a chain with these splits.
fn deflections(splits: Vec<usize>) -> Vec<f64> {
    let (b, s) = SECTIONS[1].stiffness();
    let parameters = BeamParameters {
        volume_factor: VolumeFactor::HalfEdge,
        bond_law: bond_law::find("exact").expect("the law exists"),
        end_treatment: end_treatment::find("cover").expect("the treatment exists"),
    };
    let line = Line { splits, ..Line::new(1.0, CELLS, SectionStiffness::uniform(b, s, 1.0, 1.0)) };
    let beam = TimoshenkoBeam::new(parameters, vec![line]).expect("a beam");
    let held = [0, CELLS / 2, CELLS].map(|point| Equation {
        terms: vec![(Unknown { component: W, point }, 1.0)],
        value: 0.0,
        origin: "support".into(),
    });
    let system = System::<2>::new(&beam, Vec::new(), held.to_vec()).expect("no contradiction");
    let intensity = Intensity::Linear { start: SECTIONS[1].uniform, end: SECTIONS[1].uniform };
    let uniform = Distributed { chain: 0, from: 0.0, to: 1.0, intensity, along: Along::Transverse };
    let mut load = vec![0.0; 2 * beam.points()];
    BeamLoads { distributed: vec![uniform], ..Default::default() }.add_to(&beam, &mut load);
    let k = system.assemble_sparse();
    let mut factor = SparseCholesky::analyse(&k, Ordering::MinimumDegree).expect("a pattern");
    factor.refactor(&k).expect("positive definite");
    system.constraints().restrict(&mut load);
    let mut u = vec![0.0; load.len()];
    factor.apply(&load, &mut u);
    u.truncate(beam.points());
    u
}

#[test]
fn an_interior_support_without_a_split_is_wrong_by_the_horizon() {
    let (b, s) = SECTIONS[1].stiffness();
    let q = SECTIONS[1].uniform;
    let expected: Vec<f64> = (0..=CELLS).map(|k| exact(k as f64 / CELLS as f64, b, s, q)).collect();
    let unsplit = error(&deflections(Vec::new()), &expected);
    // A22, measured 7.7e-3.
    assert!((5e-3..1e-2).contains(&unsplit), "{unsplit:e}");
    // The same with the split, by a plain factor; measured 5e-13.
    let split = error(&deflections(vec![CELLS / 2]), &expected);
    assert!(split <= 5e-12, "{split:e}");

    let mut case = steel(0.05, "exact", CELLS);
    case["supports"] = json!([0.0, 0.5, 1.0].map(|x| json!({ "at": { "x": x }, "w": 0.0 })));
    case["loads"] = json!([{ "distributed": { "force": { "uniform": q } } }]);
    let split = run(&case).errors(|x| (exact(x, b, s, q), 1.0))[0];
    // A21, measured 1.6e-14.
    assert!(split <= 2e-13, "{split:e}");
}
