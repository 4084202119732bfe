//! Random beams as case files, and what can be done to them: other units, the mirror image, their parts.

use peristat::case::from_text;
use peristat::input::Folder;
use peristat::run::beam::{self, BeamResult};
use peristat::run::{RunOptions, RunReport};
use peristat::scene::Scene;
use proptest::prelude::*;
use serde_json::{Value, json};
use std::path::Path;

/// A load; positions are parts of the length.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Load {
    Force { at: f64, value: f64, spread: bool },
    Moment { at: f64, value: f64 },
    Distributed { from: f64, to: f64, start: f64, end: f64 },
    DistributedMoment { from: f64, to: f64, value: f64 },
}

/// A support at a part of the length.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Support {
    Clamp(f64),
    Roller(f64),
    Guide(f64),
    Spring(f64),
}

/// A beam of some length in metres; loads are of the order of one.
#[derive(Clone, Debug)]
pub(crate) struct Beam {
    pub(crate) law: &'static str,
    pub(crate) length: f64,
    pub(crate) slenderness: f64,
    pub(crate) cells: usize,
    pub(crate) horizon_ratio: f64,
    pub(crate) supports: Vec<Support>,
    pub(crate) loads: Vec<Load>,
}

fn load() -> impl Strategy<Value = Load> {
    let value = || prop_oneof![-2.0..-0.1_f64, 0.1..2.0_f64];
    let span = || (0.0..0.7_f64, 0.1..0.3_f64);
    prop_oneof![
        // A multiple of 1/4 is a point of every grid below.
        (0_u8..5, value(), any::<bool>()).prop_map(|(k, value, spread)| Load::Force {
            at: 0.25 * f64::from(k),
            value,
            spread
        }),
        (0.01..0.99_f64, value()).prop_map(|(at, value)| Load::Force { at, value, spread: true }),
        (0_u8..5, value()).prop_map(|(k, value)| Load::Moment { at: 0.25 * f64::from(k), value }),
        (span(), value(), value()).prop_map(|((from, width), start, end)| Load::Distributed {
            from,
            to: from + width,
            start,
            end
        }),
        (span(), value()).prop_map(|((from, width), value)| Load::DistributedMoment {
            from,
            to: from + width,
            value
        }),
    ]
}

/// Any beam that its supports hold.
pub(crate) fn beam() -> impl Strategy<Value = Beam> {
    use Support::{Clamp, Guide, Roller, Spring};
    let supports = prop_oneof![
        Just(vec![Clamp(0.0)]),
        Just(vec![Clamp(1.0), Spring(0.25)]),
        Just(vec![Roller(0.0), Roller(1.0)]),
        Just(vec![Roller(0.25), Roller(1.0)]),
        Just(vec![Clamp(0.0), Clamp(1.0)]),
        Just(vec![Clamp(0.0), Guide(1.0)]),
        Just(vec![Roller(0.0), Guide(1.0)]),
        Just(vec![Clamp(0.0), Roller(0.5), Roller(1.0)]),
        Just(vec![Spring(0.0), Spring(0.75)]),
    ];
    let ratio = prop_oneof![(1_u8..7).prop_map(f64::from), 1.0..6.0_f64];
    let law = prop_oneof![Just("published"), Just("corrected"), Just("exact")];
    (law, 0.5..20.0_f64, 3.0..30.0_f64, 1_usize..30, ratio, supports, prop::collection::vec(load(), 1..4))
        .prop_map(|(law, length, slenderness, quarter, horizon_ratio, supports, loads)| Beam {
            law,
            length,
            slenderness,
            cells: 4 * quarter,
            horizon_ratio,
            supports,
            loads,
        })
}

/// Units of a case: how many of them make a metre and a pascal.
#[derive(Clone, Copy)]
pub(crate) struct Units {
    pub(crate) label: &'static str,
    pub(crate) length: f64,
    pub(crate) stress: f64,
}

pub(crate) const METRES: Units = Units { label: "m-N-Pa", length: 1.0, stress: 1.0 };
pub(crate) const MILLIMETRES: Units = Units { label: "mm-N-MPa", length: 1e3, stress: 1e-6 };

impl Beam {
    fn load_json(&self, load: &Load, units: Units) -> Value {
        let x = |part: f64| part * self.length * units.length;
        match *load {
            Load::Force { at, value, spread } => {
                json!({ "point": { "at": { "x": x(at) }, "force": value, "spread": spread } })
            }
            Load::Moment { at, value } => {
                json!({ "point": { "at": { "x": x(at) }, "moment": value * units.length } })
            }
            Load::Distributed { from, to, start, end } => json!({ "distributed": {
                "from": x(from), "to": x(to),
                "force": { "linear": [start / units.length, end / units.length] } } }),
            Load::DistributedMoment { from, to, value } => json!({ "distributed": {
                "from": x(from), "to": x(to), "moment": { "uniform": value } } }),
        }
    }

