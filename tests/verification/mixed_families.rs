//! State-based families of several materials against layers and inclusions, with numbers of an independent implementation in NumPy
//! (the prototypes of the rule `S`), plane strain.

use crate::support::goodier::{Elastic, Goodier};
use crate::support::mixed::{Stiffness, line, prescribed};
use nalgebra::{DMatrix, DVector};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::Mirrors;
use peristat_assembly::model::state_based::{
    Axis, Dilatation, Geometry, Measure, StateBased, StateEdges, StateMaterials, StateParameters,
};
use peristat_assembly::model::{BodyModel, Points};
use std::sync::Arc;

/// E = 1, horizon of three spacings.
fn parameters(poisson_ratio: f64) -> StateParameters {
    StateParameters {
        youngs_modulus: 1.0,
        poisson_ratio,
        geometry: Geometry::PlaneStrain(1.0),
        horizon_ratio: 3.0,
        influence: Influence::Linear,
        edges: StateEdges::Ghosts,
        measure: Measure::Section,
        axis: Axis::Images,
        dilatation: Dilatation::Points,
    }
}

/// Stiffness of a strain along an axis, and across it.
fn stiffness([e, nu]: [f64; 2]) -> [f64; 2] {
    let [[direct, other, _], ..] = StateParameters { youngs_modulus: e, ..parameters(nu) }.stiffness();
    [direct, other]
}

/// A body with another material, `[E, ν]`, at some places.
fn body(lattice: SquareLattice, nu: f64, other: [f64; 2], is_other: impl Fn([f64; 2]) -> bool) -> StateBased {
    let numbers: Vec<u32> = (0..lattice.points()).map(|p| u32::from(is_other(lattice.place(p)))).collect();
    let factor = |number: &u32| if *number == 1 { other[0] / parameters(nu).youngs_modulus } else { 1.0 };
    let factors: Vec<f64> = numbers.iter().map(factor).collect();
    let materials = StateMaterials::new(&parameters(nu), &[other[1]], &numbers, &factors);
    let real = Arc::new(lattice);
    let none = |_: &SquareLattice| Vec::new();
    let made =
        StateBased::mixed(real, Mirrors::NONE, parameters(nu), &|_, _| false, &none, materials.as_ref());
    made.expect("families exist")
}

const ROWS: usize = 34;
const COLUMNS: usize = 21;

/// Two layers of 17 rows that do not move along x nor vary along it, pulled across by six rows at either end: the extra elongation at
/// the interface in spacings of the strain of the softer side.
fn jump(nu: f64, other: [f64; 2]) -> f64 {
    let middle = 0.5 * ROWS as f64;
    let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [COLUMNS as i32, ROWS as i32]);
    let body = body(lattice, nu, other, |[_, y]| y > middle);
    let (all, n) = (Stiffness::of(&body), body.points());
    let row_of = |p: usize| body.place(p)[1].floor();
    let of_middle = |row: usize| {
        let at = [COLUMNS as f64 / 2.0, row as f64 + 0.5];
        (0..n).find(|&p| body.place(p) == at).expect("a point of the middle column")
    };
    let column = |row: usize| -> Vec<f64> {
        let moved = (0..2 * n).map(|k| f64::from(u8::from(k >= n && row_of(k - n) == row as f64)));
        let force = all.forces(&moved.collect::<Vec<_>>());
        (0..ROWS).map(|at| force[n + of_middle(at)]).collect()
    };
    let rows =
        DMatrix::from_columns(&(0..ROWS).map(|row| DVector::from_vec(column(row))).collect::<Vec<_>>());
    let softness = stiffness([1.0, nu])[0] / stiffness(other)[0];
    let exact = |row: usize| {
        let y = row as f64 + 0.5;
        if y < middle { y } else { middle + (y - middle) * softness }
    };
    let (free, held): (Vec<usize>, Vec<usize>) = (0..ROWS).partition(|row| (6..28).contains(row));
    let part = |of: &[usize]| rows.select_rows(&free).select_columns(of);
    let load = -(part(&held) * DVector::from_iterator(held.len(), held.iter().map(|&row| exact(row))));
    let found = part(&free).lu().solve(&load).expect("held rows");
    let near = |from: usize| -> Vec<(f64, f64)> {
        (from..from + 3).map(|row| (row as f64 + 0.5, found[row - 6])).collect()
    };
    let [low, high] = [line(&near(8)), line(&near(23))];
    ((high[0] + middle * high[1]) - (low[0] + middle * low[1])) / low[1].max(high[1])
}

