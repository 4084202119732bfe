//! Points with weights of their own.

use super::*;
use crate::body::plus;

/// Weights of the second table: those of one offset are zero, those of another in part.
fn others() -> Vec<[f64; 3]> {
    let mut all: Vec<[f64; 3]> = (0..STEPS.len()).map(|k| [2.0, 0.5 + k as f64, 3.0]).collect();
    (all[4], all[2]) = ([0.0; 3], [1.5, 0.0, 0.25]);
    all
}

/// Weights of a bond between the tables, also where those of one table are zero.
fn between(offset: usize) -> [f64; 3] {
    [0.75, 1.75 + offset as f64, 2.75]
}

/// The second table lies in an oblique stripe.
fn table(cell: Cell) -> u8 {
    u8::from((60..90).contains(&(cell[0] + 2 * cell[1])))
}

/// A lattice of two tables, and the list of its bonds.
fn both(exceptions: &[Exception]) -> (GridBonds<3, 3, BeamLike>, Bonds<3, 3>) {
    let lattice = lattice();
    let tables: Vec<u8> = (0..lattice.points()).map(|p| table(lattice.cell(p))).collect();
    let (mut across, mut list) = (Vec::new(), Vec::new());
    for (offset, (Offset { step, weights }, other)) in offsets::<3>().into_iter().zip(others()).enumerate() {
        for lower in 0..lattice.points() {
            let Some(upper) = lattice.number(plus(lattice.cell(lower), step)) else { continue };
            let own = match [tables[lower], tables[upper]] {
                [0, 0] => weights,
                [1, 1] => other,
                _ => between(offset),
            };
            if tables[lower] != tables[upper] {
                across.push(Between { offset, lower, weights: own });
            }
            let bond = BondGeometry { xi: lattice.vector(step) };
            let mine = exceptions.iter().filter(|e| (e.offset, e.lower) == (offset, lower));
            let factor: f64 = mine.map(|e| e.factor).product();
            let (rows, unit) = (BeamLike.rows(&bond), BeamLike.moduli(&bond));
            let moduli = std::array::from_fn(|m| factor * own[m] * unit[m]);
            if moduli != [0.0; 3] {
                list.push(Bond { points: [lower as u32, upper as u32], rows, moduli });
            }
        }
    }
    let tables = Tables { of: &tables, others: &[others()], between: &across };
    let grid = GridBonds::of_tables(lattice.clone(), &BeamLike, &offsets(), exceptions, tables);
    (grid, Bonds::new(lattice.points(), list.into_iter()))
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn a_lattice_of_two_tables_is_the_list_of_its_bonds() {
    for exceptions in [Vec::new(), exceptions(&lattice())] {
        let (grid, list) = both(&exceptions);
        assert_eq!(grid.elements(), list.elements());
        let n = grid.lattice().points();
        let u = random(3 * n);
        let mut forces = [vec![0.0; u.len()], vec![0.0; u.len()]];
        grid.add_force(&u, &mut forces[0]);
        list.add_force(&u, &mut forces[1]);
        // Found 7.1e-15, of forces of up to 22.
        assert!(largest_difference(&forces[0], &forces[1]) < 2e-14);
        // Found 4.4e-6.
        assert!(largest_of_single(&grid, &u, &forces[1]) < 1e-5);
        assert!((grid.survey(&u).energy / list.survey(&u).energy - 1.0).abs() < 1e-13);
        let mut energy = 0.0;
        grid.for_each_with_moduli(|offset, ends, moduli| {
            let rows = BeamLike.rows(&BondGeometry { xi: grid.lattice().vector(STEPS[offset]) });
            let s = Bond { points: ends.map(|p| p as u32), rows, moduli }.response(n, &u).0;
            energy += (0..3).map(|m| 0.5 * moduli[m] * s[m] * s[m]).sum::<f64>();
        });
        assert!((energy / list.survey(&u).energy - 1.0).abs() < 1e-13);
    }
}

#[test]
fn its_matrix_and_its_diagonal_are_those_of_the_list() {
    let exceptions = exceptions(&lattice());
    let (grid, list) = both(&exceptions);
    let n = grid.lattice().points();
    let [of_grid, of_list] = [Box::new(grid) as Box<dyn Term<3>>, Box::new(list)].map(|term| {
        let terms = [term];
        let mut matrix = BlockMatrix::sparse(n, &terms);
        terms[0].add_tangent(&mut matrix);
        let mut entries = Vec::new();
        matrix.for_each_entry(|row, column, value| entries.push((row, column, value)));
        let mut diagonal = vec![[[0.0; 3]; 3]; n];
        terms[0].add_diagonal(&mut diagonal);
        (entries, diagonal)
    });
    assert_eq!(of_grid.0.len(), of_list.0.len());
    for (a, b) in of_grid.0.iter().zip(&of_list.0) {
        assert!((a.0, a.1) == (b.0, b.1) && (a.2 - b.2).abs() < 1e-13, "{a:?} {b:?}");
    }
    let flat = |diagonal: &[Mat<3, 3>]| diagonal.iter().flatten().flatten().copied().collect::<Vec<f64>>();
    assert!(largest_difference(&flat(&of_grid.1), &flat(&of_list.1)) < 1e-13);
}

#[test]
fn sums_and_their_adjoint_do_the_same_work() {
    let (grid, _) = both(&exceptions(&lattice()));
    let n = grid.lattice().points();
    let shares: Vec<Mat<2, 3>> = (0..6).map(|k| [[0.5, 1.0, k as f64], [1.0, -2.0, 0.25]]).collect();
    let (u, t) = (random(3 * n), random(2 * n));
    let sums = grid.sums::<2>(&u, &shares);
    let mut force = vec![0.0; 3 * n];
    grid.add_work::<2>(&t, &vec![0..150; 12], &shares, &mut force);
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (work, adjoint) = (product(&t, &sums[..2 * n]), product(&u, &force));
    assert!((work - adjoint).abs() < 1e-13 * work.abs(), "{work} {adjoint}");
    // Half of every bond is at either end.
    let energy: f64 = sums[2 * n..].iter().sum();
    assert!((energy / grid.survey(&u).energy - 1.0).abs() < 1e-13);
}

#[test]
fn bonds_between_tables_break() {
    let (mut grid, _) = both(&[]);
    let across = |grid: &GridBonds<3, 3, BeamLike>| {
        let mut all = Vec::new();
        grid.for_each_bond(|offset, ends, _| {
            let [a, b] = ends.map(|p| table(grid.lattice().cell(p)));
            if a != b {
                all.push((offset, ends[0]));
            }
        });
        all
    };
    let (before, bonds) = (grid.elements(), across(&grid));
    assert!(bonds.len() > 100);
    for &(offset, lower) in &bonds {
        let bond = grid.bond(offset, lower).unwrap();
        let unit = BeamLike.moduli(&BondGeometry { xi: grid.lattice().vector(STEPS[offset]) });
        for m in 0..3 {
            assert!((bond.moduli[m] - between(offset)[m] * unit[m]).abs() < 1e-15);
        }
    }
    grid.break_bonds(bonds.iter().copied());
    assert_eq!((grid.elements(), across(&grid).len()), (before - bonds.len(), 0));
    let mut joined = ConnectedParts::new(grid.lattice().points());
    Term::<3>::join(&grid, &mut joined);
    assert_eq!(joined.numbered().spans().len(), 3);
}
