//! Loads and reactions are in equilibrium, and the stored energy is half the work of the loads.

use crate::support::standard::{CASES, SECTIONS, steel, unit};
use crate::support::{Run, run};
use peristat::solve_text;
use peristat::summary::{Status, Summary};
use peristat_assembly::model::Points;
use peristat_assembly::model::timoshenko_beam::Inside;
use serde_json::json;

/// Imbalance of forces, and of moments about x = 0, of loads and reactions, relative to all of them over 1 m.
fn imbalance(run: &Run) -> [f64; 2] {
    let (load, beam) = (run.load(), &run.scene.beam);
    let n = beam.points();
    let x = |point: usize| beam.position(point)[0];
    let mut forces: Vec<f64> = load[..n].to_vec();
    let mut moments: Vec<f64> = (0..n).map(|p| load[n + p] + x(p) * load[p]).collect();
    for reaction in &run.states[0].reactions {
        forces.push(reaction.force);
        moments.push(reaction.moment);
        moments.push(reaction.x * reaction.force);
    }
    let scale: f64 = forces.iter().chain(&moments).map(|v| v.abs()).sum();
    [forces, moments].map(|parts| parts.iter().sum::<f64>().abs() / scale)
}

#[test]
fn reactions_balance_the_loads() {
    for standard in CASES {
        for section in SECTIONS {
            for law in ["published", "corrected", "exact"] {
                // A locked beam has bond forces that dwarf its load, and their rounding.
                if law == "published" && section.height < 0.05 {
                    continue;
                }
                for cells in [10, 100, 1000] {
                    let run = run(&standard.case(&section, law, cells));
                    let name = format!("{}, {section:?}, {law}, {cells} cells", standard.name);
                    // A26, measured 3e-15 √cells. At slenderness 1e4 the rounding of w alone, times the stiffness of a bond,
                    // is 1e-8 of the load; measured 2e-11.
                    let slender = section.height < 1e-3 && cells > 10;
                    let bound = if slender { 1e-9 } else { 1e-14 * (cells as f64).sqrt() };
                    let [force, moment] = imbalance(&run);
                    assert!(force <= bound && moment <= bound, "{name}: {force:e}, {moment:e}");
                }
            }
        }
    }
}

#[test]
fn the_stored_energy_is_half_the_work_of_the_loads() {
    for standard in CASES {
        for section in SECTIONS {
            for law in ["published", "corrected", "exact"] {
                // A locked beam has bond forces that dwarf its load, and their rounding.
                if law == "published" && section.height < 0.05 {
                    continue;
                }
                for cells in [10, 100, 1000] {
                    let run = run(&standard.case(&section, law, cells));
                    let name = format!("{}, {section:?}, {law}, {cells} cells", standard.name);
                    let certificate = &run.states[0].record.certificate;
                    let u = &run.states[0].record.u;
                    let work: f64 = run.load().iter().zip(u).map(|(f, u)| 0.5 * f * u).sum();
                    // That of loads between points is not the work of what these bear.
                    let (loads, chain) = (&run.scene.states[0].loads, &run.scene.beam.chains()[0]);
                    let between =
                        if law == "exact" { Inside::new(loads, 0, chain).stored(false) } else { 0.0 };
                    let error = ((certificate.energy - between) / work - 1.0).abs();
                    // A27, measured 2.2e-15.
                    assert!(error <= 1e-13 && certificate.energy_balance <= 1e-13, "{name}: {error:e}");
                }
            }
        }
    }
}

#[test]
fn the_certificate_sees_balanced_forces_where_only_moments_act() {
    for standard in CASES {
        let run = run(&standard.case(&SECTIONS[1], "corrected", 96));
        let certificate = &run.states[0].record.certificate;
        for balance in &certificate.balance {
            assert!(balance.relative <= 1e-13, "{}: {balance:?}", standard.name);
        }
        assert!(certificate.residual <= 1e-10, "{}: {certificate:?}", standard.name);
        assert!(certificate.next_correction <= 1e-13, "{}: {certificate:?}", standard.name);
    }
}

