//! Bodies that are loaded: a rectangle, a polygon with slanted edges, and a rectangle with holes, all of unit spacing.

use super::asked::{Across, Asked, Edge};
use serde_json::{Value, json};
use std::f64::consts::TAU;

/// A body with its edges.
#[derive(Clone, Debug)]
pub(super) struct Body {
    pub(super) name: &'static str,
    pub(super) case: Value,
    pub(super) edges: Vec<Edge>,
    /// Points in three corners: below on the left and on the right, above on the left.
    pub(super) corners: [[f64; 2]; 3],
    /// Lower left corner, and size.
    pub(super) from: [f64; 2],
    pub(super) size: [f64; 2],
    pub(super) cells: usize,
}

const SIDES: [(&str, &str); 4] = [("left", "right"), ("right", "left"), ("bottom", "top"), ("top", "bottom")];

impl Body {
    fn new(name: &'static str, case: Value, edges: Vec<Edge>, [from, size]: [[f64; 2]; 2]) -> Self {
        let [x, y] = from;
        let corners = [[x + 0.5, y + 0.5], [x + size[0] - 0.5, y + 0.5], [x + 0.5, y + size[1] - 0.5]];
        Self { name, case, edges, corners, from, size, cells: (size[0] * size[1]) as usize }
    }

    /// A length to compare moments over.
    pub(super) fn length(&self) -> f64 {
        self.size[0].hypot(self.size[1])
    }

    /// An edge to hold where another one is loaded, and its points.
    pub(super) fn behind(&self, loaded: &str) -> (&'static str, Vec<[f64; 2]>) {
        let opposite = SIDES.iter().find(|s| s.0 == loaded).map(|s| s.1);
        // The axis of a body of revolution is no edge.
        let name = match opposite {
            Some("left") if self.from[0] == 0.0 => "bottom",
            Some(name) => name,
            None if self.edges[0].name == loaded => self.edges[1].name,
            None => self.edges[0].name,
        };
        let edge = self.edges.iter().find(|e| e.name == name).expect("an edge");
        let count = edge.length().round();
        let point = |k: usize| {
            let [x, y] = edge.at((k as f64 + 0.5) / count);
            [x - 0.5 * edge.normal[0], y - 0.5 * edge.normal[1]]
        };
        (name, (0..count as usize).map(point).collect())
    }
}

/// A rectangle of 16 by 8.
pub(super) fn rectangle(from: [f64; 2]) -> Body {
    sided("rectangle", from, [16.0, 8.0], &json!([]))
}

fn sided(name: &'static str, from: [f64; 2], size: [f64; 2], holes: &Value) -> Body {
    let [x, y] = from;
    let [right, top] = [x + size[0], y + size[1]];
    let edges = vec![
        Edge { name: "left", from, to: [x, top], normal: [-1.0, 0.0], gap: None },
        Edge { name: "right", from: [right, y], to: [right, top], normal: [1.0, 0.0], gap: None },
        Edge { name: "bottom", from, to: [right, y], normal: [0.0, -1.0], gap: None },
        Edge { name: "top", from: [x, top], to: [right, top], normal: [0.0, 1.0], gap: None },
    ];
    let case = json!({ "rectangle": { "from": from, "size": size, "spacing": 1.0, "holes": holes } });
    Body::new(name, case, edges, [from, size])
}

/// A pentagon with two slanted edges, one of them at 45°.
pub(super) fn pentagon([x, y]: [f64; 2]) -> Body {
    let vertices =
        [[0.0, 0.0], [14.0, 0.0], [14.0, 6.0], [9.0, 11.0], [0.0, 8.0]].map(|v| [x + v[0], y + v[1]]);
    let names = ["edge_1", "edge_2", "edge_3", "edge_4", "edge_5"];
    let edge = |k: usize| {
        let (from, to) = (vertices[k], vertices[(k + 1) % 5]);
        let edge = Edge { name: names[k], from, to, normal: [0.0; 2], gap: None };
        let [a, b] = edge.tangent();
        Edge { normal: [b, -a], ..edge }
    };
    let case = json!({ "outline": { "vertices": vertices, "spacing": 1.0 } });
    Body::new("pentagon", case, (0..5).map(edge).collect(), [[x, y], [14.0, 8.0]])
}

