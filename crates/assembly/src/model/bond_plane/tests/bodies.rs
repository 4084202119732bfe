//! Bodies and helpers of the tests.

use super::super::*;
use crate::body::{Hole, Outline, Shape};
use crate::model::plane::{Calibration, Edges, Mirrors, Solvable};
use crate::stiffness::{BlockMatrix, Term};
use nalgebra::{DMatrix, DVector};

pub(super) const MM_MPA: [f64; 3] = [1.0, 73100.0, 25.0];
/// A unit of length, Young's modulus and thickness: mm and MPa, m and Pa.
pub(super) const UNITS: [[f64; 3]; 2] = [MM_MPA, [1e-3, 73.1e9, 0.025]];

pub(super) fn parameters(m: f64, [_, youngs_modulus, thickness]: [f64; 3]) -> PlaneParameters {
    PlaneParameters {
        material: PlaneMaterial { youngs_modulus, thickness, state: PlaneState::Stress },
        horizon_ratio: m,
        influence: Influence::Constant,
        calibration: Calibration::Matched,
        weights: Weights::Nearest,
        volume_factor: VolumeFactor::Ramp,
        edges: Edges::Overlay,
    }
}

/// A rectangle with a hole, an L, a disc and a triangle with a sharp tip, of cells of size `h`: whole ones, and such that
/// the border cuts.
pub(in crate::model) fn bodies(h: f64) -> Vec<(&'static str, Arc<SquareLattice>)> {
    let make = |columns: i32, rows: i32, inside: &dyn Fn(f64, f64) -> bool| {
        let centre = |k: i32| f64::from(k) + 0.5;
        let at = |[i, j]: [i32; 2]| inside(centre(i), centre(j));
        Arc::new(SquareLattice::plane(h, [0.3 * h, -2.0 * h], 0..columns, 0..rows, at))
    };
    let cut = |outline: &Outline| {
        let lattice = outline.fill(h).unwrap();
        assert!(lattice.cut_cells().len() > 10);
        Arc::new(lattice)
    };
    let polygon = |corners: Vec<[f64; 2]>| {
        Outline::polygon(corners.into_iter().map(|c| c.map(|x| h * x)).collect()).unwrap()
    };
    let mut plate = Outline::rectangle([0.3 * h, -2.0 * h], [18.0 * h, 13.0 * h]).unwrap();
    let circle = Shape::Circle { centre: [9.3 * h, 4.1 * h], radius: 2.9 * h };
    plate.cut(Hole { name: None, shape: circle }).unwrap();
    let turn = |k: i32| (f64::from(k) * std::f64::consts::PI / 30.0).sin_cos();
    let disc = polygon((0..60).map(turn).map(|(s, c)| [6.3 * c, 6.3 * s]).collect());
    let wedge = polygon(vec![[0.0, 0.0], [20.0, 5.3], [20.0, 12.7]]);
    let oblique = polygon(vec![[0.0, 3.1], [11.4, 0.0], [14.0, 8.2], [2.2, 11.5]]);
    vec![
        ("hole", make(18, 13, &|x, y| (x - 9.0).hypot(y - 6.0) > 2.6)),
        ("L", make(14, 14, &|x, y| x < 6.0 || y < 5.0)),
        ("disc", make(13, 13, &|x, y| (x - 6.5).hypot(y - 6.5) < 6.4)),
        // One cell per row at the tip: cells without neighbours on three sides.
        ("wedge", make(20, 14, &|x, y| y < 0.62 * x && y > 0.3 * x)),
        ("cut hole", cut(&plate)),
        ("cut disc", cut(&disc)),
        ("cut wedge", cut(&wedge)),
        ("cut quadrilateral", cut(&oblique)),
    ]
}

