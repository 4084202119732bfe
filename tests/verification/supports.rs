//! Settlements, springs, rigid links, interior supports and combinations against values derived by hand.
//!
//! The law is `exact`, so that nodal values are those of the local beam.

use crate::support::standard::{SECTIONS, steel};
use crate::support::{Run, largest, relative, run};
use serde_json::{Value, json};

const CLAMP: fn(f64) -> Value = |x| json!({ "at": { "x": x }, "w": 0.0, "phi": 0.0 });
const ROLLER: fn(f64) -> Value = |x| json!({ "at": { "x": x }, "w": 0.0 });

fn case(height: f64, cells: usize, supports: &[Value], loads: &[Value]) -> Value {
    let mut case = steel(height, "exact", cells);
    case["supports"] = supports.into();
    case["loads"] = loads.into();
    case
}

fn force(x: f64, value: f64) -> Value {
    json!({ "point": { "at": { "x": x }, "force": value } })
}

/// Deflection of simple supports over 1 m under a unit force at `a`.
fn influence(x: f64, a: f64, b: f64, s: f64) -> f64 {
    let (x, a) = if x <= a { (x, a) } else { (1.0 - x, 1.0 - a) };
    let c = 1.0 - a;
    x * c * (1.0 - c * c - x * x) / (6.0 * b) + x * c / s
}

fn worst_deflection(run: &Run, exact: impl Fn(f64) -> f64) -> f64 {
    run.errors(|x| (exact(x), 1.0))[0]
}

#[test]
fn the_settlement_of_an_interior_support_bends_the_beam_as_a_force_there() {
    for section in SECTIONS {
        let (b, s) = section.stiffness();
        let d = -0.013;
        let mut middle = ROLLER(0.5);
        middle["w"] = json!(d);
        let run = run(&case(section.height, 40, &[ROLLER(0.0), middle, ROLLER(1.0)], &[]));
        let reaction = d / influence(0.5, 0.5, b, s);
        let error = worst_deflection(&run, |x| reaction * influence(x, 0.5, b, s));
        let found = run.states[0].reactions[1].force;
        // Measured 3e-16.
        assert!(error <= 1e-13, "{section:?}: {error:e}");
        // Measured 1e-13. A reaction is a small difference of large bond forces where the beam is slender.
        assert!(relative(found, reaction) <= 1e-11, "{section:?}: {found} for {reaction}");
    }
}

#[test]
fn the_motion_of_a_clamp_needs_the_end_actions_of_the_textbook() {
    for section in SECTIONS {
        let (b, s) = section.stiffness();
        let (d, turn) = (0.01, -0.02);
        let moved = json!({ "at": { "x": 1.0 }, "w": d, "phi": turn });
        let run = run(&case(section.height, 30, &[CLAMP(0.0), moved], &[]));
        // Exact element of length 1 with Φ = 12 B/(S L²).
        let big = 12.0 * b / s;
        let k = b / (1.0 + big);
        let force = k * (12.0 * d - 6.0 * turn);
        let moment = k * (-6.0 * d + (4.0 + big) * turn);
        let right = &run.states[0].reactions[1];
        assert!(relative(right.force, force) <= 1e-11, "{section:?}: {right:?} for {force}");
        assert!(relative(right.moment, moment) <= 1e-11, "{section:?}: {right:?} for {moment}");
    }
}

