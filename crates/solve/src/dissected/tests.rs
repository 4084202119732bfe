use super::*;
use crate::plane::{Plane, random, residual};
use crate::{Ordering, PointGraph, SparseCholesky, nested_dissection};
use sprs::TriMat;

fn factored(matrix: &CsMat<f64>, dissection: &Dissection, components: usize) -> DissectedCholesky {
    let mut factor = DissectedCholesky::analyse(matrix, dissection, components).unwrap();
    factor.refactor(matrix).unwrap();
    factor
}

#[test]
fn both_factors_solve_whatever_is_coupled() {
    for (name, plane) in Plane::gallery() {
        for components in [1, 2, 3] {
            let matrix = plane.matrix(components);
            let graph = PointGraph::from_matrix(&matrix, components);
            let dissection = nested_dissection(&plane.positions, &graph);
            let found = residual(&matrix, &mut factored(&matrix, &dissection, components));
            // Entries are below 30; measured 5e-15.
            assert!(found < 1.0e-13, "{name}, {components} components, two threads: {found:e}");
            let ordering = Ordering::Points { order: dissection.order(), components };
            let mut plain = SparseCholesky::analyse(&matrix, ordering).unwrap();
            plain.refactor(&matrix).unwrap();
            let found = residual(&matrix, &mut plain);
            assert!(found < 1.0e-13, "{name}, {components} components, one thread: {found:e}");
        }
    }
}

#[test]
fn the_same_bits_again() {
    let (_, plane) = Plane::gallery().swap_remove(0);
    let matrix = plane.matrix(2);
    let dissection = nested_dissection(&plane.positions, &plane.graph());
    let solve = |factor: &mut DissectedCholesky| {
        let mut z = vec![0.0; matrix.rows()];
        factor.apply(&vec![1.0; matrix.rows()], &mut z);
        z
    };
    let mut factor = factored(&matrix, &dissection, 2);
    let first = solve(&mut factor);
    assert_eq!(first, solve(&mut factor));
    factor.refactor(&matrix).unwrap();
    assert_eq!(first, solve(&mut factor));
    assert_eq!(first, solve(&mut factored(&matrix, &dissection, 2)));
}

#[test]
fn unknowns_without_couplings_cost_nothing() {
    let plate = Plane::lattice(30, |_| true);
    let inner = Plane::new(plate.clone(), 3.0, |a, b| a[0].min(b[0]) > 9.5);
    let dissection = nested_dissection(&plate, &inner.graph());
    let rest = Plane::new(plate.into_iter().filter(|x| x[0] > 9.5).collect(), 3.0, |_, _| true);
    let [whole, part] = [&inner, &rest].map(|plane| {
        let dissection = nested_dissection(&plane.positions, &plane.graph());
        factored(&plane.matrix(2), &dissection, 2).fill()
    });
    // 300 points of two unknowns, each an entry of its own; the others are cut otherwise.
    assert!((whole - 600) as f64 <= 1.2 * part as f64, "{whole} {part}");
    assert!(residual(&inner.matrix(2), &mut factored(&inner.matrix(2), &dissection, 2)) < 1.0e-13);
}

#[test]
fn the_bad_pivot_is_named_wherever_it_is() {
    let (_, plane) = Plane::gallery().swap_remove(0);
    let mut matrix = plane.matrix(2);
    let dissection = nested_dissection(&plane.positions, &plane.graph());
    let points = plane.positions.len();
    for point in [0, dissection.halves()[0], points - 1].map(|k| dissection.order()[k]) {
        for bad in [point, points + point] {
            // Far below what elimination subtracts, and the others far above it.
            let before = matrix.clone();
            for i in 0..2 * points {
                *matrix.get_mut(i, i).unwrap() = if i == bad { -1.0e3 } else { 1.0e3 };
            }
            let expected = Err(FactorError::NonPositivePivot { index: bad, count: 1 });
            let mut factor = DissectedCholesky::analyse(&matrix, &dissection, 2).unwrap();
            assert_eq!(factor.refactor(&matrix), expected);
            let ordering = Ordering::Points { order: dissection.order(), components: 2 };
            assert_eq!(SparseCholesky::analyse(&matrix, ordering).unwrap().refactor(&matrix), expected);
            matrix = before;
        }
    }
}

/// Two unknowns coupled with a third, which lies between them.
fn three(diagonal: f64) -> (CsMat<f64>, Dissection) {
    let mut entries = TriMat::new((3, 3));
    for (i, j, value) in [(0, 0, 1.0), (1, 1, 1.0), (2, 2, diagonal), (2, 0, 0.8), (2, 1, 0.8)] {
        entries.add_triplet(i, j, value);
    }
    (entries.to_csr(), Dissection { order: vec![0, 1, 2], halves: [1, 1] })
}

