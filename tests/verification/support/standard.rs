//! The eight standard cases of a beam of length 1 m under four slendernesses.

use serde_json::{Value, json};

/// A steel rectangle of width 0.05 m with loads that bend it by a comparable amount.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Section {
    /// m.
    pub(crate) height: f64,
    /// N.
    pub(crate) force: f64,
    /// N m.
    pub(crate) moment: f64,
    /// N/m.
    pub(crate) uniform: f64,
}

/// Slendernesses 5, 20, 100 and 1e4.
pub(crate) const SECTIONS: [Section; 4] = [
    section(0.2, 1e6, 1e6, 1e7),
    section(0.05, 1e3, 1e3, 1e4),
    section(0.01, 10.0, 10.0, 100.0),
    section(1e-4, 1e-5, 1e-5, 1e-4),
];

const fn section(height: f64, force: f64, moment: f64, uniform: f64) -> Section {
    Section { height, force, moment, uniform }
}

impl Section {
    /// EI and κGA with E = 200 GPa, ν = 0.3, κ = 5/6.
    pub(crate) fn stiffness(&self) -> (f64, f64) {
        let (e, b, h) = (200e9, 0.05, self.height);
        (e * b * h * h * h / 12.0, 5.0 / 6.0 * (e / 2.6) * b * h)
    }
}

/// Deflection and rotation at x of a beam of length 1 with stiffnesses B and S under a load.
type ClosedForm = fn(x: f64, b: f64, s: f64, load: f64) -> (f64, f64);

/// One of the standard cases.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Standard {
    pub(crate) name: &'static str,
    /// Position and whether w and φ are held.
    supports: &'static [(f64, bool, bool)],
    load: Load,
    exact: ClosedForm,
    /// Where the deflection is largest.
    pub(crate) station: f64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum Load {
    Force(f64),
    Moment(f64),
    Uniform,
}

const CLAMPED: (f64, bool, bool) = (0.0, true, true);
const ROLLER: (f64, bool, bool) = (1.0, true, false);

/// The standard cases; every closed form is the integral of `M = B φ'`, `V = S (w' − φ)`, `V' + q = 0`, `M' + V = 0`.
pub(crate) const CASES: [Standard; 8] = [
    Standard {
        name: "cantilever under a tip force",
        supports: &[CLAMPED],
        load: Load::Force(1.0),
        exact: tip_force,
        station: 1.0,
    },
    Standard {
        name: "cantilever under an end moment",
        supports: &[CLAMPED],
        load: Load::Moment(1.0),
        exact: end_moment,
        station: 1.0,
    },
    Standard {
        name: "cantilever under a uniform load",
        supports: &[CLAMPED],
        load: Load::Uniform,
        exact: cantilever_uniform,
        station: 1.0,
    },
    Standard {
        name: "simple supports, uniform load",
        supports: &[(0.0, true, false), ROLLER],
        load: Load::Uniform,
        exact: |x, b, s, q| {
            let w = q * x * (1.0 - 2.0 * x * x + x * x * x) / (24.0 * b) + q * x * (1.0 - x) / (2.0 * s);
            (w, q * (1.0 - 6.0 * x * x + 4.0 * x * x * x) / (24.0 * b))
        },
        station: 0.5,
    },
    Standard {
        name: "simple supports, force at mid-span",
        supports: &[(0.0, true, false), ROLLER],
        load: Load::Force(0.5),
        exact: |x, b, s, f| {
            let (y, sign) = if x <= 0.5 { (x, 1.0) } else { (1.0 - x, -1.0) };
            let w = f * y * (3.0 - 4.0 * y * y) / (48.0 * b) + f * y / (2.0 * s);
            (w, sign * f * (1.0 - 4.0 * y * y) / (16.0 * b))
        },
        station: 0.5,
    },
    Standard {
        name: "clamped ends, uniform load",
        supports: &[CLAMPED, (1.0, true, true)],
        load: Load::Uniform,
        exact: |x, b, s, q| {
            let y = 1.0 - x;
            let w = q * x * x * y * y / (24.0 * b) + q * x * y / (2.0 * s);
            (w, q * x * y * (1.0 - 2.0 * x) / (12.0 * b))
        },
        station: 0.5,
    },
    Standard {
        name: "clamped and simply supported, uniform load",
        supports: &[CLAMPED, ROLLER],
        load: Load::Uniform,
        exact: |x, b, s, q| {
            let omega = b / s;
            let reaction = -0.375 * q * (1.0 + 4.0 * omega) / (1.0 + 3.0 * omega);
            sum(cantilever_uniform(x, b, s, q), tip_force(x, b, s, reaction))
        },
        station: 0.5,
    },
    Standard {
        name: "clamped and guided, uniform load",
        supports: &[CLAMPED, (1.0, false, true)],
        load: Load::Uniform,
        exact: |x, b, s, q| sum(cantilever_uniform(x, b, s, q), end_moment(x, b, s, -q / 6.0)),
        station: 1.0,
    },
];