#[test]
fn springs_carry_what_their_stiffness_says() {
    let section = SECTIONS[1];
    let (b, s) = section.stiffness();
    // A tip spring in parallel with the cantilever.
    let flexibility = 1.0 / (3.0 * b) + 1.0 / s;
    let k = 2.0 / flexibility;
    let tip = json!({ "at": { "x": 1.0 }, "w_spring": k });
    let sprung = run(&case(section.height, 30, &[CLAMP(0.0), tip], &[force(1.0, 900.0)]));
    let w = 900.0 / (1.0 / flexibility + k);
    assert!(relative(sprung.w(30), w) <= 1e-13, "{} for {w}", sprung.w(30));
    assert!(relative(sprung.states[0].reactions[1].force, -k * w) <= 1e-13);
    assert!(relative(sprung.states[0].reactions[0].force, -300.0) <= 1e-12);

    // A hinge with a rotational spring under the cantilever.
    let hinge = json!({ "at": { "x": 0.0 }, "w": 0.0, "phi_spring": 5e4 });
    let hinged = run(&case(section.height, 30, &[hinge], &[force(1.0, 900.0)]));
    let w = 900.0 * (flexibility + 1.0 / 5e4);
    assert!(relative(hinged.w(30), w) <= 1e-13, "{} for {w}", hinged.w(30));
    assert!(relative(hinged.states[0].reactions[0].moment, -900.0) <= 1e-12);

    // Two springs alone hold a beam: the lever.
    let springs =
        [json!({ "at": { "x": 0.0 }, "w_spring": 1e4 }), json!({ "at": { "x": 1.0 }, "w_spring": 3e4 })];
    let lever = run(&case(section.height, 40, &springs, &[force(0.25, 900.0)]));
    let [left, right] = [0.75 * 900.0 / 1e4, 0.25 * 900.0 / 3e4];
    assert!(relative(lever.w(0), left) <= 1e-12 && relative(lever.w(40), right) <= 1e-12);
}

#[test]
fn a_rigid_link_joins_two_cantilevers_as_their_stiffnesses_say() {
    for section in SECTIONS {
        let (b, s) = section.stiffness();
        // From x = 0 to 1 and from 1.3 to 2.1, clamped at the far ends, a rigid bar of 0.3 between them.
        let (gap, other) = (0.3, 0.8);
        let mut case = case(section.height, 1, &[CLAMP(0.0), CLAMP(2.1)], &[force(1.0, section.force)]);
        case["body"] = json!({ "lines": [
            { "length": 1.0, "cells": 30 }, { "from": 1.3, "length": other, "cells": 16 } ] });
        case["links"] = json!([{ "rigid": { "from": { "x": 1.0 }, "to": { "x": 1.3 } } }]);
        // Stiffness of a beam of length l at one end, the other clamped; `side` is −1 for a right end, 1 for a left one.
        let end = |l: f64, side: f64| {
            let big = 12.0 * b / (s * l * l);
            let k = b / (l * l * l * (1.0 + big));
            [12.0 * k, side * 6.0 * l * k, (4.0 + big) * l * l * k]
        };
        let (a, c) = (end(1.0, -1.0), end(other, 1.0));
        // The left end of the second beam moves by w + gap φ and turns by φ.
        let ww = a[0] + c[0];
        let wp = a[1] + c[1] + gap * c[0];
        let pp = a[2] + c[2] + 2.0 * gap * c[1] + gap * gap * c[0];
        let determinant = ww * pp - wp * wp;
        let (w, phi) = (section.force * pp / determinant, -section.force * wp / determinant);
        let run = run(&case);
        let [found_w, found_phi] = run.unknowns(0);
        assert!(relative(found_w[30], w) <= 1e-12, "{section:?}: {} for {w}", found_w[30]);
        assert!(relative(found_phi[30], phi) <= 1e-12, "{section:?}: {} for {phi}", found_phi[30]);
        assert!(relative(found_w[31], w + gap * phi) <= 1e-12, "{section:?}: the far end of the bar");
        assert!(relative(found_phi[31], phi) <= 1e-12, "{section:?}: the far end of the bar");
        let total: f64 = run.states[0].reactions.iter().map(|r| r.force).sum();
        assert!(relative(total, -section.force) <= 1e-10, "{section:?}: {total}");
    }
}

