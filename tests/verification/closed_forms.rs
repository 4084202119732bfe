//! Every closed form that a case may name, on the case it belongs to; and the tabulated values of the standard cases.

use crate::support::standard::{CASES, SECTIONS, steel};
use crate::support::{relative, run};
use peristat::reference;
use peristat::solve_text;
use serde_json::{Value, json};

/// Supports and loads of the references that are met to rounding; `None` for the others.
fn setting(name: &str) -> Option<(Value, Value)> {
    let clamp = |x: f64| json!({ "at": { "x": x }, "w": 0.0, "phi": 0.0 });
    let roller = |x: f64| json!({ "at": { "x": x }, "w": 0.0 });
    let guide = json!({ "at": { "x": 1.0 }, "phi": 0.0 });
    let cantilever = json!([clamp(0.0)]);
    let simple = json!([roller(0.0), roller(1.0)]);
    let clamped = json!([clamp(0.0), clamp(1.0)]);
    let force = |x: f64| json!([{ "point": { "at": { "x": x }, "force": 7.0 } }]);
    let spread = |load: Value| json!([{ "distributed": load }]);
    let uniform = spread(json!({ "force": { "uniform": -7.0 } }));
    let moment = spread(json!({ "moment": { "uniform": 7.0 } }));
    Some(match name {
        "cantilever_tip_force" => (cantilever, force(1.0)),
        "cantilever_end_moment" => (cantilever, json!([{ "point": { "at": { "x": 1.0 }, "moment": 7.0 } }])),
        "cantilever_uniform" => (cantilever, uniform),
        "cantilever_uniform_moment" => (cantilever, moment),
        "simply_supported_uniform" => (simple, uniform),
        "simply_supported_mid_force" => (simple, force(0.5)),
        "simply_supported_uniform_moment" => (simple, moment),
        "simply_supported_sine" => {
            (simple, spread(json!({ "force": { "sine": { "amplitude": 7.0, "half_waves": 3 } } })))
        }
        "clamped_clamped_uniform" => (clamped, uniform),
        "clamped_clamped_mid_force" => (clamped, force(0.5)),
        "clamped_simply_supported_uniform" => (json!([clamp(0.0), roller(1.0)]), uniform),
        "clamped_guided_uniform" => (json!([clamp(0.0), guide]), uniform),
        "clamped_guided_tip_force" => (json!([clamp(0.0), guide]), force(1.0)),
        "two_span_uniform" => (json!([roller(0.0), roller(0.5), roller(1.0)]), uniform),
        "simply_supported_sine_discrete" | "simply_supported_sine_nonlocal" => return None,
        // Second order, whatever the bond law: `foundation` has them.
        "simply_supported_sine_foundation" | "free_free_foundation_mid_force" => return None,
        other => panic!("the new reference `{other}` needs a case here"),
    })
}

/// Errors of w, φ, the energy, M and V of a reference, each relative to its largest value.
fn errors(name: &str, height: f64, cells: usize) -> Option<[f64; 5]> {
    let (supports, loads) = setting(name)?;
    let mut case = steel(height, "exact", cells);
    case["supports"] = supports;
    case["loads"] = loads;
    let check = |field: &str| json!({ "closed_form": { "name": name, "field": field, "tolerance": 1.0 } });
    case["checks"] = ["w", "phi", "energy", "M", "V"].map(check).to_vec().into();
    let solved = solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{name}: {error}"));
    let errors: Vec<f64> = solved.summary.checks.iter().map(|c| c.error).collect();
    Some(errors.try_into().expect("five checks"))
}

/// Checks every local reference. Bonds do not know the bending of a load between their ends, so under distributed
/// loads the stored energy is only second order.
fn all_are_met(height: f64, cells: usize, nodal: f64) {
    let n = cells as f64;
    let point_load = |name: &str| name.contains("force") || name.contains("end_moment");
    let mut met = 0;
    for name in reference::TABLE.iter().map(|r| r.name) {
        if let Some(errors) = errors(name, height, cells) {
            // Measured 7e-15; 3e-14 for 1e5 cells.
            // A distributed moment between simple supports bends nothing and only shears: what rounding leaves of its
            // couples still bends.
            let shear_only = name == "simply_supported_uniform_moment";
            let nodal = if shear_only { nodal.max(1e-15 * height.powi(-2)) } else { nodal };
            // Second order under distributed loads, measured 18/n². A beam that only shears stores next to nothing else.
            let energy = match (point_load(name), shear_only) {
                (true, _) => nodal,
                (false, false) => 20.0 / (n * n),
                (false, true) => 1.0,
            };
            // Section forces follow the reactions, which carry the rounding of unknowns near a support times the stiffness
            // of a bond: measured 3e-13 at slenderness 20, 6e-9 at 1e4 with 1e5 cells.
            let section = 5e-13 + 1e-15 * f64::min(n * n, height.powi(-2));
            let bounds = [nodal, nodal, energy, section, section];
            let fine = errors.iter().zip(bounds).all(|(e, b)| *e <= b);
            assert!(fine, "{name}, height {height}, {cells} cells: {errors:?} for {bounds:?}");
            met += 1;
        }
    }
    assert_eq!(met, 14, "all references but the two nonlocal ones");
}

