//! Beams and frames: every load in every law, end treatment, grid and support against its force and moment.

use super::asked::Asked;
use crate::stress::row::{BALANCED, Resultant, Row, Wish};
use serde_json::{Value, json};
use std::f64::consts::PI;

const SWEEP: &str = "asked and applied";
const LENGTH: f64 = 6.0;
const CELLS: usize = 24;
/// Error of the resultant of lumped loads that vary over cells, as three half waves over eleven of them do; measured 0.0102.
const LUMPED: f64 = 0.011;
/// The same on a grid of cells, where a load at an end acts on the last point, half a cell inside; measured 0.021.
const ON_CELLS: f64 = 0.022;

/// A load on a line: what the case says, and what is asked along and across it.
#[derive(Clone, Debug)]
struct LineLoad {
    name: String,
    load: Value,
    asked: Asked,
}

impl LineLoad {
    fn point(key: &str, x: f64, is_spread: bool) -> Self {
        let mut asked = Asked::default();
        match key {
            "force" => asked.add([0.0, 7.0], [x, 0.0]),
            "axial" => asked.add([7.0, 0.0], [x, 0.0]),
            _ => (asked.moment, asked.size) = (7.0, 7.0 / LENGTH),
        }
        let load = json!({ "point": { "at": { "x": x }, key: 7.0, "spread": is_spread } });
        Self { name: format!("point, {key} at {x}, spread {is_spread}"), load, asked }
    }

    /// A load over a part of the line: its force and its first moment about the start of that part.
    fn distributed(key: &str, course: &str, [from, to]: [f64; 2]) -> Self {
        let l = to - from;
        let (value, [sum, first], size) = match course {
            "uniform" => (json!({ "uniform": 4.0 }), [4.0 * l, 2.0 * l * l], 4.0 * l),
            // 5 at the start, -2 at the end.
            "linear" => {
                (json!({ "linear": [5.0, -2.0] }), [1.5 * l, l * l * (5.0 / 6.0 - 2.0 / 3.0)], 2.07 * l)
            }
            "half sine" => {
                (json!({ "sine": { "amplitude": 3.0 } }), [6.0 * l / PI, 3.0 * l * l / PI], 6.0 * l / PI)
            }
            _ => {
                // Three half waves: two of them cancel, and all are symmetric.
                let sum = 2.0 * l / PI;
                (json!({ "sine": { "amplitude": 3.0, "half_waves": 3 } }), [sum, 0.5 * l * sum], 6.0 * l / PI)
            }
        };
        let asked = match key {
            "force" => Asked { force: [0.0, sum], moment: first + from * sum, size },
            "axial" => Asked { force: [sum, 0.0], moment: 0.0, size },
            _ => Asked { force: [0.0; 2], moment: sum, size: size / LENGTH },
        };
        let load = json!({ "distributed": { "from": from, "to": to, key: value } });
        Self { name: format!("{course} {key} from {from} to {to}"), load, asked }
    }
}

/// Loads at points, also between those of the grid; and over the whole line, whole cells and parts of cells.
fn loads() -> Vec<LineLoad> {
    let mut loads = Vec::new();
    for key in ["force", "axial", "moment"] {
        loads.extend([(2.5, false), (2.5, true), (6.0, false)].map(|(x, s)| LineLoad::point(key, x, s)));
        loads.push(LineLoad::point(key, 2.59, true));
        for course in ["uniform", "linear", "half sine", "three half waves"] {
            for span in [[0.0, LENGTH], [1.5, 4.25], [0.9, 5.3]] {
                loads.push(LineLoad::distributed(key, course, span));
            }
        }
    }
    loads
}

