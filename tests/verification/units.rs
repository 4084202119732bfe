//! Other units of length and force change no result but by themselves. They are powers of two, which rounding does not
//! see: results agree to the last bit, and what measures a length by a turn shows at once.

use crate::support::plane_frame::Frame;
use crate::support::sections::{all_ends, model, stiffness};
use crate::support::{Run, run_recovered};
use serde_json::{Value, json};

/// Lengths and forces in new units, about a thousandth and a thousand of the old ones.
const UNITS: [[f64; 2]; 4] = [[1024.0, 1.0], [1.0 / 1024.0, 1.0], [1.0, 1024.0], [1.0 / 1024.0, 1024.0]];

fn frame_in_units(frame: &Frame, [length, force]: [f64; 2]) -> Frame {
    let mut frame = frame.clone();
    frame.joints.as_flattened_mut().iter_mut().for_each(|x| *x *= length);
    for member in &mut frame.members {
        let [bending, shear, axial] = member.stiffness;
        member.stiffness = [bending * force * length * length, shear * force, axial * force];
        member.load = member.load.map(|q| q * force / length);
    }
    for support in frame.supports.iter_mut().filter(|s| s.degrees.is_some()) {
        support.value *= length;
    }
    for (_, [x, y, turn]) in &mut frame.springs {
        (*x, *y, *turn) = (*x * force / length, *y * force / length, *turn * force * length);
    }
    frame.loads.iter_mut().for_each(|[x, y, m]| (*x, *y, *m) = (*x * force, *y * force, *m * force * length));
    frame
}

/// A line that is clamped and pulled, with a spring along it at its other end.
fn line([length, force]: [f64; 2]) -> Value {
    let uniform = |v: f64| json!({ "uniform": v });
    let mut case = json!({
        "title": "test", "model": model("corrected"), "horizon_ratio": 3,
        "body": { "line": { "length": 0.7 * length, "cells": 40 } },
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 },
                     { "at": { "x": 0.7 * length }, "ux_spring": 30.0 * force / length }],
        "loads": [{ "distributed": { "force": uniform(0.3 * force / length), "axial": uniform(1.7 * force / length) } },
                  { "point": { "at": { "x": 0.7 * length }, "moment": 0.1 * force * length } }]
    });
    case["model"]["timoshenko_beam"]["stiffness"] =
        stiffness(1.3 * force * length * length, 50.0 * force, 200.0 * force);
    case
}

/// All that a run tells, in the first units; a balance is named.
fn told(run: &Run, [length, force]: [f64; 2]) -> Vec<(String, f64)> {
    let (state, mut told) = (&run.states[0], Vec::new());
    let n = state.record.u.len() / 3;
    for (component, (plane, unit)) in state.record.u.chunks_exact(n).zip([length, 1.0, length]).enumerate() {
        told.extend(plane.iter().map(|u| (format!("unknown {component}"), u / unit)));
    }
    for ends in all_ends(run) {
        for [axial, shear, moment] in ends {
            told.extend([axial, shear, moment / length].map(|f| ("section force".into(), f / force)));
        }
    }
    let certificate = &state.record.certificate;
    told.extend(certificate.balance.iter().map(|b| (b.motion.to_string(), b.relative)));
    told.extend([
        ("residual".into(), certificate.residual),
        ("next correction".into(), certificate.next_correction),
        ("first correction".into(), certificate.first_correction),
        ("energy balance".into(), certificate.energy_balance),
        ("energy".into(), certificate.energy / (force * length)),
    ]);
    told
}

#[test]
fn units_do_not_change_a_frame() {
    for seed in 400..420 {
        let frame = Frame::random(seed);
        let expected = told(&run_recovered(&frame.case()), [1.0; 2]);
        for units in UNITS {
            let found = told(&run_recovered(&frame_in_units(&frame, units).case()), units);
            for (found, expected) in found.iter().zip(&expected) {
                assert_eq!(found, expected, "seed {seed}, {units:?}");
            }
        }
    }
}

#[test]
fn units_do_not_change_a_pulled_line() {
    let expected = told(&run_recovered(&line([1.0; 2])), [1.0; 2]);
    for units in UNITS {
        assert_eq!(told(&run_recovered(&line(units)), units), expected, "{units:?}");
    }
}

#[test]
fn a_pinned_member_turns_about_its_joint_whatever_the_unit_of_length() {
    for length in [1e-9, 1.1e-7, 1.0, 1e7] {
        let case = json!({
            "title": "test", "model": model("exact"),
            "body": { "frame": {
                "joints": [{ "name": "A", "x": 0.0, "y": 0.0 }, { "name": "B", "x": 0.6 * length, "y": 0.8 * length }],
                "members": [{ "name": "m", "from": "A", "to": "B", "cells": 4 }] } },
            "supports": [{ "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0 }],
            "loads": [{ "point": { "at": { "joint": "B" }, "force_y": 1.0 } }]
        });
        let message = peristat::solve_text(&case.to_string()).expect_err("a mechanism").to_string();
        assert!(message.contains("the member `m` is free to rotate about (0, 0);"), "{length}: {message}");
    }
}
