//! The default bond law on the grids that users of other programs take: a few cells per member, or one. And what is said
//! of the other laws there.

use crate::support::plane_frame::Frame;
use crate::support::sections::{all_ends, at, difference, ends};
use crate::support::standard::{SECTIONS, Standard};
use crate::support::{Run, relative, run, run_recovered};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// A clamped beam of four cells under a uniform load.
fn four_cells() -> Value {
    json!({
        "title": "t",
        "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 100.0 }, "shear": { "uniform": 1000000.0 } } } },
        "body": { "line": { "length": 2.0, "cells": 4 } },
        "supports": [{ "at": { "x": 0 }, "w": 0, "phi": 0 }, { "at": { "x": 2 }, "w": 0, "phi": 0 }],
        "loads": [{ "distributed": { "force": { "uniform": 1 } } }],
        "probes": [{ "name": "M", "at": { "x": 0 }, "field": "M" }, { "name": "w", "at": { "x": 1 }, "field": "w" }]
    })
}

/// A cantilever of one cell under a force.
fn one_cell() -> Value {
    json!({
        "title": "t",
        "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 100.0 }, "shear": { "uniform": 1000000.0 } } } },
        "body": { "line": { "length": 2.0, "cells": 1 } },
        "supports": [{ "at": { "x": 0 }, "w": 0, "phi": 0 }],
        "loads": [{ "point": { "at": { "x": 2 }, "force": 1 } }],
        "probes": [{ "name": "w", "at": { "x": 2 }, "field": "w" }]
    })
}

fn with_law(mut case: Value, law: &str) -> Value {
    case["model"]["timoshenko_beam"]["bond_law"] = json!(law);
    case
}

/// Warnings of the case, then those of its run, which name the bond law alone.
fn told(run: &Run) -> Vec<String> {
    let mut warnings = run.scene.warnings.clone();
    warnings.append(run.report.warnings.clone());
    warnings.into_report("case", "").diagnostics.iter().map(|d| d.message.clone()).collect()
}

fn told_of(case: &Value) -> Vec<String> {
    told(&run(case))
}

#[test]
fn four_cells_and_one_are_exact_by_default() {
    let clamped = run_recovered(&four_cells());
    // q L⁴/(384 EI) + q L²/(8 S), and q L²/12 at the clamps. Measured 3e-16 and 2e-16.
    assert!(relative(clamped.w(2), 16.0 / 38400.0 + 4.0 / 8e6) <= 1e-13, "{}", clamped.w(2));
    let moment = at(&clamped, FieldName::M, 0, 0).abs();
    assert!(relative(moment, 1.0 / 3.0) <= 1e-13, "{moment}");
    // F L³/(3 EI) + F L/S. Measured 1e-16.
    let cantilever = run(&one_cell());
    assert!(relative(cantilever.w(1), 8.0 / 300.0 + 2e-6) <= 1e-13, "{}", cantilever.w(1));
    // The horizon of three cells does nothing, so nothing is said of it.
    assert_eq!(told(&clamped).len() + told(&cantilever).len(), 0);
}

#[test]
fn frames_of_twelve_cells_per_member_and_of_one_are_right_by_default() {
    for cells in [1, 12] {
        for seed in 0..20 {
            let mut frame = Frame::random(seed);
            frame.members.iter_mut().for_each(|member| member.cells = cells);
            let mut case = frame.case();
            case["model"]["timoshenko_beam"].as_object_mut().expect("keys").remove("bond_law");
            let (run, answer) = (run_recovered(&case), frame.answer());
            // Measured 7e-13 at worst.
            let error = difference(&all_ends(&run), &answer.sections);
            assert!(error <= 1e-11, "{cells} cells, seed {seed}: section forces differ by {error:e}");
            assert!(told(&run).is_empty(), "{cells} cells, seed {seed}: {:?}", told(&run));
        }
    }
}

/// Two bars that are hinged at all ends, those on the supports, where nothing else ends, included.
fn two_bars(cells: usize) -> Value {
    let member = |name: &str, from: &str, to: &str| json!({ "name": name, "from": from, "to": to, "cells": cells, "hinges": ["from", "to"] });
    json!({
        "title": "two-bar truss, all ends hinged",
        "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 1e3 }, "shear": { "uniform": 1e5 }, "axial": { "uniform": 1e6 } } } },
        "body": { "frame": {
            "joints": [{ "name": "A", "x": 0, "y": 0 }, { "name": "B", "x": 1, "y": 1 }, { "name": "C", "x": 2, "y": 0 }],
            "members": [member("a", "A", "B"), member("b", "B", "C")] } },
        "supports": [{ "at": { "joint": "A" }, "ux": 0, "uy": 0 }, { "at": { "joint": "C" }, "ux": 0, "uy": 0 }],
        "loads": [{ "point": { "at": { "joint": "B" }, "force_y": -1 } }],
        "probes": [{ "name": "N", "at": { "member": "a", "x": 0 }, "field": "N" }]
    })
}

