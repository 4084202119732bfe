//! The strain form: as exact at slenderness 10⁶ as at 20, and the same answers as the displacement form.

use crate::support::standard::{CASES, SECTIONS, Section, Standard, steel, unit};
use crate::support::{Run, error, largest, run, run_recovered};
use peristat::input::{Folder, Reach};
use peristat::run::RunOptions;
use peristat::run::beam::{Reaction, run as solve};
use peristat::scene::Scene;
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// Slendernesses 20, 1e4 and 1e6.
const SLENDER: [Section; 3] =
    [SECTIONS[1], SECTIONS[3], Section { height: 1e-6, force: 1e-11, moment: 1e-11, uniform: 1e-10 }];

fn with_solver(case: &Value, solver: &str) -> Value {
    let mut case = case.clone();
    case["solver"] = json!(solver);
    case
}

#[test]
fn nodal_values_are_exact_on_a_million_cells_at_any_slenderness() {
    for name in ["cantilever under a uniform load", "clamped ends, uniform load"] {
        let standard = Standard::named(name);
        for section in SLENDER {
            let run = run(&standard.case(&section, "exact", 1_000_000));
            assert_eq!(run.report.solver.method, "strain_form");
            let errors = run.errors(standard.exact(&section));
            // A4, measured 9e-16 for the cantilever and 1.1e-15 for the clamped beam, w and φ.
            assert!(errors.iter().all(|e| *e <= 1e-14), "{name}, {section:?}: {errors:?}");
        }
    }
}

#[test]
fn certificates_are_down_to_rounding_for_all_standard_cases() {
    for standard in CASES {
        for section in SLENDER {
            let run = run(&standard.case(&section, "exact", 5000));
            let certificate = &run.states[0].record.certificate;
            // Measured 1.2e-15, 5e-15, 2e-15 and 6e-17.
            assert!(certificate.residual <= 1e-14, "{}: {certificate:?}", standard.name);
            assert!(certificate.next_correction <= 1e-14, "{}: {certificate:?}", standard.name);
            assert!(certificate.energy_balance <= 1e-13, "{}: {certificate:?}", standard.name);
            assert!(
                certificate.balance.iter().all(|b| b.relative <= 1e-14),
                "{}: {certificate:?}",
                standard.name
            );
        }
    }
}

/// Differences of unknowns, reactions and section forces of two runs, relative to the largest of their kind.
fn differences(a: &Run, b: &Run) -> f64 {
    let mut worst = 0.0_f64;
    for (state, (a_state, b_state)) in a.states.iter().zip(&b.states).enumerate() {
        let ([a_w, a_phi], [b_w, b_phi]) = (a.unknowns(state), b.unknowns(state));
        // A displacement that is nearly zero everywhere is measured by the other.
        let length = a.x().last().expect("points") - a.x()[0];
        let size = largest(&b_w).max(length * largest(&b_phi)).max(f64::MIN_POSITIVE);
        let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        worst = worst.max(apart(&a_w, &b_w) / size).max(length * apart(&a_phi, &b_phi) / size);
        let forces = |run: &Run| -> Vec<f64> {
            let of = |r: &Reaction| [r.force * length, r.moment];
            run.states[state].reactions.iter().flat_map(of).collect()
        };
        let (a_forces, b_forces) = (forces(a), forces(b));
        worst = worst.max(apart(&a_forces, &b_forces) / largest(&b_forces).max(f64::MIN_POSITIVE));
        if let (Some(a), Some(b)) = (&a_state.lines[0].forces, &b_state.lines[0].forces) {
            let (a_m, b_m) = (a.moment.concat(), b.moment.concat());
            let (a_v, b_v) = (a.shear.concat(), b.shear.concat());
            let size = largest(&b_m).max(length * largest(&b_v)).max(f64::MIN_POSITIVE);
            worst = worst.max(apart(&a_m, &b_m) / size).max(length * apart(&a_v, &b_v) / size);
        }
    }
    worst
}

