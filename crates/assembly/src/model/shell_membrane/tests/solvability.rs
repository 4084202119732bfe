//! Loads that a membrane cannot bear.

use super::super::*;
use super::tubes::*;
use crate::model::BodyModel;
use crate::model::Points;
use crate::model::plane::Mirrors;
use std::sync::Arc;

/// Forces of a pressure p(s) outwards.
fn pressed(shell: &ShellMembrane, pressure: impl Fn(f64) -> f64) -> Vec<f64> {
    let n = shell.points();
    let mut f = vec![0.0; 3 * n];
    shell.real_points().for_each(|p| f[2 * n + p] = pressure(shell.place(p)[1]));
    f
}

fn wave(harmonic: f64) -> impl Fn(f64) -> f64 {
    move |s| (harmonic * std::f64::consts::TAU * s + 0.3).cos()
}

fn worked_on(shell: &ShellMembrane, ends: EndConditions, force: &[f64]) -> bool {
    Inextensional::new(&shell.parameters, (&shell.lattice, &shell.mirrors), ends).is_worked_on(force)
}

#[test]
fn free_tubes_bear_what_is_the_same_all_around_only() {
    let tube = tube(24, chords());
    let free = EndConditions::default;
    for (pressure, is_refused) in [(0.0, false), (1.0, false), (2.0, true), (3.0, true), (11.0, true)] {
        let f = pressed(&tube, wave(pressure));
        assert_eq!(worked_on(&tube, free(), &f), is_refused, "harmonic {pressure}");
    }
    // A single force has all harmonics.
    let mut f = vec![0.0; 3 * tube.points()];
    f[tube.real_points().nth(40).unwrap()] = 1.0;
    assert!(worked_on(&tube, free(), &f));
    let bent = super::tubes::tube(24, ShellParameters { bending: true, ..chords() });
    assert!(!worked_on(&bent, free(), &pressed(&bent, wave(2.0))));
}

#[test]
fn two_diaphragms_or_one_clamped_end_are_enough() {
    let tube = tube(24, chords());
    let f = pressed(&tube, wave(2.0));
    let mut one = EndConditions::default();
    one.hold_shape(0.0);
    one.hold_shape(0.0);
    assert!(!one.are_complete() && worked_on(&tube, one.clone(), &f));
    let (mut diaphragms, mut clamped) = (one.clone(), one);
    diaphragms.hold_shape(0.5);
    clamped.hold_axial();
    assert!(diaphragms.are_complete() && clamped.are_complete());
    assert!(!worked_on(&tube, diaphragms, &f) && !worked_on(&tube, clamped, &f));
}

#[test]
fn mirrors_hold_what_they_make_odd() {
    let real = crate::body::SquareLattice::rectangle(1.0 / 24.0, [0.0; 2], [6, 24]);
    let mut mirrors = Mirrors { joined: [false, true, false], ..Mirrors::NONE };
    [(0, 0), (2, 0), (3, 24)].into_iter().for_each(|(side, line)| mirrors.set_line(side, line));
    let lattice = mirrors.extended(&real, 3);
    let half = ShellMembrane::on_lattice(Arc::new(lattice), mirrors, chords()).unwrap();
    let f = pressed(&half, wave(2.0));
    assert!(worked_on(&half, EndConditions::default(), &f));
    let mut diaphragm = EndConditions::default();
    diaphragm.hold_shape(0.25);
    assert!(!worked_on(&half, diaphragm, &f));
    // Axial forces alone have nothing to do where the mirror holds u.
    let mut f = vec![0.0; 3 * half.points()];
    half.real_points().for_each(|p| f[p] = wave(2.0)(half.place(p)[1]));
    assert!(!worked_on(&half, EndConditions::default(), &f));
}
