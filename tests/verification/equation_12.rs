//! The bond energy is that of Eq. (12): its negative gradient per volume is the literal sum.
//!
//! Yang, Oterkus and Oterkus, Procedia Structural Integrity 28 (2020) 464-471.

use crate::support::error;
use peristat_assembly::material::SectionStiffness;
use peristat_assembly::model::Model;
use peristat_assembly::model::Points;
use peristat_assembly::model::timoshenko_beam::{
    BeamParameters, Grid, Line, TimoshenkoBeam, VolumeFactor, bond_law, end_treatment,
};

const AREA: f64 = 1e-3;
const BENDING: f64 = 41_666.7;
const SHEAR: f64 = 6.4e7;

/// A truncated chain: bonds only where there are points, as in the sums of Eq. (12).
fn beam(law: &str, m: u32, factor: VolumeFactor, grid: Grid) -> TimoshenkoBeam {
    let parameters = BeamParameters {
        volume_factor: factor,
        bond_law: bond_law::find(law).expect("the law exists"),
        end_treatment: end_treatment::find("truncated").expect("the treatment exists"),
    };
    let stiffness = SectionStiffness::uniform(BENDING, SHEAR, 1.0, AREA);
    let line = Line { from: 0.3, grid, horizon_ratio: f64::from(m), ..Line::new(0.7, 70, stiffness) };
    TimoshenkoBeam::new(parameters, vec![line]).expect("a chain")
}

/// Left sides of Eq. (12b) and (12a) at every point, times its volume.
fn literal(beam: &TimoshenkoBeam, m: u32, shear_scale: f64, w: &[f64], phi: &[f64]) -> [Vec<f64>; 2] {
    let (n, h) = (w.len(), 0.01);
    let delta = f64::from(m) * h;
    let c_b = 2.0 * BENDING / (delta * delta * AREA * AREA);
    // κG = S/A.
    let c_s = 2.0 * (SHEAR / AREA) / (delta * delta * AREA) * shear_scale;
    let on_end = |k: usize| beam.chains()[0].line().grid == Grid::Nodes && (k == 0 || k + 1 == n);
    let volume = |k: usize| AREA * h * if on_end(k) { 0.5 } else { 1.0 };
    let x = |k: usize| beam.position(k)[0];
    let mut sums = [vec![0.0; n], vec![0.0; n]];
    for k in 0..n {
        for j in (0..n).filter(|&j| j != k) {
            let xi = (x(j) - x(k)).abs();
            if xi > delta * (1.0 + 1e-9) {
                continue;
            }
            let at_edge = xi > delta * (1.0 - 1e-9);
            let half = at_edge && beam.parameters().volume_factor == VolumeFactor::HalfEdge;
            let v = volume(j) * if half { 0.5 } else { 1.0 };
            let sign = (x(j) - x(k)).signum();
            sums[0][k] += volume(k) * c_s * ((w[j] - w[k]) / xi - 0.5 * (phi[j] + phi[k]) * sign) * v;
            sums[1][k] += volume(k) * c_b * (phi[j] - phi[k]) / xi * v
                + volume(k) * 0.5 * c_s * ((w[j] - w[k]) * sign - 0.5 * (phi[j] + phi[k]) * xi) * v;
        }
    }
    sums
}

/// Numbers between −1 and 1 without a pattern that the bonds could share.
fn scattered(n: usize, start: f64) -> Vec<f64> {
    (0..n).map(|k| (start + 12.9898 * (k * k) as f64 + 78.233 * k as f64).sin()).collect()
}

fn deviation(law: &str, m: u32, factor: VolumeFactor, grid: Grid, shear_scale: f64) -> f64 {
    let beam = beam(law, m, factor, grid);
    let n = beam.points();
    let (w, phi) = (scattered(n, 0.1), scattered(n, 0.7));
    let u = [w.clone(), phi.iter().map(|p| 100.0 * p).collect()].concat();
    let mut force = vec![0.0; 2 * n];
    for term in Model::<2>::terms(&beam) {
        term.add_force(&u, &mut force);
    }
    force.iter_mut().for_each(|f| *f = -*f);
    let [forces, moments] = literal(&beam, m, shear_scale, &w, &u[n..]);
    f64::max(error(&force[..n], &forces), error(&force[n..], &moments))
}

#[test]
fn the_published_law_is_equation_12_at_every_point() {
    for grid in [Grid::Nodes, Grid::Cells] {
        for factor in [VolumeFactor::Full, VolumeFactor::HalfEdge] {
            for m in [1, 2, 3, 6] {
                let deviation = deviation("published", m, factor, grid, 1.0);
                // A9, measured 6e-15: the literal sums subtract coordinates.
                assert!(deviation <= 1e-13, "{grid:?}, {factor:?}, m = {m}: {deviation:e}");
            }
        }
    }
}

#[test]
fn the_corrected_law_is_equation_12_with_one_constant_changed() {
    for m in [1, 2, 3, 6] {
        // 1 + S δ² (1 + 1/m²)/(24 EI), half-edge volumes.
        let (ratio, delta) = (f64::from(m), f64::from(m) * 0.01);
        let scale = 1.0 + SHEAR * delta * delta * (1.0 + 1.0 / (ratio * ratio)) / (24.0 * BENDING);
        let deviation = deviation("corrected", m, VolumeFactor::HalfEdge, Grid::Nodes, 1.0 / scale);
        // Measured 6e-15.
        assert!(deviation <= 1e-13, "m = {m}: {deviation:e}");
    }
}
