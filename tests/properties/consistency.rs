//! Checks that every model must pass: written once, for any number of unknowns per point.
//!
//! Energy, force and tangent belong together, the tangent is symmetric and not negative, rigid motions cost nothing,
//! and both layouts of the assembled matrix hold the same numbers, with constraints and without.

use super::loose::free_motions_are_free;
use super::smoothing::steps_are_what_they_say;
use nalgebra::DMatrix;
use peristat_assembly::condition::{Equation, Unknown};
use peristat_assembly::model::Model;
use peristat_assembly::stiffness::{BlockMatrix, ConnectedParts, Term, Twofold};
use peristat_assembly::sum::Sum;
use peristat_assembly::system::System;
use proptest::test_runner::{Config, RngSeed};
use sprs::CsMat;

/// A number of random cases, the same ones in every run.
pub(crate) fn cases(number: u32) -> Config {
    Config { cases: number, rng_seed: RngSeed::Fixed(20), failure_persistence: None, ..Config::default() }
}

/// Numbers between −1 and 1 from a seed (SplitMix64).
pub(crate) struct Noise(pub(crate) u64);

impl Noise {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn vector(&mut self, length: usize) -> Vec<f64> {
        (0..length).map(|_| self.next()).collect()
    }

    pub(crate) fn index(&mut self, below: usize) -> usize {
        ((self.next() + 1.0) * 0.5 * below as f64) as usize % below
    }
}

pub(crate) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn combine(u: &[f64], factor: f64, v: &[f64]) -> Vec<f64> {
    u.iter().zip(v).map(|(u, v)| u + factor * v).collect()
}

fn force<const D: usize>(system: &System<D>, u: &[f64]) -> Vec<f64> {
    let mut force = vec![f64::NAN; system.size()];
    system.force(u, &mut force);
    force
}

pub(crate) fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |a, x| if x.is_nan() { f64::INFINITY } else { a.max(x.abs()) })
}

pub(crate) fn assert_close(found: &[f64], expected: &[f64], scale: f64, tolerance: f64, what: &str) {
    let difference = largest(&combine(found, -1.0, expected));
    assert!(difference <= tolerance * scale, "{what}: {difference:e} of {scale:e}");
}

/// All checks on a model with further terms.
pub(crate) fn check<const D: usize, M: Model<D>>(
    model: &M,
    extra: &dyn Fn() -> Vec<Box<dyn Term<D>>>,
    seed: u64,
) {
    let mut noise = Noise(seed);
    let free = System::new(model, extra(), Vec::new()).expect("no contradiction");
    force_is_the_gradient_of_the_energy(&free, &mut noise);
    tangent_is_the_derivative_of_the_force(&free, &mut noise);
    if extra().is_empty() {
        rigid_motions_cost_nothing(model, &free, &mut noise);
    }
    no_motion_gives_energy_away(&free);
    elements_are_the_couplings(&free);
    layouts_agree(model, extra(), &mut noise);
    constrained_operator_is_the_folded_matrix(model, extra(), &mut noise);
    steps_are_what_they_say(model, extra(), &mut noise);
    free_motions_are_free(model, extra, &mut noise);
}

fn force_is_the_gradient_of_the_energy<const D: usize>(system: &System<D>, noise: &mut Noise) {
    let u = noise.vector(system.size());
    let f = force(system, &u);
    let mut directions = vec![noise.vector(system.size())];
    for _ in 0..8 {
        let mut unit = vec![0.0; system.size()];
        unit[noise.index(system.size())] = 1.0;
        directions.push(unit);
    }
    for v in directions {
        // The energy is quadratic: a central difference of any width is exact.
        let [above, below] = [1.0, -1.0].map(|t| system.survey(&combine(&u, t, &v)).energy);
        let (slope, work) = (0.5 * (above - below), dot(&f, &v));
        // Measured 1e-15.
        assert!((slope - work).abs() <= 1e-13 * (above + below), "dE = {slope}, F·v = {work}");
        let second = above + below - 2.0 * system.survey(&u).energy;
        let curvature = dot(&force(system, &v), &v);
        assert!((second - curvature).abs() <= 1e-13 * (above + below), "{second} for {curvature}");
    }
    // What elements do to their ends grows with the displacement.
    let [once, twice] =
        [1.0, 2.0].map(|factor| system.survey(&u.iter().map(|u| factor * u).collect::<Vec<_>>()));
    for c in 0..D {
        assert_eq!(twice.largest_action[c], 2.0 * once.largest_action[c], "twice the action");
    }
}