#[test]
fn a_truss_of_one_cell_per_member_with_hinges_at_all_ends_is_that_of_statics() {
    for cells in [1, 2, 4] {
        let run = run_recovered(&two_bars(cells));
        for member in 0..2 {
            for [n, v, m] in ends(&run, member) {
                // −F/(2 sin 45°). Measured 2e-16.
                assert!(relative(n, -(0.5_f64.sqrt())) <= 1e-14, "{cells} cells: {n}");
                assert!(v.abs().max(m.abs()) <= 1e-14, "{cells} cells: {v} {m}");
            }
        }
        // F L/(2 EA sin² 45°) with L = √2. Measured 2e-16.
        let sag = at(&run, FieldName::Uy, 0, cells);
        assert!(relative(sag, -1e-6 * 2.0_f64.sqrt()) <= 1e-14, "{cells} cells: {sag}");
        assert!(told(&run).is_empty(), "{:?}", told(&run));
    }
}

#[test]
fn a_hinge_at_a_free_end_changes_nothing() {
    let arm = |hinges: Value| {
        json!({
            "title": "t", "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 1.0 }, "shear": { "uniform": 50.0 } } } },
            "body": { "frame": { "joints": [{ "name": "A", "x": 0, "y": 0 }, { "name": "B", "x": 2, "y": 0 }],
                                 "members": [{ "name": "m", "from": "A", "to": "B", "cells": 2, "hinges": hinges }] } },
            "supports": [{ "at": { "joint": "A" }, "uy": 0, "phi": 0 }],
            "loads": [{ "point": { "at": { "joint": "B" }, "force_y": -1 } }]
        })
    };
    let [plain, hinged] = [json!([]), json!(["to"])].map(|hinges| run(&arm(hinges)).unknowns(0));
    assert_eq!(plain, hinged);
}

#[test]
fn other_laws_say_how_far_they_are_from_the_exact_one() {
    // 57.5 % at mid-span. One cell: the bond has the shear stiffness of ⟨ξ²⟩ = 5 h², which adds (5 − 1) F L³/(12 EI).
    let (clamped, cantilever) = (four_cells(), one_cell());
    let slender = Standard::named("clamped ends, uniform load").unsplit(&SECTIONS[3], "published", 192);
    for (case, start) in [
        (
            with_law(clamped.clone(), "corrected"),
            "the law `corrected` is 57.5 % from the exact one in deflection at x = 1",
        ),
        (
            with_law(cantilever, "corrected"),
            "the law `corrected` is 100 % from the exact one in deflection at x = 2",
        ),
        // It locks.
        (slender, "the law `published` is 42.7 % from the exact one in deflection at x = 0.5"),
    ] {
        let told = told_of(&case);
        assert!(told.iter().any(|text| text == start), "{start}: {told:?}");
    }
    for law in ["corrected", "published"] {
        // 2.5e-5 and 2e-4 at 96 cells.
        let mut fine = with_law(clamped.clone(), law);
        fine["body"]["line"]["cells"] = json!(96);
        fine["horizon_ratio"] = json!(1);
        assert!(told_of(&fine).is_empty(), "{law}: {:?}", told_of(&fine));
    }
}

#[test]
fn of_moved_supports_the_energy_tells_how_far_a_law_is_off() {
    let mut case = with_law(one_cell(), "corrected");
    case["loads"] = json!([]);
    case["supports"].as_array_mut().expect("a list").push(json!({ "at": { "x": 2 }, "w": 1 }));
    // Both deflections are prescribed; twice the compliance takes half the force.
    let told = told_of(&case);
    let expected = "the law `corrected` is 50.0 % from the exact one in energy";
    assert!(told.iter().any(|text| text == expected), "{expected}: {told:?}");
    // A line that only turns is not strained.
    case["supports"][0] = json!({ "at": { "x": 0 }, "w": 0 });
    case["horizon_ratio"] = json!(1);
    assert!(told_of(&case).is_empty(), "{:?}", told_of(&case));
}

#[test]
fn the_state_and_the_member_are_named() {
    let mut case = with_law(four_cells(), "corrected");
    case["loads"] = json!([]);
    let load = |x: f64, force: f64| json!([{ "point": { "at": { "x": x }, "force": force } }]);
    case["load_cases"] =
        json!([{ "name": "left", "loads": load(0.5, 1.0) }, { "name": "right", "loads": load(1.5, 1.0) }]);
    case["combinations"] = json!([{ "name": "both", "factors": { "left": 1.0, "right": 1.0 } }]);
    let told = told_of(&case);
    let named = |text: &String| text.contains(" in deflection at x = ") && text.ends_with('`');
    assert!(told.iter().any(named), "{told:?}");
    let mut frame = with_law(two_bars(4), "corrected");
    frame["loads"] = json!([{ "distributed": { "member": "a", "force": { "uniform": 1.0 } } }]);
    let told = told_of(&frame);
    assert!(told.iter().any(|text| text.ends_with("of member `a`")), "{told:?}");
}
