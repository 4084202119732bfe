use super::*;
use crate::{Pcg, PcgOptions};

/// A chain of unit springs with held ends.
struct Chain(usize);

impl LinearOperator for Chain {
    fn size(&self) -> usize {
        self.0
    }

    fn apply(&self, x: &[f64], y: &mut [f64]) {
        let at = |k: usize| x.get(k).copied().unwrap_or(0.0);
        for (k, y) in y.iter_mut().enumerate() {
            *y = 2.0 * at(k) - at(k.wrapping_sub(1)) - at(k + 1);
        }
    }
}

/// The inverse of its diagonal, which knows no long wave.
struct Diagonal(usize);

impl Preconditioner for Diagonal {
    fn size(&self) -> usize {
        self.0
    }

    fn apply(&mut self, r: &[f64], z: &mut [f64]) {
        for (z, r) in z.iter_mut().zip(r) {
            *z = 0.5 * r;
        }
    }
}

/// Hats of equal width, which is one more than that between two tops.
struct Hats {
    count: usize,
    width: usize,
}

impl Hats {
    fn value(&self, hat: usize, k: usize) -> f64 {
        let top = (hat + 1) * self.width;
        (1.0 - (k + 1).abs_diff(top) as f64 / self.width as f64).max(0.0)
    }
}

impl SmoothVectors for Hats {
    fn count(&self) -> usize {
        self.count
    }

    fn reach(&self) -> usize {
        1
    }

    fn add(&self, factors: &[f64], x: &mut [f64]) {
        for (k, x) in x.iter_mut().enumerate() {
            *x += factors.iter().enumerate().map(|(hat, f)| f * self.value(hat, k)).sum::<f64>();
        }
    }

    fn project(&self, r: &[f64], products: &mut [f64]) {
        for (hat, product) in products.iter_mut().enumerate() {
            *product = r.iter().enumerate().map(|(k, r)| r * self.value(hat, k)).sum();
        }
    }
}

const SIZE: usize = 159;

fn hats() -> Hats {
    Hats { count: 39, width: 4 }
}

fn deflated(vectors: Hats) -> Deflated<'static> {
    Deflated::new(Box::new(Chain(SIZE)), Box::new(Diagonal(SIZE)), Box::new(vectors))
        .map_err(|e| e.0)
        .expect("a factor")
}

#[test]
fn its_products_are_those_of_every_pair() {
    let (vectors, mut scratch) = (hats(), [vec![0.0; SIZE], vec![0.0; SIZE]]);
    let [x, image] = &mut scratch;
    let matrix = coarse_matrix(&Chain(SIZE), &vectors, [x, image]);
    // Hats on a chain: 2/width on the diagonal, −1/width beside it.
    for k in 0..vectors.count {
        let found = &matrix.values[2 * k..][..2];
        let beside = if k + 1 < vectors.count { -0.25 } else { 0.0 };
        assert!((found[0] - 0.5).abs() < 1e-14 && (found[1] - beside).abs() < 1e-14, "{found:?}");
    }
}

#[test]
fn a_smooth_vector_comes_back_from_its_force() {
    let (vectors, mut smooth, mut force) = (hats(), vec![0.0; SIZE], vec![0.0; SIZE]);
    let factors: Vec<f64> = (0..vectors.count).map(|k| (k % 7) as f64 - 2.0).collect();
    vectors.add(&factors, &mut smooth);
    Chain(SIZE).apply(&smooth, &mut force);
    let mut found = vec![0.0; SIZE];
    deflated(vectors).apply(&force, &mut found);
    let off = found.iter().zip(&smooth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-13, "{off:e}"); // 7e-15
}

#[test]
fn it_is_symmetric() {
    let mut m = deflated(hats());
    let [x, y] = [7, 11].map(|n| (0..SIZE).map(|k| (k * n % 13) as f64 - 6.0).collect::<Vec<f64>>());
    let mut work = |x: &[f64], y: &[f64]| {
        let mut z = vec![0.0; SIZE];
        m.apply(x, &mut z);
        z.iter().zip(y).map(|(a, b)| a * b).sum::<f64>()
    };
    let (first, second) = (work(&x, &y), work(&y, &x));
    assert!((first / second - 1.0).abs() < 1e-12, "{first} {second}"); // 2e-15
}

#[test]
fn gradients_need_fewer_iterations_and_find_the_same() {
    let solve = |m: &mut dyn Preconditioner| {
        let mut force: Vec<f64> = (0..SIZE).map(|k| 1.0 + (k % 7) as f64).collect();
        let mut x = vec![0.0; SIZE];
        let options = PcgOptions {
            residual_drop: 1e-12,
            max_iterations: 500,
            stagnation_window: 500,
            ..PcgOptions::default()
        };
        let report = Pcg::new(SIZE).solve(&Chain(SIZE), m, &mut force, &mut x, &options);
        (x, report.iterations)
    };
    let (plain, slow) = solve(&mut Diagonal(SIZE));
    let (found, fast) = solve(&mut deflated(hats()));
    let off = found.iter().zip(&plain).map(|(a, b)| (a - b).abs() / b.abs()).fold(0.0, f64::max);
    assert!(off < 1e-8, "{off:e}");
    assert!(3 * fast < slow, "{fast} iterations, without {slow}");
}

#[test]
fn vectors_that_depend_on_each_other_leave_the_preconditioner_to_its_owner() {
    /// Each twice.
    struct Twice(Hats);
    impl SmoothVectors for Twice {
        fn count(&self) -> usize {
            2 * self.0.count
        }
        fn reach(&self) -> usize {
            3
        }
        fn add(&self, factors: &[f64], x: &mut [f64]) {
            let sums: Vec<f64> = factors.chunks(2).map(|pair| pair[0] + pair[1]).collect();
            self.0.add(&sums, x);
        }
        fn project(&self, r: &[f64], products: &mut [f64]) {
            let mut single = vec![0.0; self.0.count];
            self.0.project(r, &mut single);
            for (pair, single) in products.chunks_mut(2).zip(single) {
                pair.fill(single);
            }
        }
    }
    let outcome = Deflated::new(Box::new(Chain(SIZE)), Box::new(Diagonal(SIZE)), Box::new(Twice(hats())));
    let Err((error, mut rest)) = outcome else { panic!("a factor of a singular matrix") };
    assert!(matches!(error, FactorError::NonPositivePivot { .. }), "{error:?}");
    let mut z = vec![0.0; SIZE];
    rest.apply(&vec![1.0; SIZE], &mut z);
    assert_eq!(z[0], 0.5);
}
