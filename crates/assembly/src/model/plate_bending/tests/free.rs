//! Curvatures that need no moments.

use super::body::holed;
use super::steps::perforated;
use super::{Held, PHI_X, PHI_Y, Solver, assert_close, deflection, fixed, parameters, plate, square};
use crate::body::SquareLattice;
use crate::model::plate_bending::{FreeCurvature, PlateBending, PlateFields};
use std::ops::Range;

/// Units of a curvature in the cells of some columns.
fn free(
    plate: &PlateBending,
    columns: Option<Range<u32>>,
    unit: [f64; 3],
    value: impl Fn([f64; 2]) -> f64,
) -> FreeCurvature {
    let nodes = plate.nodes();
    let number = |(number, [column, _]): (usize, [i32; 2])| {
        let is_in = columns.as_ref().is_none_or(|columns| columns.contains(&(column as u32)));
        is_in.then_some(number as u32)
    };
    FreeCurvature {
        cells: columns.is_some().then(|| nodes.all_cells().enumerate().filter_map(number).collect()),
        units: vec![unit; 1 + plate.sections().others.len()],
        values: (0..nodes.points()).map(|p| value(nodes.place(p))).collect(),
    }
}

fn load(plate: &PlateBending, free: &FreeCurvature) -> Vec<f64> {
    let mut load = vec![0.0; 3 * plate.nodes().points()];
    plate.add_free_curvature(free, &mut |unknown, force| load[unknown] += force);
    load
}

fn fields(plate: &PlateBending, u: &[f64], free: &FreeCurvature) -> PlateFields {
    plate.fields(u, &[(1.0, free)], &|_| [false; 2])
}

fn largest<const N: usize>(values: &[[f64; N]]) -> f64 {
    values.iter().flatten().fold(0.0, |most, value| most.max(value.abs()))
}

#[test]
fn a_free_plate_bends_without_moments_whatever_its_edges_and_steps() {
    let unit = [0.7, -0.3, 0.2];
    for (m, t) in [1.5, 2.0, 3.0, 3.2].into_iter().flat_map(|m| [0.3, 1e-3].map(|t| (m, t))) {
        for plate in [holed(parameters(m, t)), perforated(m, t)] {
            let free = free(&plate, None, unit, |_| 1.0);
            let n = plate.nodes().points();
            let mut exact = vec![0.0; 3 * n];
            for point in 0..n {
                let [x, y] = plate.nodes().place(point);
                exact[point] = 0.5 * (unit[0] * x * x + unit[1] * y * y) + unit[2] * x * y;
                exact[PHI_X * n + point] = unit[0] * x + unit[2] * y;
                exact[PHI_Y * n + point] = unit[2] * x + unit[1] * y;
            }
            let pinned = plate.nodes().number([0, 0]).unwrap();
            let u = Solver::new(&plate, Vec::new(), &[0, 1, 2].map(|c| c * n + pinned))
                .solve(&load(&plate, &free));
            let off = u.iter().zip(&exact).fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
            // 2e-15 is found, 6e-15 and 5e-13.
            assert!(off < 1e-14, "m = {m}, t = {t}: {off:.1e}");
            let fields = fields(&plate, &u, &free);
            let (moment, shear) = (largest(&fields.moment), largest(&fields.shear));
            assert!(moment < 5e-14 && shear < 3e-12, "m = {m}, t = {t}: {moment:.1e}, {shear:.1e}");
        }
    }
}

#[test]
fn a_clamped_plate_stays_flat_and_has_the_moments() {
    for m in [1.5, 3.0] {
        let plate = square(8, parameters(m, 0.01));
        let free = free(&plate, None, [-2.0, -2.0, 0.0], |_| 1.0);
        let u = Solver::new(&plate, Vec::new(), &fixed(&plate, Held::Clamped)).solve(&load(&plate, &free));
        assert!(u.iter().all(|u| u.abs() < 1e-14), "{u:?}");
        // -D (1 + ν) κ*.
        let moments = fields(&plate, &u, &free).moment;
        assert!(moments.iter().flat_map(|m| &m[..2]).all(|m| (m - 2.6).abs() < 1e-13), "{moments:?}");
    }
}

#[test]
fn a_strip_that_is_free_to_bend_in_a_part_is_exact_at_its_points() {
    for (m, t) in [1.5, 2.0, 3.0].into_iter().flat_map(|m| [0.2, 1e-3].map(|t| (m, t))) {
        let strip = SquareLattice::rectangle(0.125, [0.0; 2], [16, 3]);
        let plate = plate(strip, parameters(m, t));
        let free = free(&plate, Some(4..8), [1.0, 0.0, 0.0], |_| 1.0);
        let u = Solver::new(&plate, Vec::new(), &fixed(&plate, Held::Strip)).solve(&load(&plate, &free));
        // ∫ κ* (2 - x) from 0.5 to 1.
        let fields = fields(&plate, &u, &free);
        assert_close(deflection(&plate, &u, [2.0, 0.125]), 0.625, 1e-13);
        assert!(largest(&fields.moment) < 1e-14 && largest(&fields.shear) < 3e-12);
    }
}

#[test]
fn a_curvature_that_varies_linearly_bends_a_strip_exactly_without_shear_forces() {
    for (m, t) in [1.5, 2.0, 3.0].into_iter().flat_map(|m| [0.2, 1e-3].map(|t| (m, t))) {
        let strip = SquareLattice::rectangle(0.125, [0.0; 2], [8, 3]);
        let plate = plate(strip, parameters(m, t));
        let free = free(&plate, None, [1.0, 0.0, 0.0], |[x, _]| x);
        let u = Solver::new(&plate, Vec::new(), &fixed(&plate, Held::Strip)).solve(&load(&plate, &free));
        // ∫ x (1 - x).
        let error = 6.0 * deflection(&plate, &u, [1.0, 0.125]) - 1.0;
        let fields = fields(&plate, &u, &free);
        // With two spacings per horizon 7e-16; bonds of three end between the points of the free edges, where rotations
        // are taken for linear: 1.4e-4, 9e-4 of the moments are left.
        let (most, least) = if m < 3.0 { (2e-15, 1e-13) } else { (2e-4, 1e-2) };
        assert!(error.abs() < most, "m = {m}, t = {t}: {error:.1e}");
        assert!(largest(&fields.moment) < 10.0 * most && largest(&fields.shear) < least, "m = {m}, t = {t}");
    }
}

#[test]
fn a_curvature_that_varies_bends_a_strip_to_second_order() {
    let off = |cells: i32, m: f64| {
        let strip = SquareLattice::rectangle(1.0 / f64::from(cells), [0.0; 2], [cells, 3]);
        let plate = plate(strip, parameters(m, 0.05));
        let free = free(&plate, None, [1.0, 0.0, 0.0], |[x, _]| x * x);
        let u = Solver::new(&plate, Vec::new(), &fixed(&plate, Held::Strip)).solve(&load(&plate, &free));
        // ∫ x² (1 - x).
        deflection(&plate, &u, [1.0, 0.0]) * 12.0 - 1.0
    };
    for m in [1.5, 2.0] {
        let [coarse, fine] = [8, 16].map(|cells| off(cells, m));
        assert!((coarse / fine).log2() > 1.85, "m = {m}: {coarse:.2e}, {fine:.2e}");
    }
}
