//! Frames that statics determine, against the principle of virtual forces.

use crate::stress::row::{Kind, Row, decades};
use serde_json::{Value, json};

const MODEL: &str = "plane frame";

pub(crate) fn rows() -> Vec<Row> {
    [angles(), contrasts(), soft_feet(), sizes()].concat()
}

fn case(joints: Value, members: Value, stiffness: [f64; 3]) -> Value {
    json!({
        "model": { "timoshenko_beam": { "stiffness": stiff(stiffness), "bond_law": "exact" } },
        "body": { "frame": { "joints": joints, "members": members } }
    })
}

fn stiff([bending, shear, axial]: [f64; 3]) -> Value {
    json!({ "bending": { "uniform": bending }, "shear": { "uniform": shear }, "axial": { "uniform": axial } })
}

fn joint(row: Row, name: &str, [ux, uy, phi]: [f64; 3], length: f64) -> Row {
    let place = json!({ "joint": name });
    let row = row.expect(place.clone(), "ux", Kind::Displacement, 1.0, ux);
    row.expect(place.clone(), "uy", Kind::Displacement, 1.0, uy).expect(
        place,
        "phi",
        Kind::Displacement,
        length,
        phi,
    )
}

/// Section forces of that frame, which statics tells: the column bends alike all along, the arm most at its beginning.
fn sections(row: Row, force: f64) -> Row {
    let [column, arm] = ["column", "arm"].map(|name| json!({ "member": name, "x": 0.0 }));
    row.expect(column.clone(), "M", Kind::Force, 1.0, -1.5 * force)
        .expect(column, "N", Kind::Force, 1.0, -force)
        .expect(arm.clone(), "M", Kind::Force, 1.0, -1.5 * force)
        .expect(arm, "V", Kind::Force, 1.0, -force)
}

/// A cantilever of several members in a line at some angle, under a force across it.
fn angles() -> Vec<Row> {
    let mut rows = Vec::new();
    for degrees in [0.0_f64, 1e-6, 1.0, 30.0, 45.0, 90.0, 200.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        for (slender, members) in [1.0, 1e2, 1e4, 1e6].into_iter().flat_map(|s| [1, 7, 64].map(|n| (s, n))) {
            for cells in [1, 30] {
                let at = |k: usize| k as f64 / members as f64;
                let joints: Vec<Value> = (0..=members)
                    .map(|k| json!({ "name": format!("j{k}"), "x": cos * at(k), "y": sin * at(k) }))
                    .collect();
                let list: Vec<Value> = (0..members)
                    .map(|k| json!({ "name": format!("m{k}"), "from": format!("j{k}"), "to": format!("j{}", k + 1), "cells": cells }))
                    .collect();
                let shear = slender * slender;
                let mut case = case(json!(joints), json!(list), [1.0, shear, 3.0 * shear]);
                case["supports"] = json!([{ "at": { "joint": "j0" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }]);
                let tip = format!("j{members}");
                // 2 along it, 1 across it.
                let force = [2.0 * cos - sin, 2.0 * sin + cos];
                case["loads"] = json!([{ "point": { "at": { "joint": tip }, "force_x": force[0], "force_y": force[1] } }]);
                let name = format!("{degrees:.0e}°, L/h = {slender:.0e}, {members} members of {cells} cells");
                let row = Row::new(MODEL, "angles, slenderness, members", name, case, members * cells);
                let [along, across] = [2.0 / (3.0 * shear), 1.0 / 3.0 + 1.0 / shear];
                rows.push(joint(
                    row,
                    &tip,
                    [along * cos - across * sin, along * sin + across * cos, 0.5],
                    1.0,
                ));
            }
        }
    }
    rows
}

/// A column and an arm of other stiffness.
fn angle_frame(cells: usize, column: [f64; 3], arm: [f64; 3]) -> Value {
    let mut case = case(
        json!([{ "name": "foot", "x": 0.0, "y": 0.0 }, { "name": "corner", "x": 0.0, "y": 2.0 }, { "name": "tip", "x": 1.5, "y": 2.0 }]),
        json!([
            { "name": "column", "from": "foot", "to": "corner", "cells": cells },
            { "name": "arm", "from": "corner", "to": "tip", "cells": cells, "stiffness": stiff(arm) }
        ]),
        column,
    );
    case["supports"] = json!([{ "at": { "joint": "foot" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }]);
    case
}

/// Motion of the tip of that frame under a force down.
fn tip(force: f64, column: [f64; 3], arm: [f64; 3]) -> [f64; 3] {
    let turn = 1.5 * 2.0 / column[0];
    let down = 1.5 * turn + 2.0 / column[2] + 1.5_f64.powi(3) / (3.0 * arm[0]) + 1.5 / arm[1];
    [force * 1.5 * 2.0 * 2.0 / (2.0 * column[0]), -force * down, -force * (turn + 1.5 * 1.5 / (2.0 * arm[0]))]
}

fn contrasts() -> Vec<Row> {
    let mut rows = Vec::new();
    for (ratio, slender) in decades(-12, 12, 2).flat_map(|r| [1.0, 1e2, 1e4].map(|s| (r, s))) {
        for cells in [1, 10, 300] {
            let column = [1.0, slender * slender, 4.0 * slender * slender];
            let arm = column.map(|s| s * ratio);
            let mut case = angle_frame(cells, column, arm);
            case["loads"] = json!([{ "point": { "at": { "joint": "tip" }, "force_y": -1.0 } }]);
            let name = format!("{ratio:.0e}, L/h = {slender:.0e}, {cells} cells");
            let row = Row::new(MODEL, "stiffness contrast of members", name, case, 2 * cells);
            rows.push(sections(joint(row, "tip", tip(1.0, column, arm), 2.5), 1.0));
        }
    }
    rows
}

/// The same on a foot that turns on a spring.
fn soft_feet() -> Vec<Row> {
    let mut rows = Vec::new();
    for stiffness in decades(-12, 12, 2) {
        for cells in [1, 10, 300] {
            let column = [1.0, 400.0, 1600.0];
            let mut case = angle_frame(cells, column, column);
            case["supports"] =
                json!([{ "at": { "joint": "foot" }, "ux": 0.0, "uy": 0.0, "phi_spring": stiffness }]);
            case["loads"] = json!([{ "point": { "at": { "joint": "tip" }, "force_y": -1.0 } }]);
            let row = Row::new(
                MODEL,
                "soft feet, almost mechanisms",
                format!("k = {stiffness:.0e}, {cells} cells"),
                case,
                2 * cells,
            );
            let [ux, uy, phi] = tip(1.0, column, column);
            let turn = 1.5 / stiffness;
            let row = joint(row, "tip", [ux + 2.0 * turn, uy - 1.5 * turn, phi - turn], 2.5);
            rows.push(sections(row, 1.0));
        }
    }
    rows
}

fn sizes() -> Vec<Row> {
    let mut rows = Vec::new();
    for force in [1e-200, 1e-60, 1e-30, 1e30, 1e60, 1e200] {
        let column = [1.0, 400.0, 1600.0];
        let mut case = angle_frame(10, column, column);
        case["loads"] = json!([{ "point": { "at": { "joint": "tip" }, "force_y": -force } }]);
        let row = Row::new(MODEL, "loads of 1e±200", format!("{force:.0e}"), case, 20);
        rows.push(sections(joint(row, "tip", tip(force, column, column), 2.5), force));
    }
    rows
}
