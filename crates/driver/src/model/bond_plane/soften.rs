//! How central bonds yield and soften.

use super::super::{CriticalFormula, OnGround, Refusal, SofteningBonds};
use super::{BilinearLaw, PlaneBondLaw};
use crate::diagnostic::{Faults, JsonPath, positive, root, tidy};
use peristat_assembly::law::{Bilinear, Compression, Unloading};
use peristat_assembly::model::bond_plane::{
    PlaneParameters, critical_stretch, failure_stretch, published_critical_stretch, yield_stretch,
};
use peristat_assembly::model::plane::Edges;

/// `s_f/s_y` below which hardly anything of softening is left.
const NEARLY_BRITTLE: f64 = 1.05;

/// Bonds that soften by a law.
pub(super) fn bonds(
    PlaneBondLaw::Bilinear(given): &PlaneBondLaw,
    parameters: &PlaneParameters,
    on: &OnGround,
    faults: &mut Faults,
) -> Option<SofteningBonds> {
    if parameters.edges == Edges::Overlay {
        faults
            .error(root("model").key("bond_plane").key("edges"), "triangles of the overlay do not soften")
            .hint("use `border`, the default, or `none`");
        return None;
    }
    let law = law(given, parameters, on, faults)?;
    // The energy of a bond triangle on a crack one spacing long; by the published integral where no rate is given.
    let published = published_critical_stretch(1.0, parameters, on.horizon);
    let rate = law.yield_stretch() * law.failure_stretch() / (published * published);
    let crack_energy = given.energy_release_rate.unwrap_or(rate) * parameters.material.thickness * on.spacing;
    Some(SofteningBonds { law, kinematics: given.kinematics, crack_energy })
}

/// One of two numbers that follow from each other.
fn one_of(pair: [(Option<f64>, &str); 2], path: &JsonPath, faults: &mut Faults) -> Option<[Option<f64>; 2]> {
    let [(a, first), (b, second)] = pair;
    match (a, b) {
        (Some(_), Some(_)) => {
            faults
                .error(path.key(second), format!("`{first}` and `{second}` are both given"))
                .hint("the one follows from the other: remove one of them");
            None
        }
        (None, None) => {
            faults.error(path.clone(), format!("`{first}` is missing, or `{second}`"));
            None
        }
        _ => {
            let (value, key) = if a.is_some() { (a, first) } else { (b, second) };
            let fine = value.is_some_and(|v| positive(v, key, path.key(key), faults));
            fine.then_some([a, b])
        }
    }
}

/// The law of the bonds.
fn law(
    given: &BilinearLaw,
    parameters: &PlaneParameters,
    on: &OnGround,
    faults: &mut Faults,
) -> Option<Bilinear> {
    let path = root("model").key("bond_plane").key("bond_law").key("bilinear");
    let yields =
        one_of([(given.yield_stress, "yield_stress"), (given.yield_stretch, "yield_stretch")], &path, faults);
    let fails = one_of(
        [(given.energy_release_rate, "energy_release_rate"), (given.failure_stretch, "failure_stretch")],
        &path,
        faults,
    );
    let scale = given.yield_scale.unwrap_or(1.0);
    let fine = positive(scale, "yield_scale", path.key("yield_scale"), faults);
    if given.yield_scale.is_some() && given.yield_stress.is_none() {
        faults
            .error(path.key("yield_scale"), "`yield_scale` is for `yield_stress`")
            .hint("give the `yield_stretch` that you want");
        return None;
    }
    if given.unloading == Unloading::Damage && given.compression == Compression::PerfectlyPlastic {
        faults
            .error(path.key("compression"), "`perfectly_plastic` compression goes with `plastic` unloading")
            .hint("bonds that unload by damage keep no stretch: use `elastic`");
        return None;
    }
    let ([stress, stretch], [rate, failure]) = (yields?, fails?);
    if !fine {
        return None;
    }
    let yielding = stretch.or(stress.map(|s| scale * yield_stretch(s, &parameters.material)))?;
    let failing = match (failure, rate) {
        (Some(failure), _) => failure,
        (None, Some(rate)) => {
            failure_stretch(critical(rate, given.formula, parameters, on, &path, faults)?, yielding)
        }
        (None, None) => return None,
    };
    check_ductility(yielding, failing, rate, on, &path, faults)?;
    Bilinear::new([yielding, failing], given.unloading, given.compression).ok()
}

/// Refuses bonds that fail no later than they yield.
fn check_ductility(
    yielding: f64,
    failing: f64,
    rate: Option<f64>,
    on: &OnGround,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<()> {
    let ratio = failing / yielding;
    if ratio > 1.0 {
        if ratio < NEARLY_BRITTLE {
            faults
                .warning(path.clone(), format!("s_f/s_y = {}: bonds are nearly brittle", tidy(ratio)))
                .hint("expect many snap-backs; a smaller horizon makes bonds more ductile");
        }
        return Some(());
    }
    if rate.is_none() {
        faults
            .error(path.key("failure_stretch"), format!("the failure stretch {} is not above the yield stretch {}", tidy(failing), tidy(yielding)))
            .hint("brittle bonds, which fail where they would yield, are those of `fracture` with `critical.stretch`");
        return None;
    }
    faults
        .error(
            root(on.horizon_key),
            format!(
                "the horizon {} is not below {}, the largest with which these bonds yield before they fail",
                tidy(on.horizon),
                tidy(ratio * on.horizon)
            ),
        )
        .hint("the failure stretch is proportional to 1/δ: use a smaller spacing, or brittle bonds under `fracture`");
    None
}

/// The critical stretch of a brittle bond of the same energy.
fn critical(
    rate: f64,
    formula: Option<CriticalFormula>,
    parameters: &PlaneParameters,
    on: &OnGround,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
    let is_suited = parameters.suits_published_formulas();
    let default = if is_suited { CriticalFormula::Published } else { CriticalFormula::Energy };
    let formula = formula.unwrap_or(default);
    if formula == CriticalFormula::Growth {
        faults
            .error(path.key("formula"), "the formula `growth` is of bonds that break at once")
            .hint("use `energy`: bonds that soften dissipate what they are given, and the lattice holds them back less");
        return None;
    }
    if formula == CriticalFormula::Published && !is_suited {
        faults
            .error(
                path.key("formula"),
                "the published formula is that of the influence `constant` and the weights `nearest`",
            )
            .hint("use the formula `energy`, which knows the bonds");
        return None;
    }
    if formula == CriticalFormula::Published {
        return Some(published_critical_stretch(rate, parameters, on.horizon));
    }
    if !on.is_lattice {
        faults
            .error(path.key("formula"), "the formula `energy` needs the bonds of a lattice")
            .hint("use the influence `constant` and the formula `published`, or give `failure_stretch`");
        return None;
    }
    let found = critical_stretch(rate, parameters, on.spacing).map_err(Refusal::from);
    found.map_err(|refusal| refusal.tell("bond_plane", on.horizon_key, faults)).ok()
}
