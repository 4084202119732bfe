//! Beams on a straight line, against closed forms: the law `exact` is exact at every point, whatever the grid.

mod supports;

use crate::stress::row::{Kind, Row, decades};
use serde_json::{Value, json};

const MODEL: &str = "timoshenko_beam";

/// Length, bending and shear stiffness, cells, horizon ratio.
#[derive(Clone, Copy, Debug)]
struct Beam {
    length: f64,
    bending: f64,
    shear: f64,
    cells: usize,
    ratio: f64,
    law: &'static str,
    solver: &'static str,
}

/// Deflection and rotation at z = x/L, with bending compliance `f = L³/EI` and shear compliance `g = L/κGA` of a force.
type Form = fn(z: f64, f: f64, g: f64) -> [f64; 2];

/// Bending moment over the length and shear force at z = x/L under a unit load.
type Statics = fn(z: f64) -> [f64; 2];

/// Supports, load and closed forms of a beam; rotations are times L.
struct Standard {
    name: &'static str,
    ends: [&'static str; 2],
    load: &'static str,
    form: Form,
    statics: Statics,
}

const STANDARDS: [Standard; 5] = [
    Standard {
        name: "cantilever, tip force",
        ends: ["clamped", "free"],
        load: "force",
        form: |z, f, g| [f * z * z * (3.0 - z) / 6.0 + g * z, f * z * (2.0 - z) / 2.0],
        statics: |z| [1.0 - z, 1.0],
    },
    Standard {
        name: "cantilever, end moment",
        ends: ["clamped", "free"],
        load: "moment",
        form: |z, f, _| [f * z * z / 2.0, f * z],
        statics: |_| [1.0, 0.0],
    },
    Standard {
        name: "cantilever, uniform load",
        ends: ["clamped", "free"],
        load: "uniform",
        form: |z, f, g| {
            [
                f * z * z * (6.0 - 4.0 * z + z * z) / 24.0 + g * z * (2.0 - z) / 2.0,
                f * z * (3.0 - 3.0 * z + z * z) / 6.0,
            ]
        },
        statics: |z| [0.5 * (1.0 - z).powi(2), 1.0 - z],
    },
    Standard {
        name: "simple supports, uniform load",
        ends: ["pinned", "pinned"],
        load: "uniform",
        form: |z, f, g| {
            let y = 1.0 - z;
            [
                f * z * y * (1.0 + z * y) / 24.0 + g * z * y / 2.0,
                f * (1.0 - 2.0 * z) * (1.0 + 2.0 * z * y) / 24.0,
            ]
        },
        statics: |z| [-0.5 * z * (1.0 - z), 0.5 - z],
    },
    Standard {
        name: "clamped ends, uniform load",
        ends: ["clamped", "clamped"],
        load: "uniform",
        form: |z, f, g| {
            let y = 1.0 - z;
            [f * z * z * y * y / 24.0 + g * z * y / 2.0, f * z * y * (1.0 - 2.0 * z) / 12.0]
        },
        statics: |z| [(1.0 - 6.0 * z * (1.0 - z)) / 12.0, 0.5 - z],
    },
];

impl Beam {
    /// A beam of length one and EI of one.
    fn unit(slenderness: f64, cells: usize, solver: &'static str) -> Self {
        let shear = slenderness * slenderness;
        Self { length: 1.0, bending: 1.0, shear, cells, ratio: 3.0, law: "exact", solver }
    }

    fn case(&self) -> Value {
        json!({
            "model": { "timoshenko_beam": {
                "stiffness": { "bending": { "uniform": self.bending }, "shear": { "uniform": self.shear } },
                "bond_law": self.law } },
            "body": { "line": { "length": self.length, "cells": self.cells } },
            "horizon_ratio": self.ratio, "solver": self.solver, "supports": [], "loads": []
        })
    }

    fn name(&self) -> String {
        format!("N = {}, m = {}, {}", self.cells, self.ratio, self.solver)
    }

