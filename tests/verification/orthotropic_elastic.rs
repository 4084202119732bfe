//! Beam bonds: free motions, condition, shear moduli of bonds as published, what holds and loads rotations.

use crate::support::largest;
use crate::support::orthotropic::{A, B, parameters, plate, stiffness};
use crate::support::plane::{probe, refusal, solve};
use nalgebra::DMatrix;
use peristat::case::{FieldName, Model};
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamNeighbourhood, OrthotropicMaterial, OrthotropicParameters, Start,
};
use peristat_assembly::model::plane::{Calibration, Edges};
use serde_json::{Value, json};

fn eigenvalues(matrix: DMatrix<f64>) -> Vec<f64> {
    let mut values = matrix.symmetric_eigenvalues().data.as_vec().clone();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn a_free_plate_with_completed_edges_has_three_motions_without_energy() {
    let wide = OrthotropicMaterial { poisson_ratio_12: 0.36, ..A };
    let soft = OrthotropicMaterial { shear_modulus_12: 3500.0, ..A };
    for (material, degrees, ratio) in
        [(A, 0.0, 3.0), (wide, 0.0, 3.0), (soft, 0.0, 3.0), (B, 45.0, 3.0), (B, 30.0, 3.2)]
    {
        for edges in [Edges::Overlay, Edges::Border] {
            let parameters = OrthotropicParameters { edges, ..parameters(material, degrees, ratio) };
            let values = eigenvalues(stiffness(&plate(parameters, 1.0, [14, 8])));
            let most = values[values.len() - 1];
            assert!(values[..3].iter().all(|v| v.abs() < 1e-14 * most), "{edges:?} {:?}", &values[..4]);
            // At least 9.6e-4 of the largest, at 45 degrees; 4e-16 of it in rigid motions.
            assert!(values[3] > 5e-4 * most, "{edges:?} {degrees}: {} of {most}", values[3]);
        }
    }
}

#[test]
fn the_condition_does_not_depend_on_the_unit_of_length() {
    let conditions = [1e-3, 1.0, 1e3].map(|spacing| {
        let material = OrthotropicMaterial { thickness: spacing, ..A };
        let k = stiffness(&plate(parameters(material, 0.0, 3.0), spacing, [20, 10]));
        // The first three columns of points are held.
        let free: Vec<usize> = (0..600).filter(|i| i % 20 >= 3).collect();
        let values = eigenvalues(k.select_rows(&free).select_columns(&free));
        values[values.len() - 1] / values[0]
    });
    // 2268; 2.3e3 of the same plate in an independent NumPy implementation.
    assert!((conditions[1] / 2.3e3 - 1.0).abs() < 0.02, "{conditions:?}");
    for condition in conditions {
        // Measured 5e-12.
        assert!((condition / conditions[1] - 1.0).abs() < 1e-9, "{conditions:?}");
    }
}

#[test]
fn bonds_as_published_are_too_soft_in_shear() {
    // Of the lattice, from an independent NumPy implementation.
    for (material, ratio, expected) in [(B, 3.015, 0.7509), (A, 3.0, 0.9699)] {
        let published =
            OrthotropicParameters { calibration: Calibration::Published, ..parameters(material, 0.0, ratio) };
        let bonds = BeamNeighbourhood::new(&published).expect("the bonds exist");
        let found = bonds.effective_shear_modulus() / material.shear_modulus_12;
        assert!((found - expected).abs() <= 1e-4, "{found}");
    }
}

/// A plate with fibres at 30 degrees, whatever holds and loads it.
fn loaded(more: &Value) -> Value {
    let mut case = json!({
        "title": "plate", "units": "mm-N-MPa", "solver": "sparse",
        "model": { "beam_bond_orthotropic": {
            "youngs_modulus_1": 41000, "youngs_modulus_2": 10400, "poisson_ratio_12": 0.28,
            "shear_modulus_12": 4300, "fibre_angle": 30
        } },
        "body": { "rectangle": { "size": [30, 10], "spacing": 1 } },
        "regions": {
            "clamp": { "box": { "from": [0, 0], "to": [3, 10] } }, "end": { "box": { "from": [28, 0], "to": [30, 10] } }
        },
        "supports": [{ "at": { "region": "clamp" }, "ux": 0, "uy": 0, "phi": 0 }]
    });
    for (key, value) in more.as_object().expect("keys") {
        case[key] = value.clone();
    }
    case
}

#[test]
fn held_rotations_are_those_prescribed_and_a_rigid_region_turns_its_points() {
    let supports = json!([{ "at": { "region": "clamp" }, "ux": 0, "uy": 0, "phi": 0.002 }]);
    let rigid = json!([{ "region": "end", "ux": 0.1, "uy": -0.2, "phi": -0.003 }]);
    let run = solve(&loaded(&json!({ "supports": supports, "rigid": rigid })));
    for (at, phi) in run.positions().into_iter().zip(run.field(0, FieldName::Phi)) {
        let expected = if at[0] < 3.0 { 0.002 } else { -0.003 };
        let is_held = at[0] < 3.0 || at[0] > 28.0;
        assert!(!is_held || (phi - expected).abs() < 1e-15, "{phi} at {at:?}");
    }
}

#[test]
fn what_holds_rigid_regions_is_in_equilibrium_with_its_moments() {
    let still = json!({ "region": "clamp", "ux": 0, "uy": 0, "phi": 0 });
    let moved = json!({ "region": "end", "ux": 0.1, "uy": -0.2, "phi": -0.003 });
    let run = solve(&loaded(&json!({ "supports": [], "rigid": [still, moved] })));
    let (mut force, mut moment, mut size) = ([0.0; 2], 0.0, 0.0_f64);
    for reaction in &run.states[0].reactions {
        let (own, ([x, y, _], _)) =
            (reaction.moment.expect("it cannot turn"), reaction.centre.expect("a rigid region").parts());
        force = [force[0] + reaction.force_x, force[1] + reaction.force_y];
        moment += own + x * reaction.force_y - y * reaction.force_x;
        size = size.max(own.abs());
    }
    // Measured 1e-15.
    assert!(largest(&[force[0], force[1], moment]) < 1e-12 * size, "{force:?} {moment} of {size}");
}

#[test]
fn rollers_on_an_edge_are_exact_for_oblique_fibres() {
    let supports =
        json!([{ "at": { "region": "left" }, "ux": 0 }, { "at": { "x": 0.5, "y": 0.5 }, "uy": 0 }]);
    let loads = json!([{ "traction": { "edge": "right", "uniform": [41.0, 0.0] } }]);
    let run = solve(&loaded(&json!({ "supports": supports, "loads": loads })));
    let [xx, yy, xy] = A.compliance_at(30.0_f64.to_radians()).map(|row| 41.0 * row[0]);
    // The edge is held on its line: no line along y turns.
    let error = run.error(0, |[x, y]| [xx * x, xy * (x - 0.5) + yy * (y - 0.5)]);
    // Measured 1.4e-15.
    assert!(error < 1e-13, "{error}");
}

#[test]
fn the_usual_horizon_and_start_depend_on_the_fibres() {
    for (degrees, lattice, ratio, start) in [
        (45.0, "axes", 3.0, Start::Aligned),
        (30.0, "axes", 3.2, Start::Oblique),
        (30.0, "fibre", 3.0, Start::Aligned),
    ] {
        let mut case =
            loaded(&json!({ "loads": [{ "traction": { "edge": "right", "uniform": [1.0, 0.0] } }] }));
        case["model"]["beam_bond_orthotropic"]["fibre_angle"] = json!(degrees);
        case["model"]["beam_bond_orthotropic"]["lattice"] = json!(lattice);
        let resolved = solve(&case).scene.case;
        assert_eq!(resolved.horizon_ratio, Some(ratio));
        let Model::BeamBondOrthotropic(model) = resolved.model else { panic!("beam bonds") };
        assert_eq!((model.start, model.edges), (Some(start), Some(Edges::Border)));
    }
}

#[test]
fn moments_on_points_are_balanced_by_the_clamp() {
    // A moment on the points of the end, and none of the forces: the couple of the clamp is all there is.
    let loads = json!([{ "point": { "at": { "region": "end" }, "moment": 500.0 } }]);
    let probes = json!([
        { "name": "force", "at": { "region": "clamp" }, "field": "reaction_y" },
        { "name": "couple", "at": { "region": "clamp" }, "field": "reaction_moment" },
        { "name": "tip", "at": { "region": "end" }, "field": "phi" }
    ]);
    let case = loaded(&json!({ "loads": loads, "probes": probes }));
    let run = solve(&case);
    let (n, u) = (run.scene.model.points(), &run.states[0].record.u);
    assert_eq!(u.len(), 3 * n);
    assert!(probe(&case, "force").abs() < 1e-7, "{}", probe(&case, "force"));
    assert!(probe(&case, "tip") > 0.0);
    // The rigid region at the same place feels the same moment: statics about its centre.
    let rigid = json!([{ "region": "end", "phi": 0.001 }]);
    let twist = json!([{ "name": "moment", "at": { "region": "end" }, "field": "reaction_moment" }]);
    let turned = loaded(&json!({ "rigid": rigid, "probes": twist }));
    let moment = probe(&turned, "moment");
    let free = json!([{ "region": "end" }]);
    let loads = json!([{ "point": { "at": { "region": "end" }, "moment": moment } }]);
    let probes = json!([{ "name": "turn", "at": { "region": "end" }, "field": "phi" }]);
    let back = probe(&loaded(&json!({ "rigid": free, "loads": loads, "probes": probes })), "turn");
    assert!((back / 0.001 - 1.0).abs() < 1e-9, "{back}");
}

#[test]
fn what_beam_bonds_have_not_is_refused() {
    let text = refusal(&loaded(&json!({ "symmetry": ["left"] })));
    assert!(text.contains("a mirror would turn the fibres from 30 to -30 degrees"), "{text}");
    let text = refusal(&loaded(&json!({ "body": { "points": { "file": "points.csv" } } })));
    assert!(text.contains("needs a lattice"), "{text}");
}
