//! Members that bear tension alone, or compression: against frames without the slack ones.

use crate::support::{largest, run_recovered};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// A tower of three hinged bays, each with two crossed braces, of which `kept` are there.
fn tower(kept: &[bool], only: Option<&str>, forces: &[f64]) -> Value {
    let bar = |name: String, from: String, to: String| json!({ "name": name, "from": from, "to": to, "cells": 1, "hinges": ["from", "to"] });
    let joint = |side: &str, k: usize| format!("{side}{k}");
    let mut members = Vec::new();
    for k in 0..3 {
        members.push(bar(format!("left {k}"), joint("l", k), joint("l", k + 1)));
        members.push(bar(format!("right {k}"), joint("r", k), joint("r", k + 1)));
        members.push(bar(format!("beam {k}"), joint("l", k + 1), joint("r", k + 1)));
    }
    for (k, _) in kept.iter().enumerate().filter(|(_, kept)| **kept) {
        let (from, to) = if k % 2 == 0 { ("l", "r") } else { ("r", "l") };
        let mut brace = bar(format!("brace {k}"), joint(from, k / 2), joint(to, k / 2 + 1));
        if let Some(only) = only {
            brace["only"] = json!(only);
        }
        members.push(brace);
    }
    let joints: Vec<Value> = (0..4)
        .flat_map(|k| {
            [("l", 0.0), ("r", 4.0)]
                .map(|(side, x)| json!({ "name": joint(side, k), "x": x, "y": 3.0 * k as f64 }))
        })
        .collect();
    let loads: Vec<Value> = forces
        .iter()
        .enumerate()
        .map(|(k, force)| json!({ "point": { "at": { "joint": joint("l", k + 1) }, "force_x": force, "force_y": -1 } }))
        .collect();
    json!({
        "title": "test", "model": crate::support::sections::model("exact"), "body": { "frame": { "joints": joints, "members": members } },
        "supports": [ { "at": { "joint": "l0" }, "ux": 0, "uy": 0 }, { "at": { "joint": "r0" }, "ux": 0, "uy": 0 } ],
        "loads": loads
    })
}

#[test]
fn slack_braces_are_as_good_as_none() {
    for (only, sign) in [("tension", 1.0), ("compression", -1.0)] {
        for forces in [[3.0, 1.0, 2.0], [3.0, -2.0, 1.0], [-2.0, 5.0, -4.0], [1.0, 1.0, -5.0]] {
            let found = run_recovered(&tower(&[true; 6], Some(only), &forces));
            let axial: Vec<f64> = (9..15)
                .map(|line| found.states[0].value(FieldName::N, line, 0).expect("recovered"))
                .collect();
            let kept: Vec<bool> = axial.iter().map(|n| n.abs() > 1e-9).collect();
            // Of two diagonals of a bay one is slack at least; the shear force tells which one is taut.
            let shear = [forces[0] + forces[1] + forces[2], forces[1] + forces[2], forces[2]];
            for (bay, shear) in shear.into_iter().enumerate() {
                let taut = 2 * bay + usize::from(sign * shear < 0.0);
                assert!(!(kept[2 * bay] && kept[2 * bay + 1]) && kept[taut], "{only} {forces:?}: {axial:?}");
                // Statics: the diagonal alone takes the shear force; 4e-15 is found.
                assert!(
                    (axial[taut] - sign * 1.25 * shear.abs()).abs() < 1e-12,
                    "{only} {forces:?}: {axial:?}"
                );
            }
            let other = run_recovered(&tower(&kept, None, &forces));
            let displacements =
                |run: &crate::support::Run| run.states[0].displacements().take(18).collect::<Vec<_>>();
            let (a, b) = (displacements(&found), displacements(&other));
            let difference: Vec<f64> =
                a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| a - b).collect();
            // 3e-15 is found.
            assert!(largest(&difference) < 1e-12 * largest(a.as_flattened()), "{:e}", largest(&difference));
            let of = found.states[0].one_way.as_ref().expect("a state of what acts");
            assert!(of.settled && of.parts[0].act == 3 && of.parts[0].all == 6);
        }
    }
}

#[test]
fn braces_that_become_colder_are_taut_together() {
    let mut case = tower(&[true; 6], Some("tension"), &[0.3, 0.2, 0.1]);
    case["thermal_expansion"] = json!(1e-3);
    let heat = |k: usize| json!({ "temperature": { "member": format!("brace {k}"), "change": -100 } });
    case["loads"].as_array_mut().expect("a list").extend((0..6).map(heat));
    let run = run_recovered(&case);
    assert_eq!(run.states[0].one_way.as_ref().expect("a state of what acts").parts[0].act, 6);
    let mut both = case.clone();
    for member in both["body"]["frame"]["members"].as_array_mut().expect("a list") {
        member.as_object_mut().expect("a member").remove("only");
    }
    let other = run_recovered(&both);
    for line in 0..15 {
        let [a, b] = [&run, &other].map(|run| run.states[0].value(FieldName::N, line, 0).expect("recovered"));
        // 1e-14 is found, of 10.
        assert!((a - b).abs() < 1e-11, "{line}: {a} {b}");
    }
}

/// A hinged mast with two stays that end alone at their anchors: slack, they leave the mast.
#[test]
fn stays_leave_the_mast_whichever_way_they_are_written() {
    for (only, sign) in [("tension", 1.0), ("compression", -1.0)] {
        for (force, taut) in [(4.0, 0), (-4.0, 1)] {
            for outwards in [true, false] {
                let stay = |name: &str, anchor: &str| {
                    let (from, to) = if outwards { ("top", anchor) } else { (anchor, "top") };
                    json!({ "name": name, "from": from, "to": to, "cells": 2, "hinges": ["from", "to"], "only": only })
                };
                let joint = |name: &str, x: f64, y: f64| json!({ "name": name, "x": x, "y": y });
                let pin = |name: &str| json!({ "at": { "joint": name }, "ux": 0, "uy": 0 });
                let case = json!({
                    "title": "test", "model": crate::support::sections::model("exact"),
                    "body": { "frame": {
                        "joints": [joint("foot", 0.0, 0.0), joint("top", 0.0, 3.0), joint("west", -4.0, 0.0), joint("east", 4.0, 0.0)],
                        "members": [stay("left", "west"), stay("right", "east"),
                            { "name": "mast", "from": "foot", "to": "top", "cells": 2, "hinges": ["from"] }] } },
                    "supports": [pin("foot"), pin("west"), pin("east")],
                    "loads": [ { "point": { "at": { "joint": "top" }, "force_x": force } } ]
                });
                let run = run_recovered(&case);
                let axial = [0, 1].map(|line| run.states[0].value(FieldName::N, line, 1).expect("recovered"));
                // Statics: 4/(4/5) in one of them; 1e-15 is found.
                let mut expected = [0.0; 2];
                expected[if sign > 0.0 { taut } else { 1 - taut }] = 5.0 * sign;
                let off = largest(&[axial[0] - expected[0], axial[1] - expected[1]]);
                assert!(off < 1e-12, "{only} {force} {outwards}: {axial:?}");
            }
        }
    }
}
