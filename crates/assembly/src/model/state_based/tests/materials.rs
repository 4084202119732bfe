//! Several materials: layers in series, motions without energy, and strains that need no stress.

use super::spectrum::eigenvalues;
use super::*;
use crate::model::state_based::StateMaterials;
use crate::model::{BodyModel, Points};

/// Random numbers from 0 to 1.
fn random(mut state: u64) -> impl FnMut() -> f64 {
    move || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 40) as f64 / (1u64 << 24) as f64
    }
}

/// A body whose points have one of some materials, `[E, ν]` over a base of E = 1.
fn mixed(
    lattice: SquareLattice,
    parameters: StateParameters,
    others: &[[f64; 2]],
    number: impl Fn([f64; 2]) -> u32,
) -> StateBased {
    let numbers: Vec<u32> = (0..lattice.points()).map(|p| number(lattice.place(p))).collect();
    let ratios: Vec<f64> = others.iter().map(|other| other[1]).collect();
    let factor = |number: &u32| number.checked_sub(1).map_or(1.0, |k| others[k as usize][0]);
    let factors: Vec<f64> = numbers.iter().map(factor).collect();
    let materials = StateMaterials::new(&parameters, &ratios, &numbers, &factors);
    let (real, none) = (Arc::new(lattice), |_: &SquareLattice| Vec::new());
    StateBased::mixed(real, Mirrors::NONE, parameters, &|_, _| false, &none, materials.as_ref()).unwrap()
}

const OTHERS: [[f64; 2]; 4] = [[1e-4, 0.3], [50.0, 0.1], [1.0, 0.45], [1e4, 0.3]];

#[test]
fn mixtures_are_definite_and_rigid_motions_alone_are_free() {
    let mut next = random(5);
    for (parameters, rigid) in [(PLATE, 3), (RING, 1)] {
        for dilatation in [Dilatation::Points, Dilatation::Blocks] {
            for horizon_ratio in [2.0, 3.0] {
                let parameters = StateParameters { horizon_ratio, dilatation, ..parameters };
                let numbers: Vec<u32> = (0..88).map(|_| (5.0 * next()) as u32).collect();
                let at = |[x, y]: [f64; 2]| numbers[(x - 1.0) as usize + 11 * y as usize];
                let body = mixed(cells(1.0, 1.0, [11, 8]), parameters, &OTHERS, at);
                let values = eigenvalues(&body);
                let most = values[values.len() - 1];
                // The softest material has 1e-8 of the stiffest.
                let zero = values.iter().filter(|v| **v < 1e-12 * most).count();
                assert!(values[0] > -1e-13 * most, "{}", values[0] / most);
                assert_eq!(zero, rigid, "{:?} {dilatation:?} {horizon_ratio}", parameters.geometry);
            }
        }
    }
}

/// Layers under one stress across them: every point tells that stress, up to the border.
#[test]
fn points_of_layers_in_series_tell_one_stress() {
    for ratio in [2.0, 3.0] {
        for contrast in [1e-3, 10.0, 1e4] {
            let parameters =
                StateParameters { horizon_ratio: ratio, geometry: Geometry::PlaneStrain(1.0), ..RING };
            let layer = |[_, y]: [f64; 2]| u32::from(y > 5.0);
            let body = mixed(cells(1.0, 0.0, [8, 11]), parameters, &[[contrast, 0.3]], layer);
            let n = body.points();
            let [_, [_, modulus, _], _] = parameters.stiffness();
            let moved = |y: f64| if y > 5.0 { 5.0 + (y - 5.0) / contrast } else { y };
            let mut u = vec![0.0; 2 * n];
            (0..n).for_each(|p| u[n + p] = moved(body.place(p)[1]));
            let stress = body.fields(&u).stress;
            // Differences of displacements have the digits of these.
            let slack = 1e-13 * f64::max(1.0, contrast);
            for p in real_points(&body) {
                assert!((stress[1][p] / modulus - 1.0).abs() < slack, "{ratio} {contrast} {p}");
                assert!(stress[2][p].abs() < slack * modulus);
            }
        }
    }
}

/// The load of a strain that needs no stress is what the motion with this strain takes.
#[test]
fn bodies_that_stretch_alike_need_no_stress() {
    let strain = [0.7, 0.7, 0.0];
    let others = OTHERS.map(|[e, _]| [e, 0.3]);
    for parameters in [PLATE, RING, StateParameters { geometry: Geometry::PlaneStrain(2.0), ..RING }] {
        for dilatation in [Dilatation::Points, Dilatation::Blocks] {
            let parameters = StateParameters { dilatation, ..parameters };
            let number = |[x, y]: [f64; 2]| ((0.9 * x + 0.4 * y) as u32) % 5;
            let lattice = SquareLattice::plane(1.0, [1.0, 0.0], 0..12, 0..9, |c| c != [5, 4] && c != [6, 4]);
            let body = mixed(lattice, parameters, &others, number);
            let n = body.points();
            let mut t: Vec<f64> = strain.iter().flat_map(|e| vec![*e; n]).collect();
            let mut load = vec![0.0; 2 * n];
            body.add_strain_work(&mut t, None, &mut load);
            let u = linear(&body, [strain[0], 0.0, 0.0, strain[1]]);
            let mut force = vec![0.0; 2 * n];
            body.terms().iter().for_each(|term| term.add_force(&u, &mut force));
            let most = largest(force.iter().copied());
            let worst = largest(force.iter().zip(&load).map(|(a, b)| a - b));
            assert!(most > 1.0 && worst < 1e-13 * most, "{dilatation:?}: {worst} of {most}");
        }
    }
}

#[test]
fn materials_that_are_alike_are_none() {
    let plain: StateBased = body(cells(0.1, 1.0, [9, 7]), Mirrors::NONE, PLATE);
    let u = linear(&plain, [0.3, -0.2, 0.5, 0.1]);
    let force = |body: &StateBased, u: &[f64]| {
        let mut force = vec![0.0; u.len()];
        body.terms().iter().for_each(|term| term.add_force(u, &mut force));
        force
    };
    let alike = mixed(cells(0.1, 1.0, [9, 7]), PLATE, &[[1.0, 0.3]], |[x, _]| u32::from(x > 1.4));
    assert_eq!(force(&plain, &u), force(&alike, &u));
    // All of another one: as a body of that.
    let all = mixed(cells(0.1, 1.0, [9, 7]), PLATE, &[[3.0, 0.2]], |_| 1);
    let own = body(
        cells(0.1, 1.0, [9, 7]),
        Mirrors::NONE,
        StateParameters { youngs_modulus: 3.0, poisson_ratio: 0.2, ..PLATE },
    );
    let (found, expected) = (force(&all, &u), force(&own, &u));
    let worst = largest(found.iter().zip(&expected).map(|(a, b)| a - b));
    assert!(worst < 1e-13 * largest(expected), "{worst}");
}

#[test]
fn families_of_several_materials_have_ghosts() {
    let parameters = StateParameters { edges: StateEdges::MomentPlus, ..PLATE };
    let lattice = Arc::new(cells(1.0, 0.0, [6, 6]));
    let materials = StateMaterials::new(&parameters, &[0.3], &[1; 36], &[2.0; 36]);
    let none = |_: &SquareLattice| Vec::new();
    let made =
        StateBased::mixed(lattice, Mirrors::NONE, parameters, &|_, _| false, &none, materials.as_ref());
    assert!(made.unwrap_err().to_string().contains("use the edges `ghosts`"));
}
