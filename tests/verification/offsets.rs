//! Rigid arms and links of frames, against members that are all but rigid.

use crate::support::{largest, run_recovered};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// How much stiffer the members are that stand for arms.
const STIFF: f64 = 1e6;

fn frame(joints: &[Value], members: &[Value], links: &[Value]) -> Value {
    let loads = json!([
        { "point": { "at": { "joint": "B" }, "force_x": 1, "moment": 0.5 } },
        { "distributed": { "member": "beam", "force_y": { "uniform": -2 }, "force_x": { "linear": [0, 1] } } }
    ]);
    json!({
        "title": "test", "model": crate::support::sections::model("exact"), "body": { "frame": { "joints": joints, "members": members } },
        "supports": [ { "at": { "joint": "A" }, "ux": 0, "uy": 0, "phi": 0 }, { "at": { "joint": "D" }, "ux": 0.01, "uy": 0, "phi": 0 } ],
        "links": links, "loads": loads
    })
}

fn joint(name: &str, x: f64, y: f64) -> Value {
    json!({ "name": name, "x": x, "y": y })
}

fn member(name: &str, from: &str, to: &str) -> Value {
    json!({ "name": name, "from": from, "to": to, "cells": 4 })
}

/// A leaning frame whose beam begins and ends beside its joints.
fn joints() -> Vec<Value> {
    vec![joint("A", 0.0, 0.0), joint("B", 0.3, 3.0), joint("C", 4.0, 2.5), joint("D", 4.2, 0.0)]
}

const ARMS: [[f64; 2]; 2] = [[0.2, -0.3], [-0.1, 0.4]];

fn ends() -> [Value; 2] {
    [joint("b", 0.3 + ARMS[0][0], 3.0 + ARMS[0][1]), joint("c", 4.0 + ARMS[1][0], 2.5 + ARMS[1][1])]
}

/// Section forces at both ends of the beam and the columns, and displacements of the joints.
fn answers(case: &Value) -> Vec<f64> {
    let run = run_recovered(case);
    let state = &run.states[0];
    let balance = state.record.certificate.resultants.as_ref().expect("resultants");
    assert!(balance.difference < 1e-12, "{balance:?}");
    let fields = [FieldName::M, FieldName::V, FieldName::N, FieldName::Ux, FieldName::Uy, FieldName::Phi];
    let value =
        |line: usize, point: usize, field: FieldName| state.value(field, line, point).expect("recovered");
    (0..3)
        .flat_map(|line| [0, 4].into_iter().flat_map(move |point| fields.map(|field| (line, point, field))))
        .map(|(l, p, f)| value(l, p, f))
        .collect()
}

#[test]
fn arms_and_links_are_members_that_are_all_but_rigid() {
    for hinges in [json!([]), json!(["to"])] {
        let mut beam = member("beam", "B", "C");
        beam["offsets"] = json!({ "from": ARMS[0], "to": ARMS[1] });
        beam["hinges"] = hinges.clone();
        let columns = [member("left", "A", "B"), member("right", "D", "C")];
        let with_arms = answers(&frame(&joints(), &[&columns[..], &[beam]].concat(), &[]));
        let mut own = member("beam", "b", "c");
        own["hinges"] = hinges.clone();
        let mut stubs = [member("stub b", "B", "b"), member("stub c", "C", "c")];
        for stub in &mut stubs {
            let stiff = |value: f64| json!({ "uniform": STIFF * value });
            stub["stiffness"] = json!({ "bending": stiff(1.0), "shear": stiff(50.0), "axial": stiff(200.0) });
        }
        let all = [joints(), ends().to_vec()].concat();
        let stiff = answers(&frame(&all, &[&columns[..], &[own.clone()], &stubs].concat(), &[]));
        let linked = if hinges == json!([]) {
            let link = |from: &str, to: &str| json!({ "rigid": { "from": { "joint": from }, "to": { "joint": to } } });
            Some(answers(&frame(&all, &[&columns[..], &[own]].concat(), &[link("B", "b"), link("c", "C")])))
        } else {
            None
        };
        let size = largest(&stiff);
        let apart =
            |other: &[f64]| largest(&with_arms.iter().zip(other).map(|(a, b)| a - b).collect::<Vec<_>>());
        // 2e-7 is found of the stiff members, which leave a millionth, and 1e-14 of links.
        assert!(apart(&stiff) < 1e-5 * size, "{hinges}: {:e}", apart(&stiff));
        if let Some(linked) = linked {
            assert!(apart(&linked) < 1e-12 * size, "{:e}", apart(&linked));
        }
    }
}
