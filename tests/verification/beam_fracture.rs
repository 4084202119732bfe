//! Beams that break in load steps: first breaks by statics, energies that balance, parts that come off, resumed runs.

use crate::support::{refusal, relative, scene};
use peristat::case::FieldName;
use peristat::run::beam::{self, BeamResult};
use peristat::run::fracture::Event;
use peristat::run::{Advance, Restart, RunOptions, RunReport, Sink, StateResult};
use serde_json::{Value, json};
use std::io;

const CELLS: usize = 40;
/// EI, κGA, EA and the area.
const SECTION: [f64; 4] = [2.0, 900.0, 700.0, 0.3];
const CURVATURE: f64 = 0.05;

/// All that a run tells.
#[derive(Default)]
struct Told {
    events: Vec<Event>,
    restarts: Vec<Restart>,
    states: Vec<BeamResult>,
}

impl Sink for Told {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        let StateResult::Beam(result) = result else { panic!("a beam") };
        self.states.push(result);
        Ok(())
    }

    fn advance(&mut self, advance: Advance<'_>, restart: Option<&dyn Fn() -> Restart>) -> io::Result<()> {
        let Advance::Break(event) = advance else { return Ok(()) };
        self.events.push(*event);
        self.restarts.extend(restart.map(|make| make()));
        Ok(())
    }
}

fn run(case: &Value, resume: Option<Restart>) -> (Told, RunReport) {
    let (scene, mut told) = (scene(case), Told::default());
    let options = RunOptions { recover: true, max_memory: None, compare: true };
    let report = beam::run_breaking(&scene, &options, resume, &mut told);
    let report = report.unwrap_or_else(|error| panic!("{error}: {case}"));
    assert!(report.converged, "not converged: {case}");
    (told, report)
}

/// A cantilever of length 1 with a force on its tip, in whose clamp the reaction is probed.
fn cantilever(strategy: &str) -> Value {
    let [bending, shear, axial, area] = SECTION;
    let [bending, shear, axial] = [bending, shear, axial].map(|value| json!({ "uniform": value }));
    let stiffness = json!({ "bending": bending, "shear": shear, "axial": axial, "area": area });
    json!({
        "title": "test", "model": { "timoshenko_beam": { "stiffness": stiffness, "bond_law": "exact" } },
        "body": { "line": { "length": 1.0, "cells": CELLS } },
        "supports": [{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }],
        "loads": [{ "point": { "at": { "x": 1.0 }, "force": 1.0 } }],
        "probes": [{ "name": "R", "at": { "x": 0.0 }, "field": "reaction_force" }],
        "fracture": { "critical": { "curvature": CURVATURE }, "strategy": strategy, "load": "R", "record_every": 1 }
    })
}

/// Load at which the first bond of the cantilever breaks: the bond of one cell at the clamp is bent as the middle of it.
fn first_load(curvature: f64) -> f64 {
    curvature * SECTION[0] / (1.0 - 0.5 / CELLS as f64)
}

#[test]
fn a_cantilever_breaks_at_its_clamp() {
    for strategy in ["worst", "batch", "all"] {
        let pushed = cantilever(strategy);
        let mut pulled = pushed.clone();
        pulled["supports"][0]["ux"] = json!(0.0);
        pulled["loads"][0]["point"]["axial"] = json!(3.0);
        let mut moved = pushed.clone();
        moved["loads"] = json!([]);
        moved["supports"].as_array_mut().expect("a list").push(json!({ "at": { "x": 1.0 }, "w": 1.0 }));
        // What the tip still holds has not come off, but nothing strains it.
        for (case, off) in [(pushed, CELLS), (pulled, CELLS), (moved, 0)] {
            let (told, report) = run(&case, None);
            let first = &told.events[0];
            // Those that go step by step are a ten millionth beyond. Measured 1.7e-12.
            let beyond = if strategy == "worst" { 0.0 } else { 1e-7 };
            let expected = -first_load(CURVATURE) * (1.0 + beyond);
            assert!(relative(first.load, expected) < 1e-9, "{strategy}: {} {expected}", first.load);
            let last = told.events.last().expect("there is one");
            // All bonds across the first cell; one piece, the clamped point alone stays. `all` does not wait for what the
            // first break takes off the bonds beyond.
            assert!(last.broken == 3 || strategy == "all" && last.broken > 3, "{strategy}");
            assert_eq!(last.island_points, off, "{strategy}");
            // Measured 1e-12 of the first one where the tip is held.
            assert!(last.load.abs() < 1e-9 * first.load.abs(), "{strategy}: {last:?}");
            assert_eq!(report.fracture.expect("it broke").ending, "nothing carries the load any more");
            // All work is released in the end. Measured 3.7e-11.
            assert!(last.stored <= 1e-18 * last.work, "{strategy} {last:?}");
            assert!(relative(last.released, last.work) < 1e-9, "{strategy} {last:?}");
            assert!(told.events.iter().all(|e| e.balance.abs() < 1e-9), "{strategy}");
        }
    }
}

