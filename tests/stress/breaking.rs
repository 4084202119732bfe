//! Bodies that can break or soften, before the first bond does: their answer is the elastic one.

use crate::stress::row::{Kind, Row, Wish};
use serde_json::{Value, json};

/// A model with a way to break, and what it takes for its usual treatment of edges.
struct Medium {
    model: &'static str,
    keys: Value,
    /// What the program takes where it is not given, as keys of an elastic body.
    usual: Value,
    /// All treatments of edges that are asked for.
    treated: Vec<Value>,
    fractures: Vec<Value>,
    /// A law with memory, where there is one.
    law: Option<Value>,
    /// Modulus along x.
    modulus: f64,
}

const E: f64 = 70_000.0;

fn media() -> Vec<Medium> {
    let treated =
        ["matched", "published"].into_iter().flat_map(|c| ["none", "volume", "energy"].map(|e| (c, e)));
    let mut treated: Vec<Value> = treated.map(|(c, e)| json!({ "calibration": c, "edges": e })).collect();
    treated.extend(["overlay", "border"].map(|e| json!({ "calibration": "matched", "edges": e })));
    let stretch = || json!({ "stretch": 0.5 });
    let central = |state: &str, modulus: f64| Medium {
        model: "bond_plane",
        keys: json!({ "youngs_modulus": E, "state": state }),
        usual: json!({}),
        treated: treated.clone(),
        fractures: vec![stretch(), json!({ "energy_release_rate": 1e9 })],
        law: Some(json!({ "bilinear": { "yield_stretch": 0.5, "failure_stretch": 2.0 } })),
        modulus,
    };
    let fibres = |degrees: f64, modulus: f64| Medium {
        model: "beam_bond_orthotropic",
        keys: json!({
            "youngs_modulus_1": 105_000.0, "youngs_modulus_2": 8400.0, "poisson_ratio_12": 0.32, "shear_modulus_12": 4000.0,
            "fibre_angle": degrees
        }),
        usual: json!({}),
        treated: treated.clone(),
        fractures: vec![json!({ "fibre_stretch": 0.5, "matrix_stretch": 0.7 })],
        law: None,
        modulus,
    };
    let states = ["ghosts", "moment_plus", "none"].map(|e| json!({ "edges": e })).to_vec();
    let state = Medium {
        model: "state_plane",
        keys: json!({ "youngs_modulus": E, "state": "plane_stress", "poisson_ratio": 0.3 }),
        usual: json!({ "edges": "ghosts" }),
        treated: states,
        fractures: vec![stretch()],
        law: None,
        ..central("plane_stress", E)
    };
    let strain = E / (1.0 - 0.0625);
    vec![
        central("plane_stress", E),
        central("plane_strain", strain),
        fibres(0.0, 105_000.0),
        fibres(90.0, 8400.0),
        state,
    ]
}

/// A bar of unit spacing that is moved or loaded at its right end.
#[derive(Clone, Copy, Debug)]
struct Bar {
    size: [f64; 2],
    loaded: &'static str,
}

const BY: f64 = 0.01;

impl Bar {
    fn case(&self, medium: &Medium, treated: &Value) -> Value {
        let mut keys = medium.keys.clone();
        for (key, value) in treated.as_object().expect("keys") {
            keys[key] = value.clone();
        }
        let middle = (0.5 * self.size[1]).floor() + 0.5;
        let mut supports = vec![
            json!({ "at": { "region": "left" }, "ux": 0.0 }),
            json!({ "at": { "x": 0.5, "y": middle }, "uy": 0.0 }),
        ];
        let loads = match self.loaded {
            "moved" => {
                supports.push(json!({ "at": { "region": "right" }, "ux": BY }));
                json!([])
            }
            "traction" => json!([{ "traction": { "edge": "right", "uniform": [7.0, 2.0] } }]),
            _ => {
                json!([{ "body_force": { "density": [0.3, -0.1] } }, { "point": { "at": { "region": "right" }, "force_y": 5.0 } }])
            }
        };
        // A roller cannot bear a shear that bends.
        if self.loaded != "moved" {
            supports[0]["uy"] = json!(0.0);
            supports.pop();
        }
        // The same for both, since whole bodies have another default.
        json!({
            "horizon_ratio": 3, "model": { medium.model: keys }, "body": { "rectangle": { "size": self.size, "spacing": 1.0 } },
            "supports": supports, "loads": loads
        })
    }

