//! Every field of every model, as a probe of a point and of a region, as a check of all points and along lines: a number, or a
//! refusal by message where the model has no such field.

use crate::stress::row::{Row, Wish};
use serde_json::{Value, json};

/// All fields that a case can name.
const FIELDS: [&str; 29] = [
    "w",
    "u",
    "ux",
    "uy",
    "phi",
    "M",
    "V",
    "N",
    "stress_top",
    "stress_bottom",
    "strain_xx",
    "strain_yy",
    "strain_xy",
    "strain_xz",
    "strain_yz",
    "stress_xx",
    "stress_yy",
    "stress_xy",
    "stress_xz",
    "stress_yz",
    "stress_zz",
    "von_mises",
    "opening",
    "damage",
    "energy_density",
    "reaction_force",
    "reaction_x",
    "reaction_y",
    "reaction_moment",
];

/// Those that every point of a body in the plane has.
const PLANE: [&str; 12] = [
    "ux",
    "uy",
    "strain_xx",
    "strain_yy",
    "strain_xy",
    "stress_xx",
    "stress_yy",
    "stress_xy",
    "stress_zz",
    "von_mises",
    "damage",
    "energy_density",
];

/// A body and the fields that it has at all of its points, and where it is held.
struct Subject {
    name: &'static str,
    model: &'static str,
    case: Value,
    fields: Vec<&'static str>,
    reactions: Vec<&'static str>,
    /// Places with and without a support.
    held: Vec<Value>,
    free: Vec<Value>,
}

/// A plate of 10 by 6, held at its left edge and pulled at its right one.
fn plate(name: &'static str, model: &'static str, keys: Value, more: &Value) -> Subject {
    let is_shell = model == "shell_membrane";
    let is_revolved = model == "axisymmetric";
    let turns = model == "beam_bond_orthotropic";
    let mut still = json!({ "at": { "region": "left" }, "ux": 0.0, "uy": 0.0 });
    let (mut fields, mut reactions) = (PLANE.to_vec(), vec!["reaction_x", "reaction_y"]);
    if is_shell {
        still["w"] = json!(0.0);
        fields.push("w");
        reactions.push("reaction_force");
    }
    if turns {
        still["phi"] = json!(0.0);
        fields.push("phi");
        reactions.push("reaction_moment");
    }
    let mut case = json!({
        "model": { model: keys },
        "body": { "rectangle": { "from": [if is_revolved { 3.0 } else { 0.0 }, 0.0], "size": [10.0, 6.0], "spacing": 1.0 } },
        "regions": { "block": { "box": { "from": [5.0, 1.0], "to": [8.0, 4.0] } } },
        "supports": [still],
        "loads": [{ "traction": { "edge": "right", "uniform": [if is_revolved { 0.0 } else { 4.0 }, 1.0] } }]
    });
    for (key, value) in more.as_object().expect("keys") {
        case[key] = value.clone();
    }
    Subject {
        name,
        model,
        case,
        fields,
        reactions,
        held: vec![json!({ "region": "left" })],
        free: vec![
            json!({ "x": 6.5, "y": 2.5 }),
            json!({ "x": 7.1, "y": 2.8 }),
            json!({ "region": "block" }),
            json!({ "region": "right" }),
        ],
    }
}

