//! Orthotropic plates under a uniform stress, for fibres at any angle.

use crate::stress::row::{Kind, Row};
use serde_json::json;

/// A rectangle of beam bonds.
#[derive(Clone, Copy, Debug)]
struct Laminate {
    moduli: [f64; 2],
    poisson_ratio: f64,
    shear_modulus: f64,
    degrees: f64,
    ratio: f64,
    spacing: f64,
    cells: [usize; 2],
    stress: f64,
    solver: &'static str,
}

const LAMINATE: Laminate = Laminate {
    moduli: [105_000.0, 8400.0],
    poisson_ratio: 0.32,
    shear_modulus: 4000.0,
    degrees: 0.0,
    ratio: 3.0,
    spacing: 1.0,
    cells: [24, 12],
    stress: 100.0,
    solver: "auto",
};

impl Laminate {
    /// Strains per stress along x: `[ε_xx, ε_yy, γ_xy]`.
    fn strains(&self) -> [f64; 3] {
        let (s, c) = self.degrees.to_radians().sin_cos();
        let [e1, e2] = self.moduli;
        let (s11, s22, s12, s66) = (1.0 / e1, 1.0 / e2, -self.poisson_ratio / e1, 1.0 / self.shear_modulus);
        let [c2, s2] = [c * c, s * s];
        [
            s11 * c2 * c2 + (2.0 * s12 + s66) * s2 * c2 + s22 * s2 * s2,
            s12 * (s2 * s2 + c2 * c2) + (s11 + s22 - s66) * s2 * c2,
            (2.0 * s11 - 2.0 * s12 - s66) * s * c * c2 - (2.0 * s22 - 2.0 * s12 - s66) * s2 * s * c,
        ]
    }

    fn row(&self, sweep: &'static str, at: String) -> Row {
        let far = self.cells.map(|n| (n as f64 - 0.5) * self.spacing);
        let near = 0.5 * self.spacing;
        let [xx, yy, shear] = self.strains().map(|e| e * self.stress);
        // The lower edge keeps its height.
        let u = |[x, y]: [f64; 2]| [xx * (x - near) + shear * (y - near), yy * (y - near)];
        let case = json!({
            "model": { "beam_bond_orthotropic": {
                "youngs_modulus_1": self.moduli[0], "youngs_modulus_2": self.moduli[1],
                "poisson_ratio_12": self.poisson_ratio, "shear_modulus_12": self.shear_modulus, "fibre_angle": self.degrees
            } },
            "body": { "rectangle": { "size": self.cells.map(|n| n as f64 * self.spacing), "spacing": self.spacing } },
            "horizon_ratio": self.ratio, "solver": self.solver,
            "supports": [{ "at": { "x": near, "y": near }, "ux": 0.0, "uy": 0.0 }, { "at": { "x": far[0], "y": near }, "uy": 0.0 }],
            "loads": [
                { "traction": { "edge": "right", "uniform": [self.stress, 0.0] } },
                { "traction": { "edge": "left", "uniform": [-self.stress, 0.0] } }
            ]
        });
        let name = format!("{at}{}x{}, m = {}, {}", self.cells[0], self.cells[1], self.ratio, self.solver);
        let mut row = Row::new("beam_bond_orthotropic", sweep, name, case, self.cells[0] * self.cells[1]);
        for at in [[far[0], near], far, [near, far[1]]] {
            row = row.moved(at, u(at));
        }
        row =
            row.expect(json!({ "x": far[0], "y": far[1] }), "phi", Kind::Displacement, far[0], -0.5 * shear);
        row.expect(json!({ "x": far[0], "y": far[1] }), "stress_xx", Kind::Force, 1.0, self.stress)
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for contrast in [1.0, 1.5, 3.0, 10.0, 12.5, 30.0, 100.0, 300.0, 1000.0] {
        for (degrees, ratio) in
            [0.0, 45.0, 90.0, 30.0, 7.3].into_iter().flat_map(|d| [2.0, 3.0, 3.2, 5.0, 8.0].map(|m| (d, m)))
        {
            let moduli = [contrast * 8400.0, 8400.0];
            // Between the bounds of the shear modulus of two phases.
            let shear_modulus = 8400.0 / 2.2;
            let laminate = Laminate { moduli, poisson_ratio: 0.2, shear_modulus, degrees, ratio, ..LAMINATE };
            rows.push(
                laminate.row("E1/E2 to 1e3, angle, horizon", format!("E1/E2 = {contrast}, {degrees}°, ")),
            );
        }
    }
    for poisson_ratio in [-0.9, -0.3, 0.0, 0.3, 0.9, 0.99, 0.999_999] {
        for shear in [1e-6, 1e-3, 0.1, 0.4, 1.0, 10.0] {
            let laminate = Laminate { poisson_ratio, shear_modulus: shear * 8400.0, ..LAMINATE };
            rows.push(laminate.row(
                "Poisson's ratio and shear modulus to their limits",
                format!("nu = {poisson_ratio}, G/E2 = {shear:.0e}, "),
            ));
        }
    }
    for (name, spacing, modulus) in [
        ("nm-µN", 1e6, 1e-6),
        ("µm-mN", 1e3, 1e-3),
        ("mm-N", 1.0, 1.0),
        ("m-kN", 1e-3, 1e3),
        ("km-GN", 1e-6, 1.0),
    ] {
        for (solver, stress) in
            ["auto", "sparse", "pcg"].into_iter().flat_map(|s| [1e-6, 1.0, 1e6].map(|k| (s, k)))
        {
            let laminate = Laminate {
                moduli: LAMINATE.moduli.map(|e| e * modulus),
                shear_modulus: 4000.0 * modulus,
                degrees: 30.0,
                spacing,
                stress,
                solver,
                ..LAMINATE
            };
            rows.push(laminate.row("units", format!("{name}, {stress:.0e}, ")));
        }
    }
    for (cells, solver) in [
        ([3, 3], "sparse"),
        ([40, 40], "auto"),
        ([40, 40], "sparse"),
        ([40, 40], "pcg"),
        ([400, 6], "auto"),
        ([400, 6], "sparse"),
        ([2000, 4], "sparse"),
        ([100, 100], "auto"),
        ([100, 100], "sparse"),
    ] {
        let laminate = Laminate { cells, solver, degrees: 45.0, ratio: 3.2, ..LAMINATE };
        rows.push(laminate.row("size, aspect", String::new()));
    }
    for stress in [1e-200, 1e-60, 1e-30, 1e30, 1e60, 1e200] {
        rows.push(
            Laminate { stress, degrees: 15.0, ..LAMINATE }.row("loads of 1e±200", format!("{stress:.0e}, ")),
        );
    }
    rows
}
