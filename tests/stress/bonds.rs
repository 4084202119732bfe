//! Plates of central bonds cut by a crack until a few bonds hold the rest, against a factorisation in double-double
//! arithmetic of the same bonds.

use crate::row::{Kind, Row};
use serde_json::json;
use twofloat::TwoFloat;

/// Points of a small lattice, E = 1, t = 1, h = 1.
#[derive(Clone, Copy, Debug)]
struct Lattice {
    cells: [usize; 2],
    ratio: f64,
    /// End of a crack that comes from below, between two columns.
    tip: [f64; 2],
    /// Stiffness of springs that hold the part behind the crack, too.
    spring: f64,
    load: f64,
    /// Control of a path with bonds that could soften, and their failure stretch over their yield stretch.
    path: Option<(&'static str, f64)>,
}

impl Lattice {
    fn points(&self) -> Vec<[f64; 2]> {
        let [nx, ny] = self.cells;
        (0..nx * ny).map(|k| [(k % nx) as f64 + 0.5, (k / nx) as f64 + 0.5]).collect()
    }

    /// Whether the crack crosses a bond.
    fn cuts(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        let [x, tip] = self.tip;
        if (a[0] - x) * (b[0] - x) >= 0.0 {
            return false;
        }
        a[1] + (b[1] - a[1]) * (x - a[0]) / (b[0] - a[0]) < tip
    }

    /// Ends, direction times length, and stiffness of the bonds; the micromodulus of plane stress is 9E/(π t δ³).
    fn bonds(&self) -> Vec<([usize; 2], [f64; 2], TwoFloat)> {
        let points = self.points();
        let mut bonds = Vec::new();
        for (i, a) in points.iter().enumerate() {
            for (j, b) in points.iter().enumerate().skip(i + 1) {
                let xi = [b[0] - a[0], b[1] - a[1]];
                let square = xi[0] * xi[0] + xi[1] * xi[1];
                if square <= self.ratio * self.ratio * (1.0 + 1e-9) && !self.cuts(*a, *b) {
                    let length = TwoFloat::from(square).sqrt();
                    let c = over(
                        over(TwoFloat::from(9.0), twofloat::consts::PI),
                        TwoFloat::from(self.ratio).powi(3),
                    );
                    // k n nᵀ = k/ξ² ξ ξᵀ.
                    bonds.push(([i, j], xi, over(over(c, length), TwoFloat::from(square))));
                }
            }
        }
        bonds
    }

    /// Displacements `[point][component]` under the load along y shared by the last column; the first one is held.
    fn reference(&self) -> Option<Vec<[f64; 2]>> {
        let (points, [nx, ny]) = (self.points(), self.cells);
        let n = 2 * points.len();
        let mut matrix = vec![vec![TwoFloat::from(0.0); n]; n];
        for ([i, j], xi, k) in self.bonds() {
            for (a, b) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let value = k * xi[a] * xi[b];
                matrix[2 * i + a][2 * i + b] += value;
                matrix[2 * j + a][2 * j + b] += value;
                matrix[2 * i + a][2 * j + b] -= value;
                matrix[2 * j + a][2 * i + b] -= value;
            }
        }
        let mut rhs = vec![TwoFloat::from(0.0); n];
        for row in 0..ny {
            let last = row * nx + nx - 1;
            rhs[2 * last + 1] = over(TwoFloat::from(self.load), TwoFloat::from(ny as f64));
            for c in 0..2 {
                let held = 2 * row * nx + c;
                matrix[held] = vec![TwoFloat::from(0.0); n];
                matrix.iter_mut().for_each(|line| line[held] = TwoFloat::from(0.0));
                matrix[held][held] = TwoFloat::from(1.0);
                matrix[2 * last + c][2 * last + c] +=
                    over(TwoFloat::from(self.spring), TwoFloat::from(ny as f64));
            }
        }
        let u = solved(matrix, rhs)?;
        Some((0..points.len()).map(|p| [f64::from(u[2 * p]), f64::from(u[2 * p + 1])]).collect())
    }

