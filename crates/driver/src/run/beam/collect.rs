//! From a solved state to its result.

use super::{BeamResult, LineFields, LinePoints, eigenstrain, reaction, twin};
use crate::case::FieldName;
use crate::run::workspace::StateSolution;
use crate::run::{Resultants, SolvedState, StateRecord};
use crate::scene::beam::{BeamScene, State, resultant, resultant_of};
use peristat_assembly::model::timoshenko_beam::{BeamLoads, Grid, Inside, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;

/// Collects the result of a state.
pub(super) fn result(scene: &BeamScene, solved: SolvedState, recover: bool) -> BeamResult {
    let state = &scene.states[solved.state];
    of_beam(scene, (&scene.beam, &scene.springs), state, solved, recover)
}

/// The same for a beam that has broken bonds, maybe, on the springs that act, under a state of its own.
pub(super) fn of_beam(
    scene: &BeamScene,
    (beam, springs): (&TimoshenkoBeam, &[Spring]),
    state: &State,
    solved: SolvedState,
    recover: bool,
) -> BeamResult {
    let SolvedState { state: index, load, mut solution, mut certificate } = solved;
    let n = beam.points();
    let mut u = std::mem::take(&mut solution.u);
    if scene.has_axial {
        beam.fill_axial(&mut u);
    }
    let all = recover.then(|| forces_on_points(scene, springs, load, &solution, &u));
    let lumped = if recover { lumped_forces(scene, springs, &state.loads, &u) } else { None };
    let line = |c: usize| {
        let chain = &beam.chains()[c];
        LineFields {
            x: LinePoints::new(chain),
            first: beam.first_real(c),
            origin: chain.line().origin,
            direction: chain.line().direction,
            stiffness: chain.line().stiffness.clone(),
            section: scene.sections[c].clone(),
            from: chain.line().from,
            stored: (recover && scene.fracture.is_some()).then(|| beam.energy_density(c, &u)),
            forces: all.as_ref().map(|all| {
                let mut forces = beam.section_forces(c, all, lumped.as_deref(), &state.loads);
                let strained = state.eigenstrains.iter().filter(|given| given.chain == c);
                strained.for_each(|given| eigenstrain::take_off(given, &mut forces));
                forces
            }),
        }
    };
    let lines = (0..beam.chains().len()).map(line).collect();
    certificate.energy +=
        eigenstrain::energy(&state.eigenstrains, beam, &u) + between_points(scene, &state.loads);
    // A strain form whose forces on points nobody asks for has none.
    if !load.is_empty() {
        let resultants = resultants(scene, (beam, springs), state, (load, &solution.held), &u);
        // Loads on parts that have come off act no more.
        let whole = scene.fracture.is_none() || index == 0;
        certificate.account(resultants, if whole { scene.slack(&state.loads) } else { f64::INFINITY });
    }
    let held = reaction::forces(scene, &solution.multipliers, springs, &u);
    let fields = FieldName::of_beam(scene.frame.is_some(), scene.has_axial);
    let (name, load_factor) = (state.name.clone(), state.load_factor);
    BeamResult {
        record: StateRecord { index, name, load_factor, u, certificate, facts: None },
        lines,
        reactions: reaction::of_lines(scene, &held),
        joint_reactions: reaction::of_joints(scene, &held),
        held,
        one_way: None,
        points: n,
        fields,
    }
}

/// Energy of the loads between points, which the bonds of a beam that is exact lack. What others store is what their bonds do.
fn between_points(scene: &BeamScene, loads: &BeamLoads) -> f64 {
    if scene.fracture.is_some() || !twin::departures(scene).is_empty() {
        return 0.0;
    }
    let chains = scene.beam.chains().iter().enumerate();
    chains.map(|(number, chain)| Inside::new(loads, number, chain).stored(scene.has_axial)).sum()
}

/// Resultants of the loads of a state, and of what holds the beam.
fn resultants(
    scene: &BeamScene,
    (beam, springs): (&TimoshenkoBeam, &[Spring]),
    state: &State,
    (load, held): (&[f64], &[(usize, f64)]),
    u: &[f64],
) -> Resultants {
    let n = beam.points();
    let springs = springs.iter().flat_map(|spring| spring.forces(n, u)).map(|(k, f)| (k, -f));
    let reactions = resultant_of(beam, held.iter().copied().chain(springs));
    Resultants::new(&scene.asked(state), &resultant(beam, load), &reactions, (scene.statical(), [false; 3]))
}

/// Loads and the forces of supports, links and springs, by unknown.
fn forces_on_points(
    scene: &BeamScene,
    springs: &[Spring],
    load: &[f64],
    StateSolution { held, multipliers, .. }: &StateSolution,
    u: &[f64],
) -> Vec<f64> {
    let n = scene.beam.points();
    let mut forces = load.to_vec();
    let on_cells = scene.beam.chains().iter().any(|c| c.line().grid == Grid::Cells);
    if on_cells || scene.fracture.is_some() {
        // Ghost points alone hold the ends of a grid of cells: their forces stand for the support. What has come off is
        // held without a support.
        held.iter().for_each(|&(k, force)| forces[k] += force);
    } else {
        for (equation, multiplier) in scene.equations.iter().zip(multipliers) {
            for (unknown, coefficient) in &equation.terms {
                forces[unknown.component * n + unknown.point] += coefficient * multiplier;
            }
        }
    }
    for (unknown, force) in springs.iter().flat_map(|spring| spring.forces(n, u)) {
        forces[unknown] -= force;
    }
    forces
}

/// Forces on points that stand for what acts all along their parts: lumped loads and foundations.
fn lumped_forces(scene: &BeamScene, springs: &[Spring], loads: &BeamLoads, u: &[f64]) -> Option<Vec<f64>> {
    let has_loads = loads.lumped && !loads.distributed.is_empty();
    if !has_loads && scene.bedding.is_empty() {
        return None;
    }
    let (n, mut forces) = (scene.beam.points(), vec![0.0; u.len()]);
    if has_loads {
        BeamLoads { point: Vec::new(), ..loads.clone() }.add_to(&scene.beam, &mut forces);
    }
    for (unknown, force) in springs[scene.bedding.clone()].iter().flat_map(|spring| spring.forces(n, u)) {
        forces[unknown] -= force;
    }
    Some(forces)
}
