//! Solids and plates in antiplane shear of several materials.

use crate::support::mixed::{Stiffness, line};
use nalgebra::{DMatrix, DVector, SymmetricEigen};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_antiplane::{AntiplaneParameters, BondAntiplane};
use peristat_assembly::model::bond_plane::{Influence, VolumeFactor, Weights};
use peristat_assembly::model::bond_solid::{BondSolid, BondSolidParameters};
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors, PlaneModel};
use peristat_assembly::model::solid::{SolidEdges, SolidError, SolidModel, TENSOR};
use peristat_assembly::model::{BodyModel, Points};
use std::sync::Arc;

fn parameters(horizon_ratio: f64) -> BondSolidParameters {
    BondSolidParameters {
        youngs_modulus: 1.0,
        horizon_ratio,
        influence: Influence::Constant,
        calibration: Calibration::Matched,
        weights: Weights::Nearest,
        volume_factor: VolumeFactor::Full,
        edges: SolidEdges::Border,
    }
}

/// A block of cubes with moduli by place.
fn block(cells: [i32; 3], ratio: f64, modulus: impl Fn([f64; 3]) -> f64) -> BondSolid {
    let lattice = SquareLattice::cuboid(1.0, [0.0; 3], cells);
    let factors = (0..lattice.points()).map(|p| modulus(lattice.position(p))).collect();
    BondSolid::mixed(Arc::new(lattice), Mirrors::NONE, parameters(ratio), &[], factors)
        .expect("the bonds exist")
}

/// Two layers of fourteen that nothing varies in, pulled across: the extra elongation at the interface in spacings of the softer strain.
fn jump(contrast: f64, ratio: f64) -> f64 {
    const LAYERS: usize = 28;
    const SIDE: usize = 9;
    let block =
        block(
            [SIDE as i32, SIDE as i32, LAYERS as i32],
            ratio,
            |[_, _, z]| if z < 14.0 { 1.0 } else { contrast },
        );
    let (stiffness, n) = (Stiffness::of(&block), block.points());
    let layer = SIDE * SIDE;
    let column = |at: usize| -> Vec<f64> {
        let moved = (0..3 * n).map(|k| f64::from(u8::from(k >= 2 * n && (k - 2 * n) / layer == at)));
        let force = stiffness.forces(&moved.collect::<Vec<_>>());
        (0..LAYERS).map(|k| force[2 * n + layer * k + layer / 2]).collect()
    };
    let all = DMatrix::from_columns(&(0..LAYERS).map(|k| DVector::from_vec(column(k))).collect::<Vec<_>>());
    let exact = |k: usize| {
        let z = k as f64 + 0.5;
        if z < 14.0 { z } else { 14.0 + (z - 14.0) / contrast }
    };
    let (free, held): (Vec<usize>, Vec<usize>) = (0..LAYERS).partition(|k| (5..23).contains(k));
    let part = |of: &[usize]| all.select_rows(&free).select_columns(of);
    let load = -(part(&held) * DVector::from_iterator(held.len(), held.iter().map(|&k| exact(k))));
    let found = part(&free).lu().solve(&load).expect("held layers");
    let near = |from: usize| -> Vec<(f64, f64)> {
        (from..from + 3).map(|k| (k as f64 + 0.5, found[k - 5])).collect()
    };
    let [low, high] = [line(&near(7)), line(&near(18))];
    ((high[0] + 14.0 * high[1]) - (low[0] + 14.0 * low[1])) / low[1]
}

#[test]
fn layers_of_solids_in_series_have_no_jump() {
    for (contrast, ratio) in [2.0, 10.0, 100.0].into_iter().flat_map(|c| [(c, 2.0), (c, 3.0)]) {
        let found = jump(contrast, ratio);
        // Measured -0.038, -0.020, -0.031, -0.035, -0.004, -0.005.
        assert!(found.abs() <= 0.04, "{contrast} {ratio}: {found}");
    }
}

