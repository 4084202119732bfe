mod solid;

use super::*;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

/// A ring of 5 × 4 cells with a hole of 2 × 2 and a notch on the right.
fn ring() -> SquareLattice {
    let hole = |[i, j]: [i32; 2]| (1..3).contains(&i) && (1..3).contains(&j);
    SquareLattice::plane(0.5, [1.0, -2.0], 0..5, 0..4, |c| !hole(c) && c != [4, 2])
}

#[test]
fn numbers_and_cells_are_inverse() {
    let lattice = ring();
    assert_eq!(lattice.points(), 15);
    assert_eq!(lattice.runs().len(), 6);
    for p in 0..lattice.points() {
        assert_eq!(lattice.number(lattice.cell(p)), Some(p));
    }
    assert_eq!(lattice.number([1, 1, 0]), None);
    assert_eq!(lattice.number([4, 2, 0]), None);
    assert_eq!(lattice.number([0, 4, 0]), None);
    assert_eq!(lattice.position(0), [1.25, -1.75, 0.0]);
    assert_eq!(lattice.cell_at([3.4, -1.6]), [4, 0, 0]);
}

#[test]
fn a_coarse_cell_exists_if_any_child_does() {
    let coarse = ring().coarser();
    let cells: Vec<Cell> = (0..coarse.points()).map(|p| coarse.cell(p)).collect();
    // The hole covers one child of each of four coarse cells; nothing vanishes.
    assert_eq!(cells, [[0, 0, 0], [1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [2, 1, 0]]);
    assert_eq!((coarse.spacing(), coarse.corner()), (1.0, [1.0, -2.0, -0.5]));
    let far = SquareLattice::plane(1.0, [0.0; 2], -3..-1, 5..6, |_| true).coarser();
    assert_eq!(far.runs(), [Run { row: 2, layer: 0, columns: -2..0, first: 0 }]);
}

#[test]
fn areas_of_coarse_cells_are_sums() {
    let fine = ring().with_areas(&[([0, 0, 0], 0.5), ([4, 1, 0], 1.25), ([2, 2, 0], 9.0), ([3, 3, 0], 1.0)]);
    // The cell in the hole is none, and one of area one is whole.
    assert_eq!(fine.cut_cells(), [(0, 0.5), (7, 1.25)]);
    assert_eq!((fine.fraction(7), fine.fraction(8), fine.area(0)), (1.25, 1.0, 0.125));
    let coarse = fine.coarser();
    let parts: Vec<f64> = (0..coarse.points()).map(|p| coarse.fraction(p)).collect();
    assert_eq!(parts, [0.625, 0.75, 0.5625, 0.75, 0.75, 0.25]);
    let area = |l: &SquareLattice| (0..l.points()).map(|p| l.area(p)).sum::<f64>();
    assert_eq!(area(&coarse), area(&fine));
    assert_eq!(fine.with_whole_cells(), ring());
}

#[test]
fn stretches_of_neighbours_are_complete() {
    let lattice = ring();
    for step in [[1, 0, 0], [-2, 1, 0], [0, 2, 0], [3, 1, 0], [1, -1, 0]] {
        let mut found = Vec::new();
        for run in lattice.runs() {
            lattice.shifted(run.line(), &run.columns, step, |columns, first| {
                columns.zip(first..).for_each(|(i, q)| found.push((run.number(i), q)));
            });
        }
        let expected: Vec<(usize, usize)> = (0..lattice.points())
            .filter_map(|p| Some((p, lattice.number(plus(lattice.cell(p), step))?)))
            .collect();
        assert_eq!(found, expected);
    }
}

#[test]
fn a_rectangle_is_one_run_per_row() {
    let made = SquareLattice::rectangle(2.0, [0.0; 2], [7, 3]);
    assert_eq!(made, SquareLattice::plane(2.0, [0.0; 2], 0..7, 0..3, |_| true));
}

#[test]
fn rows_along_x_have_the_bits_of_corner_and_spacing() {
    let (h, corner) = (0.1 / 3.0, [1.0 / 3.0, -0.7]);
    let made = SquareLattice::plane(h, corner, -3..4, -2..5, |_| true);
    for angle in [0.0, -0.0, FRAC_PI_2, -PI, 3.0 * FRAC_PI_2] {
        let lattice = made.clone().turned(angle, [5.0, 7.0]);
        assert_eq!(lattice, made);
        assert_eq!((lattice.is_turned(), lattice.angle()), (false, 0.0));
        assert_eq!(lattice.axes(), [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
        let [x, y, _] = lattice.corner();
        assert_eq!([x, y].map(f64::to_bits), corner.map(f64::to_bits));
        for p in 0..lattice.points() {
            let cell = lattice.cell(p);
            let bits = |at: [f64; 3]| at.map(f64::to_bits);
            let along = |k: usize| corner[k] + (f64::from(cell[k]) + 0.5) * h;
            assert_eq!(bits(lattice.centre(cell)), bits([along(0), along(1), 0.0]));
            assert_eq!(bits(lattice.vector(cell)), bits(cell.map(|k| h * f64::from(k))));
        }
    }
}

proptest! {
    #[test]
    fn turned_cells_are_found_at_their_centres(
        angle in -4.0..4.0f64, h in 1e-3..10.0f64, corner in [-9.0..9.0f64, -9.0..9.0], origin in [-9.0..9.0f64, -9.0..9.0],
    ) {
        let made = SquareLattice::plane(h, corner, -7..8, -5..9, |[i, j]| i != j);
        let lattice = made.clone().turned(angle, origin);
        let (sin, cos) = angle.sin_cos();
        // Rounding of positions, which are below 300.
        let same = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-12;
        for p in 0..lattice.points() {
            let cell = lattice.cell(p);
            prop_assert_eq!(cell, made.cell(p));
            prop_assert_eq!(lattice.cell_at(lattice.place_of(cell)), cell);
            let [x, y] = made.place(p);
            let place = [origin[0] + cos * x - sin * y, origin[1] + sin * x + cos * y];
            prop_assert!(same(lattice.place(p), place));
            let next = lattice.place_of(plus(cell, [3, -2, 0]));
            let ([a, b, _], at) = (lattice.vector([3, -2, 0]), lattice.place(p));
            prop_assert!(same(next, [at[0] + a, at[1] + b]));
            let node = [cell[0], cell[1]];
            let [i, j] = lattice.in_cells(lattice.node(node));
            prop_assert!(same([i * h, j * h], node.map(|k| f64::from(k) * h)));
        }
        // Four cells lie around the centre of the coarser one.
        let coarse = lattice.coarser();
        prop_assert_eq!(coarse.axes(), lattice.axes());
        for p in 0..coarse.points() {
            let [i, j, _] = coarse.cell(p);
            prop_assert!(same(coarse.place(p), lattice.node([2 * i + 1, 2 * j + 1])));
        }
    }
}

#[test]
fn segments_cross_rows_columns_and_diagonals() {
    let lattice = SquareLattice::rectangle(2.0, [1.0, 3.0], [4, 4]);
    // From the point of cell [0, 0] along its row, to the middle between two points: one diagonal falls there, one rises.
    assert_eq!(lattice.crossings([2.0, 4.0], [5.0, 4.0]), [0.0, 2.0 / 3.0, 1.0]);
    // Half a spacing beyond the points of the first row.
    assert_eq!(lattice.crossings([1.0, 3.0], [5.0, 3.0]), [0.0, 0.25, 0.5, 0.75, 1.0]);
    assert_eq!(lattice.crossings([2.2, 4.1], [2.3, 4.1]), [0.0, 1.0]);
    assert_eq!(lattice.crossings([2.0, 4.0], [2.0, 4.0]), [0.0, 1.0]);
}
