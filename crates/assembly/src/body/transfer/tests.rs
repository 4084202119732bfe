use super::*;

fn random(size: usize, seed: usize) -> Vec<f64> {
    (0..size).map(|i| (((i + seed) * 7919 % 1013) as f64) / 1013.0 - 0.5).collect()
}

/// 41 × 30 cells, their corner at odd numbers, with a hole and a ragged side.
fn lattice() -> SquareLattice {
    let inside = |[i, j]: [i32; 2]| (i - 20).pow(2) + (j - 15).pow(2) > 20 && i < 40 - j % 4;
    SquareLattice::plane(1.0, [0.0; 2], -1..40, 3..33, inside)
}

fn checks(fine: &SquareLattice, near: &dyn Fn(usize) -> bool, visible: &dyn Fn([f64; 3], [f64; 3]) -> bool) {
    let coarse = fine.coarser();
    let transfer = Transfer::new(fine, &coarse, near, visible);
    let mut ones = vec![0.0_f64; fine.points()];
    transfer.prolong_add(&vec![1.0; coarse.points()], &mut ones);
    assert!(ones.iter().all(|v| (v - 1.0).abs() < 1e-15));
    let (x, y) = (random(coarse.points(), 3), random(fine.points(), 8));
    let (mut up, mut down) = (vec![0.0; fine.points()], vec![9.0; coarse.points()]);
    transfer.prolong_add(&x, &mut up);
    transfer.restrict(&y, &mut down);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    assert!((dot(&up, &y) - dot(&down, &x)).abs() < 1e-12);
}

#[test]
fn constants_stay_and_the_restriction_is_the_transpose() {
    checks(&lattice(), &|_| false, &|_, _| true);
    checks(&SquareLattice::rectangle(1.0, [0.0; 2], [64, 17]), &|_| false, &|_, _| true);
    checks(&SquareLattice::rectangle(1.0, [0.0; 2], [1, 1]), &|_| false, &|_, _| true);
    let fine = lattice();
    let near = |p: usize| (fine.place(p)[1] - 12.0).abs() < 3.0;
    checks(&fine, &near, &|a, b| (a[1] < 12.0) == (b[1] < 12.0));
}

#[test]
fn linear_fields_are_exact_where_all_four_cells_exist() {
    let fine = lattice();
    let coarse = fine.coarser();
    let field = |[x, y]: [f64; 2]| 3.0 * x - 2.0 * y + 1.0;
    let transfer = Transfer::new(&fine, &coarse, &|_| false, &|_, _| true);
    let values: Vec<f64> = (0..coarse.points()).map(|p| field(coarse.place(p))).collect();
    let mut found = vec![0.0; fine.points()];
    transfer.prolong_add(&values, &mut found);
    for p in 0..fine.points() {
        if candidates(fine.cell(p), true).iter().all(|c| coarse.number(c.0).is_some()) {
            assert!((found[p] - field(fine.place(p))).abs() < 1e-12);
        }
    }
}

#[test]
fn nothing_comes_through_a_crack() {
    let fine = SquareLattice::rectangle(1.0, [0.0; 2], [32, 32]);
    let coarse = fine.coarser();
    let above = |y: f64| if y > 13.0 { 1.0 } else { 0.0 };
    let near = |p: usize| (fine.place(p)[1] - 13.0).abs() < 4.0;
    let transfer = Transfer::new(&fine, &coarse, &near, &|a, b| above(a[1]) == above(b[1]));
    let values: Vec<f64> = (0..coarse.points()).map(|p| above(coarse.place(p)[1])).collect();
    let mut found = vec![0.0; fine.points()];
    transfer.prolong_add(&values, &mut found);
    // The row of cells with y in 12..13 shares its parents, at y = 13, with the row above.
    assert!((0..fine.points()).all(|p| found[p] == above(fine.place(p)[1])));
}

/// 19 × 16 × 13 cells with a hole through some layers and a ragged side.
fn solid() -> SquareLattice {
    let inside = |[i, j, k]: Cell| ((i - 9).pow(2) + (j - 8).pow(2) > 6 || k > 7) && i < 18 - (j + k) % 3;
    SquareLattice::new(0.5, [0.3, -1.0, 2.0], [-1..18, 1..17, -3..10], inside)
}

#[test]
fn solids_keep_constants_and_the_transpose() {
    checks(&solid(), &|_| false, &|_, _| true);
    checks(&SquareLattice::cuboid(1.0, [0.0; 3], [22, 9, 2]), &|_| false, &|_, _| true);
    checks(&SquareLattice::cuboid(1.0, [0.0; 3], [40, 30, 12]), &|_| false, &|_, _| true);
}

#[test]
fn linear_fields_of_solids_are_exact_where_all_eight_cells_exist() {
    let fine = solid();
    let coarse = fine.coarser();
    let field = |[x, y, z]: [f64; 3]| 3.0 * x - 2.0 * y + 0.7 * z + 1.0;
    let transfer = Transfer::new(&fine, &coarse, &|_| false, &|_, _| true);
    assert!(!transfer.fine.stretches.is_empty() && !transfer.coarse.stretches.is_empty());
    let values: Vec<f64> = (0..coarse.points()).map(|p| field(coarse.position(p))).collect();
    let mut found = vec![0.0; fine.points()];
    transfer.prolong_add(&values, &mut found);
    let is_told = |p: &usize| candidates(fine.cell(*p), false).iter().all(|c| coarse.number(c.0).is_some());
    assert!((0..fine.points()).filter(is_told).count() > fine.points() / 3);
    for p in (0..fine.points()).filter(is_told) {
        assert!((found[p] - field(fine.position(p))).abs() < 1e-12);
    }
}