#[test]
fn every_local_closed_form_is_met_in_all_its_fields() {
    for section in SECTIONS {
        for cells in [10, 100, 1000] {
            all_are_met(section.height, cells, 1e-13);
        }
    }
}

#[test]
fn every_local_closed_form_is_met_on_a_hundred_thousand_cells() {
    for section in [SECTIONS[1], SECTIONS[3]] {
        all_are_met(section.height, 100_000, 1e-12);
    }
}

/// What a row of the table gives.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Quantity {
    W(usize),
    Phi(usize),
    /// Reaction force at the last support over −qL.
    LastReaction,
    /// Moment at the first support: M(0) is the negative of the clamp's moment on the beam, over qL².
    FirstMoment,
}

/// Closed forms evaluated with E = 200 GPa, ν = 0.3, κ = 5/6, b = 0.05 m, L = 1 m for the four sections; all digits
/// that are not zero, or 13.
const TARGETS: [(usize, Quantity, [f64; 4]); 18] = {
    use Quantity::{FirstMoment, LastReaction, Phi, W};
    [
        (0, W(20), [0.05156, 0.00320624, 0.004000312, 0.0040000000312]),
        (0, Phi(20), [0.075, 0.0048, 0.006, 0.006]),
        (1, W(20), [0.075, 0.0048, 0.006, 0.006]),
        (1, Phi(20), [0.15, 0.0096, 0.012, 0.012]),
        (2, W(20), [0.1953, 0.0120312, 0.01500156, 0.015000000156]),
        (2, Phi(20), [0.25, 0.016, 0.02, 0.02]),
        (3, W(10), [0.02148125, 0.0012578, 0.00156289, 0.001562500039]),
        (3, Phi(0), [0.0625, 0.004, 0.005, 0.005]),
        (4, W(10), [0.003515, 0.00020156, 0.000250078, 0.0002500000078]),
        (4, Phi(0), [0.009375, 0.0006, 0.00075, 0.00075]),
        (5, W(10), [0.00585625, 0.0002578, 0.00031289, 0.000312500039]),
        (5, Phi(5), [0.01171875, 0.00075, 0.0009375, 0.0009375]),
        (6, W(10), [0.01011706264546, 0.0005092596536753, 0.0006254631192967, 0.0006250000463125]),
        (6, Phi(20), [-0.03408650116369, -0.002011677229403, -0.002500584954374, -0.0025000000585]),
        (6, LastReaction, [0.3787820015516, 0.3752432756126, 0.3750097492396, 0.375000000975]),
        (7, W(20), [0.0703, 0.0040312, 0.00500156, 0.005000000156]),
        (7, FirstMoment, [1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0]),
        (7, Phi(0), [0.0, 0.0, 0.0, 0.0]),
    ]
};

#[test]
fn tabulated_values_of_the_standard_cases_are_met() {
    for (index, quantity, targets) in TARGETS {
        for (section, target) in SECTIONS.iter().zip(targets) {
            let run = run(&CASES[index].case(section, "exact", 20));
            let [w, phi] = run.unknowns(0);
            let reactions = &run.states[0].reactions;
            let found = match quantity {
                Quantity::W(point) => w[point],
                Quantity::Phi(point) => phi[point],
                Quantity::LastReaction => -reactions[reactions.len() - 1].force / section.uniform,
                Quantity::FirstMoment => -reactions[0].moment / section.uniform,
            };
            let error = if target == 0.0 { found.abs() } else { relative(found, target) };
            // Measured 2e-13: the digits of the table.
            assert!(error <= 2e-12, "{}, {quantity:?}, {section:?}: {found}", CASES[index].name);
        }
    }
}
