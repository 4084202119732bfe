//! The stiffness of a case as an operator.

use peristat::input::Folder;
use peristat::{Loaded, Operator, case, solve_text};

const PANEL: &str = r#"{
    "title": "panel", "units": "mm-N-MPa",
    "model": { "beam_bond_orthotropic": { "youngs_modulus_1": 40000, "youngs_modulus_2": 10000, "poisson_ratio_12": 0.25, "shear_modulus_12": 5000, "fibre_angle": 30 } },
    "body": { "rectangle": { "size": [8, 6], "spacing": 1 } },
    "supports": [ { "at": { "region": "left" }, "ux": 0, "uy": 0 }, { "at": { "region": "right" }, "ux": 0.01 } ],
    "loads": [ { "traction": { "edge": "top", "uniform": [3, 5] } } ]
}"#;

fn operator(text: &str) -> Operator {
    let source = case::from_text("case", text.into(), &[], &Folder::default()).expect("a case");
    let loaded = Loaded::from_source(source, std::path::Path::new(".").into(), None).expect("a scene");
    Operator::new(&loaded, None).expect("no contradiction")
}

/// Rotations have a scale of their own, a support moves, and corners are shared: the solution of the program solves `K q = f`.
#[test]
fn a_solution_solves_its_equations() {
    let (operator, solved) = (operator(PANEL), solve_text(PANEL).unwrap());
    let fields: Vec<_> = operator.components().iter().map(|name| solved.field(0, name).unwrap()).collect();
    let q: Vec<f64> = operator.unknowns().iter().map(|&(point, c)| fields[c][point]).collect();
    let mut product = vec![0.0; q.len()];
    operator.product(&q, &mut product);
    let forces = operator.right_hand_side(0);
    let largest = forces.iter().fold(0.0_f64, |m, f| m.max(f.abs()));
    // 3e-13 measured.
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    assert!(apart(&product, forces) < 1e-11 * largest, "{:e}", apart(&product, forces) / largest);
    let matrix = operator.matrix();
    let row = |r: usize| matrix.outer_view(r).unwrap().iter().map(|(c, v)| v * q[c]).sum::<f64>();
    let assembled: Vec<f64> = (0..q.len()).map(row).collect();
    assert!(apart(&assembled, &product) < 1e-11 * largest);
    let all = operator.expand(&q, 0);
    let (ux, n) = (&fields[0], operator.components().len());
    assert!((0..operator.points()).all(|p| (all[n * p] - ux[p]).abs() < 1e-15));
}

#[test]
fn a_case_without_supports_keeps_its_rigid_motions() {
    let free = PANEL.replace(
        r#"{ "at": { "region": "left" }, "ux": 0, "uy": 0 }, { "at": { "region": "right" }, "ux": 0.01 }"#,
        "",
    );
    let operator = operator(&free);
    let q: Vec<f64> = operator.unknowns().iter().map(|&(_, c)| if c == 0 { 1.0 } else { 0.0 }).collect();
    let mut product = vec![0.0; q.len()];
    operator.product(&q, &mut product);
    // A translation costs nothing: the moduli are 4e4, rounding 4e-12.
    assert!(product.iter().all(|force| force.abs() < 1e-9));
    assert!(solve_text(&free).unwrap_err().to_string().contains("nothing holds the body"));
}
