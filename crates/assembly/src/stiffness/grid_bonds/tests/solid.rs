//! Bonds of a lattice of several layers: every point moves along x, y and z, and bonds resist their elongation.

use super::*;
use std::ops::Range;

/// Elongation alone, in space.
struct InSpace;

impl BondModel<3, 1> for InSpace {
    const DIFFERENCE: [[bool; 3]; 1] = [[true; 3]];
    const MEAN: [[bool; 3]; 1] = [[false; 3]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 1> {
        Rows { difference: [bond.xi.map(|x| x / bond.length())], mean: [[0.0; 3]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        [1.0 / bond.length()]
    }
}

/// 205 × 9 × 7 cells with a hole and a ragged side: some chunks have all neighbours.
fn solid() -> Arc<SquareLattice> {
    let inside = |[i, j, k]: Cell| (i - 180).pow(2) + (j - 4).pow(2) > 6 - k && i < 205 - (j + k) % 3;
    Arc::new(SquareLattice::new(0.5, [1.0, -2.0, 0.5], [0..205, 0..9, 0..7], inside))
}

/// Half of the steps to all neighbours within two cells.
fn steps() -> Vec<Offset<1>> {
    let all = (0..=2).flat_map(|c| (-2..=2).flat_map(move |b| (-2..=2).map(move |a: i32| [a, b, c])));
    let half = all.filter(|&[a, b, c]| [c, b, a] > [0; 3] && a * a + b * b + c * c <= 4);
    half.zip(1..).map(|(step, k)| Offset { step, weights: [f64::from(k)] }).collect()
}

/// Forces, and the energy, pair by pair.
fn pair_by_pair(lattice: &SquareLattice, exceptions: &[Exception], u: &[f64]) -> (Vec<f64>, f64) {
    let n = lattice.points();
    let (mut force, mut energy) = (vec![0.0; 3 * n], 0.0);
    for (k, Offset { step, weights }) in steps().iter().enumerate() {
        let xi = step.map(|s| lattice.spacing() * f64::from(s));
        let length = xi.iter().map(|x| x * x).sum::<f64>().sqrt();
        for i in 0..n {
            let Some(j) = lattice.number(plus(lattice.cell(i), *step)) else { continue };
            let mine = exceptions.iter().filter(|e| (e.offset, e.lower) == (k, i));
            let stiffness = weights[0] / length * mine.map(|e| e.factor).product::<f64>();
            let stretch = (0..3).map(|c| xi[c] / length * (u[c * n + j] - u[c * n + i])).sum::<f64>();
            energy += 0.5 * stiffness * stretch * stretch;
            for c in 0..3 {
                force[c * n + j] += stiffness * stretch * xi[c] / length;
                force[c * n + i] -= stiffness * stretch * xi[c] / length;
            }
        }
    }
    (force, energy)
}

fn grid(lattice: &Arc<SquareLattice>) -> (GridBonds<3, 1, InSpace>, Vec<Exception>) {
    let some = (0..lattice.points()).filter(|p| p % 97 == 5);
    let weak = |lower: usize| Exception { offset: lower % 16, lower, factor: [0.0, 0.25][lower % 2] };
    let exceptions: Vec<Exception> = some.map(weak).collect();
    (GridBonds::new(lattice.clone(), &InSpace, &steps(), &exceptions), exceptions)
}

fn largest_difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn forces_are_those_of_all_pairs() {
    let lattice = solid();
    let whole = GridBonds::new(lattice.clone(), &InSpace, &steps(), &[]);
    let (weakened, exceptions) = grid(&lattice);
    assert!(whole.chunks.all().iter().any(|chunk| chunk.is_inner));
    let u = random(3 * lattice.points());
    for (grid, exceptions) in [(whole, Vec::new()), (weakened, exceptions)] {
        let (expected, energy) = pair_by_pair(&lattice, &exceptions, &u);
        let mut force = vec![0.0; u.len()];
        grid.add_force(&u, &mut force);
        // Sums of about thirty numbers of size ten in another order.
        assert!(largest_difference(&force, &expected) < 1e-12);
        assert!((grid.survey(&u).energy / energy - 1.0).abs() < 1e-13);
        // The assembled matrix does the same.
        let n = lattice.points();
        let terms: [Box<dyn Term<3>>; 1] = [Box::new(grid)];
        let mut matrix = BlockMatrix::sparse(n, &terms);
        terms[0].add_tangent(&mut matrix);
        let matrix = matrix.to_csr(|point, component| component * n + point);
        for (row, force) in matrix.outer_iterator().zip(&expected) {
            let product: f64 = row.iter().map(|(column, k)| k * u[column]).sum();
            assert!((product - force).abs() < 1e-12);
        }
    }
}

#[test]
fn six_rigid_motions_cost_nothing() {
    let lattice = solid();
    let (grid, _) = grid(&lattice);
    let n = lattice.points();
    let motions: [fn([f64; 3]) -> [f64; 3]; 6] = [
        |_| [1.0, 0.0, 0.0],
        |_| [0.0, 1.0, 0.0],
        |_| [0.0, 0.0, 1.0],
        |[_, y, z]| [0.0, -z, y],
        |[x, _, z]| [z, 0.0, -x],
        |[x, y, _]| [-y, x, 0.0],
    ];
    for motion in motions {
        let moved: Vec<[f64; 3]> = (0..n).map(|p| motion(lattice.position(p))).collect();
        let u: Vec<f64> = (0..3 * n).map(|k| moved[k % n][k / n]).collect();
        let mut force = vec![0.0; 3 * n];
        grid.add_force(&u, &mut force);
        // Displacements up to 100, stiffnesses up to 30.
        assert!(force.iter().all(|f| f.abs() < 1e-11));
        assert!(grid.survey(&u).energy < 1e-18);
    }
}

#[test]
fn work_is_the_adjoint_of_sums_over_bonds_in_layers() {
    let lattice = solid();
    let (grid, _) = grid(&lattice);
    let (n, u) = (lattice.points(), random(3 * lattice.points()));
    let shares: Vec<Mat<2, 1>> = (0..steps().len()).map(|k| [[1.0 + k as f64], [0.3]]).collect();
    // Two lines of different layers alone have strains.
    let spans: Vec<Range<i32>> =
        (0..9 * 7).map(|line| if line == 20 || line == 41 { 10..60 } else { 0..0 }).collect();
    let is_in = |p: usize| {
        let [column, row, layer] = lattice.cell(p);
        spans[(layer * 9 + row) as usize].contains(&column)
    };
    let t: Vec<f64> =
        random(2 * n).iter().enumerate().map(|(k, t)| if is_in(k % n) { *t } else { 0.0 }).collect();
    let sums = grid.sums::<2>(&u, &shares);
    let mut force = vec![0.0; 3 * n];
    grid.add_work::<2>(&t, &spans, &shares, &mut force);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (work, expected) = (dot(&force, &u), dot(&t, &sums));
    assert!((work / expected - 1.0).abs() < 1e-12, "{work} {expected}");
}

#[test]
fn a_cut_between_layers_makes_two_parts() {
    let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], [150, 6, 8]));
    let crosses = |step: Cell, p: usize| {
        let layer = lattice.cell(p)[2];
        (layer < 4) != (layer + step[2] < 4)
    };
    let all =
        steps().into_iter().enumerate().flat_map(|(k, o)| (0..lattice.points()).map(move |p| (k, o.step, p)));
    let cuts: Vec<Exception> = all
        .filter(|&(_, step, p)| crosses(step, p))
        .map(|(offset, _, lower)| Exception { offset, lower, factor: 0.0 })
        .collect();
    for (exceptions, count) in [(&cuts[..], 2), (&[], 1)] {
        let grid = GridBonds::new(lattice.clone(), &InSpace, &steps(), exceptions);
        let mut joined = ConnectedParts::new(lattice.points());
        Term::<3>::join(&grid, &mut joined);
        assert_eq!(joined.numbered().spans().len(), count);
    }
}
