//! Points and blocks that come off a plate, and the equilibria of what is left.

use super::islands::Islands;
use super::lost::LostParts;
use super::unit::{Outcome, Unit};
use crate::case::from_text;
use crate::input::Folder;
use crate::model::AnyBody;
use crate::run::body::BodyProblem;
use crate::run::{Problem, RunOptions, Timing, prepare};
use crate::scene::Scene;
use crate::scene::body::BodyScene;
use peristat_assembly::model::plane::BreakingModel;
use peristat_assembly::system::System;
use peristat_solve::PcgStatus;
use serde_json::{Value, json};
use std::path::Path;

/// A plate of 28 × 16 points with fibres at 45 degrees, pulled by its ends.
fn scene() -> BodyScene {
    scene_at(2.5)
}

fn scene_at(spacing: f64) -> BodyScene {
    let fibres = json!({ "beam_bond_orthotropic": { "youngs_modulus_1": 105000, "youngs_modulus_2": 8400,
        "poisson_ratio_12": 0.32, "shear_modulus_12": 4000, "thickness": 0.6, "fibre_angle": 45, "edges": "none" } });
    scene_of(&fibres, spacing, json!({ "phi": 0 }))
}

fn scene_of(model: &Value, spacing: f64, also_held: Value) -> BodyScene {
    let mut case = json!({
        "title": "plate", "units": "mm-N-MPa", "model": model,
        "body": { "rectangle": { "size": [70, 40], "spacing": spacing } },
        "horizon_ratio": 3.015, "solver": "sparse",
        "regions": { "left grip": { "box": { "from": [0, 0], "to": [7.5, 40] } },
            "right grip": { "box": { "from": [62.5, 0], "to": [70, 40] } } },
        "supports": [ { "at": { "region": "left grip" }, "ux": -2, "uy": 0 },
            { "at": { "region": "right grip" }, "ux": 2, "uy": 0 } ]
    });
    for support in case["supports"].as_array_mut().expect("a list") {
        support.as_object_mut().expect("keys").extend(also_held.as_object().expect("keys").clone());
    }
    let source = from_text("case", case.to_string(), &[], &Folder::default())
        .unwrap_or_else(|report| panic!("{report}"));
    let scene = Scene::new(source.case, Path::new("."), "case", &source.text, None);
    scene.unwrap_or_else(|report| panic!("{report}")).into_body().expect("a plate")
}

type Plate<'a> = BodyProblem<'a, dyn BreakingModel<3>>;

/// A body whose bonds break, its system, and the first equilibrium without loads.
fn begun<const D: usize>(
    scene: &BodyScene,
    model: Box<dyn BreakingModel<D>>,
) -> (BodyProblem<'_, dyn BreakingModel<D>>, System<D>, Unit<D>) {
    let plate = BodyProblem::new(scene, model);
    let (system, _) = prepare::<D>(&plate, &RunOptions::default()).unwrap();
    let loads = vec![0.0; system.size()];
    let mut timing = Timing::default();
    let mut unit = Unit::new(&plate, &system, (loads, None), 1e-12, &mut timing).unwrap();
    assert_eq!(unit.solve(&plate, &system, &mut timing).unwrap(), (Outcome::Found, false));
    (plate, system, unit)
}

/// Cuts all bonds from some cells to others, and finds what has come off.
fn cut_out(
    plate: &mut Plate,
    (system, islands): (&mut System<3>, &mut Islands),
    unit: &Unit<3>,
    cells: &[[i32; 2]],
) -> bool {
    let (lattice, _) = plate.model.lattice().unwrap();
    let points: Vec<usize> =
        cells.iter().map(|&cell| lattice.number([cell[0], cell[1], 0]).unwrap()).collect();
    let crosses = |&bond: &u64| {
        let [a, b] = plate.model.ends(bond);
        points.contains(&a) != points.contains(&b)
    };
    let bonds: Vec<u64> = (0..plate.model.bond_numbers()).filter(crosses).collect();
    system.change_model(&mut *plate.model, |model| model.break_bonds(&bonds));
    let equations = Problem::<3>::equations(plate).to_vec();
    islands.find(&*plate.model, system, &equations, [&unit.u, &unit.loads])
}

#[test]
fn a_point_and_a_block_come_off_and_the_old_inverse_finds_the_rest() {
    let scene = scene();
    let AnyBody::Three(body) = &scene.model else { panic!("beam bonds") };
    let (mut plate, mut system, mut unit) = begun(&scene, body.breaking().unwrap());
    let mut timing = Timing::default();
    let mut islands = Islands::new::<3>(&*plate.model);

    assert!(cut_out(&mut plate, (&mut system, &mut islands), &unit, &[[14, 8]]));
    assert_eq!(islands.points(), 1);
    // Without a new factor: 16 iterations at most.
    assert_eq!(unit.solve(&plate, &system, &mut timing).unwrap(), (Outcome::Found, false));

    // Four points; the six bonds between them stay.
    let block = [[8, 5], [9, 5], [8, 6], [9, 6]];
    assert!(cut_out(&mut plate, (&mut system, &mut islands), &unit, &block));
    assert_eq!(islands.points(), 5);
    assert_eq!(unit.solve(&plate, &system, &mut timing).unwrap().0, Outcome::Found);
    let found = unit.u.clone();

    unit.renew(&plate, &system, &mut timing).unwrap();
    unit.u.fill(0.0);
    assert_eq!(unit.solve(&plate, &system, &mut timing).unwrap().0, Outcome::Found);
    let largest = found.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
    let difference = found.iter().zip(&unit.u).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    // Measured: 2e-12.
    assert!(difference <= 1e-8 * largest, "{difference} of {largest}");
    // What has come off is at rest.
    let (lattice, _) = plate.model.lattice().unwrap();
    let n = lattice.points();
    let off = block.iter().chain(&[[14, 8]]).flat_map(|&cell| (0..3).map(move |c| (cell, c)));
    assert!(
        off.into_iter()
            .all(|(cell, c)| unit.u[c * n + lattice.number([cell[0], cell[1], 0]).unwrap()] == 0.0)
    );
}

