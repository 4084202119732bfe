//! Times of a plate of a million points: making it, its forces, its fields, its loads, its coarser levels.
#![allow(clippy::print_stdout)]

use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::bond_plane::{
    BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
};
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors, PlaneModel, Solvable};
use peristat_assembly::model::{Model, Points};
use std::hint::black_box;
use std::sync::Arc;
use std::time::Instant;

fn timed<T>(what: &str, f: impl FnOnce() -> T) -> T {
    let begin = Instant::now();
    let value = f();
    println!("{what:40} {:8.1} ms", begin.elapsed().as_secs_f64() * 1e3);
    value
}

fn main() {
    let side = 1000;
    let material = PlaneMaterial { youngs_modulus: 70e9, thickness: 0.01, state: PlaneState::Stress };
    for (edges, calibration) in [
        (Edges::Overlay, Calibration::Matched),
        (Edges::None, Calibration::Matched),
        (Edges::Energy, Calibration::Published),
    ] {
        println!("{edges:?}, {calibration:?}");
        let parameters = PlaneParameters {
            material,
            horizon_ratio: 3.0,
            influence: Influence::Constant,
            calibration,
            weights: Weights::Nearest,
            volume_factor: VolumeFactor::Ramp,
            edges,
        };
        let lattice = Arc::new(SquareLattice::rectangle(1e-3, [0.0; 2], [side, side]));
        let make = || BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]);
        let plane = timed("make", make).expect("the horizon is large enough");
        let n = plane.points();
        let u: Vec<f64> = (0..2 * n).map(|i| ((i * 31 % 101) as f64) / 101.0).collect();
        let mut f = vec![0.0; 2 * n];
        for term in plane.terms() {
            timed("force of a term, first", || term.add_force(black_box(&u), &mut f));
            timed("force of a term", || term.add_force(black_box(&u), &mut f));
            timed("survey", || term.survey(black_box(&u)));
            let mut blocks = vec![[[0.0; 2]; 2]; n];
            timed("diagonal blocks", || term.add_diagonal(&mut blocks));
        }
        let fields = timed("fields", || plane.fields(&u));
        timed("strain", || plane.strain(&fields.stress));
        timed("load of a stress everywhere", || plane.add_stress_load(None, &|_, _| [1.0, 0.0, 0.0], &mut f));
        let edge: Vec<usize> = (0..n).filter(|p| p % side as usize >= side as usize - 6).collect();
        timed("load of a stress at one side", || {
            plane.add_stress_load(Some(&edge), &|_, _| [1.0, 0.0, 0.0], &mut f);
        });
        let coarse = timed("coarser", || plane.coarser(&|_, _| Vec::new()));
        println!("{} points, {} triangles", n, plane.triangles());
        drop(coarse);
    }
    let parameters = PlaneParameters {
        material,
        horizon_ratio: 3.0,
        influence: Influence::Constant,
        calibration: Calibration::Matched,
        weights: Weights::Nearest,
        volume_factor: VolumeFactor::Full,
        edges: Edges::Overlay,
    };
    let mirrors = Mirrors::in_plane([Some(0), None], [Some(0), None]);
    let real = SquareLattice::rectangle(1e-3, [0.0; 2], [side, side]);
    let extended = Arc::new(timed("extend a quarter", || mirrors.extended(&real, 3)));
    let quarter = timed("make a quarter", || BondPlane::on_lattice(extended, mirrors, parameters, &[]));
    let quarter = quarter.expect("the horizon is large enough");
    timed("its relations", || quarter.relations());
    timed("coarser", || quarter.coarser(&|_, _| Vec::new()));
}