    fn end(&self, x: f64, held: &str) -> Option<Value> {
        match held {
            "clamped" => Some(json!({ "at": { "x": x }, "w": 0.0, "phi": 0.0 })),
            "pinned" => Some(json!({ "at": { "x": x }, "w": 0.0 })),
            _ => None,
        }
    }

    /// A standard case under a load of this size, times what makes forces of it.
    fn standard(&self, sweep: &'static str, at: &str, standard: &Standard, force: f64) -> Row {
        let mut case = self.case();
        let ends = [0.0, self.length].into_iter().zip(standard.ends);
        case["supports"] = ends.filter_map(|(x, held)| self.end(x, held)).collect();
        case["loads"] = json!([match standard.load {
            "force" => json!({ "point": { "at": { "x": self.length }, "force": force } }),
            "moment" => json!({ "point": { "at": { "x": self.length }, "moment": force * self.length } }),
            _ => json!({ "distributed": { "force": { "uniform": force / self.length } } }),
        }]);
        let row = Row::new(MODEL, sweep, format!("{at}{}, {}", self.name(), standard.name), case, self.cells);
        let [f, g] = [force * self.length.powi(3) / self.bending, force * self.length / self.shear];
        let stations = [0, self.cells / 4, self.cells / 2, self.cells];
        let row = self.expect(row, &stations, |z| (standard.form)(z, f, g));
        self.bears(row, 0.25, |z| (standard.statics)(z).map(|s| force * s))
    }

    /// Expects w and φ L at some points of an even grid.
    fn expect(&self, row: Row, stations: &[usize], form: impl Fn(f64) -> [f64; 2]) -> Row {
        let mut row = row;
        for &k in stations {
            let z = k as f64 / self.cells as f64;
            row = self.expect_at(row, z, form(z));
        }
        row
    }

    /// Expects bending moment, over the length, and shear force at the last point of an even grid up to some place.
    fn bears(&self, row: Row, z: f64, statics: impl Fn(f64) -> [f64; 2]) -> Row {
        let z = (z * self.cells as f64).floor() / self.cells as f64;
        let (place, [moment, shear]) = (json!({ "x": z * self.length }), statics(z));
        row.expect(place.clone(), "M", Kind::Force, 1.0 / self.length, moment * self.length).expect(
            place,
            "V",
            Kind::Force,
            1.0,
            shear,
        )
    }

