//! Edges that are held and moved, against the exact uniform state.

use crate::stress::row::{Kind, Row, Wish};
use serde_json::{Value, json};

/// Modulus along x, contraction along y per stretch along x, and shear modulus, in the plane.
#[derive(Clone, Copy, Debug)]
struct Moduli {
    x: f64,
    contraction: f64,
    shear: f64,
    /// Modulus along x where nothing can move along y.
    confined: f64,
}

/// A model with what is known of its held edges: the error of displacements, and that of stresses and forces. They are measured;
/// zero is exact.
#[derive(Clone, Debug)]
struct Medium {
    model: &'static str,
    name: &'static str,
    keys: Value,
    moduli: Moduli,
    /// Between joined sides, with no stress along the held edges.
    joined: [f64; 2],
    /// Between joined sides or mirrors that keep the width of the body: with a stress along them.
    confined: [f64; 2],
    /// Where a free edge meets them.
    free: [f64; 2],
    /// Sheared along x, and along y.
    sheared: [[f64; 2]; 2],
}

const E: f64 = 70_000.0;
const THICKNESS: f64 = 2.0;
const EXACT: [f64; 2] = [0.0; 2];

fn isotropic(state: &str, nu: f64) -> Moduli {
    let confined = E / (1.0 - nu * nu);
    match state {
        "plane_stress" => Moduli { x: E, contraction: nu, shear: E / (2.0 + 2.0 * nu), confined },
        _ => Moduli {
            x: confined,
            contraction: nu / (1.0 - nu),
            shear: E / (2.0 + 2.0 * nu),
            confined: E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)),
        },
    }
}

fn media() -> Vec<Medium> {
    let central = |state: &'static str, nu: f64| Medium {
        model: "bond_plane",
        name: state,
        keys: json!({ "youngs_modulus": E, "state": state, "thickness": THICKNESS }),
        moduli: isotropic(state, nu),
        joined: EXACT,
        confined: EXACT,
        free: EXACT,
        sheared: [EXACT; 2],
    };
    let state_based = |state: &'static str, nu: f64| Medium {
        model: "state_plane",
        keys: json!({ "youngs_modulus": E, "poisson_ratio": nu, "state": state, "thickness": THICKNESS }),
        moduli: isotropic(state, nu),
        joined: [0.0135, 0.0405],
        confined: [0.0165, 0.0415],
        free: [0.031, 0.155],
        sheared: [[0.0026, 0.0078]; 2],
        ..central(state, nu)
    };
    let fibres = |name: &'static str, degrees: f64, [along, across]: [f64; 2]| {
        let (major, nu, shear) = (105_000.0, 0.32, 4000.0);
        let contraction = nu * along / major;
        Medium {
            model: "beam_bond_orthotropic",
            name,
            keys: json!({
                "youngs_modulus_1": major, "youngs_modulus_2": 8400.0, "poisson_ratio_12": nu, "shear_modulus_12": shear,
                "fibre_angle": degrees, "thickness": THICKNESS
            }),
            moduli: Moduli {
                x: along,
                contraction,
                shear,
                confined: along / (1.0 - contraction * nu * across / major),
            },
            confined: [5.5e-5, 0.0012],
            free: [0.033, 0.14],
            sheared: [[0.001, 0.0105], EXACT],
            ..central("plane_stress", 0.0)
        }
    };
    vec![
        central("plane_stress", 1.0 / 3.0),
        central("plane_strain", 0.25),
        state_based("plane_stress", 0.3),
        state_based("plane_strain", 0.3),
        fibres("fibres along x", 0.0, [105_000.0, 8400.0]),
        fibres("fibres along y", 90.0, [8400.0, 105_000.0]),
    ]
}

/// A rectangle of unit spacing.
#[derive(Clone, Copy, Debug)]
struct Plate {
    size: [f64; 2],
    ratio: f64,
    /// How far the moved edge moves.
    by: f64,
}

impl Plate {
    fn row(&self, medium: &Medium, what: &str, keys: &Value) -> Row {
        let mut case = json!({
            "model": { medium.model: medium.keys }, "horizon_ratio": self.ratio,
            "body": { "rectangle": { "size": self.size, "spacing": 1.0 } }
        });
        for (key, value) in keys.as_object().expect("keys") {
            case[key] = value.clone();
        }
        let [nx, ny] = self.size;
        let at = format!("{}, {what}, {nx}x{ny}, m = {}, by {:.0e}", medium.name, self.ratio, self.by);
        let mut row = Row::new(medium.model, "edges held and moved", at, case, (nx * ny) as usize);
        row.wish = Wish::Answer;
        row
    }

    /// Points in corners, in the middles of edges and in the middle.
    fn places(&self) -> [[f64; 2]; 6] {
        let [x, y] = self.size.map(|n| n - 0.5);
        let [a, b] = self.size.map(|n| (n / 2.0).floor() + 0.5);
        [[0.5, 0.5], [x, 0.5], [x, y], [0.5, y], [a, y], [a, b]]
    }

