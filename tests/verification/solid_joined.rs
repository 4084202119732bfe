//! Solids whose opposite faces are joined: uniform strains, layers in shear, and cells that repeat themselves.

use serde_json::{Value, json};

fn solved(case: &Value) -> peristat::Solved {
    peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

/// Both models with all that is done about faces.
fn models() -> [Value; 5] {
    let bonds = |edges: &str| json!({ "bond_solid": { "youngs_modulus": 1000.0, "edges": edges } });
    let families = |edges: &str| json!({ "state_solid": { "youngs_modulus": 1000.0, "poisson_ratio": 0.3, "edges": edges } });
    [bonds("border"), bonds("overlay"), bonds("none"), families("border"), families("overlay")]
}

fn poisson_ratio(model: &Value) -> f64 {
    model["state_solid"]["poisson_ratio"].as_f64().unwrap_or(0.25)
}

fn value(found: &peristat::Solved, name: &str) -> f64 {
    let probe = found.summary.probes.iter().find(|probe| probe.name == name);
    probe.unwrap_or_else(|| panic!("a probe `{name}`")).value
}

/// A block of cells of side 1, of which one point is held.
fn block(model: &Value, size: [u32; 3], periodic: Value) -> Value {
    json!({
        "title": "block", "units": "none", "model": model, "periodic": periodic,
        "body": { "block": { "size": size, "spacing": 1.0 } },
        "supports": [{ "at": { "x": 0.5, "y": 0.5, "z": 0.5 }, "ux": 0, "uy": 0, "uz": 0 }],
    })
}

/// Two points along an axis whose difference is two spacings of uniform strain, by the name of what is read.
fn grown(axis: usize) -> [Value; 2] {
    let at = |along: f64| {
        let mut at = [0.5; 3];
        at[axis] = along;
        json!({ "x": at[0], "y": at[1], "z": at[2] })
    };
    let field = ["ux", "uy", "uz"][axis];
    [0, 2].map(|k| json!({ "name": format!("{field} {k}"), "at": at(0.5 + f64::from(k)), "field": field }))
}

/// All three pairs of faces are joined, and the body stretches along them under a force along one: tension, exact to rounding. Where
/// it keeps its length, there is the strain of none.
#[test]
fn uniform_strains_are_exact_in_bodies_without_faces() {
    for model in models() {
        let ratio = poisson_ratio(&model);
        for axis in 0..3 {
            let pair = |k: usize, free: bool| {
                let along = ["x", "y", "z"][k];
                match (k == axis, free) {
                    (true, _) => json!({ "along": along, "stretches": true, "force": 24.0 }),
                    (_, true) => json!({ "along": along, "stretches": true }),
                    _ => json!({ "along": along }),
                }
            };
            for free in [true, false] {
                let size = [5, 4, 6];
                let pairs: Vec<Value> = (0..3).map(|k| pair(k, free)).collect();
                let mut case = block(&model, size, json!(pairs));
                let across = (axis + 1) % 3;
                case["probes"] = json!([grown(axis), grown(across)].concat());
                let found = solved(&case);
                let area: f64 = (0..3).filter(|&k| k != axis).map(|k| f64::from(size[k])).product();
                let stress = 24.0 / area;
                // Free sides narrow; held ones let the body stretch less, by 1 − 2ν²/(1 − ν).
                let along = if free { 1.0 } else { 1.0 - 2.0 * ratio * ratio / (1.0 - ratio) };
                let narrow = if free { -ratio } else { 0.0 };
                let strain = |k: usize| {
                    let field = ["ux", "uy", "uz"][k];
                    (value(&found, &format!("{field} 2")) - value(&found, &format!("{field} 0"))) / 2.0
                };
                let [own, beside] = [axis, across].map(|k| strain(k) * 1000.0 / stress);
                assert!((own - along).abs() < 1e-11, "{model} {axis}: {own} {along}");
                assert!((beside - narrow).abs() < 1e-11, "{model} {axis}: {beside} {narrow}");
                let name = ["stress_xx", "stress_yy", "stress_zz"][axis];
                let values = found.field(0, name).expect("a field");
                assert!(values.iter().all(|s| (s - stress).abs() < 1e-11 * stress), "{model} {axis}");
            }
        }
    }
}

/// A layer without ends, held below and sheared above: one angle and one stress everywhere.
#[test]
fn an_endless_layer_shears_as_a_whole() {
    let bonds = json!({ "bond_solid": { "youngs_modulus": 1000.0 } });
    for (across, faces) in [("y", ["bottom", "top"]), ("z", ["back", "front"]), ("x", ["left", "right"])] {
        let axis = ["x", "y", "z"].iter().position(|name| *name == across).expect("an axis");
        let along = (axis + 2) % 3;
        let pairs: Vec<Value> = ["x", "y", "z"]
            .into_iter()
            .filter(|name| *name != across)
            .map(|name| json!({ "along": name }))
            .collect();
        let mut size = [4; 3];
        size[axis] = 9;
        let mut case = block(&bonds, size, json!(pairs));
        case["supports"] = json!([{ "at": { "region": faces[0] }, "ux": 0, "uy": 0, "uz": 0 }]);
        let mut traction = [0.0; 3];
        traction[along] = 2.0;
        case["loads"] = json!([{ "traction": { "face": faces[1], "uniform": traction } }]);
        let found = solved(&case);
        let field = ["ux", "uy", "uz"][along];
        // G = 400: an angle of 1/200.
        for (u, at) in found.field(0, field).expect("a field").iter().zip(found.points()) {
            assert!((u - 0.005 * at[axis]).abs() < 1e-12, "{across} {at:?}: {u}");
        }
        let name = ["stress_yz", "stress_xz", "stress_xy"]
            [(0..3).find(|k| *k != axis && *k != along).expect("an axis")];
        assert!(found.field(0, name).expect("a field").iter().all(|s| (s - 2.0).abs() < 1e-9), "{across}");
    }
}

/// Elongation of a bored cell of 6 x 6 x 6 under a stress along x, or of twice as many such cells along every axis.
fn elongation(model: &Value, copies: u32, solver: &str) -> f64 {
    let cells = (0..copies).flat_map(|a| (0..copies).map(move |b| [a, b]));
    let bores = cells.map(|[a, b]| {
        let middle = |k: u32| 6.0 * f64::from(k) + 3.0;
        json!({ "bore": { "along": "z", "centre": [middle(a), middle(b), 0.0], "radius": 1.8 } })
    });
    let size = 6 * copies;
    let force = 36.0 * f64::from(copies * copies);
    let mut case = block(
        model,
        [size; 3],
        json!([{ "along": "x", "stretches": true, "force": force },
        { "along": "y", "stretches": true }, { "along": "z" }]),
    );
    case["body"]["block"]["cuts"] = json!(bores.collect::<Vec<_>>());
    case["solver"] = json!(solver);
    case["probes"] = json!([{ "name": "moved", "at": { "x": 5.5, "y": 0.5, "z": 0.5 }, "field": "ux" }]);
    value(&solved(&case), "moved")
}

#[test]
fn a_cell_is_as_stiff_as_its_copies() {
    for model in models() {
        let [one, eight] = [1, 2].map(|copies| elongation(&model, copies, "sparse"));
        // 5e-3 without the bore; 1e-13 measured.
        assert!(one > 5.5e-3, "{one}");
        assert!((one - eight).abs() < 1e-9 * one, "{model}: {one} {eight}");
        for solver in ["multigrid", "pcg"] {
            let found = elongation(&model, 2, solver);
            assert!((found - one).abs() < 1e-8 * one, "{solver} {model}: {found} {one}");
        }
    }
}
