//! How the path of a body that softens is followed, resolved.

use super::root;
use crate::case::{Case, Path, PathControl, Solver, Turn};
use crate::diagnostic::{Faults, suggest};
use crate::model::SofteningBonds;
use peristat_assembly::law::Bilinear;
use peristat_assembly::stiffness::Kinematics;

/// How a body is followed.
#[derive(Clone, Debug)]
pub struct PathScene {
    /// What drives it.
    pub control: PathControl,
    /// Largest growth of the load factor in a step.
    pub increment: f64,
    /// Where the path turns.
    pub turns: Vec<Goal>,
    /// Law of the bonds.
    pub law: Bilinear,
    /// Kinematics of the bonds.
    pub kinematics: Kinematics,
    /// Points whose bonds stay elastic, by number of the model.
    pub exempt: Vec<bool>,
    /// The probe that stands for the load.
    pub load: usize,
    /// The probe that it is drawn over.
    pub opening: Option<usize>,
    /// Part of the largest load below which the run ends.
    pub stop_below: Option<f64>,
    /// Largest energy that a step of dissipated energy takes, J.
    pub energy_increment: f64,
    /// Most steps.
    pub max_steps: usize,
    /// Steps from one record of all fields to the next.
    pub record_every: usize,
}

/// Where the path turns next.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Goal {
    /// Where the load factor has this value.
    LoadFactor(f64),
    /// Where the load has this value, the load factor falling.
    Load(f64),
}

/// `s_f/s_y` below which bodies are expected to snap back.
const BRITTLE: f64 = 2.5;

impl PathScene {
    /// What drives the body, and why.
    pub fn chosen(&self) -> (PathControl, String) {
        let ratio = self.law.brittleness();
        match (self.control, self.kinematics) {
            (PathControl::Auto, _) if ratio >= BRITTLE => {
                (PathControl::Displacement, format!("s_f/s_y = {ratio:.3}: no snap-back is expected"))
            }
            (PathControl::Auto, Kinematics::Linear) => (
                PathControl::Event,
                format!("s_f/s_y = {ratio:.3} is below {BRITTLE}: the body may snap back"),
            ),
            (PathControl::Auto, Kinematics::Finite) => (
                PathControl::Dissipation,
                format!("s_f/s_y = {ratio:.3} is below {BRITTLE}: the body may snap back"),
            ),
            (control, _) => (control, "the case asks for it".into()),
        }
    }
}

/// What is resolved before: the bonds, and points that stay elastic.
pub(super) struct Softening {
    pub(super) bonds: SofteningBonds,
    pub(super) exempt: Vec<bool>,
}

/// How a body of bonds that soften is followed, with the defaults of the case filled in.
pub(super) fn resolve(
    path: &mut Path,
    body: Softening,
    probes: &[&str],
    faults: &mut Faults,
) -> Option<PathScene> {
    let place = root("path");
    let mut fine = true;
    let mut part = |value: f64, key: &str, faults: &mut Faults| {
        if !(value > 0.0 && value <= 1.0) {
            fine = false;
            faults.error(place.key(key), format!("`{key}` must be between 0 and 1, found {value}"));
        }
    };
    part(*path.increment.get_or_insert(0.02), "increment", faults);
    if let Some(stop_below) = path.stop_below {
        part(stop_below, "stop_below", faults);
    }
    let energy_increment = *path.energy_increment.get_or_insert(0.25);
    if energy_increment.is_nan() || energy_increment <= 0.0 {
        fine = false;
        faults.error(place.key("energy_increment"), "`energy_increment` must be positive");
    }
    let max_steps = *path.max_steps.get_or_insert(10_000);
    let record_every = *path.record_every.get_or_insert(50);
    for (key, value) in [("max_steps", max_steps), ("record_every", record_every)] {
        if value == 0 {
            fine = false;
            faults.error(place.key(key), format!("`{key}` must be at least 1"));
        }
    }
    let control = *path.control.get_or_insert_default();
    if control == PathControl::Event && body.bonds.kinematics == Kinematics::Finite {
        fine = false;
        faults
            .error(
                place.key("control"),
                "`event` needs linear kinematics: with finite ones the path is no polyline",
            )
            .hint("use `displacement` or `dissipation`, or \"kinematics\": \"linear\" in the bond law");
    }
    if path.turns.is_empty() {
        path.turns.push(Turn::LoadFactor(1.0));
    }
    let mut from = 0.0;
    for (k, turn) in path.turns.iter().enumerate() {
        if let Turn::LoadFactor(to) = *turn {
            if to == from {
                fine = false;
                faults.error(
                    place.key("turns").index(k),
                    format!("the path is at the load factor {to} already"),
                );
            }
            from = to;
        } else if k == 0 {
            fine = false;
            faults
                .error(place.key("turns").index(k), "a path cannot begin by unloading")
                .hint("load first, by a load factor");
        } else {
            from = f64::NAN;
        }
    }
    let mut named = |name: &str, key: &str, faults: &mut Faults| {
        let found = probes.iter().position(|p| *p == name);
        if found.is_none() {
            fine = false;
            faults
                .error(place.key(key), format!("there is no probe `{name}`"))
                .hint(suggest(name, probes.iter().copied()));
        }
        found
    };
    let load = named(&path.load, "load", faults);
    let opening = path.opening.as_ref().and_then(|name| named(name, "opening", faults));
    let turns = path.turns.iter().map(|turn| match *turn {
        Turn::LoadFactor(to) => Goal::LoadFactor(to),
        Turn::Load(to) => Goal::Load(to),
    });
    let scene = PathScene {
        control,
        increment: path.increment.unwrap_or(0.02),
        turns: turns.collect(),
        law: body.bonds.law,
        kinematics: body.bonds.kinematics,
        exempt: body.exempt,
        load: load?,
        opening,
        stop_below: path.stop_below,
        energy_increment: energy_increment * body.bonds.crack_energy,
        max_steps,
        record_every,
    };
    fine.then_some(scene)
}

/// Faults of what a body that softens cannot have.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    if case.path.is_none() {
        return;
    }
    let foreign = [
        ("fracture", case.fracture.is_some(), "bonds of a law with softening fail by themselves"),
        ("steps", case.steps.is_some(), "`path.turns` says where the load factor goes"),
        (
            "load_cases",
            !case.load_cases.is_empty(),
            "what has softened depends on the order of loads: use `loads`",
        ),
        ("symmetry", !case.symmetry.is_empty(), "model the whole body"),
        ("periodic", !case.periodic.is_empty(), "model the whole body"),
    ];
    for (key, _, hint) in foreign.iter().filter(|f| f.1) {
        faults.error(root(key), format!("`{key}` and `path` do not go together")).hint(*hint);
    }
    if !matches!(case.solver, Solver::Auto | Solver::Sparse) {
        faults
            .error(root("solver"), "a body that softens keeps a sparse factor from step to step")
            .hint("use `auto` or `sparse`");
    }
}
