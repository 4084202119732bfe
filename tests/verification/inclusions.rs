//! A stiffer or softer disc in a plate under remote tension, with exact displacements on a frame around it.

use crate::support::goodier::{Elastic, Goodier};
use crate::support::mixed::{Stiffness, parameters, plate, prescribed};
use nalgebra::SymmetricEigen;
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_plane::BondPlane;
use peristat_assembly::model::plane::{Edges, Mirrors, PlaneModel};
use peristat_assembly::model::{BodyModel, Points};
use std::sync::Arc;

/// A disc of a contrast in a plate with E = 1 and ν = 1/3 in plane stress.
fn exact(contrast: f64) -> Goodier {
    Goodier::new([1.0, contrast].map(|e| Elastic { shear: 3.0 * e / 8.0, kappa: 2.0 }))
}

/// Errors of the stress along x, relative, and along y, over that along x, of the core of a disc with so many points per radius.
fn core(contrast: f64, per_radius: i32, ratio: f64) -> [f64; 2] {
    let exact = exact(contrast);
    let cells = 5 * per_radius + 8;
    let h = 1.0 / f64::from(per_radius);
    let lattice = SquareLattice::rectangle(h, [-0.5 * h * f64::from(cells); 2], [cells; 2]);
    let modulus = |[x, y]: [f64; 2]| if x.hypot(y) < 1.0 { contrast } else { 1.0 };
    let plate = plate(lattice, parameters(ratio, Edges::Overlay), modulus);
    let inner = h * (0.5 * f64::from(cells) - 4.0);
    let held = prescribed(&plate, |_, at| {
        let is_frame = at.iter().any(|x| x.abs() > inner);
        exact.at(at).map(|u| is_frame.then_some(u))
    });
    let u = Stiffness::of(&plate).relaxed(&held);
    let n = plate.points();
    let core: Vec<usize> = (0..n).filter(|&p| plate.place(p)[0].hypot(plate.place(p)[1]) < 0.5).collect();
    // The centre of all is zero: slopes are moments.
    let slope = |k: usize, c: usize| {
        core.iter().map(|&p| plate.place(p)[k] * u[c * n + p]).sum::<f64>()
            / core.iter().map(|&p| plate.place(p)[k].powi(2)).sum::<f64>()
    };
    let (strain, c) = ([slope(0, 0), slope(1, 1)], plate.stiffness());
    let stress = [0, 1].map(|q| contrast * (c[q][0] * strain[0] + c[q][1] * strain[1]));
    let [x, y] = exact.inside();
    [stress[0] / x - 1.0, (stress[1] - y) / x]
}

#[test]
fn a_disc_has_the_stress_of_goodier() {
    // The exact stress along x at contrasts 10 and 100, and the errors of Sc+pt1 at 16 points per radius of the prototype.
    assert!((exact(10.0).inside()[0] - 1.4286).abs() < 1e-4);
    for (contrast, expected, across) in [(10.0, 0.0062, 0.006), (100.0, 0.0063, 0.006)] {
        let [x, y] = core(contrast, 16, 3.0);
        assert!((x - expected).abs() <= 5e-4 && y.abs() <= across, "{contrast}: {x} {y}");
    }
}

#[test]
fn the_core_of_a_disc_is_good_at_eight_points_per_radius() {
    for (contrast, ratio) in [1e-3, 0.1, 2.0, 10.0, 100.0].into_iter().flat_map(|c| [(c, 2.0), (c, 3.0)]) {
        let [x, y] = core(contrast, 8, ratio);
        assert!(x.abs() <= 0.012 && y.abs() <= 0.012, "{contrast} {ratio}: {x} {y}");
    }
}

/// Whatever lies beside what, nothing is less than zero, and rigid motions alone are free.
#[test]
fn mixtures_are_definite() {
    let mut state = 1_u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize
    };
    for (ratio, edges) in [(2.0, Edges::Border), (3.0, Edges::Border), (3.0, Edges::Overlay)] {
        for _ in 0..4 {
            let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [11, 9]);
            let factors: Vec<f64> =
                (0..lattice.points()).map(|_| [1.0, 1e-6, 1e-2, 1e2, 1e4][next() % 5]).collect();
            let plate =
                BondPlane::mixed(Arc::new(lattice), Mirrors::NONE, parameters(ratio, edges), &[], factors);
            let dense = Stiffness::of(&plate.expect("the bonds exist")).dense();
            let mut found: Vec<f64> = SymmetricEigen::new(dense).eigenvalues.iter().copied().collect();
            found.sort_by(f64::total_cmp);
            let most = found.last().copied().unwrap_or(0.0);
            assert!(found[0] >= -1e-14 * most, "{ratio} {edges:?}: {}", found[0] / most);
        }
    }
}

#[test]
fn materials_that_are_alike_change_nothing() {
    let lattice = Arc::new(SquareLattice::rectangle(0.5, [0.0; 2], [13, 9]));
    for (ratio, edges) in [(2.0, Edges::Border), (3.0, Edges::Border), (3.0, Edges::Overlay)] {
        let of = |factors: Vec<f64>| {
            BondPlane::mixed(lattice.clone(), Mirrors::NONE, parameters(ratio, edges), &[], factors).unwrap()
        };
        let plain = of(Vec::new());
        let u: Vec<f64> = (0..2 * plain.points()).map(|k| (0.7 * k as f64).sin()).collect();
        let force = Stiffness::of(&plain).forces(&u);
        assert_eq!(force, Stiffness::of(&of(vec![1.0; plain.points()])).forces(&u));
        // All of another material: as a plate of that.
        let other = of(vec![3.0; plain.points()]);
        let found = Stiffness::of(&other).forces(&u);
        let worst = found.iter().zip(&force).map(|(a, b)| (a - 3.0 * b).abs()).fold(0.0, f64::max);
        assert!(worst <= 1e-13 * 3.0, "{worst}");
        let (a, b) = (other.fields(&u), plain.fields(&u));
        let planes = a.stress.concat().into_iter().zip(b.stress.concat());
        assert!(planes.map(|(a, b)| (a - 3.0 * b).abs()).fold(0.0, f64::max) <= 1e-12);
    }
}
