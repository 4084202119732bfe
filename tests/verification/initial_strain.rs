//! Strains that lines and members have from the beginning: without forces where nothing holds them, and as heat where something does.

use crate::support::{Run, largest, run_recovered};
use peristat::case::FieldName;
use serde_json::{Value, json};

fn values(run: &Run, field: FieldName) -> Vec<f64> {
    (0..run.states[0].lines.len())
        .flat_map(|line| run.states[0].values(field, line).expect("recovered").into_owned())
        .collect()
}

fn portal(loads: &Value, foot: &Value) -> Value {
    json!({
        "title": "test", "thermal_expansion": 1e-3,
        "model": { "timoshenko_beam": { "youngs_modulus": 1e4, "poisson_ratio": 0.25, "section": { "rectangle": { "width": 0.2, "height": 0.4 } } } },
        "body": { "frame": {
            "joints": [ { "name": "A", "x": 0, "y": 0 }, { "name": "B", "x": 0.5, "y": 3 }, { "name": "C", "x": 4, "y": 3 }, { "name": "D", "x": 4, "y": 0 } ],
            "members": [ { "name": "left", "from": "A", "to": "B", "cells": 5 }, { "name": "beam", "from": "B", "to": "C", "cells": 7 }, { "name": "right", "from": "D", "to": "C", "cells": 3 } ] } },
        "supports": [ { "at": { "joint": "A" }, "ux": 0, "uy": 0, "phi": 0 }, foot ], "loads": loads
    })
}

#[test]
fn what_nothing_holds_takes_the_strain_without_force() {
    let case = json!({
        "title": "test", "model": crate::support::sections::model("exact"), "body": { "line": { "length": 2, "cells": 8 } },
        "supports": [ { "at": { "x": 0 }, "w": 0, "phi": 0, "ux": 0 } ],
        "loads": [ { "initial_strain": { "strain": 0.02, "curvature": 0.3 } } ]
    });
    let run = run_recovered(&case);
    for k in 0..=8 {
        let x = 0.25 * f64::from(k);
        let k = k as usize;
        // w = κ x²/2, u = ε x; 2e-16 is found.
        assert!((values(&run, FieldName::W)[k] - 0.15 * x * x).abs() < 1e-14);
        assert!((values(&run, FieldName::U)[k] - 0.02 * x).abs() < 1e-14);
    }
    for field in [FieldName::M, FieldName::V, FieldName::N] {
        // 2e-15 is found, of forces of the load of 4.
        assert!(largest(&values(&run, field)) < 1e-12, "{}", field.name());
    }
    assert!(run.states[0].record.certificate.energy.abs() < 1e-13);
}

#[test]
fn lengths_and_forces_are_strains_and_heat_is_one() {
    let foot = json!({ "at": { "joint": "D" }, "ux": 0, "uy": 0 });
    let length = 3.5_f64;
    // EA = 800: a change of −50 K is a strain of −0.05; the height is 0.4.
    let loads = [
        json!([{ "temperature": { "member": "beam", "change": -50, "difference": 20 } }]),
        json!([{ "initial_strain": { "member": "beam", "strain": -0.05, "curvature": -0.05 } }]),
        json!([{ "initial_strain": { "member": "beam", "length": -0.05 * length, "curvature": -0.05 } }]),
        json!([{ "initial_strain": { "member": "beam", "force": 40, "curvature": -0.05 } }]),
    ];
    let runs = loads.map(|loads| run_recovered(&portal(&loads, &foot)));
    for field in [FieldName::M, FieldName::V, FieldName::N, FieldName::Ux] {
        let all = runs.each_ref().map(|run| values(run, field));
        let size = largest(&all[0]);
        assert!(size > 1e-3, "{}", field.name());
        for other in &all[1..] {
            let difference: Vec<f64> = all[0].iter().zip(other).map(|(a, b)| a - b).collect();
            // 1e-14 is found.
            assert!(largest(&difference) < 1e-11 * size, "{}: {:e}", field.name(), largest(&difference));
        }
    }
}