    fn expect_at(&self, row: Row, z: f64, [w, turn]: [f64; 2]) -> Row {
        let place = json!({ "x": z * self.length });
        row.expect(place.clone(), "w", Kind::Displacement, 1.0, w).expect(
            place,
            "phi",
            Kind::Displacement,
            self.length,
            turn / self.length,
        )
    }
}

pub(crate) fn rows() -> Vec<Row> {
    [slenderness(), horizons(), laws(), grids(), weights(), units(), contrasts(), sizes(), supports::rows()]
        .concat()
}

fn slenderness() -> Vec<Row> {
    let mut rows = Vec::new();
    for slender in decades(0, 6, 1) {
        for (cells, solver) in [4, 10, 100, 1000, 10_000, 100_000, 1_000_000]
            .map(|n| (n, "auto"))
            .into_iter()
            .chain([4, 100, 1000, 10_000, 100_000].map(|n| (n, "band")))
        {
            for standard in STANDARDS.iter().filter(|s| s.load != "moment") {
                let beam = Beam::unit(slender, cells, solver);
                rows.push(beam.standard(
                    "slenderness, cells",
                    &format!("L/h = {slender:.0e}, "),
                    standard,
                    1.0,
                ));
            }
        }
        // A whole band of a million cells takes seconds.
        rows.push(Beam::unit(slender, 1_000_000, "band").standard(
            "slenderness, cells",
            &format!("L/h = {slender:.0e}, "),
            &STANDARDS[2],
            1.0,
        ));
    }
    rows
}

fn horizons() -> Vec<Row> {
    let mut rows = Vec::new();
    for ratio in (1..=12).map(f64::from) {
        for (cells, slender) in [4, 12, 48, 1000].into_iter().flat_map(|n| [1.0, 1e3, 1e6].map(|s| (n, s))) {
            for (solver, k) in [("auto", 4), ("band", 4), ("sparse", 2)] {
                let beam = Beam { ratio, ..Beam::unit(slender, cells, solver) };
                rows.push(beam.standard(
                    "horizon, also longer than the body",
                    &format!("L/h = {slender:.0e}, "),
                    &STANDARDS[k],
                    1.0,
                ));
            }
        }
    }
    rows
}

fn laws() -> Vec<Row> {
    let mut rows = Vec::new();
    for (law, ratio) in
        ["published", "corrected"].into_iter().flat_map(|l| [1.0, 3.0, 6.0, 12.0].map(|m| (l, m)))
    {
        for (cells, slender) in [20, 200, 2000].into_iter().flat_map(|n| [1.0, 1e2, 1e4, 1e6].map(|s| (n, s)))
        {
            for solver in ["auto", "band"] {
                let beam = Beam { ratio, law, ..Beam::unit(slender, cells, solver) };
                // A constant curvature is exact under every law.
                rows.push(beam.standard(
                    "bond laws that lock",
                    &format!("{law}, L/h = {slender:.0e}, "),
                    &STANDARDS[1],
                    1.0,
                ));
            }
        }
    }
    rows
}

/// Positions of points whose cells differ by up to a ratio, from a generator of its own.
fn random_positions(cells: usize, ratio: f64, seed: u64) -> Vec<f64> {
    let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15) | 1;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let lengths: Vec<f64> = (0..cells).map(|_| ratio.powf(random())).collect();
    let whole: f64 = lengths.iter().sum();
    let mut x = 0.0;
    let mut positions: Vec<f64> = lengths
        .iter()
        .map(|h| {
            x += h / whole;
            x
        })
        .collect();
    positions[cells - 1] = 1.0;
    positions.insert(0, 0.0);
    positions
}

fn grids() -> Vec<Row> {
    let mut rows = Vec::new();
    let mut graded = |beam: Beam, at: String, grading: Value, standard: &Standard, middle: Option<f64>| {
        let mut row = beam.standard("graded and random grids", &at, standard, 1.0);
        row.case["body"]["line"]["grading"] = grading;
        // Only the ends, and a point that is known, have a position that is.
        let mut ended = Row { truths: Vec::new(), ..row.clone() };
        ended.case["probes"] = json!([]);
        let form = |z: f64| (standard.form)(z, 1.0, 1.0 / beam.shear);
        for z in middle.into_iter().chain([1.0]) {
            ended = beam.expect_at(ended, z, form(z));
        }
        rows.push(ended);
    };
    for (cells, slender) in [10, 100, 1000].into_iter().flat_map(|n| [1.0, 1e3, 1e6].map(|s| (n, s))) {
        for (solver, standard) in
            ["auto", "band"].into_iter().flat_map(|s| [2, 4].map(|k| (s, &STANDARDS[k])))
        {
            let beam = Beam::unit(slender, cells, solver);
            for (k, ratio) in [10.0, 1e3, 1e6].into_iter().enumerate() {
                let positions = random_positions(cells, ratio, (k + 7 * cells) as u64);
                let middle = positions[cells / 2];
                let at = format!("random, ratio {ratio:.0e}, L/h = {slender:.0e}, ");
                graded(beam, at, json!({ "positions": positions }), standard, Some(middle));
            }
            for ratio in [1e-6, 1e6] {
                let at = format!("geometric, ratio {ratio:.0e}, L/h = {slender:.0e}, ");
                graded(beam, at, json!({ "geometric": { "ratio": ratio } }), &STANDARDS[0], None);
            }
            let at = format!("both ends, ratio 1e6, L/h = {slender:.0e}, ");
            graded(beam, at, json!({ "both_ends": { "ratio": 1e6 } }), standard, Some(0.5));
        }
    }
    rows
}

