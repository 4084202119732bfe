//! Bonds that end on the border: uniform stresses are in equilibrium, whatever the border of cells.

use super::super::*;
use super::bodies::*;
use super::patch::{STRAINS, check_fields, check_rigid};
use crate::body::in_space;
use crate::body::plus;
use crate::model::Points;
use crate::model::plane::{Edges, PlaneModel};

fn bordered(m: f64) -> PlaneParameters {
    PlaneParameters { edges: Edges::Border, ..parameters(m, MM_MPA) }
}

/// A rectangle, an L, a square with a square hole, a staircase disc, a comb with a notch two cells wide.
fn staircases() -> Vec<(&'static str, Arc<SquareLattice>)> {
    let make = |columns: i32, rows: i32, inside: &dyn Fn(i32, i32) -> bool| {
        Arc::new(SquareLattice::plane(1.0, [0.3, -2.0], 0..columns, 0..rows, |[i, j]| inside(i, j)))
    };
    let middle = |i: i32| f64::from(i) - 6.5;
    vec![
        ("rectangle", make(14, 10, &|_, _| true)),
        ("L", make(12, 12, &|i, j| i < 6 || j < 6)),
        ("square hole", make(13, 13, &|i, j| !((5..8).contains(&i) && (5..8).contains(&j)))),
        ("disc", make(14, 14, &|i, j| middle(i).hypot(middle(j)) < 6.4)),
        ("notch", make(12, 10, &|i, j| !((5..7).contains(&i) && j > 4))),
    ]
}

#[test]
fn uniform_strains_are_exact_on_staircases() {
    for m in [2.0, 2.5, 3.0, 4.0, 5.0] {
        for (name, lattice) in staircases() {
            let plane = plane(&lattice, bordered(m));
            assert_eq!((plane.uncorrected(), BodyModel::edges(&plane)), (0, Some(Edges::Border)), "{name}");
            check_rigid(name, &plane);
            STRAINS.iter().for_each(|&g| check_fields(&format!("{name} {m}"), &plane, g));
        }
    }
}

/// Forces of the tractions of a uniform stress on the sides of the cells, by what moves the border.
fn through_border(plane: &BondPlane, lattice: &SquareLattice, [xx, yy, xy]: [f64; 3]) -> Vec<f64> {
    let (n, h, t) = (plane.points(), lattice.spacing(), plane.parameters().material.thickness);
    let shares = plane.border_shares().unwrap();
    let mut force = vec![0.0; 2 * n];
    for point in 0..n {
        let (cell, at) = (lattice.cell(point), lattice.place(point));
        for [a, b] in [[1, 0], [-1, 0], [0, 1], [0, -1]] {
            if lattice.number(plus(cell, [a, b, 0])).is_some() {
                continue;
            }
            let normal = [f64::from(a), f64::from(b)];
            let middle = [0, 1].map(|k| at[k] + 0.5 * h * normal[k]);
            let traction = [xx * normal[0] + xy * normal[1], xy * normal[0] + yy * normal[1]];
            for (p, share) in shares(in_space(middle), in_space(normal)).unwrap() {
                (0..2).for_each(|k| force[k * n + p] += share * h * t * traction[k]);
            }
        }
    }
    force
}

/// The load of a uniform stress on the bonds is that of its tractions on the border, which knows no bonds.
#[test]
fn tractions_on_the_border_hold_every_uniform_stress() {
    for m in [2.0, 3.0, 4.0] {
        for (name, lattice) in staircases() {
            let plane = plane(&lattice, bordered(m));
            for stress in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.7, -1.3, 0.4]] {
                let strain = plane.strain_of(stress);
                let u = linear(&plane, [[strain[0], 0.5 * strain[2]], [0.5 * strain[2], strain[1]]]);
                let (internal, load) = (force(&plane, &u), through_border(&plane, &lattice, stress));
                // At most 4e-14 is found.
                let off = difference(&internal, &load) / largest(&load);
                assert!(off < 2e-13, "{name} {m} {stress:?}: {off:e}");
            }
        }
    }
}

/// Numbers of an independent implementation (numpy) of border nodes: a block of 7 x 5 points, E = 1, m = 3.
#[test]
fn the_stiffness_is_that_of_another_implementation() {
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [7, 5]));
    let unit = PlaneParameters { edges: Edges::Border, ..parameters(3.0, [1.0, 1.0, 1.0]) };
    let plane = plane(&lattice, unit);
    let column = |unknown: usize| {
        let mut u = vec![0.0; 2 * plane.points()];
        u[unknown] = 1.0;
        force(&plane, &u)[unknown]
    };
    // Along x of the points [0, 0] and [1, 0].
    assert!((column(0) - 2.087_177_832_659_624_4).abs() < 1e-14, "{}", column(0));
    assert!((column(1) - 1.772_223_064_089_304).abs() < 1e-14, "{}", column(1));
}

#[test]
fn thin_and_cut_bodies_have_the_overlay() {
    let row = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [7, 1]));
    assert_eq!(BodyModel::edges(&plane(&row, bordered(3.0))), Some(Edges::Overlay));
    let cut = SquareLattice::rectangle(1.0, [0.0; 2], [7, 5]).with_areas(&[([3, 4, 0], 0.7)]);
    assert_eq!(BodyModel::edges(&plane(&Arc::new(cut), bordered(3.0))), Some(Edges::Overlay));
}