#[test]
fn strains_and_displacements_give_the_same_answer_under_every_law_and_support() {
    let supports = [
        json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }, { "at": { "x": 1.0 }, "w_spring": 3e6 }]),
        json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi_spring": 2e4 }, { "at": { "x": 1.0 }, "w_spring": 3e5, "phi": 0.01 }]),
        json!([{ "at": { "x": 0.0 }, "w": 0.001 }, { "at": { "x": 0.5 }, "w": -0.002 }, { "at": { "x": 1.0 }, "w": 0.0 }]),
        json!([{ "at": { "x": 0.25 }, "w": 0.0 }, { "at": { "x": 0.75 }, "w": 0.0, "phi": 0.0 }]),
        json!([{ "at": { "x": 1.0 }, "w": 0.0, "phi": 0.002 }]),
        json!([{ "at": { "x": 0.0 }, "phi": 0.0 }, { "at": { "x": 1.0 }, "w": 0.0, "phi": 0.0 }]),
        json!(
            (0..=10)
                .map(|k| json!({ "at": { "x": 0.1 * f64::from(k) }, "w": 0.0 }))
                .take(10)
                .collect::<Vec<_>>()
        ),
    ];
    let loads = json!([
        { "distributed": { "from": 0.1, "to": 0.65, "force": { "linear": [4e3, 9e3] }, "moment": { "uniform": 1e3 } } },
        { "point": { "at": { "x": 0.5 }, "force": -2e3, "moment": 300.0 } }
    ]);
    for (law, ratio) in [("exact", 3.0), ("exact", 1.0), ("corrected", 5.0), ("published", 2.5)] {
        for support in &supports {
            let mut case = steel(0.05, law, 120);
            (case["horizon_ratio"], case["supports"], case["loads"]) =
                (json!(ratio), support.clone(), loads.clone());
            case["steps"] = json!({ "load_factors": [0.5, -2.0] });
            let [band, strain] = ["band", "strain"].map(|solver| run_recovered(&with_solver(&case, solver)));
            let difference = differences(&strain, &band);
            // Measured 5e-13.
            assert!(difference <= 1e-12, "{law}, {ratio}, {support}: {difference:e}");
        }
    }
}

/// All cases of beams of the gallery but those that break: they take a factor.
fn gallery() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/beam");
    let entries = std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("an entry").path());
    let breaks = |path: &PathBuf| std::fs::read_to_string(path).expect("a case").contains("\"fracture\"");
    entries.filter(|path| path.extension().is_some_and(|e| e == "json") && !breaks(path)).collect()
}

/// A case of the gallery with a solver; `None` if the solver does not apply.
fn solved(path: &Path, solver: &str) -> Option<Run> {
    let source =
        peristat::case::read(path, &[format!("solver={solver}")], &Folder::of(path, Reach::Inside), None)
            .expect("a case");
    let scene = Scene::new(source.case, path.parent().expect("a folder"), "case", &source.text, None)
        .expect("a scene");
    let scene = scene.into_beam().expect("a beam");
    let mut states = Vec::new();
    let options = RunOptions { recover: true, max_memory: None, compare: false };
    let report = solve(&scene, &options, &mut |state| {
        states.push(state);
        Ok(())
    });
    report.ok().map(|report| Run { scene, states, report })
}

#[test]
fn the_gallery_has_the_same_answers_in_strains() {
    let mut compared = 0;
    for path in gallery() {
        let Some(strain) = solved(&path, "strain") else { continue };
        assert!(strain.report.converged, "{}", path.display());
        let band = solved(&path, "band").expect("a result");
        let difference = differences(&strain, &band);
        // The displacement form loses digits where the law `published` locks, 3e-11, and to settlements, 2e-12.
        assert!(difference <= 1e-10, "{}: {difference:e}", path.display());
        compared += 1;
    }
    assert!(compared >= 30, "{compared}");
}

