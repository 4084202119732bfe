//! Uniform strains and what holds of every energy.

use super::super::super::bond_plane::tests::bodies::{bodies, difference, largest, random, turned_bodies};
use super::*;
use crate::model::BodyModel;
use crate::model::Points;
use crate::model::plane::{PlaneModel, Solvable};

const STRAINS: [[f64; 2]; 3] = [[1e-3, 0.0], [0.0, 1e-3], [4e-4, -7e-4]];

fn linear(plate: &BondAntiplane, [x, y]: [f64; 2]) -> Vec<f64> {
    at_points(plate, |at| x * at[0] + y * at[1])
}

/// Stress and energy of every point, and the load that belongs to the stress.
fn check(name: &str, plate: &BondAntiplane, strain: [f64; 2]) {
    let (n, g) = (plate.points(), plate.parameters().shear_modulus);
    let w = linear(plate, strain);
    let fields = plate.fields(&w);
    let (stress, density) = (strain.map(|s| g * s), 0.5 * g * strain.iter().map(|s| s * s).sum::<f64>());
    for p in 0..n {
        for q in 0..2 {
            let error = fields.stress[q][p] - stress[q];
            // 5e-15 measured, of turned lattices.
            assert!(error.abs() < 1e-13 * g * 1e-3, "{name} {p}: {error:e}");
        }
        assert_eq!(fields.stress[2][p], 0.0);
        assert!((fields.energy_density[p] / density - 1.0).abs() < 1e-12, "{name} {p}");
    }
    let mut load = vec![0.0; n];
    plate.add_stress_load(None, &|_, _| [stress[0], stress[1], 0.0], &mut load);
    let internal = force(plate, &w);
    let off = difference(&load, &internal) / largest(&internal);
    assert!(off < 1e-12, "{name}: {off:e}");
    let volume: f64 = (0..n).map(|p| plate.volume(p)).sum();
    let off = (energy(plate, &w) / (density * volume) - 1.0).abs();
    // Where corners of two borders meet in one cell, parts are sampled, as with central bonds.
    assert!(off < if plate.follows_border() { 2e-4 } else { 1e-12 }, "{name}: {off:e}");
}

#[test]
fn uniform_strains_are_exact_at_every_point() {
    for horizon_ratio in [1.0, 2.0, 3.0, 3.015, 4.0] {
        for influence in [Influence::Constant, Influence::Inverse, Influence::Linear] {
            // All next neighbours are at the horizon.
            if horizon_ratio == 1.0 && influence == Influence::Linear {
                continue;
            }
            for (name, lattice) in bodies(1e-3).into_iter().chain(turned_bodies(1e-3)) {
                for edges in [Edges::Overlay, Edges::Border] {
                    let plate =
                        plate(&lattice, AntiplaneParameters { horizon_ratio, influence, edges, ..PLATE });
                    assert_eq!(plate.uncorrected(), 0, "{name}");
                    STRAINS.iter().for_each(|&strain| check(name, &plate, strain));
                    let coarse = plate.coarser(&|_, _| Vec::new()).unwrap();
                    assert_eq!(coarse.components(), plate.components());
                }
            }
        }
    }
}

#[test]
fn loads_of_a_uniform_stress_are_solved_by_the_linear_displacement() {
    for (name, lattice) in bodies(1.0) {
        let plate = plate(&lattice, PLATE);
        let exact = linear(&plate, STRAINS[2]);
        let mut load = vec![0.0; exact.len()];
        let stress = STRAINS[2].map(|s| PLATE.shear_modulus * s);
        plate.add_stress_load(None, &|_, _| [stress[0], stress[1], 0.0], &mut load);
        let start = (0..exact.len()).map(|p| if p == 0 { exact[0] } else { 0.0 }).collect();
        let w = solve(&plate, start, &load, |p| p == 0);
        // 1.2e-14 measured.
        let error = difference(&w, &exact) / largest(&exact);
        assert!(error < 1e-12, "{name}: {error:e}");
    }
}

#[test]
fn without_overlay_edges_are_too_soft() {
    let (_, lattice) = &bodies(1.0)[0];
    let plate = plate(lattice, AntiplaneParameters { edges: Edges::None, ..PLATE });
    let stress = &plate.fields(&linear(&plate, STRAINS[0])).stress[0];
    let least = stress.iter().fold(f64::INFINITY, |a, b| a.min(b / (1e-3 * PLATE.shear_modulus)));
    assert!((0.25..0.45).contains(&least), "{least}");
}

#[test]
fn forces_are_the_slope_of_the_energy_and_translations_are_free() {
    let (_, lattice) = &bodies(1.0)[1];
    let plate = plate(lattice, PLATE);
    let (w, step) = (random(plate.points()), random(plate.points()).into_iter().rev().collect::<Vec<_>>());
    let moved = |t: f64| energy(&plate, &w.iter().zip(&step).map(|(w, s)| w + t * s).collect::<Vec<_>>());
    let slope: f64 = force(&plate, &w).iter().zip(&step).map(|(f, s)| f * s).sum();
    // The energy is quadratic: the difference has rounding alone.
    assert!(((moved(1.0) - moved(-1.0)) / (2.0 * slope) - 1.0).abs() < 1e-12);
    let ones = vec![1.0; plate.points()];
    assert_eq!(largest(&force(&plate, &ones)), 0.0);
}

#[test]
fn half_a_plate_is_a_whole_one() {
    let whole = Arc::new(SquareLattice::plane(1.0, [-9.0, 0.0], 0..18, 0..11, |[i, j]| {
        (f64::from(i) - 8.5).hypot(f64::from(j) - 5.0) > 2.6
    }));
    let mirrors = Mirrors::in_plane([Some(9), None], [None; 2]);
    for edges in [Edges::Overlay, Edges::Border] {
        let parameters = AntiplaneParameters { edges, ..PLATE };
        let full = plate(&whole, parameters);
        let depth = BondAntiplane::depth(&parameters).unwrap();
        let half = Arc::new(mirrors.extended(&mirrors.real(&whole), depth));
        let half = BondAntiplane::on_lattice(half, mirrors, parameters, &[]).unwrap();
        let even = |[x, y]: [f64; 2]| (0.1 * x * x).cos() + 0.3 * y;
        let (w, image) = (at_points(&full, even), at_points(&half, even));
        assert!((energy(&full, &w) / (2.0 * energy(&half, &image)) - 1.0).abs() < 1e-13);
        let (stress, own) = (full.fields(&w).stress, half.fields(&image).stress);
        for p in (0..half.points()).filter(|&p| half.volume(p) > 0.0) {
            let same = full.body.lattice.number(half.body.lattice.cell(p)).unwrap();
            (0..2).for_each(|q| assert!((own[q][p] - stress[q][same]).abs() < 1e-12 * PLATE.shear_modulus));
        }
        // A load of a stress does not know the line either.
        let load = |plate: &BondAntiplane| {
            let mut load = vec![0.0; plate.points()];
            plate.add_stress_load(None, &|_, [x, y]| [x, 1.0 + y, 0.0], &mut load);
            load
        };
        let (all, mut own) = (load(&full), load(&half));
        for equation in half.relations() {
            let [(ghost, _), (real, _)] = equation.terms[..] else { panic!("an image has a real point") };
            own[real.point] += std::mem::take(&mut own[ghost.point]);
        }
        for p in (0..half.points()).filter(|&p| half.volume(p) > 0.0) {
            let same = full.body.lattice.number(half.body.lattice.cell(p)).unwrap();
            assert!((own[p] - all[same]).abs() < 1e-12 * largest(&all));
        }
    }
}
