//! Ways to hold a body in the plane: what statics determines, and what it does not.

use super::bodies::Body;
use super::medium::Medium;
use crate::stress::row::Wish;
use serde_json::{Value, json};

/// Supports and rigid regions.
#[derive(Clone, Debug)]
pub(super) struct Hold {
    pub(super) name: &'static str,
    pub(super) supports: Vec<Value>,
    pub(super) rigid: Vec<Value>,
    /// Where the supports are; none of an edge, whose moment nobody tells.
    pub(super) places: Vec<[f64; 2]>,
    pub(super) tells_moment: bool,
    /// What must become of the body.
    pub(super) wish: Wish,
}

fn at([x, y]: [f64; 2], keys: Value) -> Value {
    let mut support = keys;
    support["at"] = json!({ "x": x, "y": y });
    support
}

impl Hold {
    /// Points that are held, each with its keys.
    pub(super) fn points(name: &'static str, held: impl IntoIterator<Item = ([f64; 2], Value)>) -> Self {
        let (places, supports) = held.into_iter().map(|(place, keys)| (place, at(place, keys))).unzip();
        Self { name, supports, places, tells_moment: true, rigid: Vec::new(), wish: Wish::Answer }
    }

    fn edge(name: &'static str, edge: &str, keys: Value) -> Self {
        let mut support = keys;
        support["at"] = json!({ "region": edge });
        Self { supports: vec![support], tells_moment: false, ..Self::points(name, []) }
    }

    /// The loaded edge itself: a body without any strain has no digits.
    fn loaded(edge: &str, keys: Value) -> Self {
        Self { wish: Wish::Honest, ..Self::edge("the loaded edge", edge, keys) }
    }

    /// A rigid region, and points beside it.
    fn rigid(name: &'static str, rigid: Value, points: Vec<([f64; 2], Value)>) -> Self {
        Self { rigid: vec![rigid], ..Self::points(name, points) }
    }
}

/// All ways to hold a body of a model that is loaded on an edge.
pub(super) fn holds(medium: &Medium, body: &Body, loaded: &str) -> Vec<Hold> {
    let [near, right, top] = body.corners;
    let (edge, points) = body.behind(loaded);
    if medium.is_revolved() {
        return vec![
            Hold::points("a point", [(near, json!({ "uy": 0.0 }))]),
            Hold::points("two springs", [near, top].map(|p| (p, json!({ "uy_spring": 3e4 })))),
            Hold::points(
                "points of an edge",
                points.into_iter().map(|p| (p, json!({ "ux": 0.0, "uy": 0.0 }))),
            ),
            Hold::edge("an edge", edge, json!({ "ux": 0.0, "uy": 0.0 })),
            Hold::loaded(loaded, json!({ "uy": 0.0 })),
        ];
    }
    let still = json!({ "ux": 0.0, "uy": 0.0 });
    let grip = json!({ "region": edge, "centre": [1.5, -2.0], "ux": 0.0, "uy": 0.0, "phi": 0.0 });
    let of_edges = vec![
        Hold::rigid("a rigid edge", grip, Vec::new()),
        Hold::edge("an edge", edge, still.clone()),
        Hold::loaded(loaded, still.clone()),
    ];
    if medium.is_turned {
        return of_edges;
    }
    let clamp = match medium.turns() {
        true => json!({ "ux": 0.0, "uy": 0.0, "phi": 0.0 }),
        false => still.clone(),
    };
    let pin = json!({ "region": edge, "ux": 0.0, "uy": 0.0 });
    let far = [near, right, top].into_iter().find(|p| !points.contains(p)).unwrap_or(top);
    let inclined = json!({ "inclined": { "degrees": 60.0 } });
    let roller = json!({ "uy": 0.0 });
    let springs =
        [(near, json!({ "ux_spring": 2e4, "uy_spring": 3e4 })), (right, json!({ "uy_spring": 5e3 }))];
    let mut all = vec![
        Hold::points("two points", [(near, still.clone()), (right, roller)]),
        Hold::points("a point and an inclined roller", [(near, still), (top, inclined)]),
        Hold::points("springs", springs.into_iter().chain([(top, json!({ "ux_spring": 1e5 }))])),
        Hold::points("points of an edge", points.into_iter().map(|p| (p, clamp.clone()))),
        Hold::rigid("a rigid pin and a point", pin, vec![(far, json!({ "ux": 0.0, "uy": 0.0 }))]),
    ];
    all.extend(of_edges);
    all
}
