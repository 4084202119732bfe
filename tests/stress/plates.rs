//! Plates under a uniform stress, free to turn: exact at every point for every horizon.

use crate::stress::row::{Kind, Row, decades};
use serde_json::{Value, json};

/// A rectangle of cells under stresses, with E = 1.
#[derive(Clone, Copy, Debug)]
struct Plate {
    model: &'static str,
    state: &'static str,
    poisson_ratio: f64,
    cells: [usize; 2],
    spacing: f64,
    modulus: f64,
    ratio: f64,
    stress: [f64; 3],
    solver: &'static str,
}

const PLATE: Plate = Plate {
    model: "bond_plane",
    state: "plane_stress",
    poisson_ratio: 1.0 / 3.0,
    cells: [24, 12],
    spacing: 1.0,
    modulus: 1.0,
    ratio: 3.0,
    stress: [1.0, -0.3, 0.2],
    solver: "auto",
};

impl Plate {
    /// Displacement gradient of the stress without rotation.
    fn gradient(&self) -> [[f64; 2]; 2] {
        let (nu, [x, y, shear]) = (self.poisson_ratio, self.stress);
        let [xx, yy] = match self.state {
            "plane_stress" => [x - nu * y, y - nu * x],
            _ => [(1.0 + nu) * ((1.0 - nu) * x - nu * y), (1.0 + nu) * ((1.0 - nu) * y - nu * x)],
        };
        let half = (1.0 + nu) * shear;
        [[xx, half], [half, yy]].map(|row| row.map(|g| g / self.modulus))
    }

    /// Positions of the corners of the lattice of points.
    fn corners(&self) -> [[f64; 2]; 4] {
        let far = self.cells.map(|n| (n as f64 - 0.5) * self.spacing);
        let near = 0.5 * self.spacing;
        [[near, near], [far[0], near], [far[0], far[1]], [near, far[1]]]
    }

    /// The plate with a displacement gradient that is prescribed at three components and a stress that makes the rest.
    fn row(&self, sweep: &'static str, at: String, turn: f64) -> Row {
        let mut model = json!({ "youngs_modulus": self.modulus, "state": self.state });
        if self.model == "state_plane" {
            model["poisson_ratio"] = json!(self.poisson_ratio);
        }
        let [[a, b], [c, d]] = self.gradient();
        // What the supports take out of the turn of the body.
        let g = [[a, b - turn], [c + turn, d]];
        let corners = self.corners();
        let u = |at: [f64; 2]| {
            let from = [at[0] - corners[0][0], at[1] - corners[0][1]];
            g.map(|row| row[0] * from[0] + row[1] * from[1])
        };
        let [x, y, shear] = self.stress;
        let size = self.cells.map(|n| n as f64 * self.spacing);
        let case = json!({
            "model": { self.model: model },
            "body": { "rectangle": { "size": size, "spacing": self.spacing } },
            "horizon_ratio": self.ratio, "solver": self.solver,
            "supports": [
                { "at": { "x": corners[0][0], "y": corners[0][1] }, "ux": 0.0, "uy": 0.0 },
                { "at": { "x": corners[1][0], "y": corners[1][1] }, "uy": u(corners[1])[1] }
            ],
            "loads": edges([x, y, shear])
        });
        let name = format!(
            "{at}{}x{}, m = {}, {}, {}",
            self.cells[0], self.cells[1], self.ratio, self.state, self.solver
        );
        let mut row = Row::new(self.model, sweep, name, case, self.cells[0] * self.cells[1]);
        for at in &corners[1..] {
            row = row.moved(*at, u(*at));
        }
        // The largest of the stresses, which is the scale of all.
        let all = [("stress_xx", x), ("stress_yy", y), ("stress_xy", shear)];
        let (field, stress) = all.into_iter().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs())).expect("three");
        row.expect(json!({ "x": corners[2][0], "y": corners[2][1] }), field, Kind::Force, 1.0, stress)
    }

    /// The plate held by nothing but springs at two corners: a force on one of them moves it by as much as it strains.
    fn afloat(&self, spring: f64) -> Row {
        let [near, right, far, top] = self.corners();
        let place = |at: [f64; 2]| json!({ "x": at[0], "y": at[1] });
        let mut row = self.row("springs hold the body", format!("k = {spring:.0e} E t, "), 0.0);
        row.case["supports"] = json!([
            { "at": place(near), "ux_spring": spring, "uy_spring": spring }, { "at": place(right), "uy_spring": spring }
        ]);
        row.case["loads"]
            .as_array_mut()
            .expect("a list")
            .push(json!({ "point": { "at": place(near), "force_x": spring } }));
        let [xx, yy] = [self.gradient()[0][0], self.gradient()[1][1]];
        let u = |at: [f64; 2]| [1.0 + xx * (at[0] - near[0]), yy * (at[1] - near[1])];
        let bare = Row::new(row.model, row.sweep, row.at, row.case, row.cells);
        let row = [near, right, far, top].into_iter().fold(bare, |row, at| row.moved(at, u(at)));
        row.expect(place(far), "stress_xx", Kind::Force, 1.0, self.stress[0])
    }
}