#[test]
fn halves_may_be_definite_where_the_whole_is_not() {
    // 1 - 0.8² > 0, but 1 - 2 · 0.8² < 0.
    let (matrix, dissection) = three(1.0);
    let mut factor = DissectedCholesky::analyse(&matrix, &dissection, 1).unwrap();
    let expected = Err(FactorError::NonPositivePivot { index: 2, count: 1 });
    assert_eq!(factor.refactor(&matrix), expected);
    // x2 = (1 - 2 · 0.8) / (2 - 2 · 0.8²) = -0.6 / 0.72, x0 = x1 = 1 - 0.8 x2
    let (matrix, dissection) = three(2.0);
    let mut z = [0.0; 3];
    factored(&matrix, &dissection, 1).apply(&[1.0; 3], &mut z);
    let last = -0.6 / 0.72;
    for (z, x) in z.iter().zip([1.0 - 0.8 * last, 1.0 - 0.8 * last, last]) {
        assert!((z - x).abs() < 1.0e-14);
    }
}

#[test]
fn mistakes_are_reported() {
    let (_, plane) = Plane::gallery().swap_remove(0);
    let matrix = plane.matrix(2);
    let dissection = nested_dissection(&plane.positions, &plane.graph());
    let shape = |result: Result<DissectedCholesky, FactorError>| match result {
        Err(FactorError::Shape { reason }) => reason,
        other => panic!("{other:?}"),
    };
    let reason = shape(DissectedCholesky::analyse(&matrix, &dissection, 1));
    assert_eq!(reason, "1800 rows, but 900 points of 1 components");
    let (three, _) = three(2.0);
    let wrong = Dissection { order: vec![2, 0, 1], halves: [1, 2] };
    assert_eq!(
        shape(DissectedCholesky::analyse(&three, &wrong, 1)),
        "the halves of the dissection are coupled"
    );
    let mut factor = factored(&matrix, &dissection, 2);
    let mut bad = matrix.clone();
    let row = (random(5)() * 1800.0) as usize;
    *bad.get_mut(row, row).unwrap() = f64::NAN;
    assert_eq!(factor.refactor(&bad), Err(FactorError::NotFinite { index: row }));
    let ordering = Ordering::Points { order: &[0, 0, 1], components: 1 };
    assert!(matches!(SparseCholesky::analyse(&three, ordering), Err(FactorError::Shape { .. })));
}

#[test]
fn a_few_unknowns_are_solved_for_as_all_are() {
    for (name, plane) in Plane::gallery() {
        let matrix = plane.matrix(2);
        let dissection = nested_dissection(&plane.positions, &PointGraph::from_matrix(&matrix, 2));
        let mut factor = factored(&matrix, &dissection, 2);
        // Neighbours in a part of the plane, and every unknown of the separator among others.
        for keep in [|k: usize| (100..110).contains(&k), |k: usize| k.is_multiple_of(7), |_: usize| false] {
            let unknowns: Vec<usize> = (0..matrix.rows()).filter(|k| keep(*k)).collect();
            let reach = factor.reach(unknowns.clone());
            let mut r = vec![0.0; matrix.rows()];
            unknowns.iter().for_each(|k| r[*k] = (*k as f64 * 0.7).sin());
            let own: Vec<f64> = unknowns.iter().map(|k| r[*k]).collect();
            let [mut whole, mut from] = [0; 2].map(|_| vec![f64::NAN; r.len()]);
            let mut within = vec![f64::NAN; own.len()];
            factor.apply(&r, &mut whole);
            factor.apply_from(&reach, &own, &mut from);
            assert_eq!(whole, from, "{name}");
            factor.apply_within(&reach, &own, &mut within);
            let expected: Vec<f64> = unknowns.iter().map(|k| whole[*k]).collect();
            assert_eq!(expected, within, "{name}");
        }
    }
}

#[test]
fn neighbours_need_a_part_of_the_blocks() {
    let (_, plane) = Plane::gallery().swap_remove(0);
    let matrix = plane.matrix(2);
    let factor = factored(&matrix, &nested_dissection(&plane.positions, &plane.graph()), 2);
    let corner: Vec<usize> = (0..900).filter(|k| k % 30 < 3 && k / 30 < 3).collect();
    let reach = factor.reach(corner);
    let blocks: Vec<usize> = reach.parts.iter().map(|part| part.blocks.len()).collect();
    // A corner is in one half.
    assert!(blocks.contains(&0), "{blocks:?}");
    let all: usize = factor.parts.iter().map(Part::blocks).sum();
    assert!(blocks.iter().sum::<usize>() * 4 < all, "{blocks:?} of {all}");
}