#[test]
fn what_has_no_strain_form_says_why() {
    let clamp = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.0 }]);
    let mut cells = steel(0.05, "exact", 20);
    cells["body"]["line"]["grid"] = json!("cells");
    cells["model"]["timoshenko_beam"]["end_treatment"] = json!("ghost");
    cells["supports"] = clamp.clone();
    let mut images = steel(0.05, "exact", 20);
    images["model"]["timoshenko_beam"]["end_treatment"] = json!("image");
    images["supports"] = clamp;
    let mut many = steel(0.05, "exact", 20);
    many["supports"] = (0..11).map(|k| json!({ "at": { "x": 0.1 * f64::from(k) }, "w": 0.0 })).collect();
    let mut bedded = steel(0.05, "exact", 6);
    bedded["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0 }]);
    bedded["foundation"] = json!([{ "stiffness": { "uniform": 1e6 } }]);
    for (case, why) in [
        (bedded, "the beam lies on an elastic foundation"),
        (cells, "the points lie in the middle of the cells"),
        (images, "ghost points continue the beam beyond its ends"),
        (many, "11 displacements are held or sprung, more than 10"),
    ] {
        let message = peristat::solve_text(&with_solver(&case, "strain").to_string())
            .expect_err("no strain form")
            .to_string();
        assert!(message.contains(why) && message.contains("solver"), "{message}");
        let summary =
            peristat::solve_text(&with_solver(&case, "auto").to_string()).expect("a result").summary;
        assert_ne!(summary.solver.method, "strain_form", "{why}");
    }
}

#[test]
fn the_softest_spring_takes_the_moment_that_statics_gives_it() {
    for stiffness in [1e3, 1.0, 1e-6, 1e-10] {
        let mut case = steel(0.05, "exact", 24);
        case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi_spring": stiffness }]);
        case["loads"] = json!([{ "point": { "at": { "x": 1.0 }, "force": 1000.0 } }]);
        let run = run_recovered(&case);
        let reaction = &run.states[0].reactions[0];
        assert_eq!((reaction.force, reaction.moment), (-1000.0, -1000.0), "{stiffness}");
        let moments = &run.states[0].lines[0].forces.as_ref().expect("recovered").moment;
        let expected: Vec<f64> = (0..24).map(|k| 1000.0 * (1.0 - f64::from(k) / 24.0)).collect();
        let found: Vec<f64> = moments.iter().map(|m| m[0]).collect();
        assert!(error(&found, &expected) < 1e-15, "{stiffness}");
    }
}

#[test]
fn a_soft_spring_beside_a_rigid_support_of_the_first_point_turns_with_it() {
    for stiffness in [1.0, 1e-8, 1e-14, 1e-20] {
        let mut case = unit(1000.0, "exact", 8);
        case["supports"] = json!([
            { "at": { "x": 0.0 }, "w": 0.0, "phi_spring": stiffness }, { "at": { "x": 1.0 }, "w": 0.0 } ]);
        case["loads"] = json!([{ "distributed": { "force": { "uniform": 1.0 } } }]);
        let run = run(&case);
        assert_eq!(run.report.solver.method, "strain_form");
        // Simple supports, φ(0) = q L³/(24 EI), less what the moment k φ(0) at the end turns back: L/(3 EI) + 1/(S L).
        let expected = 1.0 / 24.0 / (1.0 + stiffness * (1.0 / 3.0 + 1e-3));
        let wrong = (run.unknowns(0)[1][0] / expected - 1.0).abs();
        // Measured 7e-15.
        assert!(wrong <= 1e-13 && run.states[0].record.certificate.converged, "{stiffness:e}: {wrong:e}");
    }
}

#[test]
fn a_law_that_locks_is_left_to_the_displacement_form() {
    let mut case = unit(1e10, "published", 10);
    case["supports"] = json!([0.0, 1.0].map(|x| json!({ "at": { "x": x }, "w": 0.0, "phi": 0.0 })));
    case["loads"] = json!([{ "distributed": { "force": { "uniform": 1.0 } } }]);
    let run = run(&case);
    assert_eq!(run.report.solver.method, "band_cholesky");
    assert!(run.states[0].record.certificate.converged);
}
