//! Bodies, displacements of them and a solver.

use super::*;
use crate::stiffness::BlockMatrix;
use nalgebra::DMatrix;

fn ball([i, j, k]: [i32; 3]) -> f64 {
    [i, j, k].map(|x| f64::from(x) - 5.5).iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// A block, one with a hole, an L, a ball of whole and one of cut cells, two layers, and what is left of a block without every
/// fourth cell.
pub(in crate::model) fn bodies(h: f64) -> Vec<(&'static str, Arc<SquareLattice>)> {
    let make = |size: [i32; 3], inside: &dyn Fn([i32; 3]) -> bool| {
        let corner = [0.3 * h, -2.0 * h, 0.7 * h];
        Arc::new(SquareLattice::new(h, corner, size.map(|n| 0..n), inside))
    };
    let whole = make([12; 3], &|cell| ball(cell) < 5.6);
    let areas: Vec<([i32; 3], f64)> = (0..whole.points())
        .map(|p| whole.cell(p))
        .filter(|&cell| ball(cell) > 4.9)
        .map(|cell| (cell, (5.8 - ball(cell)).min(1.0)))
        .collect();
    let cut = Arc::new(SquareLattice::clone(&whole).with_areas(&areas));
    assert!(cut.cut_cells().len() > 100);
    vec![
        ("block", make([7, 6, 5], &|_| true)),
        ("hole", make([9, 9, 5], &|[i, j, _]| !((3..6).contains(&i) && (3..6).contains(&j)))),
        ("L", make([9, 8, 5], &|[i, j, _]| i < 4 || j < 3)),
        ("ball", whole),
        ("cut ball", cut),
        ("two layers", make([9, 9, 2], &|_| true)),
        ("porous", make([7, 6, 5], &|[i, j, k]| (i * 5 + j * 3 + k * 7 + i * j) % 4 != 0)),
    ]
}

/// Displacement `g x` of all points.
pub(in crate::model) fn linear(solid: &dyn Solvable<3>, g: [[f64; 3]; 3]) -> Vec<f64> {
    planes(solid, |at| g.map(|row| (0..3).map(|k| row[k] * at[k]).sum()))
}

/// A displacement of every point.
pub(in crate::model) fn planes(solid: &dyn Solvable<3>, of: impl Fn(Point) -> [f64; 3]) -> Vec<f64> {
    let n = solid.points();
    let mut u = vec![0.0; 3 * n];
    for p in 0..n {
        let own = of(solid.position(p));
        (0..3).for_each(|c| u[c * n + p] = own[c]);
    }
    u
}

/// The symmetric gradient with some strains.
pub(in crate::model) fn gradient([xx, yy, zz, yz, xz, xy]: [f64; 6]) -> [[f64; 3]; 3] {
    [[xx, 0.5 * xy, 0.5 * xz], [0.5 * xy, yy, 0.5 * yz], [0.5 * xz, 0.5 * yz, zz]]
}

pub(in crate::model) fn force(solid: &dyn Solvable<3>, u: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; u.len()];
    solid.terms().iter().for_each(|term| term.add_force(u, &mut force));
    force
}

pub(in crate::model) fn energy(solid: &dyn Solvable<3>, u: &[f64]) -> f64 {
    solid.terms().iter().map(|term| term.survey(u).energy).sum()
}

/// The stiffness, unknowns in planes.
pub(in crate::model) fn matrix(solid: &dyn Solvable<3>) -> DMatrix<f64> {
    let n = solid.points();
    let terms = solid.terms();
    let mut k = BlockMatrix::sparse(n, &terms);
    terms.iter().for_each(|term| term.add_tangent(&mut k));
    let mut dense = DMatrix::zeros(3 * n, 3 * n);
    k.for_each_entry(|[i, r], [j, c], value| {
        dense[(r * n + i, c * n + j)] = value;
        dense[(c * n + j, r * n + i)] = value;
    });
    dense
}

/// Conjugate gradients from a displacement that stays where unknowns are held.
pub(in crate::model) fn solve(
    solid: &dyn Solvable<3>,
    u: Vec<f64>,
    load: &[f64],
    held: impl Fn(usize) -> bool,
) -> Vec<f64> {
    let mask = |mut v: Vec<f64>| {
        v.iter_mut().enumerate().filter(|(k, _)| held(*k)).for_each(|(_, x)| *x = 0.0);
        v
    };
    let missing = load.iter().zip(force(solid, &u)).map(|(f, own)| f - own).collect();
    let step = gradients(&|p| mask(force(solid, p)), mask(missing));
    u.iter().zip(&step).map(|(u, step)| u + step).collect()
}

/// Conjugate gradients from zero.
pub(in crate::model) fn gradients(product: &dyn Fn(&[f64]) -> Vec<f64>, load: Vec<f64>) -> Vec<f64> {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let (mut u, mut r) = (vec![0.0; load.len()], load);
    let (mut p, mut rr) = (r.clone(), dot(&r, &r));
    let small = 1e-28 * rr;
    for _ in 0..20_000 {
        if rr <= small {
            return u;
        }
        let q = product(&p);
        let step = rr / dot(&p, &q);
        u.iter_mut().zip(&p).for_each(|(u, p)| *u += step * p);
        r.iter_mut().zip(&q).for_each(|(r, q)| *r -= step * q);
        let before = std::mem::replace(&mut rr, dot(&r, &r));
        p.iter_mut().zip(&r).for_each(|(p, r)| *p = r + rr / before * *p);
    }
    panic!("no solution")
}