fn line(
    name: &'static str,
    model: &'static str,
    case: Value,
    fields: &[&'static str],
    places: [Value; 2],
) -> Subject {
    let [held, free] = places.map(|place| vec![place]);
    let is_frame = model == "plane frame";
    let mut reactions = vec!["reaction_moment"];
    reactions.extend(if is_frame { vec!["reaction_x", "reaction_y"] } else { vec!["reaction_force"] });
    if name == "stretched" {
        reactions.push("reaction_x");
    }
    Subject { name, model, case, fields: fields.to_vec(), reactions, held, free }
}

fn subjects() -> Vec<Subject> {
    let e = 70_000.0;
    let bonds = |state: &str| json!({ "youngs_modulus": e, "state": state });
    let states = |state: &str| json!({ "youngs_modulus": e, "poisson_ratio": 0.3, "state": state });
    let fibres = |degrees: f64| {
        json!({
            "youngs_modulus_1": 105_000.0, "youngs_modulus_2": 8400.0, "poisson_ratio_12": 0.32, "shear_modulus_12": 4000.0,
            "fibre_angle": degrees
        })
    };
    let shell = json!({ "youngs_modulus": e, "thickness": 0.1, "radius": 24.0 / std::f64::consts::TAU });
    let none = json!({});
    let cracks = json!({ "cracks": [{ "path": [[5.0, -1.0], [5.0, 2.0]] }] });
    let breaks = |critical: Value| json!({ "fracture": { "critical": critical, "load": "load" } });
    let beam = json!({ "timoshenko_beam": {
        "youngs_modulus": e, "poisson_ratio": 0.3, "section": { "rectangle": { "width": 0.1, "height": 0.3 } }
    } });
    let on_line = |held: Value, load: Value| json!({ "model": beam, "body": { "line": { "length": 6.0, "cells": 12 } }, "supports": [held], "loads": [load] });
    let clamp = json!({ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 });
    let glued = json!({ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0, "ux": 0.0 });
    let point = |keys: Value| {
        let mut load = keys;
        load["at"] = json!({ "x": 6.0 });
        json!({ "point": load })
    };
    let frame = json!({
        "model": beam,
        "body": { "frame": {
            "joints": [{ "name": "a", "x": 0.0, "y": 0.0 }, { "name": "b", "x": 3.0, "y": 4.0 }],
            "members": [{ "name": "m", "from": "a", "to": "b", "cells": 10 }]
        } },
        "supports": [{ "at": { "joint": "a" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }],
        "loads": [{ "point": { "at": { "joint": "b" }, "force_x": 1.0 } }]
    });
    const LINE: [&str; 7] = ["w", "phi", "M", "V", "stress_top", "stress_bottom", "energy_density"];
    const FRAME: [&str; 11] =
        ["ux", "uy", "w", "u", "phi", "N", "V", "M", "stress_top", "stress_bottom", "energy_density"];
    let with_axis: Vec<&'static str> = LINE.into_iter().chain(["u", "N"]).collect();
    let places = || [0.0, 3.0].map(|x| json!({ "x": x }));
    let on_frame = [json!({ "joint": "a" }), json!({ "member": "m", "x": 2.5 })];
    vec![
        plate("plane stress", "bond_plane", bonds("plane_stress"), &none),
        plate("plane strain", "bond_plane", bonds("plane_strain"), &none),
        plate("cracked", "bond_plane", bonds("plane_stress"), &cracks),
        plate("breaking", "bond_plane", bonds("plane_stress"), &breaks(json!({ "stretch": 0.5 }))),
        plate("plane stress", "state_plane", states("plane_stress"), &none),
        plate("plane strain", "state_plane", states("plane_strain"), &none),
        plate("breaking", "state_plane", states("plane_strain"), &breaks(json!({ "stretch": 0.5 }))),
        plate("fibres at 0°", "beam_bond_orthotropic", fibres(0.0), &none),
        plate("fibres at 30°", "beam_bond_orthotropic", fibres(30.0), &none),
        plate("cracked", "beam_bond_orthotropic", fibres(0.0), &cracks),
        plate("ring", "axisymmetric", json!({ "youngs_modulus": e, "poisson_ratio": 0.3 }), &none),
        plate("tube", "shell_membrane", shell, &json!({ "periodic": [{ "along": "y" }] })),
        line("bent", "timoshenko_beam", on_line(clamp, point(json!({ "force": 1.0 }))), &LINE, places()),
        line(
            "stretched",
            "timoshenko_beam",
            on_line(glued, point(json!({ "force": 1.0, "axial": 2.0 }))),
            &with_axis,
            places(),
        ),
        line("frame", "plane frame", frame, &FRAME, on_frame),
    ]
}

impl Subject {
    /// A row of one field that is asked for in some way.
    fn row(&self, what: &str, probes: &[(&str, &Value, &str)], wish: Wish) -> Row {
        let mut case = self.case.clone();
        let is_traced = case["fracture"].is_object();
        let at = format!("{}, {what}", self.name);
        let mut row = Row::new(self.model, "every field, as a number or refused", at, case.take(), 60);
        let load = json!({ "name": "load", "at": self.held[0], "field": self.reactions[0] });
        let asked = probes.iter().map(|(name, at, field)| json!({ "name": name, "at": at, "field": field }));
        row.case["probes"] = asked.chain(is_traced.then_some(load)).collect();
        row.wish = wish;
        row
    }

    /// A field at a place, with a bound on it.
    fn probed(&self, field: &str, at: &Value, wish: Wish) -> Row {
        let mut row = self.row(&format!("{field} at {at}"), &[("p", at, field)], wish);
        row.case["checks"] =
            json!([{ "limit": { "probe": "p", "at_most": 1e300, "why": "it is a number" } }]);
        row
    }

    fn rows(&self) -> Vec<Row> {
        let wish = |has: bool| if has { Wish::Answer } else { Wish::Refusal };
        let mut rows = Vec::new();
        let is_plane = !matches!(self.model, "timoshenko_beam" | "plane frame");
        for field in FIELDS {
            let (everywhere, at_supports) = (self.fields.contains(&field), self.reactions.contains(&field));
            for at in &self.free {
                rows.push(self.probed(field, at, wish(everywhere)));
            }
            for at in &self.held {
                rows.push(self.probed(field, at, wish(everywhere || at_supports)));
            }
            if is_plane {
                let mut row = self.row(&format!("{field} at all points"), &[], wish(everywhere));
                let check =
                    json!({ "field": field, "is": "1e9 + x*y", "tolerance": 1e300, "source": "none" });
                row.case["checks"] = json!([{ "formula": check }]);
                rows.push(row);
            }
        }
        if is_plane {
            let mut row = self.row("all fields along lines, in tables and pictures", &[], Wish::Answer);
            let along =
                |name: &str, to: [f64; 2]| json!({ "name": name, "from": [4.0, 0.0], "to": to, "points": 9 });
            row.case["lines"] = json!([along("level", [9.0, 0.0]), along("slanted", [9.0, 5.0])]);
            row.is_written = true;
            rows.push(row);
        } else {
            let mut row = self.row("all fields, in tables and pictures", &[], Wish::Answer);
            row.is_written = true;
            rows.push(row);
        }
        rows
    }
}

pub(crate) fn rows() -> Vec<Row> {
    subjects().iter().flat_map(Subject::rows).collect()
}