fn tangent_is_the_derivative_of_the_force<const D: usize>(system: &System<D>, noise: &mut Noise) {
    let n = system.points();
    let k = system.stiffness().to_csr(|point, component| component * n + point);
    assert_eq!((k.rows(), k.cols()), (D * n, D * n));
    for (&value, (i, j)) in &k {
        assert_eq!(k.get(j, i), Some(&value), "symmetric exactly");
    }
    let mut blocks = vec![[[0.0; D]; D]; n];
    system.terms().iter().for_each(|term| term.add_diagonal(&mut blocks));
    for (point, block) in blocks.iter().enumerate() {
        for (r, row) in block.iter().enumerate() {
            let expected: Vec<f64> =
                (0..D).map(|c| k.get(r * n + point, c * n + point).copied().unwrap_or(0.0)).collect();
            assert_close(row, &expected, row_scale(&k), 1e-15, "diagonal blocks");
        }
    }
    let (v, w) = (noise.vector(D * n), noise.vector(D * n));
    let (fv, fw) = (force(system, &v), force(system, &w));
    let scale = row_scale(&k);
    // Measured 4e-16 of the largest sum of a row.
    assert_close(&product(&k, &v), &fv, scale, 1e-14, "K v and F(v)");
    precise_forces_are_the_same(system, scale, noise);
    let (a, b) = (dot(&w, &fv), dot(&v, &fw));
    assert!((a - b).abs() <= 1e-13 * scale * D as f64 * n as f64, "w·F(v) = {a}, v·F(w) = {b}");
}

/// Where there are forces in twice the precision, of unknowns in two parts.
fn precise_forces_are_the_same<const D: usize>(system: &System<D>, scale: f64, noise: &mut Noise) {
    let (high, low) = (noise.vector(system.size()), noise.vector(system.size()));
    let mut sums = vec![Sum::default(); system.size()];
    if system.force_twofold(Twofold { high: &high, low: &low }, &mut sums) {
        let totals: Vec<f64> = sums.into_iter().map(Sum::total).collect();
        let plain = force(system, &combine(&high, 1.0, &low));
        // Measured 6e-16 of the largest sum of a row.
        assert_close(&totals, &plain, scale, 1e-14, "forces in twice the precision");
    }
}

fn rigid_motions_cost_nothing<const D: usize, M: Model<D>>(model: &M, system: &System<D>, noise: &mut Noise) {
    let n = system.points();
    let k = system.stiffness().to_csr(|point, component| component * n + point);
    let (scale, u) = (row_scale(&k), noise.vector(D * n));
    let mut others: Vec<Vec<f64>> = Vec::new();
    for kind in 0..model.rigid_motions().len() {
        let amount = noise.next();
        let motion: Vec<f64> =
            (0..D * n).map(|i| amount * model.rigid_motion(kind, i % n, [0.0; 3])[i / n]).collect();
        // Published elongations of shells resist theirs, which are none then.
        let name = model.rigid_motions()[kind].name;
        let may_be_none = name.ends_with("degrees");
        assert!(may_be_none || largest(&motion) > 0.0, "{} moves something", name);
        let along =
            |other: &Vec<f64>| dot(other, &motion).powi(2) / (dot(other, other) * dot(&motion, &motion));
        assert!(n == 1 || !others.iter().any(|o| along(o) > 1.0 - 1e-6), "{}", name);
        if largest(&motion) > 0.0 {
            others.push(motion.clone());
        }
        if ["rotation", "rotation about z"].contains(&name) {
            let turned = |centre: usize| model.displacement(kind, n - 1, model.position(centre));
            assert!(turned(n - 1) <= 1e-15 && (n == 1 || turned(0) > 0.0), "a rotation leaves its centre");
        }
        let size = scale * largest(&motion);
        assert_close(&force(system, &motion), &vec![0.0; D * n], size, 1e-14, name);
        let energy = system.survey(&motion).energy;
        assert!(energy.abs() <= 1e-26 * size * largest(&motion) * n as f64, "{energy:e}");
        let moved = force(system, &combine(&u, 1.0, &motion));
        assert_close(&moved, &force(system, &u), scale + size, 1e-14, name);
    }
}

fn no_motion_gives_energy_away<const D: usize>(system: &System<D>) {
    let n = system.points();
    // All eigenvalues of a dense matrix: small bodies only.
    if D * n > 160 {
        return;
    }
    let k = dense(&system.stiffness().to_csr(|point, component| component * n + point));
    let values = k.symmetric_eigenvalues();
    // Measured −3e-16 of the largest.
    assert!(values.min() >= -1e-13 * values.max(), "{} of {}", values.min(), values.max());
}

fn elements_are_the_couplings<const D: usize>(system: &System<D>) {
    for term in system.terms() {
        let (mut pairs, mut grounded) = (Vec::new(), 0);
        term.couplings(&mut |i, j| pairs.push((i, j)));
        term.ground_motions(&mut |_| grounded += 1);
        // Bonds couple one pair each, families of several points more.
        assert!(term.elements() <= pairs.len() + grounded);
        assert!(pairs.iter().all(|(i, j)| i.abs_diff(*j) <= term.reach()));
        let (mut joined, mut expected) =
            (ConnectedParts::new(system.points()), ConnectedParts::new(system.points()));
        term.join(&mut joined);
        pairs.iter().for_each(|&(i, j)| expected.join(i, j));
        let of_points = |parts: ConnectedParts| -> Vec<usize> {
            let parts = parts.numbered();
            (0..system.points()).map(|point| parts.of(point)).collect()
        };
        assert_eq!(of_points(joined), of_points(expected), "the same parts");
    }
}

