//! Plane frames: closed forms, rotations, statics, and a dense matrix calculation of random frames.

use crate::support::plane_frame::Frame;
use crate::support::sections::{all_ends, at, difference, ends, model, stiffness};
use crate::support::{largest, relative, run_recovered};
use peristat::case::FieldName;
use serde_json::json;

#[test]
fn the_tip_of_an_l_frame_moves_as_the_work_of_its_parts_says() {
    for (m, cells) in [(1, 1), (2, 7), (3, 20), (4, 64)] {
        let case = json!({
            "title": "test", "model": model("exact"), "horizon_ratio": m,
            "body": { "frame": {
                "joints": [{ "name": "A", "x": 0.0, "y": 0.0 }, { "name": "B", "x": 0.0, "y": 2.0 },
                           { "name": "C", "x": 1.5, "y": 2.0 }],
                "members": [{ "name": "column", "from": "A", "to": "B", "cells": cells },
                            { "name": "arm", "from": "B", "to": "C", "cells": cells }] } },
            "supports": [{ "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }],
            "loads": [{ "point": { "at": { "joint": "C" }, "force_y": -1.0 } }]
        });
        let run = run_recovered(&case);
        // -(1.5³/3 + 1.5²·2 + 2/200 + 1.5/50) and 1.5·2²/2; measured 2e-16.
        assert!(relative(at(&run, FieldName::Uy, 1, cells), -5.665) <= 4e-15);
        assert!(relative(at(&run, FieldName::Ux, 1, cells), 3.0) <= 4e-15);
        assert_eq!(ends(&run, 1)[1].map(|v| (v * 1e9).round()), [0.0, -1e9, 0.0]);
    }
}

#[test]
fn a_leaning_cantilever_is_a_turned_one() {
    let loads = json!([{ "distributed": { "force": { "linear": [1.0, 2.0] } } }, { "point": { "at": { "x": 2.0 }, "force": 3.0, "moment": -1.0 } }]);
    let straight = json!({
        "title": "test", "model": model("corrected"), "body": { "line": { "length": 2.0, "cells": 30 } },
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }], "loads": loads
    });
    let straight = run_recovered(&straight);
    let (s, c) = 30.0_f64.to_radians().sin_cos();
    let frame = json!({
        "title": "test", "model": model("corrected"),
        "body": { "frame": {
            "joints": [{ "name": "A", "x": 1.0, "y": -1.0 }, { "name": "B", "x": 1.0 + 2.0 * c, "y": -1.0 + 2.0 * s }],
            "members": [{ "name": "m", "from": "A", "to": "B", "cells": 30 }] } },
        "supports": [{ "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }],
        "loads": [
            { "distributed": { "member": "m", "force": { "linear": [1.0, 2.0] } } },
            { "point": { "at": { "member": "m", "x": 2.0 }, "force": 3.0, "moment": -1.0 } }
        ]
    });
    let leaning = run_recovered(&frame);
    for field in [FieldName::W, FieldName::Phi, FieldName::M, FieldName::V] {
        let [a, b] = [&leaning, &straight].map(|r| r.states[0].values(field, 0).expect("there").into_owned());
        // Measured 7e-16.
        assert!(crate::support::error(&a, &b) <= 1e-14, "{}", field.name());
    }
    let along = leaning.states[0].values(FieldName::U, 0).expect("there");
    // Measured 0.
    assert!(largest(&along) <= 1e-14 * largest(&leaning.states[0].values(FieldName::W, 0).expect("there")));
}

#[test]
fn random_frames_agree_with_a_dense_matrix_calculation() {
    for seed in 0..60 {
        let frame = Frame::random(seed);
        let (run, answer) = (run_recovered(&frame.case()), frame.answer());
        // Measured 6e-12 at worst.
        let error = difference(&all_ends(&run), &answer.sections);
        assert!(error <= 1e-10, "seed {seed}: section forces differ by {error:e}");
        let scale = largest(answer.displacements.as_flattened());
        for (number, member) in frame.members.iter().enumerate() {
            for side in 0..2 {
                let point = side * member.cells;
                let expected = answer.displacements[member.joints[side]];
                let found = [FieldName::Ux, FieldName::Uy].map(|f| at(&run, f, number, point));
                // Measured 1e-11 at worst.
                let error = largest(&[found[0] - expected[0], found[1] - expected[1]]) / scale;
                assert!(error <= 1e-10, "seed {seed}, member {number}: {found:?} for {expected:?}");
            }
        }
    }
}

/// What loads and the ends of members do to every joint: supports and springs must hold it.
fn left_over(frame: &Frame, sections: &[[[f64; 3]; 2]]) -> Vec<[f64; 3]> {
    let mut sums = frame.loads.clone();
    for (member, ends) in frame.members.iter().zip(sections) {
        let (_, [c, s]) = frame.line(member);
        for (side, sign) in [1.0, -1.0].into_iter().enumerate() {
            let [n, v, m] = ends[side].map(|f| sign * f);
            let sum = &mut sums[member.joints[side]];
            *sum = [sum[0] + c * n - s * v, sum[1] + s * n + c * v, sum[2] + m];
        }
    }
    sums
}

#[test]
fn every_joint_is_in_balance_and_no_hinge_carries_a_moment() {
    for seed in 100..130 {
        let frame = Frame::random(seed);
        let run = run_recovered(&frame.case());
        let sections = all_ends(&run);
        let mut sums = left_over(&frame, &sections);
        let scale = largest(sections.as_flattened().as_flattened()).max(1.0);
        for (member, ends) in frame.members.iter().zip(&sections) {
            for (hinged, [_, _, m]) in member.hinges.into_iter().zip(ends) {
                // Measured 1e-12.
                assert!(!hinged || m.abs() <= 1e-11 * scale, "seed {seed}: {m}");
            }
        }
        let state = &run.states[0];
        let held = frame.supports.iter().map(|s| s.joint).chain(frame.springs.iter().map(|s| s.0));
        for (joint, reaction) in held.zip(&state.joint_reactions) {
            let force = [reaction.force_x, reaction.force_y, reaction.moment];
            (0..3).for_each(|c| sums[joint][c] += force[c]);
        }
        // Measured 4e-12.
        assert!(largest(sums.as_flattened()) <= 1e-11 * scale, "seed {seed}: {sums:?}");
    }
}

#[test]
fn an_inclined_support_pushes_in_its_own_direction_alone() {
    for seed in 200..220 {
        let frame = Frame::random(seed);
        let (run, answer) = (run_recovered(&frame.case()), frame.answer());
        let (s, c) = frame.supports[3].degrees.expect("it is inclined").to_radians().sin_cos();
        // The force that holds the joint, from the section forces around it.
        let sections = all_ends(&run);
        let scale = largest(sections.as_flattened().as_flattened());
        let [x, y, moment] = left_over(&frame, &sections)[frame.supports[3].joint].map(|f| -f);
        let (along, across) = (c * x + s * y, c * y - s * x);
        // Measured 7e-13.
        assert!(across.abs().max(moment.abs()) <= 1e-11 * scale, "seed {seed}: {across}, {moment}");
        let reported = run.states[0].joint_reactions[3].inclined.expect("the support is inclined");
        for force in [along, reported] {
            // Measured 4e-13 and 1.5e-12.
            let off = (force - answer.reactions[3]).abs();
            assert!(off <= 2e-11 * scale, "seed {seed}: {force} is off by {off:e}");
        }
    }
}

#[test]
fn a_turned_frame_has_the_same_section_forces() {
    for seed in 300..310 {
        let mut frame = Frame::random(seed);
        // Springs stand in the axes of the plane and would not turn.
        frame.springs.clear();
        let upright = run_recovered(&frame.case());
        for degrees in [30.0, 90.0, -127.0] {
            let turned = run_recovered(&frame.turned(degrees).case());
            // Measured 1e-11, where a short member is stiff.
            let error = difference(&all_ends(&turned), &all_ends(&upright));
            assert!(error <= 1e-10, "seed {seed}, {degrees}°: {error:e}");
        }
    }
}

#[test]
fn a_slender_frame_keeps_its_digits() {
    let (height, span) = (2.0_f64, 1.5_f64);
    for h in [0.05_f64, 1e-3, 1e-4] {
        let (bending, axial) = (2e11 * 0.05 * h.powi(3) / 12.0, 2e11 * 0.05 * h);
        let shear = 5.0 / 6.0 * axial / 2.6;
        let mut case = json!({
            "title": "test", "model": model("exact"),
            "body": { "frame": {
                "joints": [{ "name": "A", "x": 0.0, "y": 0.0 }, { "name": "B", "x": 0.6 * height, "y": 0.8 * height },
                           { "name": "C", "x": 0.6 * height + span, "y": 0.8 * height }],
                "members": [{ "name": "column", "from": "A", "to": "B", "cells": 1000 },
                            { "name": "arm", "from": "B", "to": "C", "cells": 1000 }] } },
            "supports": [{ "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }],
            "loads": [{ "point": { "at": { "joint": "C" }, "force_y": -1e-5 } }]
        });
        case["model"]["timoshenko_beam"]["stiffness"] = stiffness(bending, shear, axial);
        let run = run_recovered(&case);
        // Work of a unit force: M = span + 0.6 s over the column, N = 0.8, V = 0.6 in it.
        let column = span * span * height + 0.6 * span * height.powi(2) + 0.12 * height.powi(3);
        let tip =
            (span.powi(3) / 3.0 + column) / bending + 0.64 * height / axial + (0.36 * height + span) / shear;
        // Measured 9e-16, 1.4e-15 and 5e-16.
        assert!(relative(at(&run, FieldName::Uy, 1, 1000), -1e-5 * tip) <= 2e-14, "h = {h}");
        assert!(relative(ends(&run, 0)[0][2], -1e-5 * (span + 0.6 * height)) <= 2e-14, "h = {h}");
        assert!(relative(ends(&run, 0)[0][0], -0.8e-5) <= 1e-14, "h = {h}");
    }
}
