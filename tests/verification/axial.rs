//! Axial unknowns: where they are made, where members stretch as bars, and places inside members.

use crate::support::plane_frame::Frame;
use crate::support::sections::{all_ends, at, difference, model};
use crate::support::{largest, relative, run_recovered, scene};
use peristat::case::FieldName;
use serde_json::{Value, json};

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
    let mut compared = 0;
    for &field in FieldName::of_beam(true, true) {
        // Areas are not given: no stresses, no densities.
        let Some(whole) = whole.states[0].values(field, 0) else { continue };
        let (a, b) = (parts.states[0].values(field, 0), parts.states[0].values(field, 1));
        let (a, b) = (a.expect("there"), b.expect("there"));
        let joined: Vec<f64> = a[..15].iter().chain(b.iter()).copied().collect();
        // Measured 1e-14.
        assert!(crate::support::error(&whole, &joined) <= 1e-13, "{}", field.name());
        compared += 1;
    }
    // Displacements and their parts, rotations, N, V and M.
    assert_eq!(compared, 8);
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
    // A level that is off by rounding.
    let mut off = gerber(Value::Null);
    (0..4).for_each(|k| off["body"]["frame"]["joints"][k]["y"] = json!(if k == 1 { 0.1 + 0.2 } else { 0.3 }));
    assert!(!scene(&off).has_axial);
    let [two, three] = [Value::Null, json!({ "at": { "joint": "D" }, "ux_spring": 1.0 })]
        .map(|extra| run_recovered(&gerber(extra)));
    let mut compared = 0;
    // Measured 1e-14.
    assert!(difference(&all_ends(&two), &all_ends(&three)) <= 1e-13);
    let mut worst: f64 = 0.0;
    for &field in FieldName::of_beam(true, true) {
        let of = |member: usize| [&two, &three].map(|r| r.states[0].values(field, member));
        // The rounding of a member is that of the whole frame, the largest motion of which may be in another one.
        let scale =
            (0..3).filter_map(|member| of(member)[1].as_ref().map(|b| largest(b))).fold(0.0, f64::max);
        let scale = if scale > 1e-12 { scale } else { 1.0 };
        for member in 0..3 {
            let [Some(a), Some(b)] = of(member) else { continue };
            let apart = a.iter().zip(b.iter()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
            worst = worst.max(apart / scale);
            compared += 1;
        }
    }
    // Measured 2e-14.
    assert!(worst <= 1e-13, "{worst:e}");
    // On three members displacements and their parts, rotations, N, V and M.
    assert_eq!(compared, 24);
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
    assert!(difference(&all_ends(&bars), &all_ends(&points)) <= 1e-13);
    for field in [FieldName::U, FieldName::Ux, FieldName::Uy] {
        for member in 0..frame.members.len() {
            let [a, b] =
                [&bars, &points].map(|r| r.states[0].values(field, member).expect("there").into_owned());
            let scale = largest(&bars.states[0].record.u);
            assert!(largest(&a.iter().zip(&b).map(|(a, b)| a - b).collect::<Vec<_>>()) <= 1e-13 * scale);
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