    fn row(&self, sweep: &'static str, at: String, solver: &str) -> Option<Row> {
        let ([nx, ny], points) = (self.cells, self.points());
        let u = self.reference();
        let [x, tip] = self.tip;
        let mut supports = vec![json!({ "at": { "region": "first" }, "ux": 0.0, "uy": 0.0 })];
        if self.spring > 0.0 {
            supports.push(
                json!({ "at": { "region": "last" }, "ux_spring": self.spring, "uy_spring": self.spring }),
            );
        }
        let column = |k: usize| json!({ "box": { "from": [k, 0], "to": [k + 1, ny] } });
        let mut case = json!({
            "model": { "bond_plane": { "youngs_modulus": 1.0, "state": "plane_stress", "thickness": 1.0,
                "calibration": "published", "volume_factor": "full", "edges": "none" } },
            "body": { "rectangle": { "size": [nx, ny], "spacing": 1 } },
            "horizon_ratio": self.ratio, "solver": solver, "supports": supports,
            "regions": { "first": column(0), "last": column(nx - 1) },
            "cracks": [{ "path": [[x, -1.0], [x, tip]] }],
            "loads": [{ "point": { "at": { "region": "last" }, "force_y": self.load } }]
        });
        if let Some((control, brittleness)) = self.path {
            case["model"]["bond_plane"]["bond_law"] =
                json!({ "bilinear": { "yield_stretch": 10.0, "failure_stretch": 10.0 * brittleness } });
            case["path"] = json!({ "control": control, "load": "p0", "increment": 0.5 });
            case["solver"] = json!("auto");
        }
        let mut row = Row::new(
            if self.path.is_some() { "bond_plane that softens" } else { "bond_plane, cut" },
            sweep,
            format!("{at}{nx}x{ny}, m = {}, tip {tip}, {solver}", self.ratio),
            case,
            nx * ny,
        );
        // A mechanism has no reference, and must be refused.
        for p in [points.len() - 1, points.len() / 2, nx - 1] {
            let expected = u.as_ref().map_or([f64::NAN; 2], |u| u[p]);
            row = row.moved(points[p], expected);
        }
        let reaction = -self.load;
        (self.spring == 0.0)
            .then(|| {
                row.clone().expect(json!({ "region": "first" }), "reaction_y", Kind::Force, 1.0, reaction)
            })
            .or(Some(row))
    }
}

/// A quotient in double-double arithmetic: that of the library has the digits of a double.
fn over(a: TwoFloat, b: TwoFloat) -> TwoFloat {
    let mut quotient = TwoFloat::from(0.0);
    let mut rest = a;
    for _ in 0..3 {
        let digits = f64::from(rest) / f64::from(b);
        quotient += digits;
        rest -= b * digits;
    }
    quotient
}

/// Gaussian elimination of a positive definite matrix in double-double arithmetic; none if a pivot vanishes but for rounding.
fn solved(mut matrix: Vec<Vec<TwoFloat>>, mut rhs: Vec<TwoFloat>) -> Option<Vec<TwoFloat>> {
    let n = rhs.len();
    let size: Vec<f64> = (0..n).map(|k| f64::from(matrix[k][k])).collect();
    for k in 0..n {
        let pivot = matrix[k][k];
        if f64::from(pivot) <= 1e-24 * size[k] {
            return None;
        }
        let line = matrix[k].clone();
        for i in k + 1..n {
            let factor = over(matrix[i][k], pivot);
            if f64::from(factor) != 0.0 {
                for j in k..n {
                    let taken = factor * line[j];
                    matrix[i][j] -= taken;
                }
                let taken = factor * rhs[k];
                rhs[i] -= taken;
            }
        }
    }
    for k in (0..n).rev() {
        let known = (k + 1..n).fold(TwoFloat::from(0.0), |sum, j| sum + matrix[k][j] * rhs[j]);
        rhs[k] = over(rhs[k] - known, matrix[k][k]);
    }
    Some(rhs)
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for (cells, ratio) in [[8, 6], [6, 9]].into_iter().flat_map(|n| [1.5, 2.0, 3.0, 4.2].map(|m| (n, m))) {
        for step in 0..=12 {
            // Off the bonds, which cross the line between two columns at thirds of a row.
            let tip = 0.07 + f64::from(step) * cells[1] as f64 / 12.0;
            for solver in ["auto", "sparse", "pcg"] {
                let lattice = Lattice { cells, ratio, tip: [4.0, tip], spring: 0.0, load: 1e-3, path: None };
                rows.extend(lattice.row("few bonds hold a part", String::new(), solver));
            }
        }
    }
    for spring in (-12..=12).step_by(2).map(|k| 10_f64.powi(k)) {
        for (tip, solver) in
            [3.07, 5.07, 7.0].into_iter().flat_map(|t| ["auto", "sparse", "pcg"].map(|s| (t, s)))
        {
            let lattice =
                Lattice { cells: [8, 6], ratio: 3.0, tip: [4.0, tip], spring, load: 1e-3, path: None };
            rows.extend(lattice.row("springs hold a part", format!("k = {spring:.0e} E t, "), solver));
        }
    }
    for (tip, ratio) in
        [0.57, 3.07, 5.07, 5.57].into_iter().flat_map(|t| [1.5, 2.0, 3.0, 4.2].map(|m| (t, m)))
    {
        for (control, brittleness) in ["displacement", "event", "dissipation"]
            .into_iter()
            .flat_map(|c| [1.001, 4.0, 1e6].map(|b| (c, b)))
        {
            let path = Some((control, brittleness));
            let lattice = Lattice { cells: [8, 6], ratio, tip: [4.0, tip], spring: 0.0, load: 1e-3, path };
            let at = format!("{control}, failure over yield {brittleness:.0e}, ");
            rows.extend(lattice.row("bonds that do not yet yield", at, "auto"));
        }
    }
    rows
}