    /// The case file.
    pub(crate) fn case(&self, units: Units) -> Value {
        let x = |part: f64| json!({ "x": part * self.length * units.length });
        let height = self.length / self.slenderness * units.length;
        let support = |s: &Support| match *s {
            Support::Clamp(at) => json!({ "at": x(at), "w": 0.0, "phi": 0.0 }),
            Support::Roller(at) => json!({ "at": x(at), "w": 0.0 }),
            Support::Guide(at) => json!({ "at": x(at), "phi": 0.0 }),
            Support::Spring(at) => json!({ "at": x(at), "w_spring": 1e5 / units.length }),
        };
        json!({
            "title": "random", "units": units.label,
            "model": { "timoshenko_beam": {
                "youngs_modulus": 2e10 * units.stress, "poisson_ratio": 0.25,
                "section": { "rectangle": { "width": height, "height": height } }, "bond_law": self.law } },
            "body": { "line": { "length": self.length * units.length, "cells": self.cells } },
            "horizon_ratio": self.horizon_ratio,
            "supports": self.supports.iter().map(support).collect::<Vec<_>>(),
            "loads": self.loads.iter().map(|l| self.load_json(l, units)).collect::<Vec<_>>()
        })
    }

    /// The same loads, each as a load case of its own, and their sum as a combination.
    pub(crate) fn taken_apart(&self) -> Value {
        let mut case = self.case(METRES);
        let name = |k: usize| format!("load {k}");
        let each = self.loads.iter().enumerate();
        let cases: Vec<Value> =
            each.map(|(k, l)| json!({ "name": name(k), "loads": [self.load_json(l, METRES)] })).collect();
        let factors: serde_json::Map<String, Value> =
            (0..self.loads.len()).map(|k| (name(k), json!(1.0))).collect();
        case.as_object_mut().expect("an object").remove("loads");
        case["load_cases"] = cases.into();
        case["combinations"] = json!([{ "name": "sum", "factors": factors }]);
        case
    }

    /// The beam seen from behind: x becomes L − x, w stays, φ and moments change their sign.
    pub(crate) fn mirrored(&self) -> Self {
        let support = |s: &Support| match *s {
            Support::Clamp(x) => Support::Clamp(1.0 - x),
            Support::Roller(x) => Support::Roller(1.0 - x),
            Support::Guide(x) => Support::Guide(1.0 - x),
            Support::Spring(x) => Support::Spring(1.0 - x),
        };
        let load = |l: &Load| match *l {
            Load::Force { at, value, spread } => Load::Force { at: 1.0 - at, value, spread },
            Load::Moment { at, value } => Load::Moment { at: 1.0 - at, value: -value },
            Load::Distributed { from, to, start, end } => {
                Load::Distributed { from: 1.0 - to, to: 1.0 - from, start: end, end: start }
            }
            Load::DistributedMoment { from, to, value } => {
                Load::DistributedMoment { from: 1.0 - to, to: 1.0 - from, value: -value }
            }
        };
        Self {
            supports: self.supports.iter().map(support).collect(),
            loads: self.loads.iter().map(load).collect(),
            ..self.clone()
        }
    }

    /// Sum of all applied forces, and of their moments about x = 0, in newtons and metres.
    pub(crate) fn resultant(&self) -> [f64; 2] {
        let l = self.length;
        let mut sum = [0.0; 2];
        for load in &self.loads {
            let [force, moment] = match *load {
                Load::Force { at, value, .. } => [value, value * at * l],
                Load::Moment { value, .. } => [0.0, value],
                Load::Distributed { from, to, start, end } => {
                    let width = (to - from) * l;
                    let (mean, lean) = (0.5 * (start + end) * width, (end - start) * width * width / 12.0);
                    [mean, mean * 0.5 * (from + to) * l + lean]
                }
                Load::DistributedMoment { from, to, value } => [0.0, value * (to - from) * l],
            };
            sum = [sum[0] + force, sum[1] + moment];
        }
        sum
    }
}

/// Solves a case.
pub(crate) fn run(case: &Value) -> (Vec<BeamResult>, RunReport) {
    let source =
        from_text("case", case.to_string(), &[], &Folder::default()).unwrap_or_else(|e| panic!("{e}"));
    let scene =
        Scene::new(source.case, Path::new("."), "case", &source.text, None).unwrap_or_else(|e| panic!("{e}"));
    let scene = scene.into_beam().expect("a beam");
    let mut states = Vec::new();
    let options = RunOptions { recover: true, max_memory: None, compare: true };
    let report = beam::run(&scene, &options, &mut |state| {
        states.push(state);
        Ok(())
    });
    let report = report.unwrap_or_else(|error| panic!("{error}: {case}"));
    (states, report)
}