    fn row(&self, medium: &Medium, what: &str, case: Value) -> Row {
        let [nx, ny] = self.size;
        let at = format!("{what}, {}, {nx}x{ny}, {}", medium.keys, self.loaded);
        let mut row = Row::new(medium.model, "before the first bond breaks", at, case, (nx * ny) as usize);
        row.wish = Wish::Answer;
        let [x, y] = self.size.map(|n| (0.5 * n).floor() + 0.5);
        let force = json!({ "region": "left" });
        // Sizes of a stress and of a force on the end compare over its area.
        row = row.expect(force, "reaction_x", Kind::Force, 1.0 / ny, 0.0);
        for place in [[x, y], [nx - 0.5, ny - 0.5], [0.5, 0.5]] {
            row = row.moved(place, [0.0; 2]);
            let place = json!({ "x": place[0], "y": place[1] });
            for field in ["stress_xx", "stress_yy", "stress_xy"] {
                row = row.expect(place.clone(), field, Kind::Force, 1.0, 0.0);
            }
        }
        let name = json!("p0");
        for kind in ["fracture", "path"] {
            if row.case[kind].is_object() {
                row.case[kind]["load"] = name.clone();
            }
        }
        row
    }

    /// The same answers as those of the elastic body of a case.
    fn as_elastic(row: Row, elastic: Value) -> Row {
        let mut twin = elastic;
        (twin["title"], twin["probes"]) = (json!("stress"), row.case["probes"].clone());
        Row { twin: Some(twin), ..row }
    }

    /// All treatments of edges, asked for or usual, in all ways to break.
    fn rows(&self, medium: &Medium) -> Vec<Row> {
        let mut rows = Vec::new();
        let given = medium.treated.iter().map(|t| (t, t));
        for (treated, elastic) in given.chain([(&json!({}), &medium.usual)]) {
            let elastic = self.case(medium, elastic);
            for critical in &medium.fractures {
                for strategy in ["batch", "worst"] {
                    let mut case = self.case(medium, treated);
                    case["fracture"] = json!({ "critical": critical, "strategy": strategy });
                    let row = self.row(medium, &format!("fracture, {critical}, {strategy}, {treated}"), case);
                    rows.push(Self::as_elastic(row, elastic.clone()));
                }
            }
            // Triangles do not soften.
            if let Some(law) = medium.law.as_ref().filter(|_| treated["edges"] != "overlay") {
                for control in ["displacement", "event"] {
                    let mut case = self.case(medium, treated);
                    case["model"][medium.model]["bond_law"] = law.clone();
                    case["path"] = json!({ "control": control, "increment": 0.5 });
                    let mut row = self.row(medium, &format!("path, {control}, {treated}"), case);
                    if treated["edges"] == "border" || treated == &json!({}) {
                        // Stresses beside a border come from the runs, in elastic bodies from triangles; 3.3e-2 is found.
                        row.known = [0.0, 0.05];
                    }
                    rows.push(Self::as_elastic(row, elastic.clone()));
                }
            }
        }
        rows
    }
}

/// What a body of beam bonds that breaks is softer by as it is usually made, over its length: its edges are not completed, and
/// those that are held least of all.
const SOFT: [(f64, f64); 3] = [(20.0, 0.32), (40.0, 0.22), (80.0, 0.13)];

/// The force that moves an edge, against that of the uniform state.
fn soft() -> Vec<Row> {
    let mut rows = Vec::new();
    for medium in media() {
        for (length, softness) in SOFT {
            let bar = Bar { size: [length, 20.0], loaded: "moved" };
            let force = -medium.modulus * BY / length * bar.size[1];
            let mut case = bar.case(&medium, &json!({}));
            case["fracture"] = json!({ "critical": medium.fractures[0], "load": "p0" });
            let at = format!("{}, length {length}", medium.keys);
            let mut row = Row::new(
                medium.model,
                "as soft as it says before it breaks",
                at,
                case,
                (length * 20.0) as usize,
            );
            row.wish = Wish::Answer;
            let softness = match medium.model {
                "bond_plane" => 0.0,
                "state_plane" => 0.01,
                _ => softness,
            };
            row.known = [0.0, softness];
            rows.push(row.expect(json!({ "region": "left" }), "reaction_x", Kind::Force, 1.0, force));
        }
    }
    rows
}

pub(crate) fn rows() -> Vec<Row> {
    let bars = [[12.0, 6.0], [20.0, 10.0]]
        .into_iter()
        .flat_map(|size| ["moved", "traction", "forces"].map(|loaded| Bar { size, loaded }));
    let mut rows: Vec<Row> =
        bars.flat_map(|bar| media().into_iter().flat_map(move |m| bar.rows(&m))).collect();
    rows.extend(soft());
    rows
}
