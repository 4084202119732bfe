//! Bodies of a few points, solved densely.

mod axis;
mod border;
mod lame;
mod materials;
mod patch;
mod ring_border;
mod spectrum;

use super::super::bond_plane::Influence;
use super::super::plane::{Mirrors, PlaneModel};
use super::{Axis, Dilatation, Geometry, Measure, StateBased, StateEdges, StateParameters};
use crate::body::SquareLattice;
use crate::condition::{Equation, Unknown};
use crate::model::Model;
use crate::system::System;
use nalgebra::{DMatrix, DVector};
use std::sync::Arc;

const RING: StateParameters = StateParameters {
    youngs_modulus: 1.0,
    poisson_ratio: 0.3,
    geometry: Geometry::Axisymmetric,
    horizon_ratio: 3.0,
    influence: Influence::Inverse,
    edges: StateEdges::Ghosts,
    measure: Measure::Section,
    axis: Axis::Images,
    dilatation: Dilatation::Points,
};

const PLATE: StateParameters = StateParameters { geometry: Geometry::PlaneStress(0.5), ..RING };

fn body(lattice: SquareLattice, mirrors: Mirrors, parameters: StateParameters) -> StateBased {
    StateBased::on_lattice(Arc::new(lattice), mirrors, parameters, &|_, _| false, &|_| Vec::new()).unwrap()
}

/// A lattice of `size` cells of a spacing from a radius, at y = 0.
fn cells(spacing: f64, radius: f64, size: [i32; 2]) -> SquareLattice {
    SquareLattice::rectangle(spacing, [radius, 0.0], size)
}

/// A strip of one row between mirrors: plane strain.
fn strip(spacing: f64, radius: f64, columns: i32, parameters: StateParameters) -> StateBased {
    let mirrors = Mirrors::in_plane([None; 2], [Some(0), Some(1)]);
    body(cells(spacing, radius, [columns, 1]), mirrors, parameters)
}

fn held(component: usize, point: usize, value: f64) -> Equation {
    Equation { terms: vec![(Unknown { component, point }, 1.0)], value, origin: "held".into() }
}

/// Real points, in the order of their numbers.
fn real_points(model: &impl PlaneModel) -> Vec<usize> {
    (0..model.points()).filter(|p| model.ghosts().binary_search(&(*p as u32)).is_err()).collect()
}

/// The stiffness on the independent unknowns, full.
fn stiffness(system: &System<2>) -> DMatrix<f64> {
    let lower = system.assemble_sparse();
    let mut full = DMatrix::zeros(system.size(), system.size());
    for (value, (row, column)) in &lower {
        (full[(row, column)], full[(column, row)]) = (*value, *value);
    }
    full
}

/// Unknowns under a load and the prescribed values, refined on the element-wise operator.
fn solve(model: &dyn Model<2>, held: Vec<Equation>, force: &[f64]) -> Vec<f64> {
    let system = System::new(model, Vec::new(), held).unwrap();
    let factor = stiffness(&system).cholesky().expect("the body is held");
    let mut u = vec![0.0; system.size()];
    system.constraints().expand(1.0, &mut u);
    for _ in 0..3 {
        let mut internal = vec![0.0; system.size()];
        system.terms().iter().for_each(|t| t.add_force(&u, &mut internal));
        let mut rest: Vec<f64> = force.iter().zip(&internal).map(|(f, i)| f - i).collect();
        system.constraints().restrict(&mut rest);
        let change = factor.solve(&DVector::from_vec(rest));
        u.iter_mut().zip(change.iter()).for_each(|(u, du)| *u += du);
        system.constraints().expand(1.0, &mut u);
    }
    u
}

/// The displacement `(a x + b y, c x + d y)` of all points.
fn linear(model: &dyn Model<2>, [a, b, c, d]: [f64; 4]) -> Vec<f64> {
    let at = |p: usize| model.position(p);
    let x = (0..model.points()).map(|p| a * at(p)[0] + b * at(p)[1]);
    let y = (0..model.points()).map(|p| c * at(p)[0] + d * at(p)[1]);
    x.chain(y).collect()
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |most: f64, v| most.max(v.abs()))
}