fn tip_force(x: f64, b: f64, s: f64, f: f64) -> (f64, f64) {
    let w = f * (x * x / 2.0 - x * x * x / 6.0) / b + f * x / s;
    (w, f * (x - x * x / 2.0) / b)
}

fn end_moment(x: f64, b: f64, _: f64, c: f64) -> (f64, f64) {
    (c * x * x / (2.0 * b), c * x / b)
}

fn cantilever_uniform(x: f64, b: f64, s: f64, q: f64) -> (f64, f64) {
    let w = q * x * x * (6.0 - 4.0 * x + x * x) / (24.0 * b) + q * (x - x * x / 2.0) / s;
    (w, q * x * (3.0 - 3.0 * x + x * x) / (6.0 * b))
}

fn sum(a: (f64, f64), b: (f64, f64)) -> (f64, f64) {
    (a.0 + b.0, a.1 + b.1)
}

impl Standard {
    /// The standard case of a name.
    pub(crate) fn named(name: &str) -> Self {
        let found = CASES.iter().find(|c| c.name == name);
        *found.unwrap_or_else(|| panic!("no standard case `{name}`"))
    }

    /// The local solution on a section.
    pub(crate) fn exact(&self, section: &Section) -> impl Fn(f64) -> (f64, f64) + use<> {
        let ((b, s), load, exact) = (section.stiffness(), self.magnitude(section), self.exact);
        move |x| exact(x, b, s, load)
    }

    /// The value of its load.
    pub(crate) fn magnitude(&self, section: &Section) -> f64 {
        match self.load {
            Load::Force(_) => section.force,
            Load::Moment(_) => section.moment,
            Load::Uniform => section.uniform,
        }
    }

    /// The case file on `cells` cells, horizon ratio 3.
    pub(crate) fn case(&self, section: &Section, law: &str, cells: usize) -> Value {
        let value = self.magnitude(section);
        let load = match self.load {
            Load::Force(x) => json!({ "point": { "at": { "x": x }, "force": value } }),
            Load::Moment(x) => json!({ "point": { "at": { "x": x }, "moment": value } }),
            Load::Uniform => json!({ "distributed": { "force": { "uniform": value } } }),
        };
        let supports = self.supports.iter().map(|&(x, w, phi)| {
            let mut support = json!({ "at": { "x": x } });
            if w {
                support["w"] = json!(0.0);
            }
            if phi {
                support["phi"] = json!(0.0);
            }
            support
        });
        let mut case = steel(section.height, law, cells);
        case["supports"] = supports.collect();
        case["loads"] = json!([load]);
        case
    }

    /// The same with a force in the span shared by the bonds instead of splitting the chain.
    pub(crate) fn unsplit(&self, section: &Section, law: &str, cells: usize) -> Value {
        let mut case = self.case(section, law, cells);
        if matches!(self.load, Load::Force(x) if x < 1.0) {
            case["loads"][0]["point"]["spread"] = json!(true);
        }
        case
    }
}

/// A steel beam of width 0.05 m and length 1 m that nothing holds or loads yet.
pub(crate) fn steel(height: f64, law: &str, cells: usize) -> Value {
    json!({
        "title": "test",
        "model": { "timoshenko_beam": {
            "youngs_modulus": 200e9, "poisson_ratio": 0.3,
            "section": { "rectangle": { "width": 0.05, "height": height } }, "bond_law": law } },
        "body": { "line": { "length": 1.0, "cells": cells } },
        "horizon_ratio": 3
    })
}

/// A beam of length 1 with EI = 1 and κGA = `shear`.
pub(crate) fn unit(shear: f64, law: &str, cells: usize) -> Value {
    json!({
        "title": "test",
        "model": { "timoshenko_beam": {
            "youngs_modulus": 1.0, "shear_modulus": shear,
            "section": { "general": { "area": 1.0, "second_moment": 1.0, "kappa": 1.0 } }, "bond_law": law } },
        "body": { "line": { "length": 1.0, "cells": cells } },
        "horizon_ratio": 3
    })
}
