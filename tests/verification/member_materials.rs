//! Members of frames with moduli of their own: against sections by numbers.

use crate::support::{largest, refusal, run_recovered};
use peristat::case::FieldName;
use serde_json::{Value, json};

/// A portal whose beam is of another material, by a section or by numbers.
fn portal(beam: &Value, materials: &Value) -> Value {
    let mut member = json!({ "name": "beam", "from": "B", "to": "C", "cells": 6 });
    member.as_object_mut().expect("a member").extend(beam.as_object().expect("keys").clone());
    json!({
        "title": "test", "materials": materials,
        "model": { "timoshenko_beam": { "youngs_modulus": 200, "poisson_ratio": 0.25, "section": { "rectangle": { "width": 0.5, "height": 1 } } } },
        "body": { "frame": {
            "joints": [ { "name": "A", "x": 0, "y": 0 }, { "name": "B", "x": 0, "y": 3 }, { "name": "C", "x": 4, "y": 3.5 }, { "name": "D", "x": 4, "y": 0 } ],
            "members": [ { "name": "left", "from": "A", "to": "B", "cells": 4 }, member, { "name": "right", "from": "D", "to": "C", "cells": 4 } ] } },
        "supports": [ { "at": { "joint": "A" }, "ux": 0, "uy": 0, "phi": 0 }, { "at": { "joint": "D" }, "ux": 0, "uy": 0 } ],
        "loads": [
            { "point": { "at": { "joint": "B" }, "force_x": 1 } },
            { "distributed": { "member": "beam", "force_y": { "uniform": -1 } } }
        ]
    })
}

#[test]
fn moduli_of_a_member_are_those_of_its_stiffness() {
    // A = 0.5 and I = 1/24 or, of a square of 0.8, 0.64 and 0.8⁴/12; κ = 5/6; G follows from E and ν unless it is given.
    let numbers = |e: f64, g: f64, area: f64, second: f64| {
        json!({ "stiffness": {
            "bending": { "uniform": e * second }, "shear": { "uniform": 5.0 / 6.0 * g * area }, "axial": { "uniform": e * area }
        } })
    };
    let square = json!({ "section": { "rectangle": { "width": 0.8, "height": 0.8 } } });
    let own = |keys: Value| {
        let mut material = json!({ "at": ["beam"] });
        material.as_object_mut().expect("a material").extend(keys.as_object().expect("keys").clone());
        json!({ "soft": material })
    };
    for (beam, keys, given) in [
        (json!({}), json!({ "youngs_modulus": 50 }), numbers(50.0, 20.0, 0.5, 1.0 / 24.0)),
        (
            square,
            json!({ "youngs_modulus": 50, "shear_modulus": 3 }),
            numbers(50.0, 3.0, 0.64, 0.8_f64.powi(4) / 12.0),
        ),
    ] {
        let [found, expected] =
            [portal(&beam, &own(keys)), portal(&given, &json!({}))].map(|case| run_recovered(&case));
        for field in [FieldName::M, FieldName::V, FieldName::N, FieldName::Ux, FieldName::Uy] {
            let [a, b] = [&found, &expected]
                .map(|run| run.states[0].all_values(field).expect("recovered").into_owned());
            let difference: Vec<f64> = a.iter().zip(&b).map(|(a, b)| a - b).collect();
            // 1e-14 is found.
            assert!(
                largest(&difference) < 1e-11 * largest(&b),
                "{}: {:e}",
                field.name(),
                largest(&difference)
            );
        }
    }
}

#[test]
fn a_line_has_no_materials() {
    let mut case = crate::support::standard::steel(0.1, "exact", 4);
    case["supports"] = json!([ { "at": { "x": 0 }, "w": 0, "phi": 0 } ]);
    case["materials"] = json!({ "soft": { "at": "beam", "youngs_modulus": 1 } });
    assert!(refusal(&case).contains("`materials` is for bodies in the plane"));
}