    /// Expects displacements and a stress at all places, and the force on the moved edge.
    fn expect(
        &self,
        row: Row,
        u: impl Fn([f64; 2]) -> [f64; 2],
        (field, stress): (&str, f64),
        (edge, reaction, force): (&str, &str, f64),
    ) -> Row {
        let mut row = row;
        for place in self.places() {
            row = row.moved(place, u(place));
            row = row.expect(json!({ "x": place[0], "y": place[1] }), field, Kind::Force, 1.0, stress);
        }
        // Forces over the area of the edge compare with stresses.
        row.expect(json!({ "region": edge }), reaction, Kind::Force, (stress / force).abs(), force)
    }

    /// The left edge is held along x and the right one moves.
    fn stretched(&self, medium: &Medium) -> Vec<Row> {
        let strain = self.by / self.size[0];
        let edges = json!([{ "at": { "region": "left" }, "ux": 0.0 }, { "at": { "region": "right" }, "ux": self.by }]);
        let with = |more: Value| {
            let mut all = edges.clone();
            all.as_array_mut().expect("a list").push(more);
            all
        };
        let point = json!({ "at": { "x": 0.5, "y": 0.5 }, "uy": 0.0 });
        let mirrors = |sides: Value, supports: &Value| json!({ "symmetry": sides, "supports": supports });
        let right = json!([{ "at": { "region": "right" }, "ux": self.by }]);
        let joined = |stretches: bool| json!({ "supports": with(point.clone()), "periodic": [{ "along": "y", "stretches": stretches }] });
        let ways: [(&str, Value, [f64; 2], f64, bool); 6] = [
            ("free above and below", json!({ "supports": with(point.clone()) }), medium.free, 0.5, false),
            ("a mirror below", mirrors(json!(["bottom"]), &edges), medium.free, 0.0, false),
            (
                "mirrors on the left and below",
                mirrors(json!(["left", "bottom"]), &right),
                medium.free,
                0.0,
                false,
            ),
            (
                "mirrors below and above",
                mirrors(json!(["bottom", "top"]), &edges),
                medium.confined,
                0.0,
                true,
            ),
            ("joined along y", joined(false), medium.confined, 0.5, true),
            ("joined along y, stretching", joined(true), medium.joined, 0.5, false),
        ];
        let row = |(what, keys, known, fixed, is_confined): (&str, Value, [f64; 2], f64, bool)| {
            let Moduli { x, contraction, confined, .. } = medium.moduli;
            let (modulus, across) = if is_confined { (confined, 0.0) } else { (x, contraction) };
            let stress = modulus * strain;
            let mut row = self.row(medium, &format!("stretched, {what}"), &keys);
            row.known = known;
            let u = |at: [f64; 2]| [strain * at[0], -across * strain * (at[1] - fixed)];
            self.expect(
                row,
                u,
                ("stress_xx", stress),
                ("right", "reaction_x", stress * self.size[1] * THICKNESS),
            )
        };
        ways.map(row).to_vec()
    }

    /// One edge is held and the opposite one moves along itself, the sides between joined.
    fn sheared(&self, medium: &Medium) -> Vec<Row> {
        let of = |along: &str, [low, high]: [&str; 2], axis: usize| {
            let [moved, kept] = if axis == 1 { ["ux", "uy"] } else { ["uy", "ux"] };
            let angle = self.by / self.size[axis];
            let stress = medium.moduli.shear * angle;
            let keys = json!({
                "supports": [{ "at": { "region": low }, moved: 0.0, kept: 0.0 }, { "at": { "region": high }, moved: self.by, kept: 0.0 }],
                "periodic": [{ "along": along }]
            });
            let mut row = self.row(medium, &format!("sheared, joined along {along}"), &keys);
            row.known = medium.sheared[1 - axis];
            let u = |at: [f64; 2]| if axis == 1 { [angle * at[1], 0.0] } else { [0.0, angle * at[0]] };
            let reaction = if axis == 1 { "reaction_x" } else { "reaction_y" };
            self.expect(
                row,
                u,
                ("stress_xy", stress),
                (high, reaction, stress * self.size[1 - axis] * THICKNESS),
            )
        };
        vec![of("x", ["bottom", "top"], 1), of("y", ["left", "right"], 0)]
    }

    /// The left edge is held on rollers and the right one is pulled: exact.
    fn pulled(&self, medium: &Medium) -> Row {
        let strain = self.by / self.size[0];
        let stress = medium.moduli.x * strain;
        let keys = json!({
            "supports": [{ "at": { "region": "left" }, "ux": 0.0 }, { "at": { "x": 0.5, "y": 0.5 }, "uy": 0.0 }],
            "loads": [{ "traction": { "edge": "right", "uniform": [stress, 0.0] } }]
        });
        let mut row = self.row(medium, "pulled on rollers", &keys);
        row.known = EXACT;
        let u = |at: [f64; 2]| [strain * at[0], -medium.moduli.contraction * strain * (at[1] - 0.5)];
        self.expect(row, u, ("stress_xx", stress), ("left", "reaction_x", -stress * self.size[1] * THICKNESS))
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for medium in media() {
        for ratio in [2.0, 3.0, 4.0, 5.0] {
            for (size, by) in [([16.0, 8.0], 0.02), ([9.0, 15.0], -1e-6), ([30.0, 20.0], 1e3)] {
                let plate = Plate { size, ratio, by };
                rows.extend(plate.stretched(&medium));
                rows.extend(plate.sheared(&medium));
                rows.push(plate.pulled(&medium));
            }
        }
    }
    rows
}
