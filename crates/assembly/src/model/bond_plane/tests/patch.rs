//! Patch tests: uniform strains and rigid motions are exact everywhere.

use super::super::*;
use super::bodies::*;
use crate::model::Points;
use crate::model::plane::{Edges, PlaneModel, Solvable};

pub(super) const STRAINS: [[[f64; 2]; 2]; 4] = [
    [[1e-3, 0.0], [0.0, 0.0]],
    [[0.0, 0.0], [0.0, 1e-3]],
    [[0.0, 1e-3], [0.0, 0.0]],
    // With a rotation.
    [[4e-4, -3e-4], [1e-3, -2e-4]],
];
const INFLUENCES: [Influence; 3] = [Influence::Constant, Influence::Inverse, Influence::Linear];
const RATIOS: [f64; 5] = [2.0, 3.0, 3.015, 4.0, 6.0];

pub(super) fn strain_of(g: [[f64; 2]; 2]) -> [f64; 3] {
    [g[0][0], g[1][1], g[0][1] + g[1][0]]
}

/// Stress and energy density of every point, and the load that belongs to the stress.
pub(super) fn check_fields(name: &str, plane: &dyn Solvable<2>, g: [[f64; 2]; 2]) {
    let n = plane.points();
    let u = linear(plane, g);
    let (internal, own) = (force(plane, &u), energy(plane, &u));
    let plane = plane.as_plane().unwrap();
    let (strain, stiffness) = (strain_of(g), plane.stiffness());
    let stress = stiffness.map(|row| (0..3).map(|q| row[q] * strain[q]).sum::<f64>());
    let size = largest(&stress);
    let fields = plane.fields(&u);
    let strains = plane.strain(&fields.stress);
    let density = 0.5 * (0..3).map(|q| stress[q] * strain[q]).sum::<f64>();
    for p in 0..n {
        for q in 0..3 {
            assert!(
                (fields.stress[q][p] - stress[q]).abs() < 1e-12 * size,
                "{name} {p} {q}: {}",
                fields.stress[q][p]
            );
            assert!((strains[q][p] - strain[q]).abs() < 2e-15);
        }
        assert!((fields.energy_density[p] / density - 1.0).abs() < 1e-12, "{name} {p}");
    }
    let mut load = vec![0.0; 2 * n];
    plane.add_stress_load(None, &|_, _| stress, &mut load);
    assert!(difference(&load, &internal) < 1e-12 * largest(&internal), "{name}");
    let total = density * (0..n).map(|p| plane.volume(p)).sum::<f64>();
    assert!((own / total - 1.0).abs() < 1e-12, "{name}");
}

pub(super) fn check_rigid(name: &str, plane: &dyn Solvable<2>) {
    let scale = energy(plane, &linear(plane, [[1.0, 0.0], [0.0, 0.0]]));
    let n = plane.points();
    for kind in 0..3 {
        let centre = [5.0, -3.0, 0.0];
        let mut u = vec![0.0; 2 * n];
        for p in 0..n {
            let motion = crate::model::Model::rigid_motion(plane, kind, p, centre);
            (0..2).for_each(|c| u[c * n + p] = motion[c]);
        }
        // Energies are squares of measures that are rounded.
        let energy = energy(plane, &u);
        assert!(energy < 1e-24 * scale, "{name} {kind}: {energy:e} of {scale:e}");
    }
}

#[test]
fn uniform_strains_and_rigid_motions_are_exact_at_every_point() {
    for units in UNITS {
        for m in RATIOS {
            for influence in INFLUENCES {
                for state in [PlaneState::Stress, PlaneState::Strain] {
                    for (name, lattice) in bodies(units[0]) {
                        let mut parameters = PlaneParameters { influence, ..parameters(m, units) };
                        parameters.material.state = state;
                        let plane = plane(&lattice, parameters);
                        assert_eq!(plane.uncorrected(), 0, "{name}");
                        check_rigid(name, &plane);
                        STRAINS.iter().for_each(|&g| check_fields(name, &plane, g));
                    }
                }
            }
        }
    }
}

/// Weights are found in the axes of the lattice, strains and stresses are those of the plane.
#[test]
fn uniform_strains_are_exact_on_turned_lattices() {
    for units in UNITS {
        for m in [3.0, 4.0] {
            for (name, lattice) in turned_bodies(units[0]) {
                assert!(lattice.is_turned());
                let plane = plane(&lattice, parameters(m, units));
                check_rigid(name, &plane);
                STRAINS.iter().for_each(|&g| check_fields(name, &plane, g));
                let coarse = plane.coarser(&|_, _| Vec::new()).unwrap();
                check_fields(name, &*coarse, STRAINS[3]);
            }
        }
    }
}

#[test]
fn loads_of_a_uniform_stress_are_solved_by_the_linear_displacement() {
    for units in UNITS {
        for m in RATIOS {
            for (name, lattice) in bodies(units[0]).into_iter().chain(turned_bodies(units[0]).pop()) {
                let plane = plane(&lattice, parameters(m, units));
                let g = STRAINS[3];
                let stress = plane.parameters().material.stress(strain_of(g));
                let exact = linear(&plane, g);
                let mut load = vec![0.0; exact.len()];
                plane.add_stress_load(None, &|_, _| stress, &mut load);
                let u = solve(&plane, &load, &exact);
                let error = difference(&u, &exact) / largest(&exact);
                assert!(error < 1e-12, "{name} {m}: {error:e}");
            }
        }
    }
}

#[test]
fn without_overlay_edges_are_too_soft() {
    let (_, lattice) = &bodies(1.0)[0];
    let plane = plane(lattice, PlaneParameters { edges: Edges::None, ..parameters(3.0, MM_MPA) });
    let fields = plane.fields(&linear(&plane, STRAINS[0]));
    let exact = plane.parameters().material.c11() * 1e-3;
    let ratio = fields.stress[0].iter().map(|s| s / exact).fold(f64::INFINITY, f64::min);
    // The corner has the bonds of one quadrant alone, a little more than a quarter of the stiffness with those along the edges.
    assert!((0.25..0.45).contains(&ratio), "{ratio}");
    assert!(fields.stress[0].iter().any(|s| (s / exact - 1.0).abs() < 1e-14));
}

#[test]
fn loads_at_some_points_are_those_of_a_stress_that_is_zero_elsewhere() {
    let (_, lattice) = &bodies(1.0)[0];
    let plane = plane(lattice, parameters(3.0, MM_MPA));
    let points: Vec<usize> = (0..plane.points()).filter(|&p| plane.place(p)[0] < 3.0).collect();
    let stress = |_: usize, at: [f64; 2]| if at[0] < 3.0 { [1.0, at[1], 0.5] } else { [0.0; 3] };
    let mut loads = [vec![0.0; 2 * plane.points()], vec![0.0; 2 * plane.points()]];
    plane.add_stress_load(Some(&points), &stress, &mut loads[0]);
    plane.add_stress_load(None, &stress, &mut loads[1]);
    assert_eq!(loads[0], loads[1]);
    assert!(largest(&loads[0]) > 1.0);
}