/// Whether a run refuses its answer; if it does not, it must be right within the bound that it tells, and warn if that leaves
/// few digits.
fn refuses(summary: &Summary, error: f64) -> bool {
    let certificate = &summary.states[0].certificate;
    let is_refused = summary.status == Status::NotConverged;
    assert!(is_refused || error <= certificate.strain_error, "{error:e}: {certificate:?}");
    let few = certificate.digits.min(certificate.strain_digits) < 6;
    let warned = summary.warnings.iter().any(|w| w.contains("can be trusted"));
    assert_eq!(few, warned, "{:?}: {certificate:?}", summary.warnings);
    is_refused
}

#[test]
fn a_spring_so_soft_that_rounding_moves_it_leaves_few_digits_or_none() {
    let loads = json!([{ "point": { "at": { "x": 1.0 }, "force": 1000.0 } }]);
    for (stiffness, is_soft) in [(1e3, false), (1.0, false), (1e-6, false), (1e-14, true)] {
        let mut case = steel(0.05, "exact", 24);
        case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi_spring": stiffness }]);
        case["loads"] = loads.clone();
        // In strains the spring does not matter: its moment is statics.
        case["solver"] = json!("band");
        case["probes"] = json!([
            { "name": "reaction", "at": { "x": 0.0 }, "field": "reaction_force" },
            { "name": "moment", "at": { "x": 0.0 }, "field": "reaction_moment" }
        ]);
        let summary = solve_text(&case.to_string()).unwrap().summary;
        // Minus the load, and minus its moment.
        let error = summary.probes.iter().map(|p| (p.value / 1000.0 + 1.0).abs()).fold(0.0, f64::max);
        let refused = refuses(&summary, error);
        let digits = summary.states[0].certificate.strain_digits;
        assert!(refused || is_soft == (digits < 6), "{stiffness}: {digits} digits");
        assert!(is_soft || error <= 1e-8, "{stiffness}: {error:e}");
    }
}

#[test]
fn a_load_lost_in_the_rounding_of_a_settlement_leaves_no_digits() {
    let mut case = steel(0.05, "exact", 24);
    case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 1.0, "phi": 0.0 }]);
    let (bending, shear) = SECTIONS[1].stiffness();
    // The settlement alone strains nothing and converges; the smallest load is below the forces that its rounding leaves.
    for (force, is_lost) in [(None, false), (Some(1000.0), false), (Some(1e-12), true)] {
        let load = force.map(|force| json!({ "point": { "at": { "x": 1.0 }, "force": force } }));
        case["loads"] = load.into_iter().collect::<Vec<_>>().into();
        let summary = solve_text(&case.to_string()).unwrap().summary;
        // In energy norm.
        let exact = force.map(|f: f64| 0.5 * f * f * (1.0 / (3.0 * bending) + 1.0 / shear));
        let error =
            exact.map_or(0.0, |exact| ((summary.states[0].certificate.energy / exact).sqrt() - 1.0).abs());
        assert_eq!(refuses(&summary, error), is_lost, "{force:?}: {:?}", summary.states[0].certificate);
    }
}

#[test]
fn a_force_on_a_support_of_a_beam_that_only_turns_is_in_balance() {
    for solver in ["band", "strain"] {
        let mut case = unit(50.0, "exact", 10);
        case["solver"] = json!(solver);
        case["supports"] = json!([{ "at": { "x": 0.0 }, "w": 0.0, "phi": 0.01 }]);
        case["loads"] = json!([{ "point": { "at": { "x": 0.0 }, "force": 1.0 } }]);
        let run = run(&case);
        assert!(
            run.states[0].record.certificate.converged,
            "{solver}: {:?}",
            run.states[0].record.certificate
        );
        assert!((run.w(10) - 0.01).abs() <= 1e-15, "{solver}: {}", run.w(10));
    }
}