#[test]
fn section_forces_are_those_of_statics_whatever_has_broken() {
    let (told, _) = run(&cantilever("worst"), None);
    for (event, state) in told.events.iter().zip(&told.states) {
        let carried = if event.island_points > 0 { 0.0 } else { event.load_factor };
        for point in 0..=CELLS {
            let x = point as f64 / CELLS as f64;
            let at = |field| state.value(field, 0, point).expect("recovered");
            // Measured 8e-17.
            assert!((at(FieldName::M) - carried * (1.0 - x)).abs() < 1e-13, "{event:?} {point}");
            let shear = if point == CELLS { state.value(FieldName::V, 0, point - 1) } else { None };
            let shear = shear.unwrap_or_else(|| at(FieldName::V));
            assert!((shear - carried).abs() < 1e-13, "{event:?} {point}");
        }
    }
    assert_eq!(told.states.len(), told.events.len());
}

#[test]
fn a_section_breaks_by_its_energy_release_rate() {
    let mut case = cantilever("worst");
    case["fracture"]["critical"] = json!({ "energy_release_rate": 0.02 });
    // Half the energy of a bond is its share of Σ n² α_n = 19/9 spacings: κ_c² = 2 G A/(EI l_c), γ_c² = 2 G A/(S l_c).
    let energy = 2.0 * 0.02 * SECTION[3] / (19.0 / 9.0 / CELLS as f64);
    // The first bond has the curvature F (1 − h/2)/EI and the shear strain F/S.
    let (arm, [bending, shear, ..]) = (1.0 - 0.5 / CELLS as f64, SECTION);
    let expected = (energy / (arm * arm / bending + 1.0 / shear)).sqrt();
    let (told, _) = run(&case, None);
    assert!(relative(-told.events[0].load, expected) < 1e-9, "{} {expected}", told.events[0].load);
}

#[test]
fn a_line_carries_on_when_another_has_come_off() {
    let mut case = cantilever("worst");
    let line = |from: f64| json!({ "from": from, "length": 1.0, "cells": CELLS });
    case["body"] = json!({ "lines": [line(0.0), line(2.0)] });
    case["supports"] = json!([0.0, 2.0].map(|x| json!({ "at": { "x": x }, "w": 0.0, "phi": 0.0 })));
    case["loads"] = json!(
        [[1.0, 1.0], [3.0, 0.5]].map(|[x, force]| json!({ "point": { "at": { "x": x }, "force": force } }))
    );
    case["probes"][0]["at"]["x"] = json!(2.0);
    let (told, _) = run(&case, None);
    let first = told.events.iter().find(|e| e.island_points > 0).expect("the first line");
    assert_eq!((first.broken, first.island_points), (3, CELLS));
    // Now the other one bears what one alone does, under its smaller load.
    assert!(relative(-first.load, first_load(CURVATURE)) < 1e-9, "{first:?}");
    assert!(relative(first.load_factor, 2.0 * told.events[0].load_factor) < 1e-9, "{first:?}");
    let last = told.events.last().expect("there is one");
    assert_eq!((last.broken, last.island_points), (6, 2 * CELLS));
    // The loads of what has come off do no more work. Measured 6e-16.
    assert!(told.events.iter().all(|e| e.balance.abs() < 1e-12), "{:?}", told.events);
}