/// Horizons that reach the last neighbour by next to nothing.
fn weights() -> Vec<Row> {
    let mut rows = Vec::new();
    for (whole, beyond) in
        [1.0, 1.5, 2.5, 3.0, 3.5].into_iter().flat_map(|m| [-1e-9, 1e-15, 1e-12, 1e-6].map(|b| (m, b)))
    {
        for (slender, solver) in [1.0, 1e4].into_iter().flat_map(|s| ["auto", "band"].map(|k| (s, k))) {
            let beam = Beam { ratio: whole + beyond, ..Beam::unit(slender, 60, solver) };
            rows.push(beam.standard(
                "weights near zero",
                &format!("L/h = {slender:.0e}, "),
                &STANDARDS[4],
                1.0,
            ));
        }
    }
    rows
}

fn units() -> Vec<Row> {
    let mut rows = Vec::new();
    // nm-µN, µm-mN, mm-N, m-kN, km-GN: the same steel bar as numbers.
    for (name, length, force) in [
        ("nm-µN", 1e-9, 1e-6),
        ("µm-mN", 1e-6, 1e-3),
        ("mm-N", 1e-3, 1.0),
        ("m-kN", 1.0, 1e3),
        ("km-GN", 1e3, 1e9),
    ] {
        for (cells, slender) in [10, 200, 5000].into_iter().flat_map(|n| [1.0, 1e3, 1e6].map(|s| (n, s))) {
            for (solver, k) in [("auto", 4), ("band", 0)] {
                let bending = 2e11 * 1e-8 / (force * length * length);
                let beam = Beam {
                    length: 1.0 / length,
                    bending,
                    shear: slender * slender * bending * length * length,
                    ..Beam::unit(slender, cells, solver)
                };
                rows.push(beam.standard(
                    "units",
                    &format!("{name}, L/h = {slender:.0e}, "),
                    &STANDARDS[k],
                    1.0 / force,
                ));
            }
        }
    }
    rows
}

fn contrasts() -> Vec<Row> {
    let mut rows = Vec::new();
    for ratio in decades(-12, 12, 2) {
        for (cells, solver) in [10, 200, 2000].into_iter().flat_map(|n| ["auto", "band"].map(|s| (n, s))) {
            let beam = Beam::unit(30.0, cells, solver);
            let mut case = beam.case();
            let stepped = |value: f64| json!({ "table": [[0.0, value], [0.5, value], [0.5, value * ratio], [1.0, value * ratio]] });
            case["model"]["timoshenko_beam"]["stiffness"] =
                json!({ "bending": stepped(beam.bending), "shear": stepped(beam.shear) });
            case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
            case["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "force": 1.0 } }]);
            // ∫ M m / EI + V v / κGA of both halves.
            let [b, s] = [beam.bending, beam.shear];
            let half = [7.0 / 24.0 / b + 0.5 / s, 3.0 / 8.0 / b];
            let tip = [1.0 / 24.0 / b / ratio + 0.5 / s / ratio, 1.0 / 8.0 / b / ratio];
            let middle = [5.0 / 48.0 / b + 0.5 / s, half[1]];
            let row =
                Row::new(MODEL, "stiffness contrast", format!("{ratio:.0e}, {}", beam.name()), case, cells);
            let row = beam.expect_at(row, 0.5, middle);
            let row = [0.25, 0.75].into_iter().fold(row, |row, z| beam.bears(row, z, |z| [1.0 - z, 1.0]));
            rows.push(beam.expect_at(row, 1.0, [half[0] + tip[0], half[1] + tip[1]]));
        }
    }
    rows
}

fn sizes() -> Vec<Row> {
    let mut rows = Vec::new();
    for force in [1e-200, 1e-100, 1e-60, 1e-30, 1e30, 1e60, 1e100, 1e200] {
        for (solver, standard) in
            ["auto", "band", "sparse"].into_iter().flat_map(|s| [1, 2, 4].map(|k| (s, &STANDARDS[k])))
        {
            let beam = Beam::unit(50.0, 100, solver);
            rows.push(beam.standard("loads of 1e±200", &format!("{force:.0e}, "), standard, force));
        }
    }
    rows
}
