//! Acceptance of plates: literals are those of an implementation in Python that shares no code with this one, unless something
//! else is said. Its unit is D = 1, and S = 3.5/t² for ν = 0.3 and κ = 5/6.

mod body;
mod breaking;
mod closed_forms;
mod fields;
mod free;
mod patch;
mod reference;
mod steps;
mod transfer;
mod weights;

use super::{PHI_X, PHI_Y, PlateBending, PlateParameters, PlateSection, ShearLaw, W};
use crate::body::SquareLattice;
use crate::model::Model;
use crate::stiffness::{BlockMatrix, Spring, Springs, Term};
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

/// A plate of unit bending stiffness and a thickness per unit length.
fn section(nu: f64, t: f64) -> PlateSection {
    let plate = PlateSection::homogeneous(1.0, nu, t, 5.0 / 6.0);
    PlateSection { bending: 1.0, poisson_ratio: nu, shear: plate.shear / plate.bending }
}

fn parameters(m: f64, t: f64) -> PlateParameters {
    PlateParameters { section: section(0.3, t), horizon_ratio: m, shear_law: ShearLaw::Corrected }
}

fn plate(cells: SquareLattice, parameters: PlateParameters) -> PlateBending {
    PlateBending::new(Arc::new(cells), parameters).unwrap()
}

/// A unit square of so many cells along a side.
fn square(cells: i32, parameters: PlateParameters) -> PlateBending {
    plate(SquareLattice::rectangle(1.0 / f64::from(cells), [0.0; 2], [cells; 2]), parameters)
}

/// How the edges of a rectangle are held.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Held {
    Clamped,
    HardSupports,
    SoftSupports,
    LeftClamped,
    /// The left edge clamped and no turning about x: a strip in cylindrical bending.
    Strip,
}

/// Numbers of the unknowns that are zero.
fn fixed(plate: &PlateBending, held: Held) -> Vec<usize> {
    let (nodes, n) = (plate.nodes(), plate.nodes().points());
    let cells = nodes.cells();
    let [right, top] = [cells.columns().end, cells.rows().end];
    let mut fixed = Vec::new();
    for point in 0..n {
        let [i, j] = nodes.node(point);
        let (on_x, on_y) = (i == 0 || i == right, j == 0 || j == top);
        let components: Vec<usize> = match held {
            Held::Clamped if on_x || on_y => vec![W, PHI_X, PHI_Y],
            Held::HardSupports => {
                let along = |on: bool, c: usize| on.then_some(c);
                [along(on_x || on_y, W), along(on_y, PHI_X), along(on_x, PHI_Y)]
                    .into_iter()
                    .flatten()
                    .collect()
            }
            Held::SoftSupports if on_x || on_y => vec![W],
            Held::LeftClamped if i == 0 => vec![W, PHI_X, PHI_Y],
            Held::Strip if i == 0 => vec![W, PHI_X, PHI_Y],
            Held::Strip => vec![PHI_Y],
            _ => Vec::new(),
        };
        fixed.extend(components.into_iter().map(|c| c * n + point));
    }
    fixed
}

/// A plate with springs, its stiffness factored, ready for loads.
struct Solver {
    terms: Vec<Box<dyn Term<3>>>,
    free: Vec<usize>,
    scale: Vec<f64>,
    factor: nalgebra::Cholesky<f64, nalgebra::Dyn>,
    size: usize,
}

impl Solver {
    fn new(plate: &PlateBending, springs: Vec<Spring>, fixed: &[usize]) -> Self {
        let n = plate.nodes().points();
        let mut terms = plate.terms();
        terms.push(Box::new(Springs::new(n, springs)));
        let k = stiffness(n, &terms);
        let mut is_fixed = vec![false; 3 * n];
        fixed.iter().for_each(|&unknown| is_fixed[unknown] = true);
        let free: Vec<usize> = (0..3 * n).filter(|&unknown| !is_fixed[unknown]).collect();
        let scale: Vec<f64> = free.iter().map(|&i| 1.0 / k[(i, i)].sqrt()).collect();
        let scaled =
            DMatrix::from_fn(free.len(), free.len(), |a, b| scale[a] * k[(free[a], free[b])] * scale[b]);
        Self { terms, scale, factor: scaled.cholesky().unwrap(), free, size: 3 * n }
    }