#[test]
fn uniform_strains_of_solids_have_the_stress_of_every_point() {
    for ratio in [2.0, 3.0] {
        let modulus = |[x, _, z]: [f64; 3]| if x > 5.0 && z > 4.0 { 25.0 } else { 1.0 };
        let block = block([10, 8, 9], ratio, modulus);
        let strain: [f64; TENSOR] = [1.0, -0.25, 0.5, 0.3, -0.2, 0.4];
        let n = block.points();
        let at = |p: usize| block.position(p);
        let u: Vec<f64> = (0..3 * n)
            .map(|k| {
                let [x, y, z] = at(k % n);
                match k / n {
                    0 => strain[0] * x + strain[5] * y + strain[4] * z,
                    1 => strain[1] * y + strain[3] * z,
                    _ => strain[2] * z,
                }
            })
            .collect();
        let (fields, c) = (block.fields(&u), SolidModel::stiffness(&block));
        for p in 0..n {
            let factor = modulus(at(p));
            let stress: [f64; TENSOR] =
                std::array::from_fn(|q| factor * (0..TENSOR).map(|k| c[q][k] * strain[k]).sum::<f64>());
            let worst = (0..TENSOR).map(|q| (fields.stress[q][p] - stress[q]).abs()).fold(0.0, f64::max);
            assert!(worst <= 1e-13 * factor, "{ratio} {p}: {worst}");
            let energy: f64 = (0..TENSOR).map(|q| 0.5 * stress[q] * strain[q]).sum();
            assert!((fields.energy_density[p] / energy - 1.0).abs() <= 1e-12);
            let told = block.strains_at(p, stress, 0.0);
            assert!((0..TENSOR).all(|q| (told[q] - strain[q]).abs() <= 1e-14));
        }
        // Corners of three free faces have the energy of shear on the mean of all of them alone.
        let stretched: Vec<f64> = (0..3 * n).map(|k| strain[k / n] * at(k % n)[k / n]).collect();
        let of_points: f64 = block.fields(&stretched).energy_density.iter().sum();
        let energy = 0.5
            * Stiffness::of(&block)
                .forces(&stretched)
                .iter()
                .zip(&stretched)
                .map(|(f, u)| f * u)
                .sum::<f64>();
        assert!((energy / of_points - 1.0).abs() <= 1e-12, "{ratio}: {energy} {of_points}");
    }
}

#[test]
fn solids_of_several_materials_are_definite_and_alike_ones_the_same() {
    let mut state = 7_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize
    };
    for ratio in [2.0, 3.0] {
        let cells = [5, 6, 5];
        let factors: Vec<f64> = (0..150).map(|_| [1.0, 1e-6, 1e-2, 1e2, 1e4][next() % 5]).collect();
        let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], cells));
        let solid = |factors: Vec<f64>| {
            BondSolid::mixed(lattice.clone(), Mirrors::NONE, parameters(ratio), &[], factors).unwrap()
        };
        let eigenvalues = SymmetricEigen::new(Stiffness::of(&solid(factors)).dense()).eigenvalues;
        let most = eigenvalues.max();
        assert!(eigenvalues.min() >= -1e-14 * most, "{}", eigenvalues.min() / most);
        let u: Vec<f64> = (0..450).map(|k| (0.7 * f64::from(k)).sin()).collect();
        let of = |factors: Vec<f64>| Stiffness::of(&solid(factors)).forces(&u);
        let plain = of(Vec::new());
        assert_eq!(plain, of(vec![1.0; 150]));
        let worst =
            of(vec![3.0; 150]).iter().zip(&plain).map(|(a, b)| (a - 3.0 * b).abs()).fold(0.0, f64::max);
        assert!(worst <= 1e-12, "{worst}");
    }
    // One layer of the overlay: bonds do not end there.
    let bare = BondSolidParameters { edges: SolidEdges::Overlay, ..parameters(2.0) };
    let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], [4, 4, 4]));
    let refused = BondSolid::mixed(lattice, Mirrors::NONE, bare, &[], vec![2.0; 64]).unwrap_err();
    assert_eq!(refused, SolidError::MaterialsNeedBorder);
}

#[test]
fn shear_across_a_plate_has_the_stress_of_every_point() {
    for (ratio, edges) in [(2.0, Edges::Border), (3.0, Edges::Border), (3.0, Edges::Overlay)] {
        let parameters = AntiplaneParameters {
            shear_modulus: 2.0,
            thickness: 1.0,
            horizon_ratio: ratio,
            influence: Influence::Constant,
            edges,
        };
        let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [12, 10]);
        let modulus = |[x, y]: [f64; 2]| if x + y > 11.0 { 25.0 } else { 1.0 };
        let factors = (0..lattice.points()).map(|p| modulus(lattice.place(p))).collect();
        let plate = BondAntiplane::mixed(Arc::new(lattice), Mirrors::NONE, parameters, &[], factors).unwrap();
        let u: Vec<f64> =
            (0..plate.points()).map(|p| plate.place(p)).map(|[x, y]| 0.3 * x - 0.2 * y).collect();
        let fields = plate.fields(&u);
        for p in 0..plate.points() {
            let g = 2.0 * modulus(plate.place(p));
            let [x, y] = [fields.stress[0][p], fields.stress[1][p]];
            assert!(
                (x - 0.3 * g).abs().max((y + 0.2 * g).abs()) <= 1e-13 * g,
                "{ratio} {edges:?} {p}: {x} {y}"
            );
        }
    }
}
