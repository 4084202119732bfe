//! Tubes of shell membranes under pressure and tension.

use crate::stress::row::{Kind, Row};
use serde_json::json;

/// A tube of one row of cells, open or with closed ends.
#[derive(Clone, Copy, Debug)]
struct Tube {
    modulus: f64,
    thickness: f64,
    radius: f64,
    cells: usize,
    /// Cells around, of a part of the circumference that repeats.
    around: usize,
    spacing: f64,
    ratio: f64,
    pressure: f64,
    closed: bool,
    solver: &'static str,
}

const TUBE: Tube = Tube {
    modulus: 2e11,
    thickness: 0.01,
    radius: 0.16,
    cells: 100,
    around: 1,
    spacing: 0.01,
    ratio: 3.0,
    pressure: 1e6,
    closed: false,
    solver: "auto",
};

/// That of central bonds.
const POISSON_RATIO: f64 = 1.0 / 3.0;

impl Tube {
    fn row(&self, sweep: &'static str, at: String) -> Row {
        let (h, r) = (self.spacing, self.radius);
        let hoop = self.pressure * r / self.thickness;
        let axial = if self.closed { 0.5 * hoop } else { 0.0 };
        let middle = (self.cells / 2) as f64 * h + 0.5 * h;
        let mut loads = vec![json!({ "pressure": { "value": self.pressure } })];
        if self.closed {
            loads.extend(
                [("left", -axial), ("right", axial)]
                    .map(|(edge, s)| json!({ "traction": { "edge": edge, "uniform": [s, 0.0] } })),
            );
        }
        let case = json!({
            "model": { "shell_membrane": { "youngs_modulus": self.modulus, "thickness": self.thickness, "radius": r } },
            "body": { "rectangle": { "size": [self.cells as f64 * h, self.around as f64 * h], "spacing": h } },
            "horizon_ratio": self.ratio, "solver": self.solver, "periodic": [{ "along": "y" }],
            "supports": [{ "at": { "x": middle, "y": 0.5 * h }, "ux": 0.0, "uy": 0.0 }], "loads": loads
        });
        let name = format!(
            "{at}R/h = {:.0e}, {}x{}, m = {}, {}, {}",
            r / h,
            self.cells,
            self.around,
            self.ratio,
            if self.closed { "closed" } else { "open" },
            self.solver
        );
        let mut row = Row::new("shell_membrane", sweep, name, case, self.cells * self.around);
        let [strain, hoop_strain] =
            [(axial - POISSON_RATIO * hoop) / self.modulus, (hoop - POISSON_RATIO * axial) / self.modulus];
        for k in [0, self.cells - 1] {
            let x = k as f64 * h + 0.5 * h;
            let place = json!({ "x": x, "y": 0.5 * h });
            row = row.expect(place.clone(), "ux", Kind::Displacement, 1.0, strain * (x - middle));
            row = row.expect(place, "w", Kind::Displacement, 1.0, hoop_strain * r);
        }
        row.expect(json!({ "x": middle, "y": 0.5 * h }), "stress_yy", Kind::Force, 1.0, hoop)
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for radius in [0.01, 0.02, 0.05, 0.16, 1.0, 10.0, 1e3, 1e5, 1e7, 1e9] {
        for (closed, around, cells) in [(false, 1, 100), (true, 1, 100), (true, 1, 7), (true, 1, 2000)] {
            rows.push(
                Tube { radius, closed, around, cells, ..TUBE }.row("radius over horizon", String::new()),
            );
        }
    }
    for ratio in [1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0, 12.0] {
        for (closed, cells) in [(false, 8), (true, 8), (true, 60)] {
            rows.push(
                Tube { ratio, closed, cells, ..TUBE }
                    .row("horizon, also longer than the body", String::new()),
            );
        }
    }
    for (scale, modulus) in
        [1e-9, 1e-3, 1.0, 1e3, 1e9].into_iter().flat_map(|l| [1e-6, 1.0, 1e6].map(|e| (l, e)))
    {
        let tube = Tube {
            modulus: 2e11 * modulus,
            thickness: 0.01 * scale,
            radius: 0.16 * scale,
            spacing: 0.01 * scale,
            pressure: 1e6 * modulus,
            closed: true,
            ..TUBE
        };
        rows.push(tube.row("units", format!("{scale:.0e}, {modulus:.0e}, ")));
    }
    for thickness in [1e-12, 1e-6, 1e-3, 1.0, 1e6] {
        rows.push(Tube { thickness, closed: true, ..TUBE }.row("wall", format!("t = {thickness:.0e}, ")));
    }
    for pressure in [1e-200, 1e-60, 1e-30, 1e30, 1e60, 1e200] {
        rows.push(Tube { pressure, ..TUBE }.row("loads of 1e±200", format!("{pressure:.0e}, ")));
    }
    for (cells, solver) in [(4, "sparse"), (500, "pcg"), (20_000, "sparse"), (20_000, "auto")] {
        rows.push(Tube { cells, solver, closed: true, ..TUBE }.row("length", String::new()));
    }
    rows
}
