//! Plates of central bonds pass the checks of every model: all calibrations and edges, on lattices and clouds, with lines
//! of symmetry and random cuts.

use super::consistency::{Noise, check};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::bond_plane::{
    BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
};
use peristat_assembly::model::plane::Mirrors;
use peristat_assembly::model::plane::{Calibration, Edges};
use proptest::prelude::*;
use std::sync::Arc;

/// Treatments of edges that a calibration allows, and all else.
fn parameters(ratio: f64, choice: usize) -> PlaneParameters {
    let pick = |k: usize, of: usize| choice / k % of;
    let edges = [Edges::Overlay, Edges::None, Edges::Volume, Edges::Energy][pick(1, 4)];
    let matched = edges == Edges::Overlay || pick(4, 2) == 0;
    let factors = [VolumeFactor::Full, VolumeFactor::Clip, VolumeFactor::Ramp, VolumeFactor::Area];
    PlaneParameters {
        material: PlaneMaterial {
            youngs_modulus: 3.0,
            thickness: 0.7,
            state: [PlaneState::Stress, PlaneState::Strain][pick(8, 2)],
        },
        horizon_ratio: ratio,
        influence: [Influence::Constant, Influence::Inverse, Influence::Linear][pick(16, 3)],
        calibration: if matched { Calibration::Matched } else { Calibration::Published },
        weights: Weights::Nearest,
        volume_factor: factors[pick(48, 4)],
        edges,
    }
}

proptest! {
    #![proptest_config(super::cases(60))]

    #[test]
    fn a_lattice_is_consistent_in_any_treatment(
        columns in 2_i32..90, rows in 2_i32..6, ratio in 1.5..4.0_f64, choice in 0_usize..192,
        holes in 0_usize..8, cut in 0_usize..40, mirrored in prop::array::uniform4(any::<bool>()), seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let parameters = parameters(ratio, choice);
        let holes: Vec<[i32; 2]> =
            (0..holes).map(|_| [noise.index(columns as usize) as i32, noise.index(rows as usize) as i32]).collect();
        let real = SquareLattice::plane(0.5, [1.0, -3.0], 0..columns, 0..rows, |c| !holes.contains(&c));
        let line = |k: usize, at: i32| mirrored[k].then_some(at);
        let mirrors = Mirrors::in_plane([line(0, 0), line(1, columns)], [line(2, 0), line(3, rows)]);
        let lattice = mirrors.extended(&real, BondPlane::depth(&parameters).expect("the ratio is large enough"));
        let offsets = BondPlane::offsets(&parameters).expect("the ratio is large enough");
        let cuts: Vec<(usize, usize)> =
            (0..cut).map(|_| (noise.index(offsets.len()), noise.index(lattice.points()))).collect();
        let plane = BondPlane::on_lattice(Arc::new(lattice), mirrors, parameters, &cuts).expect("as before");
        prop_assert!(plane.damage().iter().all(|d| (0.0..=1.0).contains(d)));
        check::<2, _>(&plane, &Vec::new, seed);
    }

    #[test]
    fn a_cloud_is_consistent_in_any_treatment(
        points in 2_usize..120, ratio in 1.5..4.0_f64, choice in 0_usize..144, seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let parameters = parameters(ratio, choice);
        let width = (points as f64).sqrt();
        let positions: Vec<[f64; 2]> = (0..points).map(|_| [width * noise.next(), width * noise.next()]).collect();
        let areas = (0..points).map(|_| 1.5 + noise.next()).collect();
        let level = noise.next();
        let cut = |a: [f64; 2], b: [f64; 2]| (a[0] < level) != (b[0] < level) && a[1].min(b[1]) < 0.0;
        let plane = BondPlane::on_cloud(positions, areas, ratio, parameters, &cut).expect("no two points coincide");
        prop_assert!(plane.damage().iter().all(|d| (0.0..=1.0).contains(d)));
        check::<2, _>(&plane, &Vec::new, seed);
    }
}
