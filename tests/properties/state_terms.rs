//! State-based bodies pass the checks of every model: all treatments of edges and axis, with lines of symmetry, joined sides
//! and random cuts; what breaking takes is what is missing afterwards.

use super::consistency::{Noise, check};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::Mirrors;
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateBased, StateEdges, StateParameters,
};
use peristat_assembly::model::{Breakable, Model, Points};
use proptest::prelude::*;
use std::sync::Arc;

fn parameters(horizon_ratio: f64, poisson_ratio: f64, choice: usize, revolved: bool) -> StateParameters {
    let pick = |k: usize, of: usize| choice / k % of;
    let edges = [StateEdges::Ghosts, StateEdges::MomentPlus, StateEdges::Calibrated, StateEdges::None];
    let flat = [Geometry::PlaneStress(0.7), Geometry::PlaneStrain(0.7)];
    StateParameters {
        youngs_modulus: 3.0,
        poisson_ratio,
        geometry: if revolved { Geometry::Axisymmetric } else { flat[pick(4, 2)] },
        horizon_ratio,
        influence: [Influence::Linear, Influence::Inverse][pick(8, 2)],
        edges: edges[pick(1, 4)],
        measure: if revolved {
            [Measure::Section, Measure::Published][pick(16, 2)]
        } else {
            Measure::Section
        },
        axis: [Axis::Images, Axis::Truncated][pick(32, 2)],
        dilatation: [Dilatation::Points, Dilatation::Blocks][pick(64, 2)],
    }
}

fn is_consistent(
    parameters: StateParameters,
    real: SquareLattice,
    mirrors: Mirrors,
    cut: usize,
    seed: u64,
) -> Result<(), TestCaseError> {
    let offsets = StateBased::offsets(&parameters).len();
    let cuts = |lattice: &SquareLattice| {
        let mut noise = Noise(seed);
        (0..cut).map(|_| (noise.index(offsets), noise.index(lattice.points()))).collect()
    };
    let model = StateBased::on_lattice(Arc::new(real), mirrors, parameters, &|_, _| false, &cuts);
    let mut model = model.expect("these treatments suit every body");
    prop_assert!(model.damage().iter().all(|d| (0.0..=1.0 + 1e-12).contains(d)));
    check::<2, _>(&model, &Vec::new, seed);
    let mut noise = Noise(seed);
    let broken: Vec<u64> = (0..cut).map(|_| noise.index(model.bond_numbers() as usize) as u64).collect();
    let u = noise.vector(2 * model.points());
    let energy = |model: &StateBased| model.terms().iter().map(|t| t.survey(&u).energy).sum::<f64>();
    let (before, part) = (energy(&model), model.part(&broken));
    let gone: f64 = part.iter().map(|t| t.survey(&u).energy).sum();
    model.break_bonds(&broken);
    let after = energy(&model);
    prop_assert!(model.damage().iter().all(|d| (0.0..=1.0 + 1e-12).contains(d)));
    prop_assert!((before - after - gone).abs() <= 1e-11 * before, "{} {} {}", before, after, gone);
    check::<2, _>(&model, &Vec::new, seed);
    Ok(())
}

proptest! {
    #![proptest_config(super::cases(40))]

    #[test]
    fn families_are_consistent_in_any_treatment(
        columns in 2_i32..40, rows in 2_i32..6, ratio in 2.0..3.5_f64, nu in -0.8..0.48_f64,
        choice in 0_usize..128, holes in 0_usize..5, cut in 0_usize..20, at_axis in any::<bool>(),
        images in 0_usize..4, seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let holes: Vec<[i32; 2]> =
            (0..holes).map(|_| [noise.index(columns as usize) as i32, noise.index(rows as usize) as i32]).collect();
        let real = |left: f64| SquareLattice::plane(0.5, [left, -3.0], 0..columns, 0..rows, |c| !holes.contains(&c));
        let mirrors = [
            Mirrors::NONE,
            Mirrors::in_plane([None; 2], [Some(0), None]),
            Mirrors::in_plane([None; 2], [Some(0), Some(rows)]),
            Mirrors { joined: [false, true, false], ..Mirrors::in_plane([None; 2], [Some(0), Some(rows)]) },
        ][images];
        is_consistent(parameters(ratio, nu, choice, false), real(-2.0), mirrors, cut, seed)?;
        let left = if at_axis { 0.0 } else { 5.0 };
        is_consistent(parameters(ratio, nu, choice, true), real(left), mirrors, cut, seed)?;
    }
}
