//! Tractions of every course on an edge, as cases write them and as they ask for force and moment.

use super::asked::{Across, Asked, Edge};
use serde_json::{Value, json};

/// How a traction varies along its edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Course {
    Uniform,
    Linear,
    Parabolic,
    Total,
    Pressure,
    /// A contact with its middle and half its width, in lengths of the edge.
    Hertz(f64, f64),
}

/// Whither it pulls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Way {
    Out,
    Along,
}

/// Every course in every direction that it can have; contacts within the edge, and beyond its end.
pub(super) const TRACTIONS: [(Course, Way); 11] = [
    (Course::Uniform, Way::Out),
    (Course::Uniform, Way::Along),
    (Course::Linear, Way::Out),
    (Course::Linear, Way::Along),
    (Course::Parabolic, Way::Out),
    (Course::Parabolic, Way::Along),
    (Course::Total, Way::Out),
    (Course::Total, Way::Along),
    (Course::Pressure, Way::Out),
    (Course::Hertz(0.45, 0.4), Way::Out),
    (Course::Hertz(0.9, 0.5), Way::Out),
];

/// How it reaches the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Sharing {
    Usual,
    Consistent,
    Lumped,
    /// Consistent to this depth.
    Depth(f64),
}

/// One of each, with a depth that is no multiple of the spacing and one beyond the body.
pub(super) const SHARINGS: [Sharing; 5] =
    [Sharing::Usual, Sharing::Consistent, Sharing::Lumped, Sharing::Depth(3.5), Sharing::Depth(100.0)];

impl Sharing {
    /// Adds its keys to a traction.
    pub(super) fn write(self, traction: &mut Value) {
        match self {
            Self::Usual => {}
            Self::Consistent => traction["sharing"] = json!("consistent"),
            Self::Lumped => traction["sharing"] = json!("lumped"),
            Self::Depth(depth) => traction["depth"] = json!(depth),
        }
    }
}

/// Values of a traction: its size, those at both ends of a linear one, and its whole force.
const VALUE: f64 = 3.0;
const ENDS: [f64; 2] = [5.0, -2.0];
const TOTAL: f64 = 70.0;

/// The load of a case, and what it asks for.
pub(super) fn traction(
    edge: &Edge,
    (course, way): (Course, Way),
    sharing: Sharing,
    across: Across,
) -> (Value, Asked) {
    let direction = if way == Way::Out { edge.normal } else { edge.tangent() };
    let times = |value: f64| direction.map(|d| value * d);
    let uniform = |value: f64| edge.integral(|_| times(value), across);
    let (key, value, asked) = match course {
        Course::Uniform => ("uniform", json!(times(VALUE)), uniform(VALUE)),
        Course::Linear => {
            let asked = edge.integral(|q| times(ENDS[0] + q * (ENDS[1] - ENDS[0])), across);
            ("linear", json!(ENDS.map(times)), asked)
        }
        Course::Parabolic => {
            let asked = edge.integral(|q| times(4.0 * q * (1.0 - q) * VALUE), across);
            ("parabolic", json!(times(VALUE)), asked)
        }
        Course::Total => ("total", json!(times(TOTAL)), uniform(TOTAL / edge.area(across))),
        Course::Pressure => ("pressure", json!(-VALUE), uniform(VALUE)),
        Course::Hertz(middle, radius) => {
            let length = edge.length();
            // Places are x or y, as the edge runs.
            let axis = usize::from((edge.to[1] - edge.from[1]).abs() > (edge.to[0] - edge.from[0]).abs());
            let value = json!({ "centre": edge.at(middle)[axis], "radius": radius * length, "peak": VALUE });
            ("hertz", value, edge.contact(middle * length, radius * length, VALUE, across))
        }
    };
    let mut traction = json!({ "edge": edge.name, key: value });
    sharing.write(&mut traction);
    (json!({ "traction": traction }), asked)
}
