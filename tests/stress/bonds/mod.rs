//! Plates of central bonds cut by a crack until a few bonds hold the rest, or breaking bond by bond, against a factorisation in
//! double-double arithmetic of the same bonds.

mod dense;
mod reference;

use crate::stress::row::{Kind, Row};
use serde_json::json;

/// How a body is led to where it is compared.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Way {
    /// By its load.
    Load,
    /// Along a path with bonds that could soften: its control, and their failure stretch over their yield stretch.
    Path(&'static str, f64),
    /// To the load that the next bond bears after so many have broken.
    Breaks(usize),
}

/// Stretch at which bonds break.
const CRITICAL: f64 = 1e-6;

/// Points of a small lattice, or near it; E = 1, t = 1, h = 1.
#[derive(Clone, Copy, Debug)]
struct Body {
    cells: [usize; 2],
    ratio: f64,
    /// End of a crack that comes from below, between two columns.
    tip: [f64; 2],
    /// Stiffness of springs that hold the part behind the crack, too.
    spring: f64,
    load: f64,
    /// How far points are off the lattice; as a list of points, if they are.
    scatter: f64,
    way: Way,
}

impl Body {
    fn new(cells: [usize; 2], ratio: f64, tip: f64) -> Self {
        Self { cells, ratio, tip: [4.0, tip], spring: 0.0, load: 1e-3, scatter: 0.0, way: Way::Load }
    }

    fn points(&self) -> Vec<[f64; 2]> {
        let [nx, ny] = self.cells;
        // Between -1 and 1, equally spread.
        let off = |k: usize| self.scatter * (2.0 * (k as f64 * 0.618_033_988_749_895).fract() - 1.0);
        let at = |k: usize| [(k % nx) as f64 + 0.5 + off(2 * k + 1), (k / nx) as f64 + 0.5 + off(2 * k + 2)];
        (0..nx * ny).map(at).collect()
    }

    fn model(&self) -> &'static str {
        match self.way {
            Way::Load if self.scatter > 0.0 => "bond_plane, points",
            Way::Load => "bond_plane, cut",
            Way::Path(..) => "bond_plane that softens",
            Way::Breaks(_) => "bond_plane that breaks",
        }
    }

    fn row(&self, sweep: &'static str, at: String, solver: &str) -> Option<Row> {
        let ([nx, ny], points) = (self.cells, self.points());
        let reference = self.reference();
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
            "crack_fronts": "crossed",
            "loads": [{ "point": { "at": { "region": "last" }, "force_y": self.load } }]
        });
        match self.way {
            Way::Load => {}
            Way::Path(control, brittleness) => {
                case["model"]["bond_plane"]["bond_law"] =
                    json!({ "bilinear": { "yield_stretch": 10.0, "failure_stretch": 10.0 * brittleness } });
                case["path"] = json!({ "control": control, "load": "p0", "increment": 0.5 });
            }
            Way::Breaks(count) => {
                case["fracture"] = json!({
                    "critical": { "stretch": CRITICAL }, "strategy": "worst", "load": "p0", "max_solves": count + 1
                });
            }
        }
        let at = format!("{at}{nx}x{ny}, m = {}, tip {tip}, {solver}", self.ratio);
        let mut row = Row::new(self.model(), sweep, at, case, nx * ny);
        if self.scatter > 0.0 {
            row.case["body"] = json!({ "points": { "file": "points.csv" } });
            let lines = points.iter().map(|[x, y]| format!("{x},{y},1\n"));
            row.files = vec![("points.csv", format!("x,y,area\n{}", lines.collect::<String>()))];
        }
        // A mechanism has no reference, and must be refused.
        for p in [points.len() - 1, points.len() / 2, nx - 1] {
            let expected = reference.as_ref().map_or([f64::NAN; 2], |(_, u)| u[p]);
            row = row.moved(points[p], expected);
        }
        let reaction = -self.load * reference.as_ref().map_or(1.0, |(factor, _)| *factor);
        (self.spring == 0.0)
            .then(|| {
                row.clone().expect(json!({ "region": "first" }), "reaction_y", Kind::Force, 1.0, reaction)
            })
            .or(Some(row))
    }
}

pub(crate) fn rows() -> Vec<Row> {
    let mut rows = Vec::new();
    for (cells, ratio) in [[8, 6], [6, 9]].into_iter().flat_map(|n| [1.5, 2.0, 3.0, 4.2].map(|m| (n, m))) {
        for step in 0..=12 {
            // Off the bonds, which cross the line between two columns at thirds of a row.
            let tip = 0.07 + f64::from(step) * cells[1] as f64 / 12.0;
            for solver in ["auto", "sparse", "pcg"] {
                let body = Body::new(cells, ratio, tip);
                rows.extend(body.row("few bonds hold a part", String::new(), solver));
                let scattered = Body { scatter: 0.2, ..body };
                rows.extend(scattered.row("few bonds hold a part", String::new(), solver));
            }
        }
    }
    for spring in (-12..=12).step_by(2).map(|k| 10_f64.powi(k)) {
        for (tip, solver) in
            [3.07, 5.07, 7.0].into_iter().flat_map(|t| ["auto", "sparse", "pcg"].map(|s| (t, s)))
        {
            let body = Body { spring, ..Body::new([8, 6], 3.0, tip) };
            rows.extend(body.row("springs hold a part", format!("k = {spring:.0e} E t, "), solver));
        }
    }
    for (tip, ratio) in
        [0.57, 3.07, 5.07, 5.57].into_iter().flat_map(|t| [1.5, 2.0, 3.0, 4.2].map(|m| (t, m)))
    {
        for (control, brittleness) in ["displacement", "event", "dissipation"]
            .into_iter()
            .flat_map(|c| [1.001, 4.0, 1e6].map(|b| (c, b)))
        {
            let body = Body { way: Way::Path(control, brittleness), ..Body::new([8, 6], ratio, tip) };
            let at = format!("{control}, failure over yield {brittleness:.0e}, ");
            rows.extend(body.row("bonds that do not yet yield", at, "auto"));
        }
    }
    rows.extend(breaking());
    rows
}

/// Bodies bond by bond, as far as it is clear which one is next.
fn breaking() -> Vec<Row> {
    let mut rows = Vec::new();
    for (tip, ratio, scatter) in [0.57, 3.07, 5.07]
        .into_iter()
        .flat_map(|t| [1.5, 2.0, 3.0, 4.2].map(|m| (t, m)))
        .flat_map(|(t, m)| [(t, m, 0.0), (t, m, 0.2)])
    {
        for count in (0..40).step_by(3) {
            let body = Body { load: 1.0, scatter, way: Way::Breaks(count), ..Body::new([8, 6], ratio, tip) };
            if body.reference().is_none() {
                break;
            }
            rows.extend(body.row("bonds gone", format!("{count}, scatter {scatter}, "), "auto"));
        }
    }
    rows
}
