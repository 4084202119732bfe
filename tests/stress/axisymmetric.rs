//! Bodies of revolution under stresses that are the same everywhere.

use crate::stress::row::{Kind, Row};
use serde_json::json;

/// A ring under the same pressure on all sides, or a bar that is pulled.
#[derive(Clone, Copy, Debug)]
struct Revolved {
    poisson_ratio: f64,
    /// Inner radius, spacings; 0 for a solid bar.
    inner: usize,
    cells: [usize; 2],
    spacing: f64,
    ratio: f64,
    stress: f64,
    solver: &'static str,
}

const BAR: Revolved = Revolved {
    poisson_ratio: 0.3,
    inner: 0,
    cells: [10, 10],
    spacing: 5.0,
    ratio: 3.0,
    stress: 100.0,
    solver: "auto",
};

const MODULUS: f64 = 200_000.0;

impl Revolved {
    fn row(&self, sweep: &'static str, at: String) -> Row {
        let (p, nu, h) = (self.stress, self.poisson_ratio, self.spacing);
        let from = self.inner as f64 * h;
        let size = self.cells.map(|n| n as f64 * h);
        let pressed = self.inner > 0;
        let mut loads = vec![json!({ "traction": { "edge": "top", "uniform": [0.0, p] } })];
        if pressed {
            loads.extend(
                ["left", "right"].map(|edge| json!({ "traction": { "edge": edge, "pressure": -p } })),
            );
        }
        let case = json!({
            "model": { "axisymmetric": { "youngs_modulus": MODULUS, "poisson_ratio": nu } },
            "body": { "rectangle": { "from": [from, 0.0], "size": size, "spacing": h } },
            "horizon_ratio": self.ratio, "solver": self.solver, "symmetry": ["bottom"], "loads": loads
        });
        // A bar in tension, or the same tension from all sides.
        let [radial, axial] = if pressed { [1.0 - 2.0 * nu, 1.0 - 2.0 * nu] } else { [-nu, 1.0] };
        let mut row = Row::new(
            "axisymmetric",
            sweep,
            format!(
                "{at}nu = {nu}, inner radius {} h, {}x{}, m = {}, {}",
                self.inner, self.cells[0], self.cells[1], self.ratio, self.solver
            ),
            case,
            self.cells[0] * self.cells[1],
        );
        let ends = [0, 1].map(|k| [from * [1.0, 0.0][k] + 0.5 * h, from * [1.0, 0.0][k] + size[k] - 0.5 * h]);
        for at in [[ends[0][0], ends[1][1]], [ends[0][1], ends[1][1]], [ends[0][1], ends[1][0]]] {
            row = row.moved(at, [p / MODULUS * radial * at[0], p / MODULUS * axial * at[1]]);
        }
        row.expect(json!({ "x": ends[0][0], "y": ends[1][0] }), "stress_yy", Kind::Force, 1.0, p)
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for nu in [
        -0.999_999,
        -0.9,
        0.0,
        0.3,
        0.49,
        0.4999,
        0.499_999,
        0.499_999_99,
        0.499_999_999_9,
        0.499_999_999_999,
        0.5,
    ] {
        for (inner, cells) in [(0, [6, 6]), (0, [20, 10]), (4, [8, 8]), (1000, [10, 6])] {
            rows.push(
                Revolved { poisson_ratio: nu, inner, cells, ..BAR }
                    .row("Poisson's ratio to its limits", String::new()),
            );
        }
    }
    for ratio in [1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0] {
        for (inner, cells) in [(0, [10, 10]), (1, [10, 10]), (20, [12, 5]), (0, [30, 30])] {
            rows.push(
                Revolved { ratio, inner, cells, ..BAR }
                    .row("horizon, also longer than the body", String::new()),
            );
        }
    }
    for inner in [0, 1, 2, 10, 100, 10_000, 1_000_000, 100_000_000] {
        for cells in [[8, 4], [4, 40], [40, 4]] {
            rows.push(Revolved { inner, cells, ..BAR }.row("radius over thickness", String::new()));
        }
    }
    for (cells, solver) in [
        ([60, 60], "auto"),
        ([60, 60], "sparse"),
        ([30, 30], "pcg"),
        ([200, 4], "sparse"),
        ([4, 600], "sparse"),
        ([150, 150], "auto"),
    ] {
        rows.push(Revolved { cells, solver, ..BAR }.row("size, aspect", String::new()));
    }
    for (spacing, stress) in
        [1e-9, 1e-3, 1.0, 1e3, 1e9].into_iter().flat_map(|h| [1e-9, 1.0, 1e9].map(|p| (h, p)))
    {
        rows.push(
            Revolved { spacing, stress, inner: 2, ..BAR }
                .row("units", format!("h = {spacing:.0e}, p = {stress:.0e}, ")),
        );
    }
    for stress in [1e-200, 1e-60, 1e-30, 1e30, 1e60, 1e200] {
        rows.push(Revolved { stress, ..BAR }.row("loads of 1e±200", format!("p = {stress:.0e}, ")));
    }
    rows
}