#[test]
fn layers_of_families_in_series_hardly_jump() {
    // 0.05, 0.06, -0.01, 0.07 of the prototype; by constants of their own alone -0.76, -1.13, -0.49, -1.19.
    for (nu, other, expected) in [
        (0.3, [10.0, 0.3], 0.05),
        (0.3, [100.0, 0.3], 0.06),
        (0.4, [10.0, 0.2], -0.01),
        (0.3, [1e-3, 0.3], 0.07),
    ] {
        let found = jump(nu, other);
        assert!((found - expected).abs() <= 6e-3, "{other:?}: {found}");
    }
}

/// Errors of the stress along x, relative, and along y, over that along x, of the core of a disc with so many points per radius, from
/// exact displacements on a frame around it.
fn core(nu: f64, other: [f64; 2], per_radius: i32) -> [f64; 2] {
    let side = |[e, nu]: [f64; 2]| Elastic { shear: 0.5 * e / (1.0 + nu), kappa: 3.0 - 4.0 * nu };
    let exact = Goodier::new([side([1.0, nu]), side(other)]);
    let cells = 5 * per_radius + 12;
    let h = 1.0 / f64::from(per_radius);
    let lattice = SquareLattice::rectangle(h, [-0.5 * h * f64::from(cells); 2], [cells; 2]);
    let body = body(lattice, nu, other, |[x, y]| x.hypot(y) < 1.0);
    let inner = h * (0.5 * f64::from(cells) - 6.0);
    // Ghosts, which are beyond the frame, among it.
    let held = prescribed(&body, |_, at| {
        let is_frame = at.iter().any(|x| x.abs() > inner);
        exact.at(at).map(|u| is_frame.then_some(u))
    });
    let u = Stiffness::of(&body).relaxed(&held);
    let n = body.points();
    let core: Vec<usize> = (0..n).filter(|&p| body.place(p)[0].hypot(body.place(p)[1]) < 0.5).collect();
    // The centre of all is zero: slopes are moments.
    let slope = |k: usize| {
        core.iter().map(|&p| body.place(p)[k] * u[k * n + p]).sum::<f64>()
            / core.iter().map(|&p| body.place(p)[k].powi(2)).sum::<f64>()
    };
    let (strain, [direct, cross]) = ([slope(0), slope(1)], stiffness(other));
    let stress = [0, 1].map(|q| direct * strain[q] + cross * strain[1 - q]);
    let [x, y] = exact.inside();
    [stress[0] / x - 1.0, (stress[1] - y) / x]
}

#[test]
fn a_disc_of_families_has_the_stress_of_goodier() {
    let [x, y] = core(0.3, [10.0, 0.3], 16);
    assert!((x - 0.0003).abs() <= 1e-3 && (y - 0.0102).abs() <= 1e-3, "{x} {y}");
    for (nu, other, expected) in [
        (0.3, [10.0, 0.3], [0.0, 0.021]),
        (0.3, [100.0, 0.3], [-0.005, 0.037]),
        (0.4, [10.0, 0.2], [-0.009, 0.016]),
        (0.3, [1e-3, 0.3], [0.007, 0.019]),
        (0.4, [1.0, 0.1], [-0.001, 0.0]),
    ] {
        let [x, y] = core(nu, other, 8);
        let off = (x - expected[0]).abs().max((y - expected[1]).abs());
        assert!(off <= 1e-3, "{nu} {other:?}: {x} {y}");
    }
}
