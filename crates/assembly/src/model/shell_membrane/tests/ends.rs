//! Bonds that end on the border: uniform stresses act on it alone.

use super::super::*;
use super::tubes::*;
use crate::body::SquareLattice;
use crate::model::BodyModel;
use crate::model::plane::{Calibration, Mirrors, PlaneModel};
use crate::model::{Model, Points};
use std::f64::consts::TAU;
use std::sync::Arc;

const R: f64 = 1.0 / TAU;

fn bordered(kinematics: ShellKinematics, horizon_ratio: f64) -> ShellParameters {
    let parameters = parameters(kinematics, Calibration::Matched);
    ShellParameters { ends: ShellEnds::Border, horizon_ratio, ..parameters }
}

/// Tubes of 24 rows whose ends are both free, of some columns: longer and shorter than bonds; a half behind a line of symmetry.
fn tubes(parameters: ShellParameters) -> Vec<ShellMembrane> {
    let spacing = 1.0 / 24.0;
    let mut tubes: Vec<ShellMembrane> = [[12, 24], [2, 24], [3, 24], [9, 1]]
        .map(|size| shell(size, spacing, [false, true], parameters))
        .into();
    for columns in [2, 9] {
        let real = SquareLattice::rectangle(spacing, [0.0; 2], [columns, 12]);
        let mut mirrors = Mirrors::NONE;
        [(0, 0), (2, 0), (3, 12)].into_iter().for_each(|(side, line)| mirrors.set_line(side, line));
        let lattice = mirrors.extended(&real, parameters.horizon_ratio.floor() as i32);
        tubes.push(ShellMembrane::on_lattice(Arc::new(lattice), mirrors, parameters).unwrap());
    }
    tubes
}

fn cases() -> impl Iterator<Item = ShellMembrane> {
    let horizons = [2.0, 3.0, 3.7, 4.0];
    let each = [ShellKinematics::Chord, ShellKinematics::Published].map(|k| horizons.map(|m| bordered(k, m)));
    each.into_iter().flatten().flat_map(tubes)
}

#[test]
fn uniform_strains_have_the_energy_and_the_stresses_of_the_material() {
    for tube in cases() {
        assert_eq!(tube.uncorrected(), 0);
        for strain in [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0 / 3.0]] {
            let u = state(&tube, |[x, _]| [strain[0] * x, 0.0, R * strain[1]]);
            let c = tube.stiffness();
            let stress = [0, 1].map(|k| c[k][0] * strain[0] + c[k][1] * strain[1]);
            let density = 0.5 * (stress[0] * strain[0] + stress[1] * strain[1]);
            let volume: f64 = tube.real_points().map(|p| tube.volume(p)).sum();
            // Measured: 8e-15 and 3e-14.
            assert!((energy(&tube, &u) / (density * volume) - 1.0).abs() < 1e-12);
            let fields = tube.fields(&u);
            for p in tube.real_points() {
                assert!((fields.energy_density[p] / density - 1.0).abs() < 1e-12);
                (0..2).for_each(|k| assert!((fields.stress[k][p] - stress[k]).abs() < 1e-12 * E));
                assert!(fields.stress[2][p].abs() < 1e-12 * E);
            }
        }
    }
}

/// Forces of a traction `[along x, along s]`, N/m, on the right end and of its opposite on the left one, through the border.
fn pulled(tube: &ShellMembrane, traction: [f64; 2]) -> Vec<f64> {
    let (n, spacing) = (tube.points(), tube.lattice.spacing());
    let shares = tube.border_shares().unwrap();
    let real = tube.mirrors.real(&tube.lattice);
    let mut force = vec![0.0; 3 * n];
    for (sign, column) in [(-1.0, real.columns().start), (1.0, real.columns().end)] {
        for row in real.rows() {
            let [x, s] = real.place_of([column, row, 0]);
            let Some(places) = shares([x - 0.5 * spacing, s, 0.0], [sign, 0.0, 0.0]) else { continue };
            for (p, share) in places {
                (0..2).for_each(|k| force[k * n + p] += sign * share * spacing * traction[k]);
            }
        }
    }
    restricted(tube, force)
}

