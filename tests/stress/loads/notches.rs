//! Tractions on an edge that a notch cuts, and on the walls of the notch.

use super::asked::Asked;
use super::bodies;
use super::medium::Medium;
use super::{Loaded, SHARINGS, Sharing, TRACTIONS, holds, origin, traction};
use crate::stress::row::Row;
use serde_json::{Value, json};

const SWEEP: &str = "asked and applied: tractions beside notches";

pub(super) fn rows(medium: &Medium) -> Vec<Row> {
    let (body, walls) = bodies::notched(origin(medium));
    let across = medium.across;
    let mut loads: Vec<(String, Value, Asked)> = Vec::new();
    let top = &body.edges[3];
    for (t, sharing) in TRACTIONS.into_iter().flat_map(|t| [Sharing::Usual, Sharing::Lumped].map(|s| (t, s)))
    {
        let (load, asked) = traction(top, t, sharing, across);
        loads.push((format!("top, {t:?}, {sharing:?}"), load, asked));
    }
    let on_walls = |t: &dyn Fn([f64; 2]) -> [f64; 2]| -> Asked {
        walls.iter().map(|wall| wall.integral(|_| t(wall.normal), across)).sum()
    };
    let area: f64 = walls.iter().map(|wall| wall.area(across)).sum();
    for sharing in SHARINGS.into_iter().filter(|s| *s != Sharing::Consistent) {
        for (key, value, asked) in [
            ("uniform", json!([3.0, -1.0]), on_walls(&|_| [3.0, -1.0])),
            ("total", json!([3.0, 50.0]), on_walls(&|_| [3.0 / area, 50.0 / area])),
            ("pressure", json!(4.0), on_walls(&|n| n.map(|n| -4.0 * n))),
        ] {
            let mut load = json!({ "edge": "notch", key: value });
            sharing.write(&mut load);
            loads.push((format!("notch, {key} {value}, {sharing:?}"), json!({ "traction": load }), asked));
        }
    }
    let holds = holds(medium, &body, "right");
    let row = |(k, (what, load, asked)): (usize, (String, Value, Asked))| {
        Loaded { medium, body: &body, hold: &holds[k % holds.len()] }.row(SWEEP, &what, json!([load]), &asked)
    };
    loads.into_iter().enumerate().map(row).collect()
}
