//! The discretisation of the literature, with its known errors: points in the middle of cells, ghost points, lumped
//! loads.

use crate::support::standard::{SECTIONS, Standard};
use crate::support::{relative, run};
use serde_json::json;

/// Deflection at the 50th and the last of 100 points.
fn found(name: &str, volume_factor: &str) -> [f64; 2] {
    let mut case = Standard::named(name).case(&SECTIONS[1], "published", 100);
    case["body"]["line"]["grid"] = json!("cells");
    case["model"]["timoshenko_beam"]["end_treatment"] = json!("ghost");
    case["model"]["timoshenko_beam"]["volume_factor"] = json!(volume_factor);
    let run = run(&case);
    [run.w(49), run.w(99)]
}

/// Compares with quadruple-precision solutions of the same discrete equations, 12 digits.
fn compare(volume_factor: &str, expected: [(&str, usize, f64); 4]) {
    for (name, end, expected) in expected {
        let found = found(name, volume_factor)[end];
        let error = relative(found, expected);
        // A18 and A19, measured 3.4e-12: the digits of the tables.
        assert!(error <= 1e-10, "{name}, {volume_factor}: {found} for {expected}");
    }
}

#[test]
fn full_volumes_and_ghosts_give_the_known_stiff_answer() {
    let expected = [
        ("simple supports, uniform load", 0, 0.000942817280723),
        ("clamped ends, uniform load", 0, 0.000207031619725),
        ("cantilever under a tip force", 1, 0.00243370286478),
        ("cantilever under a uniform load", 1, 0.00929056485693),
    ];
    compare("full", expected);
    // A quarter too stiff on purpose: (m + 1)/m with m = 3.
    let [middle, _] = found("simple supports, uniform load", "full");
    assert!((middle / 0.0012578 - 0.75).abs() < 1e-3, "{middle}");
}

#[test]
fn half_edge_volumes_and_ghosts_give_the_known_answer() {
    let expected = [
        ("simple supports, uniform load", 0, 0.00125719008955),
        ("clamped ends, uniform load", 0, 0.000274513510314),
        ("cantilever under a tip force", 1, 0.00323764162178),
        ("cantilever under a uniform load", 1, 0.0123505398357),
    ];
    compare("half_edge", expected);
}
