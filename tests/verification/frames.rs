//! Plane frames: closed forms, rotations, statics, and a dense matrix calculation of random frames.

use crate::support::plane_frame::Frame;
use crate::support::{Run, largest, relative, run_recovered, scene};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// A field at a real point of a member.
fn at(run: &Run, field: FieldName, member: usize, point: usize) -> f64 {
    run.states[0].value(field, member, point).expect("the field is there")
}

/// N, V, M at the two ends of a member, from inside it.
fn ends(run: &Run, member: usize) -> [[f64; 3]; 2] {
    let forces = &run.states[0].lines[member].recovered.as_ref().expect("recovered").forces;
    let (first, last) = (0, forces.moment.len() - 1);
    [(first, 0), (last, 1)].map(|(cell, side)| {
        let axial = forces.axial.get(cell).map_or(0.0, |n| n[side]);
        [axial, forces.shear[cell][side], forces.moment[cell][side]]
    })
}

/// Largest difference of all section forces relative to the largest one.
fn difference(a: &[[[f64; 3]; 2]], b: &[[[f64; 3]; 2]]) -> f64 {
    let (a, b) = (a.as_flattened().as_flattened(), b.as_flattened().as_flattened());
    crate::support::error(a, b)
}

fn all_ends(run: &Run) -> Vec<[[f64; 3]; 2]> {
    (0..run.states[0].lines.len()).map(|m| ends(run, m)).collect()
}

fn stiffness(bending: f64, shear: f64, axial: f64) -> Value {
    json!({ "bending": { "uniform": bending }, "shear": { "uniform": shear }, "axial": { "uniform": axial } })
}

fn model(law: &str) -> Value {
    json!({ "timoshenko_beam": { "stiffness": stiffness(1.0, 50.0, 200.0), "bond_law": law } })
}

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
        assert!(relative(at(&run, FieldName::Uy, 1, cells), -5.665) <= 1e-12);
        assert!(relative(at(&run, FieldName::Ux, 1, cells), 3.0) <= 1e-12);
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
        assert!(crate::support::error(&a, &b) <= 1e-12, "{}", field.name());
    }
    let along = leaning.states[0].values(FieldName::U, 0).expect("there");
    assert!(largest(&along) <= 1e-12 * largest(&leaning.states[0].values(FieldName::W, 0).expect("there")));
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