#[test]
fn what_is_held_and_moves_without_strain_ends_where_the_last_bond_broke() {
    for strategy in ["worst", "batch", "all"] {
        let mut case = cantilever(strategy);
        // The clamp is turned; two supports are left of a beam that it cannot bend any more, and one of them moves.
        case["supports"] = json!([
            { "at": { "x": 0.0 }, "w": 0.0, "phi": 1.0 },
            { "at": { "x": 0.5 }, "w": 0.0 },
            { "at": { "x": 1.0 }, "w": 0.001 }
        ]);
        case["loads"] = json!([]);
        let (told, report) = run(&case, None);
        let [.., before, last] = &told.events[..] else { panic!("{strategy}: it broke") };
        assert_eq!((last.load_factor, last.island_points), (before.load_factor, 0), "{strategy}");
        assert_eq!(report.fracture.expect("it broke").ending, "nothing carries the load any more");
        // A straight line through the supports, as far as they are moved. Measured 4e-17.
        let state = told.states.last().expect("recorded");
        for point in 1..=CELLS {
            let found = state.value(FieldName::W, 0, point).expect("an unknown");
            let x = point as f64 / CELLS as f64;
            let expected = 0.002 * last.load_factor * (x - 0.5);
            assert!((found - expected).abs() < 1e-14, "{strategy} at {x}: {found}, not {expected}");
        }
    }
}

#[test]
fn a_resumed_run_ends_as_if_it_had_not_stopped() {
    let mut case = cantilever("worst");
    case["supports"][0]["ux"] = json!(0.0);
    case["loads"][0]["point"]["axial"] = json!(3.0);
    let (whole, _) = run(&case, None);
    for solve in [0, 1] {
        let (rest, _) = run(&case, Some(whole.restarts[solve].clone()));
        assert_eq!(rest.events, whole.events[solve + 1..], "{solve}");
    }
}

#[test]
fn a_law_that_is_far_from_the_exact_one_before_the_first_break_is_told() {
    for (law, told) in [("exact", false), ("corrected", true)] {
        let mut case = cantilever("worst");
        case["body"]["line"]["cells"] = json!(2);
        case["model"]["timoshenko_beam"]["bond_law"] = json!(law);
        let (_, report) = run(&case, None);
        let text = report.warnings.into_report("case", "").to_string();
        assert_eq!(text.contains("% from the exact one in deflection at x = 1"), told, "{law}: {text}");
    }
}

#[test]
fn what_beams_cannot_do_when_they_break_is_refused() {
    let change = |key: &str, value: Value| {
        let mut case = cantilever("worst");
        case[key] = value;
        case
    };
    let fracture = |key: &str, value: Value| {
        let mut case = cantilever("worst");
        case["fracture"][key] = value;
        case
    };
    let model = |key: &str, value: Value| {
        let mut case = cantilever("worst");
        case["model"]["timoshenko_beam"][key] = value;
        case
    };
    let no_area = json!({ "bending": { "uniform": 2.0 }, "shear": { "uniform": 900.0 } });
    let mut areal = fracture("critical", json!({ "energy_release_rate": 1.0 }));
    areal["model"]["timoshenko_beam"]["stiffness"] = no_area;
    let frame = json!({ "frame": {
        "joints": [{ "name": "A", "x": 0.0, "y": 0.0 }, { "name": "B", "x": 1.0, "y": 0.0 }],
        "members": [{ "name": "m", "from": "A", "to": "B", "cells": 10 }] } });
    let closed =
        json!([{ "closed_form": { "name": "cantilever_tip_force", "field": "w", "tolerance": 1e-4 } }]);
    let steps = json!({ "load_factors": [0.5, 1.0] });
    for (case, message) in [
        (model("end_treatment", json!("ghost")), "the end treatment `ghost` has images of bonds"),
        (change("body", frame), "members of a frame do not break"),
        (change("checks", closed), "closed forms are for beams that do not break"),
        (change("solver", json!("band")), "keeps a sparse factor from equilibrium to equilibrium"),
        (change("solver", json!("strain")), "keeps a sparse factor from equilibrium to equilibrium"),
        (change("steps", steps), "`steps` and `fracture` do not go together"),
        (fracture("no_fail", json!(["left"])), "`no_fail` is for bodies in the plane"),
        (fracture("critical", json!({})), "`curvature` or `shear_strain` is missing"),
        (fracture("critical", json!({ "stretch": 1.0, "curvature": 1.0 })), "`stretch` is for another model"),
        (fracture("critical", json!({ "curvature": 1.0, "energy_release_rate": 1.0 })), "are both given"),
        (fracture("critical", json!({ "shear_strain": -1.0 })), "`shear_strain` must be greater than zero"),
        (areal, "`energy_release_rate` needs the area of the section"),
        (fracture("load", json!("Q")), "there is no probe `Q`"),
    ] {
        let text = refusal(&case);
        assert!(text.contains(message), "{message}\n{text}");
    }
}
