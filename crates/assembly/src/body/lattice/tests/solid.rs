//! Lattices of several layers.

use super::*;

/// 5 × 4 × 3 cells, without the middle of each layer but the last and without one corner.
fn shell() -> SquareLattice {
    let inside = |[i, j, k]: Cell| k == 2 || !((1..3).contains(&i) && (1..3).contains(&j));
    SquareLattice::new(0.5, [1.0, -2.0, 3.0], [0..5, 0..4, 0..3], |c| inside(c) && c != [4, 3, 2])
}

#[test]
fn cells_are_numbered_layer_by_layer() {
    let lattice = shell();
    assert_eq!(lattice.points(), 16 + 16 + 19);
    assert_eq!((lattice.rows(), lattice.layers(), lattice.columns()), (0..4, 0..3, 0..5));
    for p in 0..lattice.points() {
        assert_eq!(lattice.number(lattice.cell(p)), Some(p));
    }
    assert_eq!((lattice.cell(0), lattice.cell(16), lattice.cell(32)), ([0; 3], [0, 0, 1], [0, 0, 2]));
    for outside in [[1, 1, 1], [4, 3, 2], [0, 4, 0], [0, 0, 3], [0, 0, -1], [-1, 0, 0]] {
        assert_eq!(lattice.number(outside), None);
    }
    assert_eq!(lattice.position(16), [1.25, -1.75, 3.75]);
    assert_eq!(lattice.vector([1, -2, 3]), [0.5, -1.0, 1.5]);
    assert_eq!((lattice.volume(0), lattice.is_plane()), (0.125, false));
}

#[test]
fn a_box_is_one_run_per_row_and_one_layer_is_a_plane() {
    let made = SquareLattice::cuboid(2.0, [0.0; 3], [7, 3, 4]);
    assert_eq!(made, SquareLattice::new(2.0, [0.0; 3], [0..7, 0..3, 0..4], |_| true));
    let plane = SquareLattice::rectangle(2.0, [0.0; 2], [7, 3]);
    assert_eq!(plane, SquareLattice::cuboid(2.0, [0.0, 0.0, -1.0], [7, 3, 1]));
}

#[test]
fn stretches_of_neighbours_are_complete_across_layers() {
    let lattice = shell();
    for step in [[1, 0, 0], [0, 0, 1], [-2, 1, 1], [1, -1, 2], [0, 3, -1], [0, 0, 3]] {
        let mut found = Vec::new();
        for run in lattice.runs() {
            lattice.shifted(run.line(), &run.columns, step, |columns, first| {
                columns.zip(first..).for_each(|(i, q)| found.push((run.number(i), q)));
            });
        }
        let other = |p: usize| Some((p, lattice.number(plus(lattice.cell(p), step))?));
        assert_eq!(found, (0..lattice.points()).filter_map(other).collect::<Vec<_>>());
    }
}

#[test]
fn eight_cells_become_one() {
    let fine = shell().with_areas(&[([0; 3], 0.5), ([4, 1, 2], 1.5)]);
    let coarse = fine.coarser();
    // Every block of eight has a cell, and the last layer is halves of cells.
    assert_eq!((coarse.points(), coarse.layers()), (3 * 2 * 2, 0..2));
    assert_eq!((coarse.spacing(), coarse.corner()), (1.0, [1.0, -2.0, 3.0]));
    assert_eq!(coarse.fraction(0), 5.5 / 8.0);
    let volume = |l: &SquareLattice| (0..l.points()).map(|p| l.volume(p)).sum::<f64>();
    assert!((volume(&coarse) / volume(&fine) - 1.0).abs() < 1e-15);
    // Children lie around the centre of their parent.
    for cell in (0..fine.points()).map(|p| fine.cell(p)) {
        let (own, parent) = (fine.centre(cell), coarse.centre(SquareLattice::parent(cell)));
        assert!((0..3).all(|k| (own[k] - parent[k]).abs() == 0.25));
        assert!(coarse.number(SquareLattice::parent(cell)).is_some());
    }
}

#[test]
fn one_layer_stays_in_its_middle() {
    for layer in [-3, 0, 1, 4] {
        let h = 0.1 / 3.0;
        let mut lattice = SquareLattice::new(h, [0.0, 0.0, 0.7], [0..8, 0..8, layer..layer + 1], |_| true);
        let height = lattice.position(0)[2];
        while lattice.points() > 1 {
            lattice = lattice.coarser();
            assert!(lattice.is_plane() && (lattice.position(0)[2] - height).abs() < 1e-15);
        }
    }
    let plane = SquareLattice::rectangle(0.1 / 3.0, [0.3, 0.7], [9, 5]);
    assert!([&plane, &plane.coarser(), &plane.coarser().coarser()].iter().all(|l| l.position(0)[2] == 0.0));
}