#[test]
fn every_joint_is_in_balance_and_no_hinge_carries_a_moment() {
    for seed in 100..130 {
        let frame = Frame::random(seed);
        let run = run_recovered(&frame.case());
        let (mut sums, sections) = (frame.loads.clone(), all_ends(&run));
        let scale = largest(sections.as_flattened().as_flattened()).max(1.0);
        for (member, ends) in frame.members.iter().zip(&sections) {
            let (_, [c, s]) = frame.line(member);
            for side in 0..2 {
                let sign = if side == 0 { 1.0 } else { -1.0 };
                let [n, v, m] = ends[side].map(|f| sign * f);
                let sum = &mut sums[member.joints[side]];
                (sum[0], sum[1]) = (sum[0] + c * n - s * v, sum[1] + s * n + c * v);
                sum[2] += m;
                // Measured 1e-12.
                assert!(!member.hinges[side] || m.abs() <= 1e-11 * scale, "seed {seed}: {m}");
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
        let reaction = &run.states[0].joint_reactions[3];
        let across = c * reaction.force_y - s * reaction.force_x;
        let along = c * reaction.force_x + s * reaction.force_y;
        assert!(across.abs() <= 1e-14 * along.abs() && reaction.moment == 0.0);
        // Measured 9e-12.
        assert!(relative(along, answer.reactions[3]) <= 1e-10, "seed {seed}");
        assert_eq!(reaction.inclined.map(|f| relative(f, along) <= 1e-14), Some(true));
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
fn a_place_inside_a_member_is_as_good_as_a_joint() {
    let joints = |middle: bool| {
        let all = json!([{ "name": "A", "x": 0.0, "y": 0.0 }, { "name": "B", "x": 1.2, "y": 0.9 }, { "name": "C", "x": 3.2, "y": 2.4 }]);
        if middle { all } else { json!([all[0], all[2]]) }
    };
    let case = |middle: bool| {
        let place = if middle { json!({ "joint": "B" }) } else { json!({ "member": "m", "x": 1.5 }) };
        let members = match middle {
            true => {
                json!([{ "name": "m", "from": "A", "to": "B", "cells": 15 }, { "name": "n", "from": "B", "to": "C", "cells": 25 }])
            }
            false => json!([{ "name": "m", "from": "A", "to": "C", "cells": 40 }]),
        };
        json!({
            "title": "test", "model": model("exact"),
            "body": { "frame": { "joints": joints(middle), "members": members } },
            "supports": [
                { "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }, { "at": place, "uy_spring": 3.0, "inclined": { "degrees": 10.0 } }
            ],
            "loads": [
                { "point": { "at": place, "force_x": 1.0, "force_y": 2.0, "moment": 0.5 } },
                { "point": { "at": { "joint": "C" }, "force_x": -1.0, "force_y": 0.3 } }
            ]
        })
    };
    let [whole, parts] = [case(false), case(true)].map(|c| run_recovered(&c));
    for field in FieldName::FRAME {
        // Areas are not given: no stresses, no densities.
        let Some(whole) = whole.states[0].values(field, 0) else { continue };
        let (a, b) = (parts.states[0].values(field, 0), parts.states[0].values(field, 1));
        let (a, b) = (a.expect("there"), b.expect("there"));
        let joined: Vec<f64> = a[..15].iter().chain(b.iter()).copied().collect();
        // Measured 1e-14.
        assert!(crate::support::error(&whole, &joined) <= 1e-11, "{}", field.name());
    }
}

fn gerber(extra: Value) -> Value {
    let mut case = json!({
        "title": "test", "model": model("exact"),
        "body": { "frame": {
            "joints": [{ "name": "A", "x": 0.0, "y": 1.0 }, { "name": "B", "x": 4.0, "y": 1.0 },
                       { "name": "C", "x": 6.0, "y": 1.0 }, { "name": "D", "x": 10.0, "y": 1.0 }],
            "members": [{ "name": "a", "from": "A", "to": "B", "cells": 40 },
                        { "name": "b", "from": "C", "to": "B", "cells": 20 },
                        { "name": "c", "from": "C", "to": "D", "cells": 40, "hinges": ["from"] }] } },
        "supports": [{ "at": { "joint": "A" }, "ux": 0.0, "uy": 0.0, "phi": 0.001 }, { "at": { "joint": "B" }, "uy": -0.01 },
                     { "at": { "joint": "D" }, "uy": 0.0 }],
        "loads": [{ "distributed": { "member": "c", "force_y": { "uniform": -1.0 } } }, { "point": { "at": { "joint": "C" }, "force_y": 2.0 } }]
    });
    if extra != Value::Null {
        case["supports"].as_array_mut().expect("a list").push(extra);
    }
    case
}

#[test]
fn a_straight_frame_has_no_axial_unknowns_until_something_reads_them() {
    assert!(!scene(&gerber(Value::Null)).has_axial);
    let still = json!({ "at": { "joint": "D" }, "ux": 0.0 });
    assert!(!scene(&gerber(still)).has_axial);
    for reads in [
        json!({ "at": { "joint": "D" }, "ux": 0.1 }),
        json!({ "at": { "joint": "D" }, "ux_spring": 1.0 }),
        json!({ "at": { "joint": "D" }, "inclined": { "degrees": 80.0 } }),
    ] {
        assert!(scene(&gerber(reads)).has_axial);
    }
    let [two, three] = [Value::Null, json!({ "at": { "joint": "D" }, "ux_spring": 1.0 })]
        .map(|extra| run_recovered(&gerber(extra)));
    // The same to the last digit.
    assert!(difference(&all_ends(&two), &all_ends(&three)) <= 1e-11);
    for field in FieldName::FRAME {
        for member in 0..3 {
            let values = [&two, &three].map(|r| r.states[0].values(field, member));
            let [Some(a), Some(b)] = values else { continue };
            let scale = if largest(&b) > 1e-12 { largest(&b) } else { 1.0 };
            let apart = a.iter().zip(b.iter()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            assert!(apart <= 1e-11 * scale, "{} of member {member}: {apart:e}", field.name());
        }
    }
}

#[test]
fn bars_from_end_to_end_are_as_good_as_points_that_stretch() {
    let mut frame = Frame::random(7);
    frame.members.iter_mut().for_each(|m| m.load[1] = 0.0);
    let (mut case, bars) = (frame.case(), run_recovered(&frame.case()));
    // A band has no bars that reach from end to end.
    case["solver"] = json!("band");
    let points = run_recovered(&case);
    assert!(bars.report.sizes.bonds < points.report.sizes.bonds);
    // Measured 8e-15.
    assert!(difference(&all_ends(&bars), &all_ends(&points)) <= 1e-11);
    for field in [FieldName::U, FieldName::Ux, FieldName::Uy] {
        for member in 0..frame.members.len() {
            let [a, b] =
                [&bars, &points].map(|r| r.states[0].values(field, member).expect("there").into_owned());
            let scale = largest(&bars.states[0].u);
            assert!(largest(&a.iter().zip(&b).map(|(a, b)| a - b).collect::<Vec<_>>()) <= 1e-11 * scale);
        }
    }
}

#[test]
fn lines_that_a_rigid_link_joins_pull_each_other() {
    let case = json!({
        "title": "test", "model": model("exact"),
        "body": { "lines": [{ "length": 1.0, "cells": 10 }, { "from": 1.1, "length": 2.0, "cells": 10 }] },
        "links": [{ "rigid": { "from": { "x": 1.0 }, "to": { "x": 1.1 } } }],
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 }],
        "loads": [{ "point": { "at": { "x": 3.1 }, "axial": 4.0 } }, { "point": { "at": { "x": 0.5 }, "axial": -1.0 } }]
    });
    let run = run_recovered(&case);
    // N is 3 up to x = 0.5 and 4 beyond: (3·0.5 + 4·0.5 + 4·2)/200.
    assert!(relative(at(&run, FieldName::U, 1, 10), 11.5 / 200.0) <= 1e-12);
    assert!(relative(run.states[0].reactions[0].axial.expect("it is held"), -3.0) <= 1e-12);
}