/// Supports of a line and their name; all of them hold its axis.
fn supports() -> [(&'static str, Value); 6] {
    let at = |x: f64, keys: Value| {
        let mut support = keys;
        support["at"] = json!({ "x": x });
        support
    };
    let clamp = || json!({ "w": 0.0, "phi": 0.0, "ux": 0.0 });
    let springs = json!({ "w_spring": 50.0, "phi_spring": 80.0, "ux_spring": 30.0 });
    [
        ("a clamp", json!([at(0.0, clamp())])),
        (
            "a pin and a roller",
            json!([at(0.0, json!({ "w": 0.0, "ux": 0.0 })), at(LENGTH, json!({ "w": 0.0 }))]),
        ),
        ("two clamps", json!([at(0.0, clamp()), at(LENGTH, clamp())])),
        ("a clamp and a roller", json!([at(0.0, clamp()), at(LENGTH, json!({ "w": 0.0 }))])),
        ("springs", json!([at(0.0, springs.clone()), at(LENGTH, springs)])),
        ("supports within", json!([at(1.0, json!({ "w": 0.0, "ux": 0.0 })), at(5.0, json!({ "w": 0.0 }))])),
    ]
}

/// Grid, end treatment and sharing of distributed loads of a line.
const ENDS: [(&str, Option<&str>, Option<&str>); 8] = [
    ("nodes", None, None),
    ("nodes", Some("cover"), Some("consistent")),
    ("nodes", Some("cover"), Some("lumped")),
    ("nodes", Some("truncated"), None),
    ("nodes", Some("ghost"), None),
    ("nodes", Some("image"), None),
    ("cells", None, None),
    ("cells", Some("truncated"), Some("lumped")),
];

pub(super) fn rows() -> Vec<Row> {
    let mut rows = beams();
    rows.extend(frames());
    rows
}

fn model(law: &str) -> Value {
    json!({
        "stiffness": { "bending": { "uniform": 90.0 }, "shear": { "uniform": 400.0 }, "axial": { "uniform": 900.0 } },
        "bond_law": law
    })
}

fn asked_of(row: &mut Row, asked: &Asked, length: f64, wish: Wish) {
    row.wish = wish;
    row.resultant = Some(Resultant {
        force: asked.force.map(Some),
        moment: Some(asked.moment),
        size: asked.size,
        length,
        bound: BALANCED,
        places: Vec::new(),
    });
}

fn beams() -> Vec<Row> {
    let (loads, supports) = (loads(), supports());
    let mut rows = Vec::new();
    for law in ["published", "corrected", "exact"] {
        for (grid, treatment, sharing) in ENDS {
            // Displacements along the line need points on its ends, and whole bonds there.
            let has_axis = grid == "nodes" && treatment.is_none_or(|t| t == "cover");
            for load in loads.iter().filter(|load| has_axis || load.asked.force[0] == 0.0) {
                let (held, supports) = &supports[rows.len() % supports.len()];
                let mut supports = supports.clone();
                for support in supports.as_array_mut().expect("a list").iter_mut().filter(|_| !has_axis) {
                    let keys = support.as_object_mut().expect("keys");
                    keys.retain(|key, _| !key.starts_with("ux"));
                }
                let mut model = model(law);
                treatment.iter().for_each(|t| model["end_treatment"] = json!(t));
                sharing.iter().for_each(|s| model["distributed_loads"] = json!(s));
                let case = json!({
                    "model": { "timoshenko_beam": model },
                    "body": { "line": { "length": LENGTH, "cells": CELLS, "grid": grid } },
                    "supports": supports, "loads": [load.load]
                });
                let ends = treatment.unwrap_or("usual ends");
                let at = format!("{law}, {grid}, {ends}, {sharing:?}, {}, held by {held}", load.name);
                let mut row = Row::new("timoshenko_beam", SWEEP, at, case, CELLS);
                // A grid of cells has no points at some of these places.
                let wish = if has_axis { Wish::Answer } else { Wish::Honest };
                asked_of(&mut row, &load.asked, LENGTH, wish);
                // Values at points times what belongs to them are no integrals.
                let is_lumped =
                    sharing == Some("lumped") || grid == "cells" || treatment.is_some_and(|t| t != "cover");
                let bound = if grid == "cells" { ON_CELLS } else { LUMPED };
                row.resultant.iter_mut().filter(|_| is_lumped).for_each(|r| r.bound = bound);
                rows.push(row);
            }
        }
    }
    rows
}

/// A frame of a slanted column and a beam, under loads on both in all directions.
fn frames() -> Vec<Row> {
    let joints = [("foot", [0.0, 0.0]), ("knee", [3.0, 4.0]), ("end", [9.0, 4.0])];
    let members = [("column", [0, 1]), ("beam", [1, 2])];
    let point = |at: [f64; 2]| {
        move |force: [f64; 2]| {
            let mut asked = Asked::default();
            asked.add(force, at);
            asked
        }
    };
    let mut loads: Vec<(String, Value, Asked)> = Vec::new();
    for (key, force) in [("force_x", [7.0, 0.0]), ("force_y", [0.0, 7.0])] {
        for (name, at) in joints {
            loads.push((
                format!("{key} at {name}"),
                json!({ "point": { "at": { "joint": name }, key: 7.0 } }),
                point(at)(force),
            ));
        }
    }
    for (name, [a, b]) in members {
        let (from, to) = (joints[a].1, joints[b].1);
        let length = (to[0] - from[0]).hypot(to[1] - from[1]);
        let along = [0, 1].map(|k| (to[k] - from[k]) / length);
        let directions = [
            ("force", [-along[1], along[0]]),
            ("axial", along),
            ("force_x", [1.0, 0.0]),
            ("force_y", [0.0, 1.0]),
        ];
        for (key, direction) in directions {
            for course in ["uniform", "linear", "half sine", "three half waves"] {
                for span in [[0.0, length], [1.25, 3.1]] {
                    let LineLoad { mut load, asked, .. } = LineLoad::distributed("force", course, span);
                    let value = load["distributed"]["force"].take();
                    load = json!({ "distributed": { "member": name, "from": span[0], "to": span[1], key: value } });
                    let middle = asked.moment / asked.force[1];
                    let at = [0, 1].map(|k| from[k] + middle * along[k]);
                    let size = asked.size;
                    let asked = Asked { size, ..point(at)(direction.map(|d| d * asked.force[1])) };
                    loads.push((format!("{course} {key} on {name}, {span:?}"), load, asked));
                }
            }
            let at = [0, 1].map(|k| from[k] + 2.5 * along[k]);
            let load = json!({ "point": { "at": { "member": name, "x": 2.5 }, key: 7.0 } });
            loads.push((format!("{key} at 2.5 on {name}"), load, point(at)(direction.map(|d| 7.0 * d))));
        }
    }
    let fixed = || json!({ "at": { "joint": "foot" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 });
    let holds = [
        json!([fixed()]),
        json!([fixed(), { "at": { "joint": "end" }, "ux": 0.0, "uy": 0.0, "phi": 0.0 }]),
        json!([{ "at": { "joint": "foot" }, "ux": 0.0, "uy": 0.0 }, { "at": { "joint": "end" }, "inclined": { "degrees": 110.0 } }]),
        json!([{ "at": { "joint": "foot" }, "ux_spring": 50.0, "uy_spring": 40.0, "phi_spring": 90.0 }, { "at": { "joint": "end" }, "uy": 0.0 }]),
    ];
    let body = json!({ "frame": {
        "joints": joints.map(|(name, [x, y])| json!({ "name": name, "x": x, "y": y })),
        "members": members.map(|(name, [a, b])| json!({ "name": name, "from": joints[a].0, "to": joints[b].0, "cells": 12 }))
    } });
    let mut rows = Vec::new();
    for law in ["published", "corrected", "exact"] {
        for (what, load, asked) in &loads {
            let k = rows.len() % holds.len();
            let case = json!({ "model": { "timoshenko_beam": model(law) }, "body": body, "supports": holds[k], "loads": [load] });
            let mut row = Row::new("plane frame", SWEEP, format!("{law}, {what}, supports {k}"), case, CELLS);
            asked_of(&mut row, asked, 10.0, Wish::Answer);
            rows.push(row);
        }
    }
    rows
}
