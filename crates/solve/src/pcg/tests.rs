use super::*;
use crate::{BandCholesky, BandMatrix};
use std::cell::Cell;

/// `-x[i-1] + diagonal x[i] - x[i+1]`, with a relative error of `noise` in every
/// product that changes from call to call.
struct Chain {
    size: usize,
    diagonal: f64,
    noise: f64,
    calls: Cell<u64>,
}

impl Chain {
    fn new(size: usize, diagonal: f64) -> Self {
        Self { size, diagonal, noise: 0.0, calls: Cell::new(0) }
    }

    fn factor(&self, error: f64) -> BandCholesky {
        let mut values = [self.diagonal * (1.0 + error), -1.0].repeat(self.size);
        *values.last_mut().unwrap() = 0.0;
        let matrix = BandMatrix { order: self.size, half_bandwidth: 1, values };
        BandCholesky::factor(matrix, 1).unwrap()
    }
}

impl LinearOperator for Chain {
    fn size(&self) -> usize {
        self.size
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        self.calls.set(self.calls.get() + 1);
        for i in 0..x.len() {
            let left = if i > 0 { x[i - 1] } else { 0.0 };
            let right = x.get(i + 1).copied().unwrap_or(0.0);
            let wave = ((i as f64 + 1.0) * (self.calls.get() as f64 + 0.3)).sin();
            y[i] = (self.diagonal * x[i] - left - right) * (1.0 + self.noise * wave);
        }
    }
}

struct Identity(usize);

impl Preconditioner for Identity {
    fn size(&self) -> usize {
        self.0
    }
    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        z.copy_from_slice(r);
    }
}

fn wavy(n: usize) -> Vec<f64> {
    (0..n).map(|i| (i as f64 * 0.7).sin() + 0.1).collect()
}

fn run(op: &Chain, m: &mut dyn Preconditioner, b: &[f64]) -> (PcgReport, Vec<f64>) {
    let mut x = vec![0.0; b.len()];
    let report = Pcg::new(b.len()).solve(op, m, &mut b.to_vec(), &mut x, &PcgOptions::default());
    (report, x)
}

fn largest_residual(op: &Chain, b: &[f64], x: &[f64]) -> f64 {
    let mut y = vec![0.0; x.len()];
    op.apply(x, &mut y);
    y.iter().zip(b).map(|(y, b)| (y - b).abs()).fold(0.0, f64::max)
}

#[test]
fn an_exact_factor_needs_two_steps_at_most() {
    let op = Chain::new(5000, 2.5);
    let b = wavy(5000);
    let (report, x) = run(&op, &mut op.factor(0.0), &b);
    assert_eq!(report.status, PcgStatus::Converged);
    assert!(report.iterations <= 2);
    assert!(report.first_correction < 1.0e-14);
    assert!(largest_residual(&op, &b, &x) < 1.0e-14);
}

#[test]
fn a_wrong_factor_is_corrected_and_the_correction_reported() {
    let op = Chain::new(3000, 2.5);
    let b = wavy(3000);
    let (report, x) = run(&op, &mut op.factor(0.3), &b);
    assert_eq!(report.status, PcgStatus::Converged);
    assert!(report.iterations > 4 && report.iterations < 40);
    assert!(report.energy_ratio.abs() <= 1.0e-24);
    assert!(largest_residual(&op, &b, &x) < 1.0e-13);
    // With the energy of the first step put in by hand: E1 = (b.z)^2 / (z.Az).
    let (mut z, mut image) = (vec![0.0; 3000], vec![0.0; 3000]);
    op.factor(0.3).apply(&b, &mut z);
    op.apply(&z, &mut image);
    let first = dot(&b, &z).powi(2) / dot(&z, &image);
    let whole = dot(&b, &x);
    let expected = (1.0 - first / whole).sqrt();
    assert!((report.first_correction - expected).abs() < 1.0e-6);
}

#[test]
fn plain_gradients_solve_a_laplacian_in_its_order_of_steps() {
    // A load at one end must travel to the other: no early end is possible, and
    // r . z hardly falls before.
    let op = Chain::new(60, 2.0);
    let mut b = vec![0.0; 60];
    b[0] = 1.0;
    let options = PcgOptions {
        stagnation_window: 60,
        // What one-sided rounding of 60 plain steps leaves.
        energy_drop: 1.0e-30,
        ..PcgOptions::default()
    };
    let mut x = vec![0.0; 60];
    let report = Pcg::new(60).solve(&op, &mut Identity(60), &mut b, &mut x, &options);
    assert_eq!((report.status, report.iterations), (PcgStatus::Converged, 60));
    for (i, x) in x.iter().enumerate() {
        // Linear from the load to the fixed end beyond the last entry.
        assert!((x - (60.0 - i as f64) / 61.0).abs() < 1.0e-14);
    }
}

