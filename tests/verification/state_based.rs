//! Cylinders of state-based families against the solutions of Lamé, and how their errors fall with the spacing.

use crate::support::plane::{PlaneRun, displacements};
use peristat::case::FieldName;
use serde_json::{Value, json};
use std::f64::consts::PI;

const NU: f64 = 0.3;

/// Largest difference of the displacements and its mean over the volume, each relative to that of the exact ones.
pub(super) fn errors(run: &PlaneRun, exact: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let u = [FieldName::Ux, FieldName::Uy].map(|f| run.field(0, f));
    let (mut most, mut sums) = ([0.0_f64; 2], [0.0; 2]);
    for (p, at) in run.positions().into_iter().enumerate() {
        let expected = exact(at);
        let off = (u[0][p] - expected[0]).hypot(u[1][p] - expected[1]);
        let volume = at[0] * run.scene.body().measure(p);
        for (k, value) in [off, expected[0].hypot(expected[1])].into_iter().enumerate() {
            most[k] = most[k].max(if value.is_nan() { f64::INFINITY } else { value });
            sums[k] += volume * value * value;
        }
    }
    [most[0] / most[1], (sums[0] / sums[1]).sqrt()]
}

pub(super) fn orders(errors: &[f64]) -> Vec<f64> {
    errors.windows(2).map(|e| (e[0] / e[1]).log2()).collect()
}

/// How a cylinder of radii 1 and 2 with E = 1 is loaded.
#[derive(Clone, Copy)]
struct Cylinder {
    nu: f64,
    /// Inside and outside.
    pressures: [f64; 2],
    ends: Ends,
}

#[derive(Clone, Copy, PartialEq)]
enum Ends {
    Held,
    Open,
    Closed,
}

const INSIDE: Cylinder = Cylinder { nu: NU, pressures: [1.0, 0.0], ends: Ends::Held };

impl Cylinder {
    /// Two rows with n points through the wall, the sides joined.
    fn case(self, n: u32) -> Value {
        let spacing = 1.0 / f64::from(n);
        let mut joined = json!({ "along": "y" });
        if self.ends != Ends::Held {
            joined["stretches"] = json!(true);
        }
        if self.ends == Ends::Closed {
            joined["force"] = json!(PI * (self.pressures[0] - 4.0 * self.pressures[1]));
        }
        let loads = ["left", "right"].into_iter().zip(self.pressures).filter(|l| l.1 != 0.0);
        let loads: Vec<Value> = loads
            .map(|(edge, p)| json!({ "traction": { "edge": edge, "pressure": p, "depth": 1 } }))
            .collect();
        json!({
            "title": "cylinder",
            "model": { "axisymmetric": { "youngs_modulus": 1, "poisson_ratio": self.nu } },
            "body": { "rectangle": { "from": [1, 0], "size": [1, 2.0 * spacing], "spacing": spacing } },
            "periodic": [joined],
            "supports": [{ "at": { "x": 1.0 + 0.5 * spacing, "y": 0.5 * spacing }, "uy": 0 }],
            "loads": loads
        })
    }

    /// Radial displacement by Lamé, and the strain along the axis.
    fn lame(self) -> (impl Fn(f64) -> f64, f64) {
        let ([pi, po], nu) = (self.pressures, self.nu);
        let (a, b) = ((pi - 4.0 * po) / 3.0, 4.0 * (pi - po) / 3.0);
        let along = match self.ends {
            Ends::Held => 2.0 * nu * a,
            Ends::Open => 0.0,
            Ends::Closed => a,
        };
        (move |r: f64| ((1.0 - nu) * a - nu * along) * r + (1.0 + nu) * b / r, along - 2.0 * nu * a)
    }

    /// Errors of the radial displacement, largest and mean, and of the strain along the axis.
    fn errors(self, n: u32) -> [f64; 3] {
        let run = displacements(&self.case(n));
        let (u, strain) = self.lame();
        let lowest = 0.5 / f64::from(n);
        let [most, mean] = errors(&run, |[x, y]| [u(x), strain * (y - lowest)]);
        let uy = run.field(0, FieldName::Uy);
        let rows = run.positions().into_iter().zip(uy);
        let grown = rows
            .filter(|(at, _)| at[1] > 2.0 * lowest)
            .map(|r| r.1)
            .fold(0.0, |a: f64, v| if v.abs() > a.abs() { v } else { a });
        let size = if strain == 0.0 { 1.0 } else { strain };
        [most, mean, (grown * f64::from(n) - strain) / size]
    }
}

