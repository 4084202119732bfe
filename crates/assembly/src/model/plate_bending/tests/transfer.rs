//! Interpolation between a plate and its coarser one.

use super::super::{PHI_X, PHI_Y, PlateTransfer};
use super::body::holed;
use super::parameters;
use crate::body::Interpolation;
use crate::model::plate_bending::PlateBending;

/// A deflection that is quadratic, with its gradient.
fn curved(plate: &PlateBending) -> Vec<f64> {
    let n = plate.nodes().points();
    let mut u = vec![0.0; 3 * n];
    for point in 0..n {
        let [x, y] = plate.nodes().place(point);
        u[point] = 0.2 + 0.3 * x - 0.7 * y + 0.6 * x * x - 0.4 * x * y + 0.9 * y * y;
        u[PHI_X * n + point] = 0.3 + 1.2 * x - 0.4 * y;
        u[PHI_Y * n + point] = -0.7 - 0.4 * x + 1.8 * y;
    }
    u
}

#[test]
fn quadratic_deflections_are_interpolated_exactly() {
    // An odd hole: coarse points lie in it and beyond it.
    let fine = holed(parameters(1.5, 0.1));
    let coarse = fine.coarser().unwrap();
    let transfer = PlateTransfer::new(fine.nodes(), coarse.nodes());
    let mut found = vec![0.0; 3 * fine.nodes().points()];
    transfer.prolong_all(&curved(&coarse), &mut found);
    let worst = found.iter().zip(curved(&fine)).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(worst < 1e-14, "{worst}");
}

#[test]
fn the_restriction_is_the_transpose() {
    let fine = holed(parameters(1.5, 0.1));
    let coarse = fine.coarser().unwrap();
    let transfer = PlateTransfer::new(fine.nodes(), coarse.nodes());
    let sizes = [&fine, &coarse].map(|plate| 3 * plate.nodes().points());
    let numbers = |size: usize, seed: f64| (0..size).map(|k| (seed * k as f64).sin()).collect::<Vec<_>>();
    let (x, y) = (numbers(sizes[1], 1.3), numbers(sizes[0], 0.7));
    let (mut up, mut down) = (vec![0.0; sizes[0]], vec![0.0; sizes[1]]);
    transfer.prolong_all(&x, &mut up);
    transfer.restrict_all(&y, &mut down);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    assert!((dot(&up, &y) - dot(&x, &down)).abs() < 1e-12);
}

#[test]
fn rows_are_those_of_the_interpolation() {
    let fine = holed(parameters(1.5, 0.1));
    let coarse = fine.coarser().unwrap();
    let transfer = PlateTransfer::new(fine.nodes(), coarse.nodes());
    let [n, m] = [&fine, &coarse].map(|plate| plate.nodes().points());
    let x: Vec<f64> = (0..3 * m).map(|k| (1.3 * k as f64).sin()).collect();
    let mut all = vec![0.0; 3 * n];
    transfer.prolong_all(&x, &mut all);
    for (unknown, expected) in all.into_iter().enumerate() {
        let row = transfer.row(unknown / n, unknown % n);
        let found: f64 = row.iter().map(|&(component, point, share)| share * x[component * m + point]).sum();
        assert!((found - expected).abs() < 1e-14, "{unknown}: {found} {expected}");
    }
}
