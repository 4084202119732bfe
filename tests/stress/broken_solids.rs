//! Solids whose bonds can break: before the first of them does, and when nothing joins both ends any more.

use crate::stress::row::{Kind, Row, Wish};
use serde_json::{Value, json};

/// Cells along the axis that is drawn, and along the others.
const LONG: f64 = 10.0;
const WIDE: f64 = 4.0;
/// Motion of the drawn end, in cells.
const DRAWN: f64 = 0.6;

/// A bar with a notch at half of its length.
#[derive(Clone, Copy, Debug)]
struct Bar {
    model: &'static str,
    /// The axis along which it is drawn.
    axis: usize,
    ratio: f64,
    spacing: f64,
    modulus: f64,
    solver: &'static str,
}

const FACES: [[&str; 2]; 3] = [["left", "right"], ["bottom", "top"], ["back", "front"]];
const MOTIONS: [&str; 3] = ["ux", "uy", "uz"];
const REACTIONS: [&str; 3] = ["reaction_x", "reaction_y", "reaction_z"];

/// Stiffness of a spring over modulus and spacing, and what it takes from its force and from the motion, measured 1e-6 of them.
const SPRING: f64 = 1e-6;
const SOFT: f64 = 2e-6;

impl Bar {
    const STANDARD: Self =
        Self { model: "bond_solid", axis: 1, ratio: 2.0, spacing: 1.0, modulus: 1.0, solver: "sparse" };

    fn size(&self) -> [f64; 3] {
        let mut size = [WIDE; 3];
        size[self.axis] = LONG;
        size.map(|n| n * self.spacing)
    }

    /// A place by numbers of cells along the axis and across it.
    fn at(&self, along: f64, across: [f64; 2]) -> [f64; 3] {
        let mut place = [0.0; 3];
        place[self.axis] = along * self.spacing;
        place[(self.axis + 1) % 3] = across[0] * self.spacing;
        place[(self.axis + 2) % 3] = across[1] * self.spacing;
        place
    }

    fn case(&self) -> Value {
        let notch = [[-1.0, -1.0], [1.0, -1.0], [1.0, WIDE + 1.0], [-1.0, WIDE + 1.0]];
        let notch: Vec<[f64; 3]> = notch.iter().map(|across| self.at(0.5 * LONG, *across)).collect();
        let mut keys = json!({ "youngs_modulus": self.modulus });
        if self.model == "state_solid" {
            keys["poisson_ratio"] = json!(0.3);
        }
        let [held, drawn] = FACES[self.axis];
        let mut supports =
            [held, drawn].map(|region| json!({ "at": { "region": region }, "ux": 0, "uy": 0, "uz": 0 }));
        supports[1][MOTIONS[self.axis]] = json!(DRAWN * self.spacing);
        json!({
            "units": "none", "solver": self.solver, "horizon_ratio": self.ratio, "model": { self.model: keys },
            "body": { "block": { "size": self.size(), "spacing": self.spacing } },
            "cracks": [{ "polygon": notch }], "supports": supports
        })
    }

    fn row(&self, sweep: &'static str, fracture: Value) -> Row {
        let mut case = self.case();
        case["fracture"] = fracture;
        case["fracture"]["load"] = json!("p0");
        let at = format!("{self:?}, {}, {}", case["fracture"]["critical"], case["fracture"]["strategy"]);
        let mut row = Row::new(self.model, sweep, at, case, (LONG * WIDE * WIDE) as usize);
        // Moduli so far from one may be refused.
        row.wish = if (1e-50..1e50).contains(&self.modulus) { Wish::Answer } else { Wish::Honest };
        let [held, _] = FACES[self.axis];
        // Over the force that would draw the whole bar.
        let unit = 1.0 / (self.modulus * WIDE * WIDE * self.spacing * self.spacing * DRAWN / LONG);
        row = row.expect(json!({ "region": held }), REACTIONS[self.axis], Kind::Force, unit, 0.0);
        for along in [0.5, 2.5, 7.5, 9.5] {
            let [x, y, z] = self.at(along, [1.5, 2.5]);
            for (k, motion) in MOTIONS.iter().enumerate() {
                let is_drawn = k == self.axis && along > 0.5 * LONG;
                let expected = if is_drawn { DRAWN * self.spacing } else { 0.0 };
                let place = json!({ "x": x, "y": y, "z": z });
                row = row.expect(place, motion, Kind::Displacement, 1.0, expected);
            }
        }
        row
    }

