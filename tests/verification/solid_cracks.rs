//! Cracks in solids: stress intensities of round ones, mirrors against whole bodies, surfaces from files, the multigrid.

use serde_json::{Value, json};

fn solved(case: &Value) -> peristat::Solved {
    peristat::solve_text(&case.to_string()).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(case: &Value) -> String {
    peristat::solve_text(&case.to_string()).err().map_or_else(String::new, |error| error.to_string())
}

/// A block around the origin, as far as `half` from it, with a round crack of radius 1 across z in its middle, pulled along z. Sides
/// at the origin are mirrors if asked for.
fn penny(model: &str, mirrors: [bool; 3], half: f64, spacing: f64) -> Value {
    let names = ["left", "bottom", "back"];
    let size = mirrors.map(|mirror| if mirror { half } else { 2.0 * half });
    let from = mirrors.map(|mirror| if mirror { 0.0 } else { -half });
    let symmetry: Vec<&str> = (0..3).filter(|&k| mirrors[k]).map(|k| names[k]).collect();
    let keys = if model == "state_solid" {
        json!({ "youngs_modulus": 1000, "poisson_ratio": 0.25 })
    } else {
        json!({ "youngs_modulus": 1000 })
    };
    let mut loads = vec![json!({ "traction": { "face": "front", "uniform": [0, 0, 1] } })];
    let mut supports = Vec::new();
    let (low, high) = (0.5 * spacing - half, half - 0.5 * spacing);
    if !mirrors[2] {
        loads.push(json!({ "traction": { "face": "back", "uniform": [0, 0, -1] } }));
        // What mirrors do not hold.
        let (ux, uy) = (
            if mirrors[0] { json!(null) } else { json!(0) },
            if mirrors[1] { json!(null) } else { json!(0) },
        );
        let x = if mirrors[0] { 0.5 * spacing } else { low };
        let y = if mirrors[1] { 0.5 * spacing } else { low };
        supports.push(json!({ "at": { "x": x, "y": y, "z": low }, "ux": ux, "uy": uy, "uz": 0 }));
        if !mirrors[0] {
            supports.push(json!({ "at": { "x": high, "y": low, "z": low }, "uy": 0, "uz": 0 }));
            supports.push(json!({ "at": { "x": low, "y": high, "z": low }, "uz": 0 }));
        }
    }
    json!({
        "title": "penny", "units": "none", "model": { model: keys },
        "body": { "block": { "from": from, "size": size, "spacing": spacing } }, "symmetry": symmetry,
        "cracks": [ { "name": "penny", "disc": { "centre": [0, 0, 0], "normal": [0, 0, 1], "radius": 1 } } ],
        "supports": supports, "loads": loads,
        "stress_intensity": [ { "name": "K", "crack": "penny" } ]
    })
}

fn intensity(case: &Value) -> f64 {
    solved(case).summary.probes.iter().find(|probe| probe.name == "K").expect("a stress intensity").value
}

/// 2σ√(a/π) of Sneddon (1946).
const SNEDDON: f64 = std::f64::consts::FRAC_2_SQRT_PI;

#[test]
fn round_cracks_have_their_stress_intensity() {
    // The body is eight radii wide, which adds 1.3 % to that of one in an infinite body.
    for (model, found) in [("bond_solid", 1.0298), ("state_solid", 1.0318)] {
        let over = intensity(&penny(model, [true; 3], 4.0, 0.125)) / SNEDDON;
        assert!((over - found).abs() < 2e-4, "{model}: {over}");
    }
}

#[test]
fn parts_of_a_cracked_solid_are_the_whole() {
    let whole = intensity(&penny("bond_solid", [false; 3], 2.0, 0.25));
    for mirrors in [[true; 3], [true, true, false], [false, false, true]] {
        let mut case = penny("bond_solid", mirrors, 2.0, 0.25);
        if mirrors == [false, false, true] {
            case["supports"] = json!([
                { "at": { "x": -1.875, "y": -1.875, "z": 0.125 }, "ux": 0, "uy": 0 },
                { "at": { "x": 1.875, "y": -1.875, "z": 0.125 }, "uy": 0 }
            ]);
        }
        let part = intensity(&case);
        // 2e-9 found: the certificate of energies.
        assert!((part / whole - 1.0).abs() < 1e-7, "{mirrors:?}: {part} {whole}");
    }
    // The other side of the normal is the same crack.
    let mut turned = penny("bond_solid", [true; 3], 2.0, 0.25);
    turned["cracks"][0]["disc"]["normal"] = json!([0, 0, -3]);
    assert!((intensity(&turned) / whole - 1.0).abs() < 1e-7);
}

#[test]
fn multigrid_takes_as_many_cycles_as_without_a_crack() {
    for (half, spacing) in [(4.0, 0.125), (3.0, 0.083_333_333_333_333_33), (2.0, 0.125)] {
        let mut case = penny("bond_solid", [true; 3], half, spacing);
        case["solver"] = json!("multigrid");
        case["stress_intensity"] = json!([]);
        let solver = solved(&case).summary.solver;
        // 16, 17 and 16 found; 400, 101 and 37 with eigenvalues of images.
        assert!(solver.iterations[0] <= 20, "{half} {spacing}: {solver:?}");
    }
}

#[test]
fn faces_that_close_are_told() {
    let warned = |pull: f64| {
        let mut case = penny("bond_solid", [true; 3], 2.0, 0.25);
        case["loads"][0]["traction"]["uniform"] = json!([0, 0, pull]);
        let warnings = solved(&case).summary.warnings;
        warnings.iter().any(|warning| warning.contains("the faces of the crack overlap"))
    };
    assert!(warned(-1.0) && !warned(1.0));
}

#[test]
fn fronts_of_few_spacings_are_told() {
    let warned = |disc: Value| {
        let mut case = penny("bond_solid", [true; 3], 2.0, 0.25);
        case["cracks"][0]["disc"] = disc;
        solved(&case).summary.warnings.iter().any(|warning| warning.contains("less than 4 spacings"))
    };
    let disc = |inner: f64, radius: f64| json!({ "centre": [0, 0, 0], "normal": [0, 0, 1], "radius": radius, "inner_radius": inner });
    assert!(warned(disc(0.0, 0.9)) && warned(disc(0.9, 9.0)));
    assert!(!warned(disc(0.0, 1.1)) && !warned(disc(1.1, 9.0)));
}

#[test]
fn surfaces_that_are_none_are_refused() {
    let with = |crack: Value| {
        let mut case = penny("bond_solid", [true; 3], 2.0, 0.25);
        case["cracks"][0] = crack;
        case["stress_intensity"] = json!([]);
        refusal(&case)
    };
    let disc = |normal: Value, radius: f64| json!({ "disc": { "centre": [0, 0, 0], "normal": normal, "radius": radius } });
    for (crack, why) in [
        (json!({ "path": [[0, 0], [1, 1]] }), "a `path` is a crack in the plane"),
        (json!({}), "this crack is nowhere"),
        (disc(json!([0, 0, 0]), 1.0), "the normal of the disc has no direction"),
        (disc(json!([0, 0, 1]), -1.0), "the radius must be a number above zero"),
        (json!({ "polygon": [[0, 0, 0], [1, 0, 0]] }), "no polygon with an area"),
        (json!({ "polygon": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0.5]] }), "off the plane of the others"),
        (json!({ "file": "none.stl" }), "none.stl"),
    ] {
        let said = with(crack.clone());
        assert!(said.contains(why), "{crack}: {said}");
    }
    let mut case = penny("bond_solid", [true; 3], 2.0, 0.25);
    case["stress_intensity"][0]["tips"] = json!("both");
    assert!(refusal(&case).contains("has no tips"), "{}", refusal(&case));
    let mut case = penny("bond_solid", [true; 3], 2.0, 0.25);
    case["cracks"][0] = json!({ "name": "penny", "polygon": [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]] });
    assert!(refusal(&case).contains("the mean along a front is that of a `disc`"), "{}", refusal(&case));
}