#[test]
fn an_indefinite_operator_is_reported() {
    let op = Chain::new(100, 0.5); // eigenvalues 0.5 - 2 cos, from -1.5 to 2.5
    let (report, _) = run(&op, &mut Identity(100), &wavy(100));
    assert_eq!(report.status, PcgStatus::IndefiniteOperator);
}

#[test]
fn the_limit_of_iterations_is_kept() {
    let op = Chain::new(400, 2.01);
    let options = PcgOptions { max_iterations: 4, ..PcgOptions::default() };
    let mut x = vec![0.0; 400];
    let mut factor = op.factor(0.5);
    let report = Pcg::new(400).solve(&op, &mut factor, &mut wavy(400), &mut x, &options);
    assert_eq!((report.status, report.iterations), (PcgStatus::IterationLimit, 4));
}

#[test]
fn noise_in_the_operator_ends_as_stagnation() {
    // Every product is off by up to 90 % and differently each time: no direction
    // is conjugate to another and r . z wanders.
    let op = Chain { noise: 0.9, ..Chain::new(400, 2.01) };
    let options = PcgOptions { stagnation_window: 5, ..PcgOptions::default() };
    let mut x = vec![0.0; 400];
    let mut factor = op.factor(0.5);
    let report = Pcg::new(400).solve(&op, &mut factor, &mut wavy(400), &mut x, &options);
    assert_eq!(report.status, PcgStatus::Stagnated);
    assert!(report.energy_ratio > 1.0e-24);
}

#[test]
fn a_zero_load_has_a_zero_solution() {
    let op = Chain::new(10, 2.5);
    let (report, x) = run(&op, &mut op.factor(0.0), &[0.0; 10]);
    assert_eq!((report.status, report.iterations), (PcgStatus::Converged, 0));
    assert_eq!(report.energy_ratio, 0.0);
    assert_eq!(x, [0.0; 10]);
}

#[test]
fn numbers_that_are_not_finite_are_reported() {
    let op = Chain::new(10, 2.5);
    let mut b = wavy(10);
    b[3] = f64::NAN;
    assert_eq!(run(&op, &mut op.factor(0.0), &b).0.status, PcgStatus::NotFinite);
    let broken = Chain::new(10, f64::INFINITY);
    assert_eq!(run(&broken, &mut op.factor(0.0), &wavy(10)).0.status, PcgStatus::NotFinite);
}

#[test]
fn the_work_space_carries_nothing_over() {
    let op = Chain::new(777, 2.2);
    let (first, expected) = run(&op, &mut op.factor(0.1), &wavy(777));
    let mut pcg = Pcg::new(777);
    let mut x = vec![0.0; 777];
    let mut factor = op.factor(0.1);
    let options = PcgOptions::default();
    pcg.solve(&op, &mut factor, &mut vec![1.0; 777], &mut x, &options);
    x.fill(0.0);
    let again = pcg.solve(&op, &mut factor, &mut wavy(777), &mut x, &options);
    assert_eq!((again, x), (first, expected)); // to the last bit
}

#[test]
fn a_solution_is_added_to_what_is_there() {
    let op = Chain::new(50, 2.3);
    let (b, mut factor) = (wavy(50), op.factor(0.0));
    let (_, expected) = run(&op, &mut factor, &b);
    let mut x = vec![1.0; 50];
    let mut image = vec![0.0; 50];
    op.apply(&x, &mut image);
    let mut residual: Vec<f64> = b.iter().zip(&image).map(|(b, y)| b - y).collect();
    Pcg::new(50).solve(&op, &mut factor, &mut residual, &mut x, &PcgOptions::default());
    for (x, expected) in x.iter().zip(&expected) {
        assert!((x - expected).abs() < 1.0e-14);
    }
}

/// The diagonal 1, 1, -1.
struct Saddle;

impl LinearOperator for Saddle {
    fn size(&self) -> usize {
        3
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        y.copy_from_slice(&[x[0], x[1], -x[2]]);
    }
}

#[test]
fn a_direction_of_negative_curvature_that_the_load_hardly_excites_is_no_rounding() {
    // The first step takes all but 1e-13 of the load, and the second one goes down without end.
    let options = PcgOptions { energy_drop: 0.0, ..PcgOptions::default() };
    let report =
        Pcg::new(3).solve(&Saddle, &mut Identity(3), &mut [1.0, 1.0, 1e-13], &mut [0.0; 3], &options);
    assert_eq!(report.status, PcgStatus::IndefiniteOperator);
}
