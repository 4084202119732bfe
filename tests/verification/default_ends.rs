//! What is said of beams that are not exact on few cells: other ends, grids of cells, lumped loads.

use crate::support::run;
use peristat::diagnostic::Diagnostic;
use serde_json::{Value, json};

/// A beam under a uniform load, clamped at both ends or on simple supports, with other keys of its model and its line.
fn with_ends(is_clamped: bool, model: &[(&str, &str)], grid: &str, cells: usize) -> Value {
    let end = |x: f64| match is_clamped {
        true => json!({ "at": { "x": x }, "w": 0, "phi": 0 }),
        false => json!({ "at": { "x": x }, "w": 0 }),
    };
    let mut case = json!({
        "title": "t",
        "model": { "timoshenko_beam": { "stiffness": { "bending": { "uniform": 100.0 }, "shear": { "uniform": 1000000.0 } } } },
        "body": { "line": { "length": 2.0, "cells": cells, "grid": grid } },
        "supports": [end(0.0), end(2.0)],
        "loads": [{ "distributed": { "force": { "uniform": 1 } } }]
    });
    for (key, value) in model {
        case["model"]["timoshenko_beam"][key] = json!(value);
    }
    case
}

/// What its run warns of.
fn warned(case: &Value) -> Vec<Diagnostic> {
    run(case).report.warnings.into_report("case", "").diagnostics
}

fn told(case: &Value) -> Vec<String> {
    warned(case).into_iter().map(|diagnostic| diagnostic.message).collect()
}

#[test]
fn ends_grids_and_loads_say_how_far_they_are_from_the_exact_beam() {
    let [truncated, ghost, image] = ["truncated", "ghost", "image"].map(|name| [("end_treatment", name)]);
    for (case, expected) in [
        // 3.4 times the deflection of the local beam at that point, q x² (L − x)²/(24 EI) + q x (L − x)/(2 S).
        (
            with_ends(true, &[], "cells", 4),
            "with the grid `cells` is 240 % from the exact one in deflection at x = 1.25",
        ),
        (with_ends(true, &[], "cells", 32), "with the grid `cells` is 16.6 % from the exact one"),
        (with_ends(true, &[], "cells", 256), "with the grid `cells` is 2.5 % from the exact one"),
        (with_ends(false, &[], "cells", 4), "with the grid `cells` is 4.2 % from the exact one"),
        (
            with_ends(true, &truncated, "nodes", 32),
            "with the end treatment `truncated` is 55.2 % from the exact one",
        ),
        (
            with_ends(false, &truncated, "nodes", 8),
            "with the end treatment `truncated` is 14.4 % from the exact one",
        ),
        (with_ends(true, &ghost, "nodes", 8), "with the end treatment `ghost` is 14.6 % from the exact one"),
        (with_ends(true, &image, "nodes", 8), "with the end treatment `image` is 5.3 % from the exact one"),
        (
            with_ends(false, &[("bond_law", "published"), image[0]], "cells", 8),
            "with the law `published`, the end treatment `image` and the grid `cells` is 87.5 % from the exact one",
        ),
        (
            with_ends(true, &[("distributed_loads", "lumped")], "nodes", 4),
            "with `lumped` loads is 8.8 % from the exact one",
        ),
    ] {
        let told = told(&case);
        assert!(
            told.iter().any(|text| text.starts_with(&format!("the beam {expected}"))),
            "{expected}: {told:?}"
        );
    }
    // 0.90 %, 0.22 % and 0.09 %.
    for fine in [
        with_ends(true, &ghost, "nodes", 256),
        with_ends(false, &truncated, "nodes", 32),
        with_ends(false, &[], "cells", 32),
    ] {
        assert!(told(&fine).is_empty(), "{:?}", told(&fine));
    }
}

#[test]
fn what_is_to_be_left_out_is_named_and_where_it_is_written() {
    let [only] = &warned(&with_ends(true, &[], "cells", 4))[..] else { panic!("one warning") };
    assert_eq!(only.path.to_string(), "body.line.grid");
    // Ghosts that are written would stay on a grid of nodes.
    let hint = only.hint.as_ref().expect("a hint");
    assert!(hint.starts_with("leave `grid`, `end_treatment` out"), "{hint}");
    let [only] = &warned(&with_ends(true, &[("bond_law", "corrected")], "nodes", 4))[..] else {
        panic!("one warning")
    };
    assert_eq!(only.path.to_string(), "model.timoshenko_beam.bond_law");
}
