//! Motions that cost no energy, and how well a tube with held ends is conditioned.

use super::super::*;
use super::tubes::*;
use crate::model::plane::Calibration;
use nalgebra::DMatrix;

/// Eigenvalues below this part of the largest are zero.
const ZERO: f64 = 1e-13;

fn free_motions(parameters: ShellParameters) -> usize {
    let k = matrix(&tube(24, parameters)).symmetric_eigenvalues();
    let most = k.max();
    k.iter().filter(|v| **v < ZERO * most).count()
}

#[test]
fn only_rigid_motions_are_free() {
    for (kinematics, count) in [(ShellKinematics::Published, 2), (ShellKinematics::Chord, 6)] {
        for (m, calibration) in
            [(2.0, Calibration::Matched), (3.0, Calibration::Matched), (3.0, Calibration::Published)]
        {
            let parameters = ShellParameters { horizon_ratio: m, ..parameters(kinematics, calibration) };
            assert_eq!(free_motions(parameters), count, "{kinematics:?} {m}");
        }
    }
}

#[test]
fn short_horizons_leave_patterns_free() {
    for (m, count) in [(1.0, 312), (1.5, 48)] {
        for kinematics in [ShellKinematics::Published, ShellKinematics::Chord] {
            let parameters =
                ShellParameters { horizon_ratio: m, ..parameters(kinematics, Calibration::Published) };
            assert_eq!(free_motions(parameters), count, "{kinematics:?} {m}");
        }
    }
}

#[test]
fn bending_rows_leave_the_rigid_motions_free() {
    assert_eq!(free_motions(ShellParameters { bending: true, ..chords() }), 6);
}

/// Largest over smallest eigenvalue of the stiffness of the free unknowns, scaled to a unit diagonal.
fn scaled_condition(shell: &ShellMembrane, held: impl Fn(usize) -> bool) -> f64 {
    let k = matrix(shell);
    let free: Vec<usize> = (0..k.nrows()).filter(|&u| !held(u)).collect();
    let scaled = DMatrix::from_fn(free.len(), free.len(), |a, b| {
        let (a, b) = (free[a], free[b]);
        k[(a, b)] / (k[(a, a)] * k[(b, b)]).sqrt()
    });
    let values = scaled.symmetric_eigenvalues();
    values.max() / values.min()
}

#[test]
fn diaphragms_make_a_tube_stiff() {
    // v = w = 0 on both end columns, u at one point of the middle. An independent Python implementation has 832.4726 with
    // these ends, and 878.4969 with ends that go on by ghost points.
    let tube = tube(24, chords());
    let (columns, count) = (12, 12 * 24);
    let held = |k: usize| {
        let (component, column) = (k / count, k % count % columns);
        k == 6 || component > 0 && (column == 0 || column == columns - 1)
    };
    let condition = scaled_condition(&tube, held);
    assert!((condition / 832.4726438 - 1.0).abs() < 1e-8, "{condition}");
}