    fn force(&self, u: &[f64]) -> Vec<f64> {
        let mut force = vec![0.0; self.size];
        self.terms.iter().for_each(|term| term.add_force(u, &mut force));
        force
    }

    fn expand(&self, x: &DVector<f64>) -> Vec<f64> {
        let mut u = vec![0.0; self.size];
        self.free.iter().zip(x.iter()).for_each(|(&i, x)| u[i] = *x);
        u
    }

    fn restrict(&self, u: &[f64]) -> DVector<f64> {
        DVector::from_iterator(self.free.len(), self.free.iter().map(|&i| u[i]))
    }

    fn precondition(&self, r: &DVector<f64>) -> DVector<f64> {
        let scale = DVector::from_column_slice(&self.scale);
        self.factor.solve(&r.component_mul(&scale)).component_mul(&scale)
    }

    /// Unknowns under a load: the factor as preconditioner of conjugate gradients on the bonds.
    fn solve(&self, load: &[f64]) -> Vec<f64> {
        let b = self.restrict(load);
        let mut x = self.precondition(&b);
        let mut r = &b - self.restrict(&self.force(&self.expand(&x)));
        let mut z = self.precondition(&r);
        let (mut p, mut rz, first) = (z.clone(), r.dot(&z), x.dot(&b));
        for _ in 0..8 {
            if rz <= 1e-31 * first {
                break;
            }
            let q = self.restrict(&self.force(&self.expand(&p)));
            let step = rz / p.dot(&q);
            x += step * &p;
            r -= step * &q;
            z = self.precondition(&r);
            let before = std::mem::replace(&mut rz, r.dot(&z));
            p = &z + (rz / before) * p;
        }
        self.expand(&x)
    }
}

fn stiffness(n: usize, terms: &[Box<dyn Term<3>>]) -> DMatrix<f64> {
    let mut blocks = BlockMatrix::<3>::sparse(n, terms);
    terms.iter().for_each(|term| term.add_tangent(&mut blocks));
    let mut k = DMatrix::zeros(3 * n, 3 * n);
    blocks.for_each_block(|i, j, block| {
        for a in 0..3 {
            for b in 0..3 {
                k[(a * n + i, b * n + j)] = block[a][b];
                k[(b * n + j, a * n + i)] = block[a][b];
            }
        }
    });
    k
}

/// Pressure one, in quarters of cells without couples at edges.
fn lumped(plate: &PlateBending) -> Vec<f64> {
    let n = plate.nodes().points();
    let mut load = vec![0.0; 3 * n];
    (0..n).for_each(|p| load[p] = plate.nodes().area(p));
    load
}

/// Pressure one as the model has it.
fn pressure(plate: &PlateBending) -> Vec<f64> {
    let mut load = vec![0.0; 3 * plate.nodes().points()];
    plate.add_pressure(|_| true, |_| 1.0, &mut load);
    load
}

/// A line load of one along the right edge.
fn line(plate: &PlateBending) -> Vec<f64> {
    let right = plate.nodes().edges().into_iter().filter(|edge| edge.outward[0] > 0.5);
    let segments: Vec<[u32; 2]> = right.map(|edge| edge.points).collect();
    let mut load = vec![0.0; 3 * plate.nodes().points()];
    plate.add_line(&segments, |_, _| [1.0, 0.0, 0.0], &mut load);
    load
}

fn solve(plate: &PlateBending, held: Held, load: &[f64]) -> Vec<f64> {
    Solver::new(plate, Vec::new(), &fixed(plate, held)).solve(load)
}

/// The deflection at a place.
fn deflection(plate: &PlateBending, u: &[f64], place: [f64; 2]) -> f64 {
    let h = plate.nodes().spacing();
    u[plate.nodes().number(place.map(|x| (x / h).round() as i32)).unwrap()]
}

fn assert_close(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance * expected.abs(),
        "{found:.13e} is not {expected:.13e}, by {:.1e}",
        found / expected - 1.0
    );
}
