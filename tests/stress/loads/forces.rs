//! Forces on points and on volumes.

use super::bodies;
use super::medium::{DENSITY, Medium};
use super::{Across, Asked, Loaded, holds, origin};
use crate::stress::row::Row;
use serde_json::{Value, json};
use std::f64::consts::PI;

const SWEEP: &str = "asked and applied: forces on points and volumes";

/// Volume of a box, and its middle.
fn volume(from: [f64; 2], to: [f64; 2], across: Across) -> (f64, [f64; 2]) {
    let middle = [0, 1].map(|k| 0.5 * (from[k] + to[k]));
    let volume = match across {
        Across::Thickness(t) => (to[0] - from[0]) * (to[1] - from[1]) * t,
        Across::Ring => PI * (to[0] * to[0] - from[0] * from[0]) * (to[1] - from[1]),
    };
    (volume, middle)
}

pub(super) fn rows(medium: &Medium) -> Vec<Row> {
    let body = bodies::rectangle(origin(medium));
    let [x, y] = body.from;
    let far = [x + body.size[0], y + body.size[1]];
    let inner = [[x + 5.0, y + 2.0], [x + 11.0, y + 7.0]];
    let mut loads: Vec<(String, Value, Asked)> = Vec::new();
    for (region, [from, to]) in [(None, [body.from, far]), (Some("block"), inner)] {
        // Rows along fibres fill a box only by and large.
        if region.is_some() && medium.is_turned {
            continue;
        }
        let (volume, middle) = volume(from, to, medium.across);
        for value in [[3.0, 0.0], [0.0, -2.0], [1.0, 4.0]] {
            for (key, force) in [("density", value.map(|b| b * volume)), ("total", value)] {
                let mut asked = Asked::default();
                asked.add(force, middle);
                let mut load = json!({ key: value });
                region.iter().for_each(|name| load["region"] = json!(name));
                loads.push((format!("{key} {value:?} on {region:?}"), json!({ "body_force": load }), asked));
            }
        }
        if medium.is_revolved() {
            let mut load = json!({ "omega": 2.0 });
            region.iter().for_each(|name| load["region"] = json!(name));
            let asked = Asked { size: 4.0 * DENSITY * volume * middle[0], ..Asked::default() };
            loads.push((format!("spin on {region:?}"), json!({ "spin": load }), asked));
        } else {
            let mut load = json!({ "omega": 2.0, "about": [1.0, -3.0] });
            region.iter().for_each(|name| load["region"] = json!(name));
            let mut asked = Asked::default();
            let out = [middle[0] - 1.0, middle[1] + 3.0];
            asked.add(out.map(|r| 4.0 * DENSITY * volume * r), middle);
            loads.push((format!("spin on {region:?}"), json!({ "spin": load }), asked));
        }
        let mut load = json!({ "along": [0.0, -3.0], "acceleration": 7.0 });
        region.iter().for_each(|name| load["region"] = json!(name));
        let mut asked = Asked::default();
        asked.add([0.0, -7.0 * DENSITY * volume], middle);
        loads.push((format!("gravity on {region:?}"), json!({ "gravity": load }), asked));
    }
    if !medium.is_turned {
        // Of a region the points share the force: it acts in their middle.
        let places = [
            (json!({ "x": x + 12.5, "y": y + 4.5 }), [x + 12.5, y + 4.5]),
            (json!({ "region": "right" }), [far[0] - 0.5, y + 4.0]),
            (json!({ "region": "block" }), [0, 1].map(|k| 0.5 * (inner[0][k] + inner[1][k]))),
        ];
        for (at, place) in places {
            for [fx, fy, moment] in
                [[5.0, 0.0, 0.0], [0.0, 7.0, 0.0], [-2.0, 3.0, 0.0], [0.0, 0.0, 11.0], [1.0, 1.0, 9.0]]
            {
                if moment == 0.0 || medium.turns() {
                    let mut asked = Asked::default();
                    asked.add([fx, fy], place);
                    asked.moment += moment;
                    asked.size += moment / body.length();
                    let load =
                        json!({ "point": { "at": at, "force_x": fx, "force_y": fy, "moment": moment } });
                    loads.push((format!("{fx}, {fy}, {moment} at {at}"), load, asked));
                }
            }
        }
    }
    let holds = holds(medium, &body, "right");
    let loaded = loads.into_iter().enumerate().flat_map(|(k, load)| [k, k + 3].map(|k| (k, load.clone())));
    let row = |(k, (what, load, asked)): (usize, (String, Value, Asked))| {
        let hold = &holds[k % holds.len()];
        let mut row = Loaded { medium, body: &body, hold }.row(SWEEP, &what, json!([load]), &asked);
        row.case["regions"] = json!({ "block": { "box": { "from": inner[0], "to": inner[1] } } });
        row
    };
    loaded.map(row).collect()
}
