//! Reactions are the forces that hold the equations of supports, whatever else those equations meet: repetition, links,
//! ghost points. Values by statics.

use crate::support::standard::steel;
use crate::support::{Run, refusal, relative, run, run_recovered};
use peristat::case::FieldName;
use peristat::solve_text;
use serde_json::{Value, json};

fn with(mut case: Value, supports: Value, loads: Value) -> Value {
    case["supports"] = supports;
    case["loads"] = loads;
    case
}

fn tip(x: f64) -> Value {
    json!([{ "point": { "at": { "x": x }, "force": 1000.0 } }])
}

fn forces(run: &Run) -> Vec<f64> {
    run.states[0].reactions.iter().map(|r| r.force).collect()
}

fn assert_close(found: &[f64], expected: &[f64], bound: f64) {
    assert_eq!(found.len(), expected.len());
    for (f, e) in found.iter().zip(expected) {
        assert!((f - e).abs() <= bound * 1000.0, "{found:?} for {expected:?}");
    }
}

#[test]
fn a_support_that_repeats_another_carries_nothing() {
    let clamp = json!({ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 });
    let run = run(&with(steel(0.05, "exact", 40), json!([clamp, clamp]), tip(1.0)));
    // Measured 1e-13 or less.
    assert_close(&forces(&run), &[-1000.0, 0.0], 1e-12);
}

/// Two lines with a gap, joined by a rigid link, loaded at the far end.
fn linked(support: f64) -> Value {
    let mut case = steel(0.05, "exact", 10);
    case["body"] =
        json!({ "lines": [{ "length": 1.0, "cells": 10 }, { "from": 1.1, "length": 1.0, "cells": 20 }] });
    case["links"] = json!([{ "rigid": { "from": { "x": 1.0 }, "to": { "x": 1.1 } } }]);
    with(case, json!([{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": support }, "w": 0.0 }]), tip(2.1))
}

#[test]
fn a_support_on_either_end_of_a_link_takes_its_share_by_the_lever() {
    // Moments about x = 0: R a + 1000 · 2.1 = 0.
    for at in [1.0, 1.1] {
        let run = run(&linked(at));
        let far = -2100.0 / at;
        // Measured 1e-13.
        assert_close(&forces(&run), &[-1000.0 - far, far], 1e-12);
    }
}

#[test]
fn every_end_treatment_gives_the_reactions_of_statics() {
    for treatment in ["cover", "truncated", "ghost", "image"] {
        let mut case = steel(0.05, "corrected", 50);
        case["model"]["timoshenko_beam"]["end_treatment"] = treatment.into();
        let clamp = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
        let cantilever = run_recovered(&with(case.clone(), clamp, tip(1.0)));
        let reaction = &cantilever.states[0].reactions[0];
        // Measured 1e-14.
        assert_close(&[reaction.force, reaction.moment], &[-1000.0, -1000.0], 1e-12);
        let sections = cantilever.states[0].lines[0].forces.as_ref().expect("recovered");
        assert_close(&[sections.moment[0][0], sections.shear[0][0]], &[1000.0, 1000.0], 1e-12);
        let simple = json!([{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
        let uniform = json!([{ "distributed": { "force": { "uniform": 1000.0 } } }]);
        let run = run(&with(case, simple, uniform));
        assert_close(&forces(&run), &[-500.0, -500.0], 1e-12);
    }
}

#[test]
fn images_on_cells_cannot_clamp() {
    let mut case = steel(0.05, "corrected", 50);
    case["body"]["line"]["grid"] = "cells".into();
    case["model"]["timoshenko_beam"]["end_treatment"] = "image".into();
    let clamp = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
    let message = refusal(&with(case, clamp, tip(0.99)));
    assert!(message.contains("no point there to hold its deflection"), "{message}");
}

#[test]
fn extremes_see_both_sides_of_a_jump() {
    // Simple supports, moment 1000 at x = 0.6: M = −R x with R = 1000 to its left, so 600 there and −400 to the right.
    let supports = json!([{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
    let loads = json!([{ "point": { "at": { "x": 0.6 }, "moment": 1000.0 } }]);
    let run = run_recovered(&with(steel(0.05, "exact", 10), supports, loads));
    let [low, high] = run.states[0].extremes(FieldName::M).expect("recovered");
    // Measured 2e-15.
    assert!(relative(high.0, 600.0) <= 1e-12 && (high.1 - 0.6).abs() < 1e-12, "{high:?}");
    assert!(relative(low.0, -400.0) <= 1e-12 && (low.1 - 0.6).abs() < 1e-12, "{low:?}");
}

#[test]
fn the_shear_force_of_a_slender_beam_keeps_its_digits() {
    let clamp = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    let loads = json!([{ "distributed": { "force": { "uniform": 1e-4 } } }]);
    let run = run_recovered(&with(steel(1e-4, "exact", 10_000), clamp, loads));
    let sections = run.states[0].lines[0].forces.as_ref().expect("recovered");
    for (cell, shear) in sections.shear.iter().enumerate() {
        let x = cell as f64 / 10_000.0;
        // V = q (L − x); measured 5e-13 of q L.
        assert!((shear[0] - 1e-4 * (1.0 - x)).abs() <= 1e-11 * 1e-4, "{x}: {}", shear[0]);
    }
}

#[test]
fn a_closed_form_does_not_fit_a_beam_with_links() {
    let mut case = linked(1.0);
    case["body"] = json!({ "line": { "length": 1.0, "cells": 40 } });
    case["links"] = json!([{ "rigid": { "from": { "x": 0.25 }, "to": { "x": 0.75 } } }]);
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    case["loads"] = tip(1.0);
    case["checks"] =
        json!([{ "closed_form": { "name": "cantilever_tip_force", "field": "w", "tolerance": 1e-3 } }]);
    let message = refusal(&case);
    assert!(message.contains("does not fit this case"), "{message}");
}

#[test]
fn a_limit_holds_on_both_sides_of_a_jump() {
    // M is 600 to the left of the moment and −400 to its right.
    let supports = json!([{ "at": { "x": 0.0 }, "w": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0 }]);
    let loads = json!([{ "point": { "at": { "x": 0.6 }, "moment": 1000.0 } }]);
    let mut case = with(steel(0.05, "exact", 10), supports, loads);
    case["probes"] = json!([{ "name": "couple", "at": { "x": 0.6 }, "field": "M" }]);
    for (limit, passes) in [(500.0, false), (601.0, true)] {
        case["checks"] = json!([{ "limit": { "probe": "couple", "at_most": limit, "why": "capacity" } }]);
        let check = solve_text(&case.to_string()).unwrap().summary.checks[0].clone();
        assert_eq!(check.passed, passes, "{check:?}");
        assert!(relative(check.found, 600.0) <= 1e-12, "{check:?}");
    }
}