/// A rectangle of 16 by 8 with a square notch in its upper edge that ends between the points, and the walls of the notch.
pub(super) fn notched([x, y]: [f64; 2]) -> (Body, [Edge; 3]) {
    let ([left, right], floor, above) = ([x + 6.3, x + 9.7], y + 6.2, y + 9.0);
    let notch = [[left, floor], [right, floor], [right, above], [left, above]];
    let holes = json!([{ "polygon": { "name": "notch", "vertices": notch } }]);
    let mut body = sided("notched", [x, y], [16.0, 8.0], &holes);
    body.edges[3].gap = Some([6.3 / 16.0, 9.7 / 16.0]);
    let wall = |from, to, normal| Edge { name: "notch", from, to, normal, gap: None };
    let walls = [
        wall([left, y + 8.0], [left, floor], [1.0, 0.0]),
        wall([left, floor], [right, floor], [0.0, 1.0]),
        wall([right, floor], [right, y + 8.0], [-1.0, 0.0]),
    ];
    (body, walls)
}

/// A hole with its border.
#[derive(Clone, Copy, Debug)]
pub(super) struct Hole {
    pub(super) name: &'static str,
    /// Its middle and its perimeter.
    middle: [f64; 2],
    perimeter: f64,
}

impl Hole {
    /// Force and moment of the same traction all around: it acts in the middle of the border, as all are symmetric about theirs.
    pub(super) fn uniform(&self, traction: [f64; 2], across: Across) -> Asked {
        let mut asked = Asked::default();
        asked.add(traction.map(|t| t * self.perimeter * across.at(self.middle[0])), self.middle);
        asked
    }

    /// The same force whatever its area.
    pub(super) fn total(&self, force: [f64; 2]) -> Asked {
        let mut asked = Asked::default();
        asked.add(force, self.middle);
        asked
    }

    /// That of a pressure: none, whatever its size.
    pub(super) fn pressure(&self, pressure: f64, across: Across) -> Asked {
        Asked { size: (pressure * self.perimeter * across.at(self.middle[0])).abs(), ..Asked::default() }
    }
}

/// A rectangle of 24 by 16 with a circle, a slanted slot, and a square that stands on its corner.
pub(super) fn perforated([x, y]: [f64; 2]) -> (Body, [Hole; 3]) {
    let (circle, slot, square) = ([x + 5.0, y + 8.0], [x + 12.0, y + 8.0], [x + 19.0, y + 8.0]);
    let (radius, half) = (2.5, 2.0);
    let ends = [-1.0, 1.0].map(|s: f64| [slot[0] + s, slot[1] + 3.0 * s]);
    let corners = [[-1.0, 0.0], [0.0, -1.0], [1.0, 0.0], [0.0, 1.0]]
        .map(|d: [f64; 2]| [0, 1].map(|k| square[k] + 3.0 * d[k]));
    let holes = json!([
        { "circle": { "name": "circle", "centre": circle, "radius": radius } },
        { "slot": { "name": "slot", "from": ends[0], "to": ends[1], "radius": half } },
        { "polygon": { "name": "square", "vertices": corners } }
    ]);
    let of = |name, middle, perimeter| Hole { name, middle, perimeter };
    let all = [
        of("circle", circle, TAU * radius),
        of("slot", slot, TAU * half + 4.0 * 10.0_f64.sqrt()),
        of("square", square, 12.0 * 2.0_f64.sqrt()),
    ];
    (sided("perforated", [x, y], [24.0, 16.0], &holes), all)
}
