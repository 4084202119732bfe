//! How the bonds of a body break, resolved.

use super::root;
use crate::case::{Case, Fracture, Solver, Strategy};
use crate::diagnostic::{Faults, suggest};

/// Load steps of a body whose bonds break at the critical strains `C` of its model.
#[derive(Clone, Debug)]
pub struct FractureScene<C> {
    /// Strains at which bonds break.
    pub critical: C,
    /// Which of the overstrained bonds break together.
    pub strategy: Strategy,
    /// Ratio of a strain to its critical one, over the largest such ratio, from which bonds break together.
    pub threshold: f64,
    /// Growth of the load factor from step to step.
    pub increment: f64,
    /// Points whose bonds do not break, by number of the model.
    pub exempt: Vec<bool>,
    /// The probe that stands for the load.
    pub load: usize,
    /// Part of the largest load below which the run ends.
    pub stop_below: f64,
    /// Most equilibria.
    pub max_solves: usize,
    /// Equilibria from one record of all fields to the next.
    pub record_every: usize,
}

/// Bonds whose ratio differs by less from the largest one break with it: a symmetric body breaks symmetrically.
const TIE: f64 = 1e-5;

/// What fracture of any model has, but for its critical strains and the points that are exempt; fills in the defaults of
/// the case.
pub(super) fn resolve<C>(
    fracture: &mut Fracture,
    critical: C,
    exempt: Vec<bool>,
    probes: &[&str],
    faults: &mut Faults,
) -> Option<FractureScene<C>> {
    let path = root("fracture");
    let strategy = *fracture.strategy.get_or_insert_default();
    let mut fine = true;
    let mut part = |value: f64, key: &str, faults: &mut Faults| {
        if !(value > 0.0 && value < 1.0) {
            fine = false;
            faults.error(path.key(key), format!("`{key}` must be between 0 and 1, found {value}"));
        }
    };
    if strategy == Strategy::Batch {
        part(*fracture.batch_threshold.get_or_insert(0.9), "batch_threshold", faults);
    } else if fracture.batch_threshold.is_some() {
        faults
            .error(path.key("batch_threshold"), "`batch_threshold` is for the strategy `batch`")
            .hint("remove it, or take \"strategy\": \"batch\"");
    }
    part(*fracture.stop_below.get_or_insert(0.1), "stop_below", faults);
    if strategy == Strategy::Worst {
        if fracture.increment.is_some() {
            faults
                .error(path.key("increment"), "`increment` does nothing with the strategy `worst`")
                .hint("`worst` goes from break to break: the load follows from the bonds");
        }
    } else {
        part(*fracture.increment.get_or_insert(0.02), "increment", faults);
    }
    let max_solves = *fracture.max_solves.get_or_insert(5000);
    let record_every = *fracture.record_every.get_or_insert(10);
    for (key, value) in [("max_solves", max_solves), ("record_every", record_every)] {
        if value == 0 {
            fine = false;
            faults.error(path.key(key), format!("`{key}` must be at least 1"));
        }
    }
    let load = probes.iter().position(|p| *p == fracture.load);
    if load.is_none() {
        faults
            .error(path.key("load"), format!("there is no probe `{}`", fracture.load))
            .hint(suggest(&fracture.load, probes.iter().copied()));
    }
    let threshold = match strategy {
        Strategy::Batch => fracture.batch_threshold.unwrap_or(0.9),
        Strategy::Worst => 1.0 - TIE,
        Strategy::All => 0.0,
    };
    let scene = FractureScene {
        critical,
        strategy,
        threshold,
        increment: fracture.increment.unwrap_or(0.02),
        exempt,
        load: load?,
        stop_below: fracture.stop_below.unwrap_or(0.1),
        max_solves,
        record_every,
    };
    fine.then_some(scene)
}

/// Faults of what a body that breaks cannot have: loads and motions grow together, from zero.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    if case.fracture.is_none() {
        return;
    }
    let foreign = [
        ("steps", case.steps.is_some(), "the load factor grows by `fracture.increment`, or as bonds break"),
        (
            "load_cases",
            !case.load_cases.is_empty(),
            "what has broken depends on the order of loads: use `loads`",
        ),
        ("symmetry", !case.symmetry.is_empty(), "cracks need not stay symmetric: model the whole body"),
        ("periodic", !case.periodic.is_empty(), "cracks need not repeat themselves: model the whole body"),
        (
            "stress_intensity",
            !case.stress_intensity.is_empty(),
            "it moves the tips of cracks that do not grow: leave out `fracture`",
        ),
    ];
    for (key, _, hint) in foreign.iter().filter(|f| f.1) {
        faults.error(root(key), format!("`{key}` and `fracture` do not go together")).hint(*hint);
    }
    let is_solid = case.model.keys().is_ok_and(|keys| keys.is_solid());
    match case.solver {
        Solver::Auto | Solver::Sparse => {}
        Solver::Multigrid if is_solid => {}
        Solver::Strain | Solver::Band | Solver::Multigrid | Solver::Pcg => {
            faults
                .error(
                    root("solver"),
                    "a body that breaks keeps a sparse factor from equilibrium to equilibrium",
                )
                .hint(if is_solid {
                    "use `auto`, `sparse` or `multigrid`"
                } else {
                    "use `auto` or `sparse`"
                });
        }
    }
}

/// Faults of probes that have the name of something that checks know of a body that breaks.
pub(super) fn check_probes(case: &Case, facts: &[impl AsRef<str>], faults: &mut Faults) {
    for (k, probe) in case.probes.iter().enumerate() {
        if facts.iter().any(|fact| fact.as_ref() == probe.name) {
            let message = format!("checks know something else by the name `{}`", probe.name);
            faults
                .error(root("probes").index(k).key("name"), message)
                .hint("facts of a body that breaks have names of their own: choose another one");
        }
    }
}