#[test]
fn two_forces_closer_than_the_horizon_superpose() {
    for section in SECTIONS {
        let (b, s) = section.stiffness();
        let (near, far) = (0.4, 0.425);
        let loads = [force(near, 3.0), force(far, -2.0)];
        let run = run(&case(section.height, 40, &[ROLLER(0.0), ROLLER(1.0)], &loads));
        let exact = |x: f64| 3.0 * influence(x, near, b, s) - 2.0 * influence(x, far, b, s);
        let error = worst_deflection(&run, exact);
        assert!(error <= 1e-13, "{section:?}: {error:e}");
    }
}

#[test]
fn a_force_beside_an_interior_support_is_exact() {
    for section in SECTIONS {
        let (b, s) = section.stiffness();
        // The next point: both are nodes that no bond spans, the horizon is three spacings.
        for a in [0.525, 0.55] {
            let supports = [ROLLER(0.0), ROLLER(0.5), ROLLER(1.0)];
            let run = run(&case(section.height, 40, &supports, &[force(a, 7.0)]));
            let reaction = -7.0 * influence(0.5, a, b, s) / influence(0.5, 0.5, b, s);
            let exact = |x: f64| 7.0 * influence(x, a, b, s) + reaction * influence(x, 0.5, b, s);
            // Deflections are small against the two parts they are the difference of: compare with one of them.
            let scale = 7.0 * influence(0.5, a, b, s);
            let [w, _] = run.unknowns(0);
            let differences: Vec<f64> =
                run.x().iter().zip(&w).map(|(&x, w)| (w - exact(x)) / scale).collect();
            assert!(largest(&differences) <= 1e-13, "{section:?}, {a}: {:e}", largest(&differences));
            let found = run.states[0].reactions[1].force;
            assert!(relative(found, reaction) <= 1e-11, "{section:?}, {a}: {found} for {reaction}");
        }
    }
}

#[test]
fn a_combination_is_the_sum_of_its_load_cases_and_counts_settlements_once() {
    let mut case = case(0.05, 60, &[ROLLER(0.0), ROLLER(0.5), ROLLER(1.0)], &[]);
    case["load_cases"] = json!([
        { "name": "dead", "loads": [{ "distributed": { "force": { "uniform": -500.0 } } }] },
        { "name": "live", "loads": [force(0.25, -900.0)] }
    ]);
    case["combinations"] = json!([{ "name": "both", "factors": { "dead": 1.35, "live": 1.5 } }]);
    let level = run(&case);
    let u: Vec<&[f64]> = level.states.iter().map(|s| s.record.u.as_slice()).collect();
    let sum = |k: usize| 1.35 * u[0][k] + 1.5 * u[1][k];
    let differences: Vec<f64> = (0..u[2].len()).map(|k| u[2][k] - sum(k)).collect();
    assert!(largest(&differences) <= 1e-13 * largest(u[2]));

    case["supports"][1]["w"] = json!(-0.002);
    let settled = run(&case);
    let moved: Vec<Vec<f64>> = (0..3)
        .map(|k| {
            settled.states[k].record.u.iter().zip(&level.states[k].record.u).map(|(a, b)| a - b).collect()
        })
        .collect();
    for k in 1..3 {
        let differences: Vec<f64> = moved[k].iter().zip(&moved[0]).map(|(a, b)| a - b).collect();
        assert!(largest(&differences) <= 1e-12 * largest(&moved[0]), "state {k}");
    }
}

#[test]
fn load_steps_scale_loads_and_settlements_together() {
    let mut middle = ROLLER(0.5);
    middle["w"] = json!(-0.002);
    let mut case = case(0.05, 60, &[ROLLER(0.0), middle, ROLLER(1.0)], &[force(0.25, -900.0)]);
    case["steps"] = json!({ "load_factors": [0.5, -2.0, 1.0] });
    let run = run(&case);
    let full = &run.states[2].record.u;
    for (state, factor) in [(0, 0.5), (1, -2.0)] {
        let differences: Vec<f64> =
            run.states[state].record.u.iter().zip(full).map(|(found, u)| found - factor * u).collect();
        // Measured 1e-15.
        assert!(largest(&differences) <= 1e-13 * largest(full), "step {state}: {:e}", largest(&differences));
    }
}