#[test]
fn a_uniform_stress_acts_on_the_ends_alone() {
    for tube in cases() {
        for strain in [[1.0, 0.0], [0.0, 1.0], [1.0, -1.0 / 3.0]] {
            let u = state(&tube, |[x, _]| [strain[0] * x, 0.0, R * strain[1]]);
            let [axial, hoop] =
                [strain[0] + strain[1] / 3.0, strain[1] + strain[0] / 3.0].map(|e| 1.125 * E * H * e);
            let (n, found) = (tube.points(), force(&tube, &u));
            let mut expected = pulled(&tube, [axial, 0.0]);
            tube.real_points().for_each(|p| expected[2 * n + p] = hoop / R * tube.cell_area());
            let off =
                |p: usize| (0..3).map(|c| (found[c * n + p] - expected[c * n + p]).abs()).fold(0.0, f64::max);
            // Measured: 2e-13. A line of symmetry takes what acts on images.
            let most = tube
                .real_points()
                .filter(|&p| tube.lattice.cell(p)[0] > 0 || tube.mirrors.lines[0] == [None; 2]);
            let most = most.map(off).fold(0.0, f64::max);
            assert!(most < 1e-11 * largest(&found), "{strain:?} {}", most / largest(&found));
            // Loads of one stress are these forces, too.
            let (stress, mut load) = ([axial / H, hoop / H, 0.0], vec![0.0; 3 * n]);
            tube.add_stress_load(None, &|_, _| stress, &mut load);
            let load = restricted(&tube, load);
            let apart = load.iter().zip(&found).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-11 * largest(&found), "{strain:?} {}", apart / largest(&found));
        }
    }
}

#[test]
fn a_twist_acts_on_the_ends_alone() {
    for m in [2.0, 3.0, 4.0] {
        let tube = shell([12, 24], 1.0 / 24.0, [false, true], bordered(ShellKinematics::Chord, m));
        let u = state(&tube, |[x, _]| [0.0, x, 0.0]);
        // Twice the energy per area is the shear force: less than that of the material, because chords are no arcs.
        let shear = 2.0 * energy(&tube, &u) / 0.5;
        assert!((0.9..1.0).contains(&(shear / (0.375 * E * H))));
        let (found, expected) = (force(&tube, &u), pulled(&tube, [0.0, shear]));
        let off = found.iter().zip(&expected).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        // Measured: 1e-14.
        assert!(off < 1e-12 * largest(&found), "{m}: {}", off / largest(&found));
    }
}

#[test]
fn rigid_motions_alone_cost_nothing() {
    for m in [2.0, 3.0, 4.0] {
        let tube = shell([12, 24], 1.0 / 24.0, [false, true], bordered(ShellKinematics::Chord, m));
        let (n, k) = (tube.points(), matrix(&tube));
        for kind in 0..6 {
            let mut u = vec![0.0; 3 * n];
            for p in 0..n {
                let motion = tube.rigid_motion(kind, p, [0.2, 0.0, 0.0]);
                (0..3).for_each(|c| u[c * n + p] = motion[c]);
            }
            assert!(largest(&force(&tube, &u)) <= 1e-14 * k.amax() * largest(&u), "{m} {kind}");
        }
        let values = k.symmetric_eigenvalues();
        let free = values.iter().filter(|v| **v < 1e-13 * values.max()).count();
        assert_eq!(free, 6, "{m}");
    }
}

#[test]
fn panels_have_no_corners() {
    // The bonds of a corner end on the border, so that its point has those of any other beside the free side.
    let panel = shell([10, 12], 1.0 / 48.0, [false; 2], bordered(ShellKinematics::Chord, 3.0));
    assert_eq!(panel.uncorrected(), 0);
    assert!(panel.border_shares().is_none());
    let k = matrix(&panel);
    assert!(k.symmetric_eigenvalues().min() > -1e-13 * k.amax());
    // A uniform stress is in equilibrium with its own loads.
    let u = state(&panel, |[x, _]| [x, 0.0, -R / 3.0]);
    let (found, mut load) = (force(&panel, &u), vec![0.0; 3 * panel.points()]);
    panel.add_stress_load(None, &|_, _| [E, 0.0, 0.0], &mut load);
    let off = found.iter().zip(&load).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    assert!(off < 1e-12 * largest(&found), "{}", off / largest(&found));
}

#[test]
fn a_single_column_has_no_border() {
    let one = shell([1, 24], 1.0 / 24.0, [false, true], bordered(ShellKinematics::Chord, 3.0));
    assert!(one.ends.is_none() && one.border_shares().is_none());
}
