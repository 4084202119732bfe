//! How the bonds of a body in the plane soften, and how it is followed.

use super::super::fracture;
use super::super::path::{self, PathScene, Softening};
use super::super::root;
use super::bonds::PlaneBonds;
use super::fracture::check_load;
use super::model::{self};
use super::site::Site;
use crate::case::{BilinearLaw, Case, CriticalFormula, Model, Path, PlaneBondLaw};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use crate::run::path::PATH_FACTS;
use peristat_assembly::body::PlaneBody;
use peristat_assembly::law::{Bilinear, Compression, Unloading};
use peristat_assembly::model::bond_plane::{
    Influence, PlaneParameters, critical_stretch, failure_stretch, published_critical_stretch, yield_stretch,
};
use peristat_assembly::model::plane::Edges;

/// `s_f/s_y` below which hardly anything of softening is left.
const NEARLY_BRITTLE: f64 = 1.05;

/// The law of the bonds in the model of a case, if they have one.
pub(super) fn law_of(case: &Case) -> Option<&BilinearLaw> {
    match &case.model {
        Model::BondPlane(plane) => plane.bond_law.as_ref().map(|PlaneBondLaw::Bilinear(law)| law),
        _ => None,
    }
}

/// The path of a case, with its defaults filled in.
pub(super) fn resolve(
    path: &mut Path,
    site: &Site,
    probes: &[&str],
    faults: &mut Faults,
) -> Option<PathScene> {
    let (case, place) = (site.ground.case, root("path"));
    let Some(given) = law_of(case) else {
        faults
            .error(place, "`path` is for bonds that soften, and these are elastic")
            .hint("give \"bond_law\": { \"bilinear\": … } in the model `bond_plane`");
        return None;
    };
    let PlaneBonds::Central(parameters) = site.recipe.bonds else { return None };
    if parameters.edges == Edges::Overlay {
        faults
            .error(root("model").key("bond_plane").key("edges"), "triangles of the overlay do not soften")
            .hint("use `border`, the default, or `none`");
        return None;
    }
    if !site.conditions.springs.is_empty() {
        faults
            .error(root("supports"), "springs to the ground do not go with `path`")
            .hint("prescribe motions, or hold the place");
        return None;
    }
    let mut exempt = vec![false; site.ground.body.points()];
    for (k, name) in path.no_damage.iter().enumerate() {
        let points = site.ground.region(name, &place.key("no_damage").index(k), faults).unwrap_or_default();
        points.iter().for_each(|&p| exempt[p as usize] = true);
    }
    // A path in a body with images, whose points have other numbers, is refused.
    let gripped = site.conditions.gripped_points().filter(|&p| p < site.ground.body.points());
    gripped.for_each(|p| exempt[p] = true);
    check_load(&path.load, case, &place.key("load"), faults);
    let law = law(given, &parameters, site, faults)?;
    let spacing = site.recipe.body.spacing();
    let material = parameters.material;
    // The energy of a bond triangle on a crack one spacing long; by the published integral where no rate is given.
    let published = published_critical_stretch(1.0, &parameters, site.recipe.horizon);
    let rate = law.yield_stretch() * law.failure_stretch() / (published * published);
    let crack_energy = given.energy_release_rate.unwrap_or(rate) * material.thickness * spacing;
    let body = Softening { law, kinematics: given.kinematics, exempt, crack_energy };
    fracture::check_probes(case, &PATH_FACTS, faults);
    path::resolve(path, body, probes, faults)
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
    site: &Site,
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
            failure_stretch(critical(rate, given.formula, parameters, site, &path, faults)?, yielding)
        }
        (None, None) => return None,
    };
    check_ductility(yielding, failing, rate, site, &path, faults)?;
    Bilinear::new([yielding, failing], given.unloading, given.compression).ok()
}

/// Refuses bonds that fail no later than they yield.
fn check_ductility(
    yielding: f64,
    failing: f64,
    rate: Option<f64>,
    site: &Site,
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
    let horizon = site.recipe.horizon;
    let key = if site.ground.case.horizon.is_some() { "horizon" } else { "horizon_ratio" };
    faults
        .error(
            root(key),
            format!(
                "the horizon {} is not below {}, the largest with which these bonds yield before they fail",
                tidy(horizon),
                tidy(ratio * horizon)
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
    site: &Site,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
    let constant = parameters.influence == Influence::Constant;
    let default = if constant { CriticalFormula::Published } else { CriticalFormula::Energy };
    let formula = formula.unwrap_or(default);
    let is_lattice = matches!(site.recipe.body, PlaneBody::Lattice(_));
    if formula == CriticalFormula::Published && !constant {
        faults
            .error(path.key("formula"), "the published formula is that of the influence `constant`")
            .hint("use the formula `energy`, which knows the bonds");
        return None;
    }
    if formula == CriticalFormula::Published {
        return Some(published_critical_stretch(rate, parameters, site.recipe.horizon));
    }
    if !is_lattice {
        faults
            .error(path.key("formula"), "the formula `energy` needs the bonds of a lattice")
            .hint("use the influence `constant` and the formula `published`, or give `failure_stretch`");
        return None;
    }
    let found = critical_stretch(rate, parameters, site.recipe.body.spacing());
    found.map_err(|error| model::refuse(&error.into(), site.ground.case, faults)).ok()
}