#[test]
fn the_closed_forms_are_those_of_the_books() {
    // E = 1, ν = 0.3, radii 1 and 2: by hand.
    let all = [
        (INSIDE, [1.9066666667, 1.2133333333], 0.0),
        (Cylinder { pressures: [0.0, 1.0], ..INSIDE }, [-2.4266666667, -2.2533333333], 0.0),
        (Cylinder { ends: Ends::Open, ..INSIDE }, [1.9666666667, 1.3333333333], -0.2),
        (Cylinder { ends: Ends::Closed, ..INSIDE }, [1.8666666667, 1.1333333333], 0.1333333333),
    ];
    for (cylinder, [inside, outside], along) in all {
        let (u, strain) = cylinder.lame();
        let off = [u(1.0) - inside, u(2.0) - outside, strain - along];
        assert!(off.iter().all(|d| d.abs() < 1e-9), "{off:?}");
    }
}

#[test]
fn cylinders_converge_to_lame_with_the_square_of_the_spacing() {
    // Largest errors at 20, 40 and 80 points: 1.7e-3, 4.7e-4 and 1.2e-4; means 8.0e-4, 2.0e-4 and 4.9e-5.
    let found = [20, 40, 80].map(|n| INSIDE.errors(n));
    let (most, mean) = (found.map(|e| e[0]), found.map(|e| e[1]));
    assert!(most[1] < 8e-4, "{most:?}");
    assert!(orders(&most)[1] >= 1.7, "{most:?}");
    assert!(orders(&mean).iter().all(|o| *o >= 1.9), "{mean:?}");
}

#[test]
fn cylinders_under_other_loads_and_with_other_ends_are_those_of_lame() {
    // 3.9e-4.
    let outside = Cylinder { pressures: [0.0, 1.0], ..INSIDE }.errors(40);
    assert!(outside[0] < 6e-4, "{outside:?}");
    // 4.7e-4 and 1.2e-4; 4.7e-4 and 2.5e-4.
    for (ends, most) in [(Ends::Open, 3e-4), (Ends::Closed, 4e-4)] {
        let found = Cylinder { ends, ..INSIDE }.errors(40);
        assert!(found[0] < 8e-4 && found[2].abs() < most, "{found:?}");
    }
}

#[test]
fn a_cylinder_under_the_same_pressure_everywhere_is_exact() {
    for ends in [Ends::Held, Ends::Open, Ends::Closed] {
        let found = Cylinder { pressures: [1.0, 1.0], ends, ..INSIDE }.errors(20);
        assert!(found.iter().all(|e| e.abs() < 1e-11), "{found:?}");
    }
    // A force alone, through joined sides.
    let mut case = Cylinder { pressures: [0.0; 2], ends: Ends::Closed, ..INSIDE }.case(20);
    case["periodic"][0]["force"] = json!(3.0 * PI);
    let error = displacements(&case).error(0, |[x, y]| [-NU * x, y - 0.025]);
    assert!(error < 1e-11, "{error:e}");
}

#[test]
fn what_keeps_its_volume_does_not_lock() {
    // 1.0e-3, 1.1e-3 and 1.1e-3.
    let most = [0.49, 0.4999, 0.499999].map(|nu| Cylinder { nu, ..INSIDE }.errors(40)[0]);
    assert!(most.iter().all(|e| *e < 2.5e-3), "{most:?}");
    assert!((most[2] / most[1] - 1.0).abs() < 0.02, "{most:?}");
    // 4.2e-3, 1.1e-3 and 2.7e-4.
    let rubber = Cylinder { nu: 0.4999, ..INSIDE };
    let falling = [20, 40, 80].map(|n| rubber.errors(n)[0]);
    assert!(orders(&falling).iter().all(|o| *o >= 1.8), "{falling:?}");
}