/// The same bodies in axes turned by 30°, and a plate that fills turned cells.
pub(in crate::model) fn turned_bodies(h: f64) -> Vec<(&'static str, Arc<SquareLattice>)> {
    let angle = std::f64::consts::PI / 6.0;
    let turned =
        |lattice: Arc<SquareLattice>| Arc::new(lattice.as_ref().clone().turned(angle, [0.4 * h, 0.7 * h]));
    let mut plate = Outline::rectangle([0.3 * h, -2.0 * h], [18.4 * h, 13.3 * h]).unwrap();
    let circle = Shape::Circle { centre: [9.3 * h, 4.1 * h], radius: 2.9 * h };
    plate.cut(Hole { name: None, shape: circle }).unwrap();
    let mut all: Vec<_> = bodies(h).into_iter().map(|(name, lattice)| (name, turned(lattice))).collect();
    all.push(("turned cells", Arc::new(plate.fill_turned(h, angle).unwrap())));
    all
}

pub(super) fn plane(lattice: &Arc<SquareLattice>, parameters: PlaneParameters) -> BondPlane {
    BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap()
}

/// Displacement `g x` of all points.
pub(super) fn linear(plane: &dyn Solvable<2>, g: [[f64; 2]; 2]) -> Vec<f64> {
    let n = plane.points();
    let mut u = vec![0.0; 2 * n];
    for p in 0..n {
        let [x, y] = plane.place(p);
        (0..2).for_each(|c| u[c * n + p] = g[c][0] * x + g[c][1] * y);
    }
    u
}

pub(super) fn force(plane: &dyn Solvable<2>, u: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; u.len()];
    plane.terms().iter().for_each(|t| t.add_force(u, &mut force));
    force
}

pub(super) fn energy(plane: &dyn Solvable<2>, u: &[f64]) -> f64 {
    plane.terms().iter().map(|t| t.survey(u).energy).sum()
}

pub(super) fn matrix(plane: &dyn Solvable<2>) -> DMatrix<f64> {
    let n = plane.points();
    let terms: Vec<Box<dyn Term<2>>> = plane.terms();
    let mut k = BlockMatrix::sparse(n, &terms);
    terms.iter().for_each(|t| t.add_tangent(&mut k));
    let mut dense = DMatrix::zeros(2 * n, 2 * n);
    k.for_each_entry(|[i, r], [j, c], value| {
        dense[(r * n + i, c * n + j)] = value;
        dense[(c * n + j, r * n + i)] = value;
    });
    dense
}

/// Solves `K u = f` with three unknowns prescribed as in `exact`; refined with the forces of the elements.
pub(super) fn solve(plane: &dyn Solvable<2>, f: &[f64], exact: &[f64]) -> Vec<f64> {
    let n = plane.points();
    // Two points far apart.
    let far = (0..n).max_by(|&a, &b| (plane.place(a)[0]).total_cmp(&plane.place(b)[0])).unwrap();
    let held = [0, n, n + far];
    let mut k = matrix(plane);
    let scale = k.diagonal().amax();
    for h in held {
        k.row_mut(h).fill(0.0);
        k.column_mut(h).fill(0.0);
        k[(h, h)] = scale;
    }
    let factor = k.cholesky().expect("three supports hold a body");
    let mut u = vec![0.0; 2 * n];
    held.iter().for_each(|&h| u[h] = exact[h]);
    for _ in 0..4 {
        let internal = force(plane, &u);
        let mut r = DVector::from_iterator(2 * n, f.iter().zip(&internal).map(|(a, b)| a - b));
        held.iter().for_each(|&h| r[h] = 0.0);
        let step = factor.solve(&r);
        u.iter_mut().zip(step.iter()).for_each(|(u, s)| *u += s);
    }
    u
}

pub(in crate::model) fn largest(v: &[f64]) -> f64 {
    v.iter().fold(0.0, |m: f64, x| m.max(x.abs()))
}

pub(in crate::model) fn difference(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

pub(in crate::model) fn random(size: usize) -> Vec<f64> {
    (0..size).map(|i| ((i * 7919 % 1013) as f64) / 1013.0 - 0.5).collect()
}
