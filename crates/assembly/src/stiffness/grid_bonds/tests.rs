mod solid;
mod tables;

use super::*;
use crate::body::plus;
use crate::bonds::Rows;
use crate::stiffness::{Bond, Bonds};

/// Elongation alone.
struct Central;

impl BondModel<2, 1> for Central {
    const DIFFERENCE: [[bool; 2]; 1] = [[true, true]];
    const MEAN: [[bool; 2]; 1] = [[false, false]];

    fn rows(&self, bond: &BondGeometry) -> Rows<2, 1> {
        let l = bond.length();
        Rows { difference: [[bond.xi[0] / l, bond.xi[1] / l]], mean: [[0.0; 2]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 1] {
        [1.0 / bond.length()]
    }
}

/// A small beam: elongation, shear and bending of points that turn.
struct BeamLike;

impl BondModel<3, 3> for BeamLike {
    const DIFFERENCE: [[bool; 3]; 3] = [[true, true, false], [true, true, false], [false, false, true]];
    const MEAN: [[bool; 3]; 3] = [[false; 3], [false, false, true], [false; 3]];

    fn rows(&self, bond: &BondGeometry) -> Rows<3, 3> {
        let (l, [x, y, _]) = (bond.length(), bond.xi);
        Rows {
            difference: [[x / l, y / l, 0.0], [-y / l, x / l, 0.0], [0.0, 0.0, 1.0]],
            mean: [[0.0; 3], [0.0, 0.0, -l], [0.0; 3]],
        }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 3] {
        [1.0 / bond.length(), 0.3, 0.1]
    }
}

/// 150 × 12 cells with a hole and a ragged right side, so that all kinds of chunks occur.
fn lattice() -> Arc<SquareLattice> {
    let inside = |[i, j]: [i32; 2]| {
        let hole = (i - 40).pow(2) + (j - 5).pow(2) < 9;
        !hole && i < 150 - j % 3
    };
    Arc::new(SquareLattice::plane(0.5, [0.0; 2], 0..150, 0..12, inside))
}

const STEPS: [Cell; 6] = [[1, 0, 0], [2, 0, 0], [0, 1, 0], [1, 1, 0], [-1, 1, 0], [-2, 1, 0]];

fn offsets<const M: usize>() -> Vec<Offset<M>> {
    STEPS.iter().zip(1..).map(|(&step, k)| Offset { step, weights: [f64::from(k); M] }).collect()
}

/// Some bonds are cut, some are weak, one of them twice.
fn exceptions(lattice: &SquareLattice) -> Vec<Exception> {
    let some = (0..lattice.points()).filter(|p| p % 97 == 5);
    let each = some.map(|lower| Exception {
        offset: lower % 6,
        lower,
        factor: if lower % 2 == 0 { 0.0 } else { 0.25 },
    });
    let mut all: Vec<Exception> = each.collect();
    all.push(Exception { factor: 0.5, ..all[1] });
    all
}

fn listed<const D: usize, const M: usize, B: BondModel<D, M>>(
    grid: &GridBonds<D, M, B>,
    model: &B,
    exceptions: &[Exception],
) -> Bonds<D, M> {
    let lattice = grid.lattice();
    let mut bonds = Vec::new();
    for (index, offset) in offsets::<1>().iter().enumerate() {
        for i in 0..lattice.points() {
            let Some(j) = lattice.number(plus(lattice.cell(i), offset.step)) else { continue };
            let [x, y, _] = offset.step.map(|k| lattice.spacing() * f64::from(k));
            let (sin, cos) = lattice.angle().sin_cos();
            let bond = BondGeometry { xi: [cos * x - sin * y, sin * x + cos * y, 0.0] };
            let mine = exceptions.iter().filter(|e| (e.offset, e.lower) == (index, i));
            let factor: f64 = offset.weights[0] * mine.map(|e| e.factor).product::<f64>();
            bonds.push(Bond {
                points: [i as u32, j as u32],
                rows: model.rows(&bond),
                moduli: model.moduli(&bond).map(|c| factor * c),
            });
        }
    }
    Bonds::new(lattice.points(), bonds.into_iter())
}

fn random(size: usize) -> Vec<f64> {
    (0..size).map(|i| ((i * 7919 % 1013) as f64) / 1013.0 - 0.5).collect()
}

/// How far forces in numbers of 32 bits are from others.
fn largest_of_single<const D: usize, const M: usize, B: BondModel<D, M>>(
    grid: &GridBonds<D, M, B>,
    u: &[f64],
    forces: &[f64],
) -> f64 {
    let u: Vec<f32> = u.iter().map(|u| *u as f32).collect();
    let mut single = vec![f32::NAN; u.len()];
    assert!(grid.sweeps_in_single());
    assert!(grid.sweep_in_single(&u, &mut single, &|_, forces, own| {
        own.into_iter().zip(forces).for_each(|(own, forces)| own.copy_from_slice(forces));
    }));
    assert!(single.iter().all(|force| force.is_finite()));
    single.iter().zip(forces).map(|(a, b)| (f64::from(*a) - b).abs()).fold(0.0, f64::max)
}

fn agrees_with_a_list<const D: usize, const M: usize, B: BondModel<D, M>>(model: &B) {
    let plain = lattice();
    let turned = Arc::new(SquareLattice::clone(&plain).turned(0.4, [1.0, 2.0]));
    let some = exceptions(&plain);
    for (lattice, exceptions) in [(&plain, Vec::new()), (&plain, some.clone()), (&turned, some)] {
        let grid = GridBonds::new(lattice.clone(), model, &offsets(), &exceptions);
        let list = listed(&grid, model, &exceptions);
        assert_eq!(grid.elements(), list.elements());
        let u = random(D * lattice.points());
        let mut forces = [vec![0.0; u.len()], vec![0.0; u.len()]];
        grid.add_force(&u, &mut forces[0]);
        list.add_force(&u, &mut forces[1]);
        // Sums of about twenty numbers of size one in another order.
        let difference = forces[0].iter().zip(&forces[1]).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(difference < 1e-13, "{difference}");
        let difference = largest_of_single(&grid, &u, &forces[1]);
        let largest = forces[1].iter().fold(0.0_f64, |largest, f| largest.max(f.abs()));
        // Found 1.4e-7 to 2.1e-7 of the largest.
        assert!(difference < 1e-6 * largest, "{difference} of {largest}");
        let (a, b) = (grid.survey(&u), list.survey(&u));
        assert!((a.energy / b.energy - 1.0).abs() < 1e-13);
        for c in 0..D {
            assert!((a.largest_action[c] / b.largest_action[c] - 1.0).abs() < 1e-13);
        }
        let matrices = [&grid as &dyn Term<D>, &list].map(|term| {
            let (mut count, mut pairs) = (0, Vec::new());
            term.couplings(&mut |i, j| pairs.push((i, j)));
            pairs.sort_unstable();
            count += pairs.len();
            (count, pairs)
        });
        assert_eq!(matrices[0], matrices[1]);
        assert_eq!(Term::<D>::reach(&grid), Term::<D>::reach(&list));
    }
}

#[test]
fn a_lattice_is_the_list_of_its_bonds() {
    agrees_with_a_list(&Central);
    agrees_with_a_list(&BeamLike);
}

#[test]
fn the_product_of_the_assembled_matrix_is_the_force() {
    let lattice = lattice();
    let grid = GridBonds::new(lattice.clone(), &BeamLike, &offsets(), &exceptions(&lattice));
    let n = lattice.points();
    let terms: [Box<dyn Term<3>>; 1] = [Box::new(grid)];
    let mut k = BlockMatrix::sparse(n, &terms);
    terms[0].add_tangent(&mut k);
    let u = random(3 * n);
    let mut force = vec![0.0; 3 * n];
    terms[0].add_force(&u, &mut force);
    let mut product = vec![0.0; 3 * n];
    let mut blocks = vec![[[0.0; 3]; 3]; n];
    terms[0].add_diagonal(&mut blocks);
    k.for_each_entry(|[i, r], [j, c], value| {
        if i == j {
            assert!((blocks[i][r][c] - value).abs() < 1e-13 && (blocks[i][c][r] - value).abs() < 1e-13);
        }
        let (a, b) = (r * n + i, c * n + j);
        product[a] += value * u[b];
        if a != b {
            product[b] += value * u[a];
        }
    });
    let difference = product.iter().zip(&force).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(difference < 1e-13, "{difference}");
}

#[test]
fn a_cut_through_all_bonds_makes_two_parts() {
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [200, 9]));
    let mut cuts = Vec::new();
    for (offset, step) in STEPS.iter().enumerate() {
        for lower in 0..lattice.points() {
            let [i, ..] = lattice.cell(lower);
            if (i < 120) != (i + step[0] < 120) {
                cuts.push(Exception { offset, lower, factor: 0.0 });
            }
        }
    }
    for (exceptions, parts) in [(&cuts[..], 2), (&[], 1)] {
        let grid = GridBonds::new(lattice.clone(), &Central, &offsets(), exceptions);
        let mut joined = ConnectedParts::new(lattice.points());
        Term::<2>::join(&grid, &mut joined);
        assert_eq!(joined.numbered().spans().len(), parts);
    }
}

#[test]
fn forces_do_not_depend_on_the_number_of_threads() {
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [300, 100]));
    let grid = GridBonds::new(lattice.clone(), &Central, &offsets(), &[]);
    let u = random(2 * lattice.points());
    let results = [1, 2, 3].map(|threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        pool.install(|| {
            let mut force = vec![0.0; u.len()];
            grid.add_force(&u, &mut force);
            (force, grid.survey(&u))
        })
    });
    assert!(results[0] == results[1] && results[1] == results[2]);
    // Opposite forces of a bond are equal to the last bit, so only the sum over the points rounds.
    let sum: f64 = results[0].0[..lattice.points()].iter().sum();
    assert!(sum.abs() < 1e-10, "{sum}");
}