/// Displacements of the same plate of 2800 points, which is factored by halves, when it loses the bonds across a part of its middle, bond row by bond row, and iterations of all equilibria;
/// with what it has lost told to the factor, or with a new factor each time.
fn torn(tells: bool) -> (Vec<f64>, Vec<usize>, usize) {
    let scene = scene_at(1.0);
    let AnyBody::Three(body) = &scene.model else { panic!("beam bonds") };
    let (mut plate, mut system, mut unit) = begun(&scene, body.breaking().unwrap());
    let mut timing = Timing::default();
    let mut iterations = Vec::new();
    for top in 1..6 {
        let crosses = |&bond: &u64| {
            let [a, b] = plate.model.ends(bond).map(|p| plate.model.place(p));
            let within = |y: f64| y > 20.0 + f64::from(top - 1) && y < 20.0 + f64::from(top);
            (a[0] < 35.1) != (b[0] < 35.1) && within(0.5 * (a[1] + b[1]))
        };
        let bonds: Vec<u64> = (0..plate.model.bond_numbers()).filter(crosses).collect();
        assert!(bonds.len() > 3, "{bonds:?}");
        unit.lose(&plate.model.part(&bonds).into());
        system.change_model(&mut *plate.model, |model| model.break_bonds(&bonds));
        if !tells {
            unit.renew(&plate, &system, &mut timing).expect("a factor");
        }
        let (outcome, renewed) = unit.solve(&plate, &system, &mut timing).expect("an equilibrium");
        assert_eq!((outcome, renewed), (Outcome::Found, false));
        iterations.push(unit.iterations);
    }
    (unit.u, iterations, unit.counters.factorisations)
}

#[test]
fn equilibria_without_what_was_lost_are_those_of_a_new_factor() {
    let [(found, iterations, factors), (expected, anew, factors_anew)] = [true, false].map(torn);
    assert_eq!((factors, factors_anew), (1, 6));
    // A new factor takes one step, that of the intact plate more and more.
    assert_eq!((iterations, anew), (vec![9, 11, 11, 12, 12], vec![1; 5]));
    let largest = expected.iter().fold(0.0_f64, |m, u| m.max(u.abs()));
    let difference = found.iter().zip(&expected).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
    // Measured: 1.9e-12.
    assert!(difference <= 1e-11 * largest, "{difference:e} of {largest}");
}

#[test]
fn what_comes_off_is_not_told_to_the_factor_and_neither_are_loads_elsewhere() {
    let scene = scene_at(1.0);
    let AnyBody::Three(body) = &scene.model else { panic!("beam bonds") };
    let (mut plate, mut system, mut unit) = begun(&scene, body.breaking().unwrap());
    assert!(!unit.lost_parts.suits(&system), "nothing is lost");

    let mut residual = vec![0.0; system.size()];
    let inverse = |unit: &mut Unit<3>, residual: &[f64], lost: &mut LostParts<3>, system: &System<3>| {
        let factor = unit.inverse.dissected().expect("a factor by halves");
        let mut u = vec![0.0; residual.len()];
        lost.correct(system, factor, (residual, &mut u), 1e-3, 20).map(|report| report.status)
    };
    let mut lost = LostParts::new(&system);
    let (lattice, _) = plate.model.lattice().expect("a lattice");
    let point = lattice.number([30, 20, 0]).expect("a point");
    let bond = (0..plate.model.bond_numbers()).find(|bond| plate.model.ends(*bond).contains(&point));
    lost.push(&plate.model.part(&[bond.expect("a bond")]).into());
    assert!(lost.suits(&system));
    residual[point] = 1.0;
    assert_eq!(inverse(&mut unit, &residual, &mut lost, &system), Some(PcgStatus::Converged));
    residual[point + 30] = 1.0;
    assert_eq!(inverse(&mut unit, &residual, &mut lost, &system), None);

    let mut islands = Islands::new::<3>(&*plate.model);
    assert!(cut_out(&mut plate, (&mut system, &mut islands), &unit, &[[30, 20]]));
    assert!(!lost.suits(&system), "a point came off");
}

/// What they lose, they share with all others.
#[test]
fn families_are_not_told_to_the_factor() {
    let model =
        json!({ "state_plane": { "youngs_modulus": 1000, "poisson_ratio": 0.3, "state": "plane_stress" } });
    let scene = scene_of(&model, 1.0, json!({}));
    let AnyBody::Two(body) = &scene.model else { panic!("families") };
    let (mut plate, mut system, mut unit) = begun(&scene, body.breaking().unwrap());
    let mut timing = Timing::default();
    let place = |bond: &u64| plate.model.ends(*bond).map(|p| plate.model.place(p));
    let is_inside =
        |bond: &u64| place(bond).iter().all(|[x, y]| (x - 35.0).abs() < 2.0 && (y - 20.0).abs() < 2.0);
    let bond = (0..plate.model.bond_numbers()).find(is_inside).expect("a bond");
    unit.lose(&plate.model.part(&[bond]).into());
    assert!(!unit.lost_parts.suits(&system));
    system.change_model(&mut *plate.model, |model| model.break_bonds(&[bond]));
    assert_eq!(unit.solve(&plate, &system, &mut timing).expect("an equilibrium"), (Outcome::Found, false));
}
