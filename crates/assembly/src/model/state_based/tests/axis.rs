//! Bodies that touch the axis.

use super::*;
use crate::model::BodyModel;
use crate::model::Points;

/// `u_r = r` prescribed on a collar of two horizons around a solid cylinder of radius 1 in plane strain: u_r/r at the first
/// point.
fn hoop_at_axis(columns: i32, parameters: StateParameters) -> f64 {
    let spacing = 1.0 / f64::from(columns);
    let model = strip(spacing, 0.0, columns + 6, parameters);
    let points = real_points(&model);
    let mut equations: Vec<Equation> = points.iter().map(|&p| held(1, p, 0.0)).collect();
    let outside = points.iter().filter(|&&p| model.place(p)[0] > 1.0);
    equations.extend(outside.map(|&p| held(0, p, model.place(p)[0])));
    let u = solve(&model, equations, &vec![0.0; 2 * model.points()]);
    u[points[0]] / model.place(points[0])[0]
}

#[test]
fn the_table_mends_the_hoop_strain_at_the_axis() {
    // An independent Python implementation.
    let linear = StateParameters { influence: Influence::Linear, ..RING };
    let without = hoop_at_axis(40, linear);
    assert!((without - 0.36132352).abs() < 1e-6, "{without}");
    let with = hoop_at_axis(40, StateParameters { axis: Axis::Table, ..linear });
    assert!((with - 1.00105462).abs() < 1e-6, "{with}");
}

/// Unknowns of a spinning solid cylinder, body force r, free of tractions.
fn spun(columns: i32, axis: Axis) -> (StateBased, Vec<f64>) {
    let spacing = 1.0 / f64::from(columns);
    let parameters = StateParameters { influence: Influence::Linear, axis, ..RING };
    let model = strip(spacing, 0.0, columns, parameters);
    let points = real_points(&model);
    let mut force = vec![0.0; 2 * model.points()];
    points.iter().for_each(|&p| force[p] = model.volume(p) * model.place(p)[0]);
    let u = solve(&model, points.iter().map(|&p| held(1, p, 0.0)).collect(), &force);
    (model, u)
}

#[test]
fn families_that_end_at_the_axis_have_no_ghosts_behind_it() {
    // An independent Python implementation.
    for (axis, expected) in [(Axis::Images, 0.0803285418465552), (Axis::Truncated, 0.254355861845821)] {
        let (model, u) = spun(40, axis);
        let first = real_points(&model)[0];
        let hoop = u[first] / model.place(first)[0];
        assert!((hoop - expected).abs() < 1e-11, "{axis:?} {hoop}");
    }
}

/// Largest error of the same: `u = C r − k r³`.
fn spinning(columns: i32) -> f64 {
    let (model, u) = spun(columns, Axis::Table);
    let points = real_points(&model);
    let exact = |r: f64| 0.222857142857143 * r - 0.092857142857143 * r.powi(3);
    largest(points.iter().map(|&p| u[p] - exact(model.place(p)[0]))) / 0.13
}

#[test]
fn a_spinning_cylinder_converges() {
    // Measured: 1.4e-3 and 3.6e-4.
    let [coarse, fine] = [40, 80].map(spinning);
    assert!(coarse < 2.5e-3, "{coarse:e}");
    assert!((coarse / fine).log2() > 1.8, "{coarse:e} {fine:e}");
}

#[test]
fn columns_may_be_counted_from_anywhere() {
    // A solid cylinder and one with a bore, on lattices whose first column is not the zeroth.
    for radius in [0.0, 1.5] {
        let make = |corner: f64, first: i32| {
            let lattice = SquareLattice::plane(0.5, [corner, 0.0], first..first + 6, 0..4, |_| true);
            body(lattice, Mirrors::NONE, RING)
        };
        let (usual, moved) = (make(radius, 0), make(radius - 1.5, 3));
        let [a, b] = [&usual, &moved].map(real_points);
        assert_eq!(usual.points(), moved.points());
        a.iter().zip(&b).for_each(|(&i, &j)| assert_eq!(usual.place(i), moved.place(j)));
    }
}
