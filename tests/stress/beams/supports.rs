//! Beams that are all but mechanisms: on springs and foundations next to nothing, or next to rigid.

use super::{Beam, MODEL, STANDARDS};
use crate::stress::row::{Row, decades};
use serde_json::{Value, json};

pub(super) fn rows() -> Vec<Row> {
    [springs(), exact_springs(), motions(), bedded(), bent_on_a_bed()].concat()
}

fn springs() -> Vec<Row> {
    let mut rows = Vec::new();
    for stiffness in decades(-12, 12, 2) {
        for (cells, solver) in [4, 100, 2000].into_iter().flat_map(|n| ["auto", "band"].map(|s| (n, s))) {
            let beam = Beam::unit(20.0, cells, solver);
            let at = format!("k = {stiffness:.0e} EI/L³, {}", beam.name());
            let row = |supports: Value| {
                let mut case = beam.case();
                case["supports"] = supports;
                case["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "force": 1.0 } }]);
                Row::new(MODEL, "springs, almost mechanisms", at.clone(), case, cells)
            };
            let tip = STANDARDS[0].form;
            let [own, turn] = tip(1.0, 1.0, 1.0 / beam.shear);
            // A spring at the tip takes its share; the rest bends the beam.
            let left = 1.0 / (1.0 + stiffness * own);
            let propped = row(
                json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, { "at": { "x": 1.0 }, "w_spring": stiffness }]),
            );
            let propped = beam.bears(propped, 0.25, |z| [left * (1.0 - z), left]);
            rows.push(beam.expect_at(propped, 1.0, [own * left, turn * left]));
            // Hinged at one end on a spring against turning: a mechanism but for it.
            let hinged = row(json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi_spring": stiffness }]));
            let hinged = beam.bears(hinged, 0.25, |z| [1.0 - z, 1.0]);
            rows.push(beam.expect_at(hinged, 1.0, [own + 1.0 / stiffness, turn + 1.0 / stiffness]));
            // On a spring and a pin: the force over the spring.
            let seesaw =
                row(json!([{ "at": { "x": 0.0 }, "w_spring": stiffness }, { "at": { "x": 0.5 }, "w": 0.0 }]));
            let seesaw = beam.bears(beam.bears(seesaw, 0.25, |z| [z, -1.0]), 0.75, |z| [1.0 - z, 1.0]);
            let [arm, _] = tip(1.0, 0.125, 0.5 / beam.shear);
            let lean = 1.0 / stiffness;
            rows.push(beam.expect_at(seesaw, 1.0, [2.0 * arm + lean, 2.0 * arm + 2.0 * lean + 0.125]));
        }
    }
    rows
}

/// Springs that are powers of two under moments that leave what they need to the last bit, on so few cells that sums are exact.
fn exact_springs() -> Vec<Row> {
    let mut rows = Vec::new();
    for (cells, exponent) in [1, 2, 3, 4, 8, 50].into_iter().flat_map(|n| (2..=48).map(move |e| (n, e))) {
        for (slender, solver) in [1.0, 50.0].into_iter().flat_map(|s| ["band", "sparse"].map(|k| (s, k))) {
            let ratio = f64::from(cells.min(3));
            let beam = Beam { ratio, ..Beam::unit(slender, cells as usize, solver) };
            let spring = 2_f64.powi(-exponent);
            let mut case = beam.case();
            case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi_spring": spring }]);
            case["loads"] = json!([
                { "point": { "at": { "x": 1.0 }, "moment": 1.0 } },
                { "point": { "at": { "x": 0.0 }, "moment": spring - 1.0 } }
            ]);
            let at = format!("2^-{exponent} EI/L, L/h = {slender}, {}", beam.name());
            let row = Row::new(MODEL, "springs without rounding", at, case, beam.cells);
            // It turns by 1 on the spring and bends by 1/2.
            let row = beam.bears(row, 0.75, |_| [1.0, 0.0]);
            rows.push(beam.expect(row, &[0, beam.cells], |z| [z + z * z / 2.0, 1.0 + z]));
        }
    }
    rows
}

fn motions() -> Vec<Row> {
    let mut rows = Vec::new();
    for by in [1e-200, 1e-60, 1e-10, 1.0, 1e10, 1e60, 1e200] {
        for (slender, cells) in [1.0, 1e3, 1e6].into_iter().flat_map(|s| [10, 1000].map(|n| (s, n))) {
            for solver in ["auto", "band"] {
                let beam = Beam::unit(slender, cells, solver);
                let mut case = beam.case();
                case["supports"] = json!([
                    { "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, { "at": { "x": 1.0 }, "w": by, "phi": 0.0 }
                ]);
                let row = Row::new(
                    MODEL,
                    "prescribed motions of 1e±200",
                    format!("{by:.0e}, L/h = {slender:.0e}, {}", beam.name()),
                    case,
                    cells,
                );
                // Settlement of a clamped end, w = δ (z² (3 − 2 z) + Φ z)/(1 + Φ), Φ = 12 EI/(κGA L²).
                let phi = 12.0 / beam.shear;
                rows.push(beam.expect(row, &[0, cells / 2, cells], |z| {
                    let share = by / (1.0 + phi);
                    [share * (z * z * (3.0 - 2.0 * z) + phi * z), share * 6.0 * z * (1.0 - z)]
                }));
            }
        }
    }
    rows
}

fn bedded() -> Vec<Row> {
    let mut rows = Vec::new();
    for stiffness in decades(-12, 12, 2) {
        for (cells, slender) in [4, 100, 2000].into_iter().flat_map(|n| [1.0, 1e4].map(|s| (n, s))) {
            let beam = Beam::unit(slender, cells, "auto");
            let mut case = beam.case();
            case["foundation"] = json!([{ "stiffness": { "uniform": stiffness } }]);
            case["loads"] = json!([{ "distributed": { "force": { "uniform": 1.0 } } }]);
            // It sinks as a whole.
            let row = Row::new(
                MODEL,
                "foundation",
                format!("k = {stiffness:.0e} EI/L⁴, L/h = {slender:.0e}, {}", beam.name()),
                case,
                cells,
            );
            rows.push(beam.expect(row, &[0, cells / 2, cells], |_| [1.0 / stiffness, 0.0]));
        }
    }
    rows
}

/// A bed that is too soft to take much part in bending by moments at the ends: w = x²/2 − 1/24 from the middle makes the bed
/// bear 1/384 of its stiffness there.
fn bent_on_a_bed() -> Vec<Row> {
    let mut rows = Vec::new();
    for stiffness in decades(-16, -8, 1) {
        for (cells, slender) in [100, 2000].into_iter().flat_map(|n| [1.0, 1e2, 1e4].map(|s| (n, s))) {
            let beam = Beam::unit(slender, cells, "auto");
            let mut case = beam.case();
            case["foundation"] = json!([{ "stiffness": { "uniform": stiffness } }]);
            case["loads"] = json!([
                { "point": { "at": { "x": 0.0 }, "moment": -1.0 } }, { "point": { "at": { "x": 1.0 }, "moment": 1.0 } }
            ]);
            let at = format!("k = {stiffness:.0e} EI/L⁴, L/h = {slender:.0e}, {}", beam.name());
            let row = Row::new(MODEL, "foundation under a bent beam", at, case, cells);
            rows.push(beam.bears(row, 0.5, |_| [1.0 - stiffness / 384.0, 0.0]));
        }
    }
    rows
}
