//! Shell membranes: tractions on the ends of tubes, pressures on tubes and panels, and forces on their points.

use super::asked::Across;
use super::bodies;
use super::{Course, SHARINGS, Sharing, TRACTIONS, traction};
use crate::stress::row::{BALANCED, Kind, Resultant, Row, Wish};
use serde_json::{Value, json};
use std::f64::consts::TAU;

const MODEL: &str = "shell_membrane";
const WALL: f64 = 0.1;
/// Radius of a tube of which the body is a quarter.
const QUARTER: f64 = 4.0 * 8.0 / TAU;

fn case(radius: f64, loads: Value, held: &[&str]) -> Value {
    let still = |region: &&str| json!({ "at": { "region": region }, "ux": 0.0, "uy": 0.0, "w": 0.0 });
    json!({
        "model": { MODEL: { "youngs_modulus": 70_000.0, "thickness": WALL, "radius": radius } },
        "body": bodies::rectangle([0.0; 2]).case,
        "regions": { "all": { "box": { "from": [0.0, 0.0], "to": [16.0, 8.0] } } },
        "supports": held.iter().map(still).collect::<Vec<_>>(), "loads": loads
    })
}

/// Tractions on the ends of a tube, held at the other one.
fn ends() -> Vec<Row> {
    let body = bodies::rectangle([0.0; 2]);
    let mut rows = Vec::new();
    for edge in body.edges.iter().filter(|e| e.normal[0] != 0.0) {
        for (t, sharing) in TRACTIONS.into_iter().flat_map(|t| SHARINGS.map(|s| (t, s))) {
            let (load, asked) = traction(edge, t, sharing, Across::Thickness(WALL));
            let held = if edge.name == "left" { "right" } else { "left" };
            let what = format!("a tube, {}, {t:?}, {sharing:?}", edge.name);
            let mut row = Row::new(
                MODEL,
                "asked and applied: tractions on ends",
                what,
                case(QUARTER, json!([load]), &[held]),
                128,
            );
            row.case["periodic"] = json!([{ "along": "y" }]);
            // Under half of a contact at the joined side a membrane of so few points has no digits.
            row.wish = if matches!(t.0, Course::Hertz(..)) { Wish::Honest } else { Wish::Answer };
            let [x, y] = asked.force;
            row.resultant = Some(Resultant {
                force: [Some(x), Some(y)],
                moment: None,
                size: asked.size,
                length: body.length(),
                bound: BALANCED,
                places: Vec::new(),
            });
            rows.push(row);
        }
    }
    rows
}

/// Pressures on tubes and on open panels that are held everywhere: what holds them outwards is the pressure times the area.
fn pressures() -> Vec<Row> {
    let mut rows = Vec::new();
    for (name, radius, is_tube) in
        [("a tube", QUARTER, true), ("half a tube", 16.0 / TAU, false), ("a panel", 50.0, false)]
    {
        for value in [3.0, -0.5] {
            for sharing in [Sharing::Usual, Sharing::Lumped, Sharing::Consistent] {
                if sharing == Sharing::Consistent && !is_tube {
                    continue;
                }
                let mut load = json!({ "value": value });
                sharing.write(&mut load);
                let what = format!("{name}, pressure {value}, {sharing:?}");
                let case = case(radius, json!([{ "pressure": load }]), &["all"]);
                let mut row = Row::new(MODEL, "asked and applied: pressures", what, case, 128);
                if is_tube {
                    row.case["periodic"] = json!([{ "along": "y" }]);
                }
                row.wish = Wish::Answer;
                rows.push(row.expect(
                    json!({ "region": "all" }),
                    "reaction_force",
                    Kind::Force,
                    1.0,
                    -value * 128.0,
                ));
            }
        }
    }
    rows
}

/// Forces on points of a tube along its axis, around it and outwards.
fn points() -> Vec<Row> {
    let mut rows = Vec::new();
    for (at, place) in [(json!({ "x": 9.5, "y": 3.5 }), "a point"), (json!({ "region": "right" }), "an end")]
    {
        for force in [[5.0, 0.0, 0.0], [0.0, 5.0, 0.0], [0.0, 0.0, 5.0], [1.0, -2.0, 3.0]] {
            let [x, y, w] = force;
            let load = json!({ "point": { "at": at, "force_x": x, "force_y": y, "force": w } });
            let what = format!("a tube, {force:?} on {place}");
            // Held all along: a membrane bears no force on a point by itself.
            let mut row = Row::new(
                MODEL,
                "asked and applied: forces on points",
                what,
                case(QUARTER, json!([load]), &["all"]),
                128,
            );
            row.case["periodic"] = json!([{ "along": "y" }]);
            row.wish = Wish::Answer;
            for (field, f) in [("reaction_x", x), ("reaction_y", y), ("reaction_force", w)] {
                row = row.expect(json!({ "region": "all" }), field, Kind::Force, 1.0, -f);
            }
            rows.push(row);
        }
    }
    rows
}

pub(super) fn rows() -> Vec<Row> {
    [ends(), pressures(), points()].concat()
}
