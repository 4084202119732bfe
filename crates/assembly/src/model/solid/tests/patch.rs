//! Uniform strains and rigid motions are exact everywhere.

use super::*;
use crate::model::bond_plane::tests::bodies::{difference, largest, random};

const STRESS: [f64; 6] = [1.0, 0.3, -0.5, 0.2, -0.4, 0.7];

fn check_fields(name: &str, solid: &dyn Solvable<3>) {
    let n = solid.points();
    let strain = solid.as_solid().unwrap().strain_of(STRESS);
    let stiffness = solid.as_solid().unwrap().stiffness();
    let back = stiffness.map(|row| (0..6).map(|q| row[q] * strain[q]).sum::<f64>());
    assert!(difference(&back, &STRESS) < 1e-14, "{name} {back:?}");
    let u = linear(solid, gradient(strain));
    let fields = solid.as_solid().unwrap().fields(&u);
    let density = 0.5 * (0..6).map(|q| STRESS[q] * strain[q]).sum::<f64>();
    for p in (0..n).filter(|&p| solid.volume(p) > 0.0) {
        for q in 0..6 {
            let error = fields.stress[q][p] - STRESS[q];
            // 6e-14 measured, of ν = 0.45.
            assert!(error.abs() < 1e-12, "{name} {p} {q}: {error:e}");
        }
        assert!((fields.energy_density[p] / density - 1.0).abs() < 1e-12, "{name} {p}");
    }
    let mut load = vec![0.0; 3 * n];
    solid.as_solid().unwrap().add_stress_load(&|_, _| STRESS, &mut load);
    let internal = force(solid, &u);
    assert!(difference(&load, &internal) < 1e-12 * largest(&internal), "{name}");
    let volume: f64 = (0..n).map(|p| solid.volume(p)).sum();
    assert!((energy(solid, &u) / (density * volume) - 1.0).abs() < 1e-12, "{name}");
}

fn check_rigid(name: &str, solid: &dyn Solvable<3>) {
    let scale = energy(solid, &linear(solid, gradient([1.0, 0.0, 0.0, 0.0, 0.0, 0.0])));
    for kind in 0..6 {
        let n = solid.points();
        let mut u = vec![0.0; 3 * n];
        for p in 0..n {
            let motion = solid.rigid_motion(kind, p, [5.0, -3.0, 2.0]);
            (0..3).for_each(|c| u[c * n + p] = motion[c]);
        }
        // Energies are squares of measures that are rounded.
        let energy = energy(solid, &u);
        assert!(energy.abs() < 1e-24 * scale, "{name} {kind}: {energy:e} of {scale:e}");
    }
}

#[test]
fn uniform_strains_and_rigid_motions_are_exact_at_every_point() {
    for (body, lattice) in bodies(1.0) {
        for (name, solid) in solids(&lattice) {
            let name = format!("{body} {name}");
            assert_eq!(solid.uncorrected(), 0, "{name}");
            check_fields(&name, &*solid);
            check_rigid(&name, &*solid);
        }
    }
}

#[test]
fn units_and_coarser_lattices_change_nothing() {
    let (_, lattice) = &bodies(1e-3)[2];
    for (name, solid) in solids(lattice) {
        check_fields(&name, &*solid);
        let coarse = solid.coarser(&|_, _| Vec::new()).unwrap();
        assert!(coarse.points() < solid.points());
        check_fields(&name, &*coarse);
    }
}

#[test]
fn loads_of_a_uniform_stress_are_solved_by_the_linear_displacement() {
    for (body, lattice) in bodies(1.0) {
        for (name, solid) in solids(&lattice).into_iter().step_by(3) {
            let n = solid.points();
            let exact = linear(&*solid, gradient(solid.as_solid().unwrap().strain_of(STRESS)));
            let mut load = vec![0.0; 3 * n];
            solid.as_solid().unwrap().add_stress_load(&|_, _| STRESS, &mut load);
            // Three points that are not in a line.
            let far = |along: Point| {
                let at = |p: usize| (0..3).map(|k| along[k] * solid.position(p)[k]).sum::<f64>();
                (0..n).max_by(|&a, &b| at(a).total_cmp(&at(b))).unwrap()
            };
            let held = [0, far([1.0, -0.3, 0.1]), far([-0.3, 1.0, 0.2])];
            let is_held = |unknown: usize| held.contains(&(unknown % n));
            let start = (0..3 * n).map(|k| if is_held(k) { exact[k] } else { 0.0 }).collect();
            let u = solve(&*solid, start, &load, is_held);
            // 1.3e-13 measured.
            let error = difference(&u, &exact) / largest(&exact);
            assert!(error < 1e-12, "{body} {name}: {error:e}");
        }
    }
}

#[test]
fn forces_are_the_slope_of_the_energy_and_columns_of_the_matrix() {
    for (name, solid) in [0, 6].into_iter().flat_map(|body| solids(&bodies(1.0)[body].1)) {
        let n = 3 * solid.points();
        let (u, step) = (random(n), random(n).into_iter().rev().collect::<Vec<_>>());
        let moved =
            |t: f64| energy(&*solid, &u.iter().zip(&step).map(|(u, s)| u + t * s).collect::<Vec<_>>());
        let own = force(&*solid, &u);
        let slope: f64 = own.iter().zip(&step).map(|(f, s)| f * s).sum();
        // The energy is quadratic: the difference has rounding alone.
        assert!(((moved(1.0) - moved(-1.0)) / (2.0 * slope) - 1.0).abs() < 1e-11, "{name}");
        let k = matrix(&*solid);
        let product = &k * nalgebra::DVector::from_vec(u.clone());
        assert!(difference(product.as_slice(), &own) < 1e-12 * largest(&own), "{name}");
        for term in solid.terms() {
            let mut most = 0;
            term.couplings(&mut |i, j| most = most.max(i.abs_diff(j)));
            assert!(term.reach() >= most && term.reach() <= solid.points(), "{name}");
        }
        let mut blocks = vec![[[0.0; 3]; 3]; solid.points()];
        solid.terms().iter().for_each(|term| term.add_diagonal(&mut blocks));
        for (p, block) in blocks.iter().enumerate() {
            for (r, c) in (0..9).map(|k| (k / 3, k % 3)) {
                let of = k[(r * solid.points() + p, c * solid.points() + p)];
                assert!((block[r][c] - of).abs() < 1e-12, "{name} {p}");
            }
        }
    }
}

#[test]
fn without_overlay_faces_are_too_soft_and_thin_bodies_are_refused() {
    let (_, lattice) = &bodies(1.0)[0];
    let parameters = BondSolidParameters { edges: SolidEdges::None, ..BONDS };
    let soft = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
    let stress = &soft.fields(&linear(&soft, gradient([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]))).stress[0];
    let least = stress.iter().fold(f64::INFINITY, |a, b| a.min(b / 1.2));
    // The corner has the bonds of one octant, 1/8 of the stiffness, and those along its sides.
    assert!((0.125..0.4).contains(&least), "{least}");
    for size in [[9, 9, 1], [1, 4, 4], [4, 1, 4]] {
        let layer = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], size));
        let refused = BondSolid::on_lattice(layer, Mirrors::NONE, BONDS, &[]).unwrap_err();
        assert_eq!(refused, SolidError::TooThin);
    }
}
