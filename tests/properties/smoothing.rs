//! A system as a level of multigrid: residuals, inverse blocks and relaxed steps are what their definitions say, whether
//! they are made while forces are at hand or one after the other.

use super::consistency::{Noise, assert_close, constrained, largest};
use nalgebra::{DMatrix, DVector};
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::Term;
use peristat_assembly::system::{Level, System};

pub(crate) fn steps_are_what_they_say<const D: usize, M: Model<D>>(
    model: &M,
    extra: Vec<Box<dyn Term<D>>>,
    noise: &mut Noise,
) {
    let n = model.points();
    let equations = constrained::<D>(n, noise);
    let system = System::new(model, extra, equations).expect("homogeneous equations never contradict");
    let level = Level::coarse(&system);
    let state = |noise: &mut Noise| {
        let mut x = noise.vector(D * n);
        system.constraints().expand(0.0, &mut x);
        x
    };
    let (x, previous) = (state(noise), state(noise));
    let mut b = noise.vector(D * n);
    system.constraints().rows().iter().for_each(|row| b[row.unknown] = 0.0);
    let mut product = vec![f64::NAN; D * n];
    system.product(&x, &mut product);
    let expected: Vec<f64> = b.iter().zip(&product).map(|(b, p)| b - p).collect();
    let mut r = vec![f64::NAN; D * n];
    level.residual(&b, &x, &mut r);
    let scale = largest(&product) + 1.0;
    // Measured 2e-15.
    assert_close(&r, &expected, scale, 1e-13, "b − A x");

    let mut step = vec![0.0; D * n];
    level.smooth(1.0, &r, &mut step);
    inverts_the_blocks(&system, &r, &step);

    a_part_is_that_of_the_whole(&system, &r);

    let (keep, size) = (0.3 * noise.next(), 0.7);
    let expected: Vec<f64> =
        (0..D * n).map(|k| x[k] + keep * (x[k] - previous[k]) + size * step[k]).collect();
    let (mut relaxed, mut scratch) = (previous, vec![f64::NAN; D * n]);
    level.relax([keep, size], &b, &x, &mut relaxed, &mut scratch);
    // Measured 1.4e-12, where a block is nearly singular.
    assert_close(&relaxed, &expected, largest(&expected), 1e-10, "a relaxed step");
    numbers_of_32_bits_say_the_same(&system, [&b, &x, &r], scale);
}

/// Residual and step of a level in numbers of 32 bits.
fn numbers_of_32_bits_say_the_same<const D: usize>(system: &System<D>, [b, x, r]: [&[f64]; 3], scale: f64) {
    let level = Level::<D, f32>::coarse(system);
    let single = |v: &[f64]| -> Vec<f32> { v.iter().map(|v| *v as f32).collect() };
    let double = |v: &[f32]| -> Vec<f64> { v.iter().map(|v| f64::from(*v)).collect() };
    let [b, x] = [b, x].map(single);
    let mut found = vec![f32::NAN; b.len()];
    level.residual(&b, &x, &mut found);
    // Measured 3.3e-6 once, 2.4e-7 in all others of 669 systems.
    assert_close(&double(&found), r, scale, 1e-5, "b − A x in 32 bits");
    // A step that keeps nothing of the last one is a step of the smoother from there.
    let mut expected = x.clone();
    level.smooth(0.7, &found, &mut expected);
    let (mut relaxed, mut scratch) = (vec![0.0; b.len()], vec![f32::NAN; b.len()]);
    level.relax([0.0, 0.7], &b, &x, &mut relaxed, &mut scratch);
    let expected = double(&expected);
    // Measured 3.5e-7.
    assert_close(&double(&relaxed), &expected, largest(&expected), 2e-6, "a step in 32 bits");
}

/// A step is the solution of the block of its point on the components that nothing constrains.
fn inverts_the_blocks<const D: usize>(system: &System<D>, r: &[f64], step: &[f64]) {
    let n = system.points();
    let mut is_free = vec![true; D * n];
    system.constraints().rows().iter().for_each(|row| is_free[row.unknown] = false);
    for (point, block) in system.diagonal_blocks().iter().enumerate() {
        let free: Vec<usize> = (0..D).filter(|c| is_free[c * n + point]).collect();
        if free.is_empty() {
            continue;
        }
        let k = DMatrix::from_fn(free.len(), free.len(), |i, j| block[free[i]][free[j]]);
        let of = |v: &[f64]| DVector::from_fn(free.len(), |i, _| v[free[i] * n + point]);
        let values = k.clone().symmetric_eigenvalues();
        // What holds a point too little stays at rest.
        if values.min() > 1e-6 * values.max() {
            let left = k * of(step) - of(r);
            assert!(left.amax() <= 1e-9 * of(r).amax(), "point {point}: {left}");
        }
    }
}

/// The stiffness among some points is that part of the whole, and a level that is laid bare there takes steps of one length.
fn a_part_is_that_of_the_whole<const D: usize>(system: &System<D>, r: &[f64]) {
    let n = system.points();
    let points: Vec<usize> = (0..n).filter(|p| p % 3 != 1).collect();
    let (unknowns, part) = system.assemble_among(&points);
    let is_free = |k: &usize| system.constraints().rows().iter().all(|row| row.unknown != *k);
    assert_eq!(unknowns, (0..D * n).filter(|k| k % n % 3 != 1).filter(is_free).collect::<Vec<_>>());
    let whole = system.assemble_sparse();
    let scale = whole.data().iter().fold(0.0_f64, |most, value| most.max(value.abs()));
    for (row, &a) in unknowns.iter().enumerate() {
        for (column, &b) in unknowns[..=row].iter().enumerate() {
            let [found, expected] =
                [part.get(row, column), whole.get(a, b)].map(|value| value.copied().unwrap_or(0.0));
            // The whole keeps one on the diagonal of what has stiffness by its dependents alone.
            let off = (found - expected).abs();
            assert!(off.min((off - 1.0).abs()) <= 1e-13 * scale.max(1.0), "({a}, {b}): {found} {expected}");
        }
    }
    let mut level = Level::coarse(system);
    level.lay_bare(&unknowns, 0.25);
    let mut step = vec![0.0; D * n];
    level.smooth(1.0, r, &mut step);
    unknowns.iter().for_each(|&k| assert_eq!(step[k], 0.25 * r[k]));
}