fn edges([x, y, shear]: [f64; 3]) -> Value {
    let all = [("right", [x, shear]), ("left", [-x, -shear]), ("top", [shear, y]), ("bottom", [-shear, -y])];
    let loaded = all.into_iter().filter(|(_, t)| *t != [0.0; 2]);
    loaded.map(|(edge, t)| json!({ "traction": { "edge": edge, "uniform": t } })).collect()
}

/// Central bonds.
pub(crate) fn central() -> Vec<Row> {
    let mut rows = common(PLATE);
    for state in ["plane_stress", "plane_strain"] {
        for ratio in [1.0, 1.5, 2.0, 3.0, 3.015, 4.0, 5.0, 6.0, 8.0, 10.0, 12.0] {
            let poisson_ratio = if state == "plane_stress" { 1.0 / 3.0 } else { 0.25 };
            for cells in [[4, 4], [12, 30], [40, 40]] {
                let plate = Plate { state, poisson_ratio, ratio, cells, ..PLATE };
                rows.push(plate.row("horizon, also longer than the body", String::new(), 0.0));
            }
        }
    }
    rows
}

/// Families of points.
pub(crate) fn state_based() -> Vec<Row> {
    let plate = Plate { model: "state_plane", poisson_ratio: 0.3, ..PLATE };
    let mut rows = common(plate);
    for state in ["plane_stress", "plane_strain"] {
        for ratio in [1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0] {
            for cells in [[4, 4], [12, 30]] {
                let plate = Plate { state, ratio, cells, ..plate };
                rows.push(plate.row("horizon, also longer than the body", String::new(), 0.0));
            }
        }
        for poisson_ratio in [
            -1.0,
            -0.999_999,
            -0.99,
            -0.5,
            0.0,
            0.3,
            0.45,
            0.49,
            0.499,
            0.4999,
            0.499_999,
            0.499_999_99,
            0.499_999_999_9,
            0.499_999_999_999,
            0.5,
        ] {
            for (cells, solver) in [([10, 10], "sparse"), ([30, 20], "auto"), ([60, 60], "auto")] {
                let plate = Plate { state, poisson_ratio, cells, solver, ..plate };
                rows.push(plate.row("Poisson's ratio to its limits", format!("nu = {poisson_ratio}, "), 0.0));
            }
        }
    }
    rows
}

fn common(plate: Plate) -> Vec<Row> {
    let mut rows = Vec::new();
    for (cells, solver) in [
        ([2, 2], "sparse"),
        ([4, 4], "auto"),
        ([40, 40], "auto"),
        ([40, 40], "sparse"),
        ([40, 40], "pcg"),
        ([200, 4], "auto"),
        ([200, 4], "sparse"),
        ([1000, 8], "auto"),
        ([1000, 8], "sparse"),
        ([200, 200], "auto"),
        ([200, 200], "sparse"),
        ([4000, 6], "auto"),
        ([4000, 6], "sparse"),
    ] {
        for stress in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]] {
            let row = Plate { cells, solver, stress, ..plate };
            rows.push(row.row("size, aspect", format!("{stress:?}, "), 0.0));
        }
    }
    for (name, spacing, modulus) in [
        ("nm-µN", 1e6, 2e-1),
        ("µm-mN", 1e3, 2e2),
        ("mm-N", 1.0, 2e5),
        ("m-kN", 1e-3, 2e8),
        ("km-GN", 1e-6, 2e5),
    ] {
        for (solver, stress) in
            ["auto", "sparse", "pcg"].into_iter().flat_map(|s| [1e-9, 1e-3, 1e3].map(|k| (s, k)))
        {
            let row = Plate { spacing, modulus, solver, stress: PLATE.stress.map(|s| s * stress), ..plate };
            rows.push(row.row("units", format!("{name}, {stress:.0e}, "), 0.0));
        }
    }
    for (stress, solver) in [1e-200, 1e-100, 1e-60, 1e-30, 1e30, 1e60, 1e100, 1e200]
        .into_iter()
        .flat_map(|s| ["auto", "sparse"].map(|k| (s, k)))
    {
        let row = Plate { stress: PLATE.stress.map(|s| s * stress), solver, ..plate };
        rows.push(row.row("loads of 1e±200", format!("{stress:.0e}, "), 0.0));
    }
    // A turn of the body, that strains nothing, over the stretch that does.
    for (turn, solver) in decades(-2, 14, 2)
        .chain([1e-200, 1e60, 1e200])
        .flat_map(|t| ["auto", "sparse", "pcg"].map(|k| (t, k)))
    {
        let row = Plate { solver, ..plate };
        rows.push(row.row("rigid motion over strain", format!("{turn:.0e}, "), turn));
    }
    for (spring, solver) in
        decades(-14, 4, 1).flat_map(|k| ["auto", "sparse", "pcg", "multigrid"].map(|s| (k, s)))
    {
        for (cells, modulus) in [([12, 4], 1.0), ([24, 12], 1.0), ([60, 48], 200.0)] {
            let row = Plate { cells, solver, stress: [1.0, -0.3, 0.0], modulus, ..plate };
            rows.push(row.afloat(spring));
        }
    }
    rows
}