/// A few unknowns held at some values.
fn held<const D: usize>(points: usize, noise: &mut Noise) -> Vec<Equation> {
    let one = |noise: &mut Noise| Equation {
        terms: vec![(Unknown { component: noise.index(D), point: noise.index(points) }, 1.0)],
        value: 0.0,
        origin: "held".into(),
    };
    (0..3).map(|_| one(noise)).collect()
}

/// The same, and one unknown that follows two others.
pub(crate) fn constrained<const D: usize>(points: usize, noise: &mut Noise) -> Vec<Equation> {
    let mut equations = held::<D>(points, noise);
    let terms = [1.0, -0.7, 0.4].map(|c| {
        let (component, point) = (noise.index(D), noise.index(points));
        (Unknown { component, point }, c)
    });
    equations.push(Equation { terms: terms.to_vec(), value: 0.0, origin: "tie".into() });
    equations
}

fn layouts_agree<const D: usize, M: Model<D>>(model: &M, extra: Vec<Box<dyn Term<D>>>, noise: &mut Noise) {
    let n = model.points();
    let system = System::new(model, extra, held::<D>(n, noise)).expect("no contradiction");
    if system.constraints().has_slaves() {
        return;
    }
    let mut band = BlockMatrix::band(n, system.reach());
    system.terms().iter().for_each(|term| term.add_tangent(&mut band));
    let [banded, rows] =
        [band, system.stiffness()].map(|k| dense(&k.to_csr(|point, component| component * n + point)));
    assert_close(
        banded.as_slice(),
        rows.as_slice(),
        largest(rows.as_slice()),
        1e-14,
        "entries of both layouts",
    );
    let (half_bandwidth, values) = system.assemble_band();
    let sparse = whole(&system.assemble_sparse());
    let number = |unknown: usize| (unknown % D) * n + unknown / D;
    let scale = largest(sparse.as_slice());
    for j in 0..D * n {
        for i in j..D * n {
            let in_band =
                if i - j <= half_bandwidth { values[j * (half_bandwidth + 1) + i - j] } else { 0.0 };
            let expected = sparse[(number(i), number(j))];
            assert!((in_band - expected).abs() <= 1e-14 * scale, "({i}, {j}): {in_band} for {expected}");
        }
    }
}

fn constrained_operator_is_the_folded_matrix<const D: usize, M: Model<D>>(
    model: &M,
    extra: Vec<Box<dyn Term<D>>>,
    noise: &mut Noise,
) {
    let n = model.points();
    let mut system = System::new(model, extra, Vec::new()).expect("no contradiction");
    system.constrain(model, constrained::<D>(n, noise)).expect("homogeneous equations never contradict");
    let k = whole(&system.assemble_sparse());
    let mut q = noise.vector(D * n);
    let rows = system.constraints().rows();
    rows.iter().for_each(|r| q[r.unknown] = 0.0);
    // Points without bonds have inert entries.
    let free = system.stiffness().to_csr(|point, component| component * n + point);
    (0..D * n).filter(|&k| free.get(k, k).is_none_or(|d| *d == 0.0)).for_each(|k| q[k] = 0.0);
    let mut y = vec![f64::NAN; D * n];
    system.product(&q, &mut y);
    let product = &k * nalgebra::DVector::from_column_slice(&q);
    let scale = k.row_iter().map(|row| row.iter().map(|a| a.abs()).sum()).fold(0.0, f64::max);
    assert_close(product.as_slice(), &y, scale, 1e-14, "TᵀKT q");
    let mut u = q.clone();
    system.constraints().expand(0.0, &mut u);
    let energy = system.survey(&u).energy;
    assert!((0.5 * dot(&q, &y) - energy).abs() <= 1e-13 * energy, "q·TᵀKT q = 2 E(T q)");
}

fn product(k: &CsMat<f64>, v: &[f64]) -> Vec<f64> {
    k.outer_iterator().map(|row| row.iter().map(|(j, a)| a * v[j]).sum()).collect()
}

/// Largest sum of magnitudes of a row.
fn row_scale(k: &CsMat<f64>) -> f64 {
    let sum = |row: sprs::CsVecView<f64>| row.data().iter().map(|a| a.abs()).sum::<f64>();
    k.outer_iterator().map(sum).fold(0.0, f64::max)
}

/// A symmetric matrix from its lower triangle.
fn whole(lower: &CsMat<f64>) -> DMatrix<f64> {
    let mut k = dense(lower);
    k.fill_upper_triangle_with_lower_triangle();
    k
}

fn dense(k: &CsMat<f64>) -> DMatrix<f64> {
    let mut dense = DMatrix::zeros(k.rows(), k.cols());
    k.iter().for_each(|(&value, (i, j))| dense[(i, j)] += value);
    dense
}
