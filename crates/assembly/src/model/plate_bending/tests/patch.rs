//! Patch tests: uniform curvatures of perforated plates (P4, P5) and a constant shear force (P6).

use super::{PHI_X, PHI_Y, Solver, parameters, plate, section};
use crate::body::SquareLattice;
use crate::model::Model;
use crate::model::plate_bending::{PlateBending, PlateParameters, ShearLaw};

/// 14 × 11 cells with a hole, a cut corner and a notch of one cell.
fn perforated(parameters: PlateParameters) -> PlateBending {
    let is_out = |[i, j]: [i32; 2]| {
        (5..8).contains(&i) && (4..7).contains(&j) || i >= 11 && j >= 8 || [i, j] == [2, 8]
    };
    plate(SquareLattice::plane(0.1, [0.0; 2], 0..14, 0..11, |cell| !is_out(cell)), parameters)
}

const CURVATURES: [[f64; 3]; 4] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.3, 0.9, -0.7]];

/// `w = ½ x·κx`, `φ = κx`.
fn curved(plate: &PlateBending, [xx, yy, xy]: [f64; 3]) -> Vec<f64> {
    let n = plate.nodes().points();
    let mut u = vec![0.0; 3 * n];
    for point in 0..n {
        let [x, y] = plate.nodes().place(point);
        u[point] = 0.5 * (xx * x * x + yy * y * y) + xy * x * y;
        u[PHI_X * n + point] = xx * x + xy * y;
        u[PHI_Y * n + point] = xy * x + yy * y;
    }
    u
}

/// The moments that hold the edges of a uniformly curved plate, by the trapezoidal rule.
fn edge_moments(plate: &PlateBending, [xx, yy, xy]: [f64; 3]) -> Vec<f64> {
    let edges = plate.nodes().edges();
    let segments: Vec<[u32; 2]> = edges.iter().map(|edge| edge.points).collect();
    let mut load = vec![0.0; 3 * plate.nodes().points()];
    let moment = |k: usize, _| {
        let [x, y] = edges[k].outward;
        [0.0, xx * x + xy * y, xy * x + yy * y]
    };
    plate.add_line(&segments, moment, &mut load);
    load
}

fn amax(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, v| v.abs().max(most))
}

fn all_parameters() -> impl Iterator<Item = PlateParameters> {
    let ratios = [1.5, 2.0, 3.0, 3.2, 4.0];
    let materials = [-0.3, 0.0, 0.3, 1.0 / 3.0, 0.45];
    ratios.into_iter().flat_map(move |horizon_ratio| {
        materials.into_iter().flat_map(move |nu| {
            [1e-4, 0.3].map(|t| PlateParameters {
                section: section(nu, t),
                horizon_ratio,
                shear_law: ShearLaw::Corrected,
            })
        })
    })
}

#[test]
fn uniform_curvatures_have_their_energy_and_their_edge_moments() {
    for parameters in all_parameters() {
        let plate = perforated(parameters);
        let (n, terms) = (plate.nodes().points(), plate.terms());
        let area: f64 = (0..n).map(|p| plate.nodes().area(p)).sum();
        for curvature in CURVATURES {
            let moment = parameters.section.moments(curvature);
            let exact = 0.5
                * area
                * (moment[0] * curvature[0] + moment[1] * curvature[1] + 2.0 * moment[2] * curvature[2]);
            let u = curved(&plate, curvature);
            let energy: f64 = terms.iter().map(|term| term.survey(&u).energy).sum();
            assert!((energy / exact - 1.0).abs() < 1e-13, "{parameters:?}: {energy} {exact}");
            let load = edge_moments(&plate, moment);
            let mut rest = load.iter().map(|f| -f).collect::<Vec<_>>();
            terms.iter().for_each(|term| term.add_force(&u, &mut rest));
            // Rounding of terms of the size of S: 8e-12 of the moments at t/h = 1e-3.
            assert!(amax(&rest) < 1e-11 * amax(&load), "{parameters:?}: {}", amax(&rest) / amax(&load));
        }
    }
}

#[test]
fn a_free_plate_under_edge_moments_is_uniformly_curved() {
    for parameters in all_parameters().filter(|p| p.section.poisson_ratio != 0.0) {
        let plate = perforated(parameters);
        let n = plate.nodes().points();
        let exact = curved(&plate, CURVATURES[3]);
        let load = edge_moments(&plate, parameters.section.moments(CURVATURES[3]));
        // The first point lies at the origin: w and φ are zero there.
        let solver = Solver::new(&plate, Vec::new(), &[0, n, 2 * n]);
        let u = solver.solve(&load);
        let error = u.iter().zip(&exact).map(|(a, b)| a - b).collect::<Vec<_>>();
        assert!(amax(&error) < 1e-12 * amax(&exact), "{parameters:?}: {:.1e}", amax(&error) / amax(&exact));
    }
}

#[test]
fn a_linear_moment_is_in_equilibrium_with_its_constant_shear_force() {
    let c = [0.3, -1.2, 0.7, 0.4];
    for (m, t) in [1.5, 2.0, 3.0].into_iter().flat_map(|m| [0.2, 0.05, 0.01].map(|t| (m, t))) {
        let cells = SquareLattice::rectangle(0.1, [0.0; 2], [12, 12]);
        let plate = plate(cells, parameters(m, t));
        let n = plate.nodes().points();
        let shear = [-(c[0] + c[2]), -(c[1] + c[3])];
        let mut u = vec![0.0; 3 * n];
        for point in 0..n {
            let [x, y] = plate.nodes().place(point);
            u[point] = c[0] * x.powi(3) / 6.0
                + c[1] * x * x * y / 2.0
                + c[2] * x * y * y / 2.0
                + c[3] * y.powi(3) / 6.0;
            let slope = [
                c[0] * x * x / 2.0 + c[1] * x * y + c[2] * y * y / 2.0,
                c[1] * x * x / 2.0 + c[2] * x * y + c[3] * y * y / 2.0,
            ];
            (0..2).for_each(|k| {
                u[(k + 1) * n + point] = slope[k] - shear[k] / parameters(m, t).section.shear;
            });
        }
        let mut force = vec![0.0; 3 * n];
        plate.terms().iter().for_each(|term| term.add_force(&u, &mut force));
        let k = m as i32;
        let is_inner = |point: &usize| plate.nodes().node(*point).iter().all(|&c| c > k && c < 12 - k);
        let inner = (0..n).filter(is_inner).flat_map(|p| (0..3).map(move |c| c * n + p));
        let largest = inner.map(|unknown| force[unknown].abs()).fold(0.0, f64::max);
        let scale = shear[0].hypot(shear[1]) * 0.01;
        assert!(largest < 1e-10 * scale, "m = {m}, t = {t}: {:.1e}", largest / scale);
    }
}
