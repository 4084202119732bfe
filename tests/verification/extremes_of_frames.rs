//! Extremes of frames: those of one member between points are not hidden by the points of others.

use serde_json::{Value, json};

/// A member of ten spans of one cell under a uniform load, which rests on all of its points, and cantilevers beside it of some
/// deflections.
fn spans_beside(deflections: &[f64]) -> Value {
    let stiffness =
        json!({ "bending": { "uniform": 1.0 }, "shear": { "uniform": 1e6 }, "axial": { "uniform": 1e3 } });
    let mut joints = vec![json!({ "name": "A", "x": 0, "y": 0 }), json!({ "name": "B", "x": 10, "y": 0 })];
    let mut members = vec![json!({ "name": "spans", "from": "A", "to": "B", "cells": 10 })];
    let mut supports =
        vec![json!({ "at": { "joint": "A" }, "ux": 0, "uy": 0 }), json!({ "at": { "joint": "B" }, "uy": 0 })];
    supports.extend((1..10).map(|k| json!({ "at": { "member": "spans", "x": k }, "uy": 0 })));
    let mut loads = vec![json!({ "distributed": { "member": "spans", "force_y": { "uniform": -1 } } })];
    for (k, deflection) in deflections.iter().enumerate() {
        let [root, tip] = ["root", "tip"].map(|end| format!("{end} {k}"));
        joints.push(json!({ "name": root, "x": 20, "y": k }));
        joints.push(json!({ "name": tip, "x": 21, "y": k }));
        members.push(json!({ "name": format!("cantilever {k}"), "from": root, "to": tip, "cells": 10 }));
        supports.push(json!({ "at": { "joint": root }, "ux": 0, "uy": 0, "phi": 0 }));
        loads.push(json!({ "point": { "at": { "joint": tip }, "force_y": 3.0 * deflection } }));
    }
    json!({
        "title": "spans", "units": "none", "model": { "timoshenko_beam": { "stiffness": stiffness } },
        "body": { "frame": { "joints": joints, "members": members } }, "supports": supports, "loads": loads
    })
}

/// The smallest deflection, and where it is.
fn lowest(case: &Value) -> (f64, Option<String>) {
    let solved = peristat::solve_text(&format!("{case:#}")).expect("a case that can be solved");
    let found = &solved.summary.states[0].extremes["uy"].smallest;
    (found.value, found.member.clone())
}

#[test]
fn spans_between_supports_at_all_points_sag_whatever_is_beside_them() {
    let (sag, member) = lowest(&spans_beside(&[]));
    // The first of many spans of a beam: 0.0065 q L⁴/EI by the theorem of three moments, with an end moment of 0.1057 q L².
    assert!((sag + 0.0065).abs() < 1e-4 && member.as_deref() == Some("spans"), "{sag}");
    // Points beside the spans are above and below all of theirs, and none as low as a sag.
    let (beside, member) = lowest(&spans_beside(&[0.5 * sag, -0.5 * sag]));
    assert!((beside / sag - 1.0).abs() < 1e-12 && member.as_deref() == Some("spans"), "{beside}");
    let (below, member) = lowest(&spans_beside(&[2.0 * sag, -2.0 * sag]));
    // Shear adds 3e-6.
    assert!((below / (2.0 * sag) - 1.0).abs() < 1e-5 && member.as_deref() == Some("cantilever 0"), "{below}");
}
