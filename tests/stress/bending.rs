//! Plates in bending: one that edge moments bend evenly, and a cantilever whose points are on the curve of the beam.

use crate::stress::row::{Kind, Row};
use serde_json::{Value, json};

/// A plate of twice as many cells along as across.
#[derive(Clone, Copy, Debug)]
struct Slab {
    modulus: f64,
    poisson_ratio: f64,
    thickness: f64,
    spacing: f64,
    cells: usize,
    ratio: f64,
    /// Its moments are `[1, -0.4, 0.3]` times this.
    moment: f64,
    solver: &'static str,
}

const SLAB: Slab = Slab {
    modulus: 2e11,
    poisson_ratio: 0.3,
    thickness: 0.05,
    spacing: 0.1,
    cells: 16,
    ratio: 1.5,
    moment: 1e3,
    solver: "auto",
};

impl Slab {
    fn bending(&self) -> f64 {
        self.modulus * self.thickness.powi(3) / (12.0 * (1.0 - self.poisson_ratio.powi(2)))
    }

    fn sides(&self) -> [f64; 2] {
        [self.cells, self.cells / 2].map(|n| n as f64 * self.spacing)
    }

    fn case(&self, supports: Value, loads: Value) -> Value {
        json!({
            "model": { "plate_bending": { "youngs_modulus": self.modulus, "poisson_ratio": self.poisson_ratio,
                "thickness": self.thickness } },
            "body": { "rectangle": { "size": self.sides(), "spacing": self.spacing } },
            "horizon_ratio": self.ratio, "solver": self.solver, "supports": supports, "loads": loads
        })
    }

    fn named(&self, sweep: &'static str, at: &str, case: Value) -> Row {
        let Self { cells, ratio, solver, .. } = self;
        let thin = self.thickness / self.sides()[0];
        let name = format!("{at}t/L = {thin:.0e}, {cells}x{}, m = {ratio}, {solver}", cells / 2);
        Row::new("plate_bending", sweep, name, case, cells * cells / 2)
    }

    /// The plate that edge moments bend and twist evenly, held at a corner.
    fn bent(&self, sweep: &'static str, at: &str) -> Row {
        let [m_x, m_y, m_xy] = [1.0, -0.4, 0.3].map(|share| share * self.moment);
        let edge = |edges: [&str; 2], normal: f64, along: f64| json!({ "line": { "edge": edges, "moment_n": normal, "moment_t": along } });
        let loads = json!([edge(["left", "right"], m_x, m_xy), edge(["bottom", "top"], m_y, -m_xy)]);
        let corner = json!([{ "at": { "x": 0.0, "y": 0.0 }, "w": 0.0, "phi_x": 0.0, "phi_y": 0.0 }]);
        let (d, nu) = (self.bending(), self.poisson_ratio);
        let rest = d * (1.0 - nu * nu);
        let [k_x, k_y, k_xy] = [(m_x - nu * m_y) / rest, (m_y - nu * m_x) / rest, m_xy / (d * (1.0 - nu))];
        let mut row = self.named(sweep, at, self.case(corner, loads));
        let [l_x, l_y] = self.sides();
        for (x, y) in [(l_x, l_y), (0.5 * l_x, 0.0), (0.5 * l_x, l_y)] {
            let place = json!({ "x": x, "y": y });
            let w = 0.5 * (k_x * x * x + k_y * y * y) + k_xy * x * y;
            row = row.expect(place.clone(), "w", Kind::Displacement, 1.0, w);
            for (field, moment) in [("M_xx", m_x), ("M_yy", m_y), ("M_xy", m_xy)] {
                row = row.expect(place.clone(), field, Kind::Force, 1.0, moment);
            }
        }
        row
    }

    /// A cantilever without Poisson's ratio between guided sides, under a force across its end.
    fn cantilever(&self, sweep: &'static str, at: &str) -> Row {
        let own = Self { poisson_ratio: 0.0, ..*self };
        let force = own.moment / own.sides()[0];
        let clamp = json!([{ "at": { "region": "left" }, "w": 0.0, "phi_n": 0.0, "phi_t": 0.0 },
            { "at": { "region": "bottom" }, "phi_n": 0.0 }, { "at": { "region": "top" }, "phi_n": 0.0 }]);
        let loads = json!([{ "line": { "edge": "right", "force": force } }]);
        let (d, s) = (own.bending(), 5.0 / 12.0 * own.modulus * own.thickness);
        let mut row = own.named(sweep, at, own.case(clamp, loads));
        let [l_x, l_y] = own.sides();
        for x in [l_x, 0.5 * l_x] {
            let w = force * x * (x * (3.0 * l_x - x) / (6.0 * d) + 1.0 / s);
            row = row.expect(json!({ "x": x, "y": l_y }), "w", Kind::Displacement, 1.0, w);
        }
        row
    }

    fn both(&self, rows: &mut Vec<Row>, sweep: &'static str, at: &str) {
        rows.extend([self.bent(sweep, at), self.cantilever(sweep, at)]);
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    let length = SLAB.sides()[0];
    for thin in [1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0] {
        for (cells, solver) in [(4, "sparse"), (16, "sparse"), (64, "sparse"), (64, "multigrid")] {
            let spacing = length / cells as f64;
            let slab = Slab { thickness: thin * length, cells, spacing, solver, ..SLAB };
            slab.both(&mut rows, "thickness over length", "");
        }
    }
    for ratio in [1.5, 2.0, 3.0, 5.0] {
        for cells in [2, 4, 16] {
            rows.push(Slab { ratio, cells, ..SLAB }.bent("horizon, also longer than the body", ""));
        }
    }
    for poisson_ratio in [-0.99, -0.5, 0.0, 0.333, 0.45, 0.499_999] {
        for thickness in [1e-4, 0.05, 1.0] {
            let slab = Slab { poisson_ratio, thickness, ..SLAB };
            rows.push(slab.bent("Poisson's ratio to its limits", &format!("nu = {poisson_ratio}, ")));
        }
    }
    for (scale, modulus) in
        [1e-9, 1e-3, 1.0, 1e3, 1e9].into_iter().flat_map(|l| [1e-12, 1.0, 1e12].map(|e| (l, e)))
    {
        let moment = 1e3 * modulus * scale * scale;
        let slab =
            Slab { modulus: 2e11 * modulus, thickness: 0.05 * scale, spacing: 0.1 * scale, moment, ..SLAB };
        slab.both(&mut rows, "units", &format!("{scale:.0e}, {modulus:.0e}, "));
    }
    for moment in [1e-200, 1e-60, 1e-30, 1e30, 1e60, 1e200] {
        Slab { moment, ..SLAB }.both(&mut rows, "loads of 1e±200", &format!("{moment:.0e}, "));
    }
    for (cells, solver) in [(2, "sparse"), (200, "sparse"), (400, "auto"), (400, "multigrid")] {
        let slab = Slab { cells, solver, spacing: length / cells as f64, ..SLAB };
        slab.both(&mut rows, "size", "");
    }
    rows
}
