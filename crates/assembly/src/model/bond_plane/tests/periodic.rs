//! Bodies whose sides are joined.

use super::super::*;
use super::bodies::*;
use crate::body::Transfer;
use crate::condition::Constraints;
use crate::model::Points;
use crate::model::plane::{Calibration, Edges, Mirrors, PlaneModel, Solvable};

/// A rectangle of cells whose sides are joined along x, along y or both.
fn joined(size: [i32; 2], along: [bool; 2], parameters: PlaneParameters) -> BondPlane {
    let real = SquareLattice::rectangle(1.0, [0.0; 2], size);
    let mut mirrors = Mirrors { joined: [along[0], along[1], false], ..Mirrors::NONE };
    for side in (0..4).filter(|side| along[side / 2]) {
        mirrors.set_line(side, if side % 2 == 0 { 0 } else { size[side / 2] });
    }
    let extended = mirrors.extended(&real, BondPlane::depth(&parameters).unwrap());
    BondPlane::on_lattice(Arc::new(extended), mirrors, parameters, &[]).unwrap()
}

/// A displacement of real points by cell, with those of images.
fn displaced(body: &dyn Solvable<2>, at: impl Fn(Cell) -> [f64; 2]) -> Vec<f64> {
    let (lattice, mirrors) = body.lattice().unwrap();
    let n = body.points();
    let mut u = vec![0.0; 2 * n];
    for p in 0..n {
        let value = at(mirrors.image(lattice.cell(p)).0);
        (u[p], u[n + p]) = (value[0], value[1]);
    }
    u
}

/// Forces on real points by cell.
fn forces(body: &dyn Solvable<2>, u: &[f64]) -> impl Fn(Cell) -> [f64; 2] {
    let n = body.points();
    let mut f = force(body, u);
    let constraints = Constraints::new(n, &body.relations()).unwrap();
    constraints.restrict(&mut f);
    let lattice = body.lattice().unwrap().0.clone();
    move |cell| lattice.number(cell).map_or([0.0; 2], |p| [f[p], f[n + p]])
}

fn all_parameters() -> Vec<PlaneParameters> {
    let edges = [
        (Edges::Border, Calibration::Matched),
        (Edges::Overlay, Calibration::Matched),
        (Edges::None, Calibration::Published),
        (Edges::Volume, Calibration::Published),
    ];
    let each = |(edges, calibration)| {
        [2.0, 3.0].map(|m| PlaneParameters { edges, calibration, ..parameters(m, MM_MPA) })
    };
    edges.into_iter().flat_map(each).collect()
}

#[test]
fn a_period_is_a_part_of_several() {
    // Few rows, and a single one, are their own images several times over.
    for parameters in all_parameters() {
        for (size, along, copies) in [
            ([9, 1], [false, true], [1, 7]),
            ([9, 2], [false, true], [1, 3]),
            ([1, 8], [true, false], [4, 1]),
            ([5, 4], [true, true], [2, 2]),
            ([1, 1], [true, true], [8, 8]),
        ] {
            let whole = [size[0] * copies[0], size[1] * copies[1]];
            let (one, many) = (joined(size, along, parameters), joined(whole, along, parameters));
            let values = random(2 * (size[0] * size[1]) as usize);
            let at = |[i, j, _]: Cell| {
                let k = (i.rem_euclid(size[0]) + size[0] * j.rem_euclid(size[1])) as usize;
                [values[2 * k], values[2 * k + 1]]
            };
            let u = [displaced(&one, at), displaced(&many, at)];
            let energies = [energy(&one, &u[0]) * f64::from(copies[0] * copies[1]), energy(&many, &u[1])];
            let f = [forces(&one, &u[0]), forces(&many, &u[1])];
            let size_of_forces = largest(&force(&many, &u[1]));
            assert!((energies[0] - energies[1]).abs() <= 1e-13 * energies[1], "{energies:?}");
            for i in 0..size[0] {
                for j in 0..size[1] {
                    let [a, b] = [f[0]([i, j, 0]), f[1]([i, j, 0])];
                    (0..2).for_each(|c| assert!((a[c] - b[c]).abs() <= 1e-13 * size_of_forces));
                }
            }
        }
    }
}

#[test]
fn far_from_joined_sides_nothing_changes() {
    for parameters in all_parameters() {
        let (periodic, plain) =
            (joined([20, 20], [true; 2], parameters), joined([20, 20], [false; 2], parameters));
        let patch = |[i, j, _]: Cell| {
            let inside = (8..12).contains(&i) && (8..12).contains(&j);
            let value = f64::from((7 * i + 13 * j) % 11) - 5.0;
            if inside { [value, 0.3 * value * value] } else { [0.0; 2] }
        };
        let u = [displaced(&periodic, patch), displaced(&plain, patch)];
        let energies = [energy(&periodic, &u[0]), energy(&plain, &u[1])];
        assert!((energies[0] / energies[1] - 1.0).abs() < 1e-13);
        // What is moved over a joined side comes back on the other one.
        let moved = displaced(&periodic, |cell| patch(cell.map(|k| (k + 10).rem_euclid(20))));
        assert!((energy(&periodic, &moved) / energies[1] - 1.0).abs() < 1e-13);
    }
}

#[test]
fn a_strip_with_joined_sides_has_the_moduli_of_plane_strain() {
    // ε_xx alone; nothing moves along y.
    let parameters = parameters(3.0, MM_MPA);
    for rows in [1, 3, 4] {
        let strip = joined([12, rows], [false, true], parameters);
        let lattice = strip.lattice().unwrap().0.clone();
        let u = displaced(&strip, |cell| [lattice.place_of(cell)[0], 0.0]);
        let volume = 12.0 * f64::from(rows) * 25.0;
        let modulus = strip.stiffness()[0][0];
        assert!((energy(&strip, &u) / (0.5 * modulus * volume) - 1.0).abs() < 1e-13);
    }
}

#[test]
fn coarser_bodies_are_joined_where_whole_cells_leave_it_possible() {
    let parameters = parameters(3.0, MM_MPA);
    let none = |_: &SquareLattice, _: &[Cell]| Vec::new();
    assert!(joined([24, 9], [false, true], parameters).coarser(&none).is_none());
    let fine = joined([24, 12], [false, true], parameters);
    let coarse = fine.coarser(&none).unwrap();
    let (lattice, mirrors) = coarse.lattice().unwrap();
    assert_eq!((mirrors.lines[1], mirrors.joined), ([Some(0), Some(6)], [false, true, false]));
    assert_eq!(coarse.points() - coarse.ghosts().len(), 12 * 6);
    // Interpolation goes on over joined sides.
    let wave = |row: i32| (std::f64::consts::TAU * (f64::from(row) + 0.5) / 6.0).cos();
    let coarse_wave = displaced(&*coarse, |[_, j, _]| [wave(j), 0.0]);
    let (rows, sides) = fine.lattice().unwrap();
    let transfer = Transfer::new(rows, lattice, &|_| false, &|_, _| true);
    let mut fine_wave = vec![0.0; fine.points()];
    transfer.prolong_add(&coarse_wave[..coarse.points()], &mut fine_wave);
    for p in (0..fine.points()).filter(|&p| sides.is_real(rows.cell(p))) {
        let row = rows.cell(p)[1];
        let beside = if row % 2 == 0 { row / 2 - 1 } else { row / 2 + 1 };
        assert!((fine_wave[p] - 0.75 * wave(row / 2) - 0.25 * wave(beside)).abs() < 1e-14);
    }
}
