//! An eighth of a body with three planes of symmetry is the whole one.

use super::*;
use crate::condition::Constraints;
use crate::model::bond_plane::tests::bodies::{difference, largest};

/// A block with a hole through its middle, symmetric about the planes through the origin; cells of two faces have a part of their
/// volume.
fn whole(part: f64) -> SquareLattice {
    let hole = |[i, j, _]: [i32; 3]| (-2..2).contains(&i) && (-1..1).contains(&j);
    let all = SquareLattice::new(1.0, [0.0; 3], [-5..5, -4..4, -3..3], |cell| !hole(cell));
    let outer = |cell: [i32; 3]| if cell[0] == 4 || cell[0] == -5 { Some((cell, part)) } else { None };
    let areas: Vec<([i32; 3], f64)> = (0..all.points()).filter_map(|p| outer(all.cell(p))).collect();
    all.with_areas(&areas)
}

fn check(full: &dyn Solvable<3>, part: &dyn Solvable<3>) {
    let odd = |[x, y, z]: Point| {
        [x * (1.0 + 0.1 * y * y - 0.02 * z * z), 0.3 * y * x.abs(), z * (0.2 * x * x + y.abs()) - 0.1 * z]
    };
    let (u, own) = (planes(full, odd), planes(part, odd));
    assert!((energy(full, &u) / (8.0 * energy(part, &own)) - 1.0).abs() < 1e-13);
    let (all, fields) = (full.as_solid().unwrap().fields(&u), part.as_solid().unwrap().fields(&own));
    let (mut load, mut folded) = (vec![0.0; u.len()], vec![0.0; own.len()]);
    let stress = |_: usize, [x, y, _]: Point| [1.0 + x * x, 0.4, y.abs(), 0.0, 0.0, 0.0];
    full.as_solid().unwrap().add_stress_load(&stress, &mut load);
    part.as_solid().unwrap().add_stress_load(&stress, &mut folded);
    let constraints = Constraints::new(part.points(), &part.relations()).unwrap();
    let mut internal = force(part, &own);
    for forces in [&mut folded, &mut internal] {
        for row in constraints.rows() {
            let value = std::mem::take(&mut forces[row.unknown]);
            row.masters.iter().for_each(|&(master, c)| forces[master] += c * value);
        }
    }
    let whole_force = force(full, &u);
    for p in (0..part.points()).filter(|&p| part.volume(p) > 0.0) {
        let same = full.lattice().unwrap().0.number(part.lattice().unwrap().0.cell(p)).unwrap();
        let here = |v: &[f64]| [0, 1, 2].map(|c| v[c * part.points() + p]);
        let there = |v: &[f64]| [0, 1, 2].map(|c| v[c * full.points() + same]);
        assert!(difference(&here(&folded), &there(&load)) < 1e-12 * largest(&load));
        assert!(difference(&here(&internal), &there(&whole_force)) < 1e-12 * largest(&whole_force));
        for q in 0..6 {
            assert!((fields.stress[q][p] - all.stress[q][same]).abs() < 1e-12 * largest(&all.stress[q]));
        }
        assert!((fields.energy_density[p] / all.energy_density[same] - 1.0).abs() < 1e-11);
    }
}

const MIRRORS: Mirrors = Mirrors { lines: [[Some(0), None]; 3], ..Mirrors::NONE };

fn eighth(full: &SquareLattice, depth: i32) -> Arc<SquareLattice> {
    Arc::new(MIRRORS.extended(&MIRRORS.real(full), depth))
}

#[test]
fn an_eighth_is_the_whole_body() {
    for (part, edges) in [(0.6, SolidEdges::Overlay), (1.0, SolidEdges::Overlay), (1.0, SolidEdges::Border)] {
        let full = Arc::new(whole(part));
        for horizon_ratio in [2.0, 3.0] {
            let bonds = BondSolidParameters { horizon_ratio, edges, ..BONDS };
            let body = BondSolid::on_lattice(full.clone(), Mirrors::NONE, bonds, &[]).unwrap();
            assert_eq!(body.faces(), edges);
            let part = eighth(&full, BondSolid::depth(&bonds).unwrap());
            check(&body, &BondSolid::on_lattice(part, MIRRORS, bonds, &[]).unwrap());
            let state = StateSolidParameters { horizon_ratio, edges, ..STATE };
            let body = StateSolid::on_lattice(full.clone(), Mirrors::NONE, state, &[]).unwrap();
            assert_eq!(body.faces(), edges);
            let part = eighth(&full, StateSolid::depth(&state).unwrap());
            check(&body, &StateSolid::on_lattice(part, MIRRORS, state, &[]).unwrap());
        }
    }
}

/// Cells behind the last column are copies of the first ones: the body goes on for ever.
#[test]
fn joined_sides_have_no_faces() {
    let mirrors = Mirrors {
        lines: [[Some(0), Some(6)], [None; 2], [None; 2]],
        joined: [true, false, false],
        ..Mirrors::NONE
    };
    let real = SquareLattice::cuboid(1.0, [0.0; 3], [6, 5, 4]);
    let strain = [0.0, 0.7, -0.2, 0.5, 0.0, 0.0];
    for edges in [SolidEdges::Overlay, SolidEdges::Border] {
        let parameters = BondSolidParameters { edges, ..BONDS };
        let cells = mirrors.extended(&real, BondSolid::depth(&parameters).unwrap());
        let solid = BondSolid::on_lattice(Arc::new(cells), mirrors, parameters, &[]).unwrap();
        assert_eq!((solid.faces(), solid.uncorrected()), (edges, 0));
        let u = linear(&solid, gradient(strain));
        let c = solid.stiffness();
        let stress = c.map(|row| (0..6).map(|q| row[q] * strain[q]).sum::<f64>());
        let density = 0.5 * (0..6).map(|q| stress[q] * strain[q]).sum::<f64>();
        assert!((energy(&solid, &u) / (120.0 * density) - 1.0).abs() < 1e-12);
        let fields = solid.fields(&u);
        for p in (0..solid.points()).filter(|&p| solid.volume(p) > 0.0) {
            (0..6).for_each(|q| assert!((fields.stress[q][p] - stress[q]).abs() < 1e-12, "{p} {q}"));
        }
    }
}