    /// Drawn until nothing joins its ends: both parts are at rest.
    fn torn(&self, critical: Value) -> Row {
        let regions = |from: f64, to: f64| {
            let (from, to) = (self.at(from, [0.0; 2]), self.at(to, [WIDE; 2]));
            json!({ "box": { "from": from, "to": to } })
        };
        let fracture = json!({ "critical": critical, "increment": 0.05, "stop_below": 1e-12, "no_fail": ["held part", "drawn part"] });
        let mut row = self.row("drawn until both parts are at rest", fracture);
        row.case["regions"] = json!({ "held part": regions(0.0, 2.0), "drawn part": regions(8.0, LONG) });
        // What holds the drawn part when nothing else does, so that it is drawn all the way.
        let stiffness = SPRING * self.modulus * self.spacing;
        let [x, y, z] = self.at(8.5, [1.5, 1.5]);
        let mut spring = json!({ "at": { "x": x, "y": y, "z": z } });
        spring[format!("{}_spring", MOTIONS[self.axis])] = json!(stiffness);
        row.case["supports"].as_array_mut().expect("a list").push(spring);
        let [_, drawn] = FACES[self.axis];
        let unit = row.truths[0].unit;
        let force = stiffness * DRAWN * self.spacing;
        row = row.expect(json!({ "region": drawn }), REACTIONS[self.axis], Kind::Force, unit, force);
        row.known = [SOFT; 2];
        row
    }

    /// Not drawn far enough: as the elastic body.
    fn whole(&self, critical: Value, strategy: &str) -> Row {
        let row =
            self.row("before the first bond breaks", json!({ "critical": critical, "strategy": strategy }));
        let mut twin = self.case();
        (twin["title"], twin["probes"]) = (json!("stress"), row.case["probes"].clone());
        // Cracks that grow end where they are drawn.
        twin["crack_fronts"] = json!("crossed");
        Row { twin: Some(twin), ..row }
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let usual = Bar::STANDARD;
    let families = Bar { model: "state_solid", ..usual };
    let mut bars: Vec<Bar> =
        (0..3).flat_map(|axis| [usual, families].map(|bar| Bar { axis, ..bar })).collect();
    bars.push(Bar { ratio: 3.0, ..usual });
    bars.push(Bar { ratio: 3.0, axis: 2, ..usual });
    bars.push(Bar { solver: "multigrid", ..usual });
    for scale in [1e-9, 1e-3, 1e6] {
        bars.extend([usual, families].map(|bar| Bar { spacing: scale, ..bar }));
    }
    for modulus in [1e-100, 1e-9, 1e11, 1e100] {
        bars.extend([usual, families].map(|bar| Bar { modulus, ..bar }));
    }
    let mut rows = Vec::new();
    for bar in bars {
        let criteria = |stretch: f64| {
            let energy =
                json!({ "energy_release_rate": 3.0 * stretch * stretch * bar.modulus * bar.spacing });
            let by_energy = (bar.model == "bond_solid").then_some(energy);
            [json!({ "stretch": stretch })].into_iter().chain(by_energy).collect::<Vec<_>>()
        };
        rows.extend(criteria(0.01).into_iter().map(|critical| bar.torn(critical)));
        for strategy in ["worst", "batch"] {
            rows.extend(criteria(10.0).into_iter().map(|critical| bar.whole(critical, strategy)));
        }
    }
    rows
}
