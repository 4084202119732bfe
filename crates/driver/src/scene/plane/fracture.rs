//! How the bonds of a body in the plane break.

use super::super::fracture::{self, FractureScene, foreign, needed};
use super::super::root;
use super::bonds::PlaneBonds;
use super::conditions::Conditions;
use super::ground::Ground;
use super::model::{self, Recipe};
use crate::case::{Case, CrackDirection, CriticalFormula, FieldName, Fracture};
use crate::diagnostic::{Faults, JsonPath};
use crate::run::fracture::FACTS;
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamNeighbourhood, CriticalStretches, OrthotropicError, OrthotropicParameters, ReleaseRates, Start,
};
use peristat_assembly::model::bond_plane::{
    Influence, PlaneParameters, critical_stretch, published_critical_stretch,
};
use peristat_assembly::model::plane::CriticalStretch;

/// How a body in the plane breaks.
#[derive(Clone, Debug)]
pub struct PlaneFracture {
    /// Load steps and critical stretches by offset.
    pub steps: FractureScene<CriticalStretch>,
    /// Per offset, whether its bonds lie along the fibres; empty if there are none.
    pub fibres: Vec<bool>,
    /// Where directions of cracks are found.
    pub directions: Vec<CrackDirection>,
}

impl PlaneFracture {
    /// Names of all that checks can ask for.
    pub fn facts(&self) -> Vec<String> {
        let general = general_facts(&self.fibres).into_iter();
        general.chain(self.directions.iter().flat_map(CrackDirection::facts)).collect()
    }
}

/// Names of what is known of a body with such fibres wherever cracks run.
fn general_facts(fibres: &[bool]) -> Vec<String> {
    let of_fibres = (!fibres.is_empty()).then_some("broken_fibre_bonds");
    FACTS.into_iter().chain(of_fibres).map(Into::into).collect()
}

/// What resolution looks at.
pub(super) struct Context<'a> {
    pub(super) ground: &'a Ground<'a>,
    pub(super) recipe: &'a Recipe,
    pub(super) conditions: &'a Conditions,
    pub(super) probes: &'a [&'a str],
}

/// The fracture of a case, with its defaults filled in.
pub(super) fn resolve(
    fracture: &mut Fracture,
    context: &Context,
    faults: &mut Faults,
) -> Option<PlaneFracture> {
    let path = root("fracture");
    if !context.ground.case.symmetry.is_empty() {
        // It is refused already; images have numbers of their own.
        return None;
    }
    let mut exempt = vec![false; context.ground.body.points()];
    for (k, name) in fracture.no_fail.iter().enumerate() {
        let points = context.ground.region(name, &path.key("no_fail").index(k), faults).unwrap_or_default();
        points.iter().for_each(|&p| exempt[p as usize] = true);
    }
    let conditions = context.conditions;
    let held = conditions.holds.iter().flat_map(|h| &h.points);
    let rigid = conditions.rigid.iter().flat_map(|r| &r.points);
    held.chain(rigid).for_each(|&p| exempt[p as usize] = true);
    let (critical, fibres) = critical(fracture, context, &path.key("critical"), faults)?;
    check_directions(fracture, &general_facts(&fibres), &path.key("directions"), faults);
    check_load(fracture, context.ground.case, &path.key("load"), faults);
    let directions = fracture.directions.clone();
    let steps = fracture::resolve(fracture, critical, exempt, context.probes, faults)?;
    let fracture = PlaneFracture { steps, fibres, directions };
    fracture::check_probes(context.ground.case, &fracture.facts(), faults);
    Some(fracture)
}

/// Critical stretches by offset, and which offsets are along fibres.
fn critical(
    fracture: &mut Fracture,
    context: &Context,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(CriticalStretch, Vec<bool>)> {
    match context.recipe.bonds {
        PlaneBonds::Central(parameters) => {
            let stretch = of_central(fracture, &parameters, context, path, faults)?;
            let offsets = context.recipe.bonds.offsets().map_or(1, |offsets| offsets.len());
            Some((CriticalStretch(vec![stretch; offsets]), Vec::new()))
        }
        PlaneBonds::Beams(parameters) => of_beams(fracture, &parameters, context, path, faults),
    }
}

fn of_central(
    fracture: &mut Fracture,
    parameters: &PlaneParameters,
    context: &Context,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<f64> {
    let given = &mut fracture.critical;
    foreign(
        &[
            ("fibre_stretch", given.fibre_stretch),
            ("matrix_stretch", given.matrix_stretch),
            ("fibre_energy_release_rate", given.fibre_energy_release_rate),
            ("matrix_energy_release_rate", given.matrix_energy_release_rate),
            ("curvature", given.curvature),
            ("shear_strain", given.shear_strain),
        ],
        "central bonds break by `stretch`, or by `energy_release_rate`",
        path,
        faults,
    );
    if given.stretch.is_some() && given.energy_release_rate.is_some() {
        faults
            .error(path.key("energy_release_rate"), "`stretch` and `energy_release_rate` are both given")
            .hint("the one follows from the other: remove one of them");
        return None;
    }
    let Some(rate) = given.energy_release_rate else {
        if given.formula.is_some() {
            faults.error(path.key("formula"), "`formula` is for energy release rates");
        }
        return needed(given.stretch, "stretch", path, faults);
    };
    needed(Some(rate), "energy_release_rate", path, faults)?;
    let is_lattice = matches!(context.ground.body, peristat_assembly::body::PlaneBody::Lattice(_));
    let default = if is_lattice { CriticalFormula::Energy } else { CriticalFormula::Published };
    match given.formula.get_or_insert(default) {
        CriticalFormula::Published if parameters.influence != Influence::Constant => {
            faults
                .error(path.key("formula"), "the published formula is that of the influence `constant`")
                .hint("use the formula `energy`, which knows the bonds");
            None
        }
        CriticalFormula::Published => {
            Some(published_critical_stretch(rate, parameters, context.recipe.horizon))
        }
        CriticalFormula::Energy if !is_lattice => {
            faults
                .error(path.key("formula"), "the formula `energy` needs the bonds of a lattice")
                .hint("use `published`, or give `stretch`");
            None
        }
        CriticalFormula::Energy => {
            let spacing = context.recipe.body.spacing();
            let found = critical_stretch(rate, parameters, spacing);
            found.map_err(|error| model::refuse(&error.into(), context.ground.case, faults)).ok()
        }
    }
}

fn of_beams(
    fracture: &mut Fracture,
    parameters: &OrthotropicParameters,
    context: &Context,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(CriticalStretch, Vec<bool>)> {
    let refuse = |error: OrthotropicError, faults: &mut Faults| {
        model::refuse(&error.into(), context.ground.case, faults);
    };
    let bonds = BeamNeighbourhood::new(parameters).map_err(|error| refuse(error, faults)).ok()?;
    if bonds.start() == Some(Start::Oblique) {
        // Why not the other way, unless it is for want of bonds along the fibres.
        let aligned = OrthotropicParameters { start: Some(Start::Aligned), ..*parameters };
        match BeamNeighbourhood::new(&aligned) {
            Err(OrthotropicError::NoFibreBonds { .. }) | Ok(_) => {}
            Err(error) => {
                refuse(error, faults);
                return None;
            }
        }
        faults
            .error(
                root("fracture"),
                "stiff bonds lie beside the fibres, not on them: cracks would run wrong although the moduli are exact",
            )
            .hint("turn the lattice with the fibres: \"lattice\": \"fibre\" in the model");
        return None;
    }
    let given = &mut fracture.critical;
    foreign(
        &[
            ("stretch", given.stretch),
            ("energy_release_rate", given.energy_release_rate),
            ("curvature", given.curvature),
            ("shear_strain", given.shear_strain),
        ],
        "beam bonds break by `fibre_stretch` and `matrix_stretch`, or by the energy release rates of both",
        path,
        faults,
    );
    let rates = [given.fibre_energy_release_rate, given.matrix_energy_release_rate];
    let stretches = [given.fibre_stretch, given.matrix_stretch];
    if stretches.iter().any(Option::is_some) && rates.iter().any(Option::is_some) {
        faults
            .error(path.clone(), "stretches and energy release rates are both given")
            .hint("the ones follow from the others: remove either");
        return None;
    }
    let critical = if rates.iter().any(Option::is_some) {
        let fibre = needed(rates[0], "fibre_energy_release_rate", path, faults);
        let matrix = needed(rates[1], "matrix_energy_release_rate", path, faults);
        let rates = ReleaseRates { fibre: fibre?, matrix: matrix? };
        match given.formula.get_or_insert_default() {
            CriticalFormula::Published => {
                CriticalStretches::published(rates, &parameters.material, context.recipe.horizon)
            }
            CriticalFormula::Energy => {
                let found = CriticalStretches::by_energy(rates, &bonds, context.recipe.body.spacing());
                found.map_err(|error| refuse(error, faults)).ok()?
            }
        }
    } else {
        if given.formula.is_some() {
            faults.error(path.key("formula"), "`formula` is for energy release rates");
        }
        let fibre = needed(stretches[0], "fibre_stretch", path, faults);
        let matrix = needed(stretches[1], "matrix_stretch", path, faults);
        CriticalStretches { fibre: fibre?, matrix: matrix? }
    };
    let fibres = bonds.is_fibre().to_vec();
    let by_offset = fibres.iter().map(|&along| if along { critical.fibre } else { critical.matrix });
    Some((CriticalStretch(by_offset.collect()), fibres))
}

/// Fault of a load that would take fields of every equilibrium.
fn check_load(fracture: &Fracture, case: &Case, path: &JsonPath, faults: &mut Faults) {
    use FieldName::{ReactionX, ReactionY, Ux, Uy};
    let probe = case.probes.iter().find(|p| p.name == fracture.load);
    if let Some(probe) = probe.filter(|p| !matches!(p.field, ReactionX | ReactionY | Ux | Uy)) {
        let message =
            format!("the probe `{}` is one of `{}`, which is no load", probe.name, probe.field.name());
        faults
            .error(path.clone(), message)
            .hint("use a probe of `reaction_x` or `reaction_y`, or of `ux` or `uy` where forces are given");
    }
}

/// Faults of directions, of which none may be known by a name among the `taken` ones.
fn check_directions(fracture: &Fracture, taken: &[String], path: &JsonPath, faults: &mut Faults) {
    for (k, direction) in fracture.directions.iter().enumerate() {
        let path = path.index(k);
        if fracture.directions[..k].iter().any(|d| d.name == direction.name) {
            faults.error(path.key("name"), format!("there are two directions `{}`", direction.name));
        }
        if let Some(name) = direction.facts().iter().find(|name| taken.contains(name)) {
            faults
                .error(path.key("name"), format!("checks know something else by the name `{name}`"))
                .hint("they know a direction as `<name>_direction` and `<name>_bonds`: choose another name");
        }
        if (0..2).any(|axis| direction.from[axis] >= direction.to[axis]) {
            faults
                .error(path.key("to"), "the part is empty: `to` must be above and to the right of `from`")
                .hint("`from` is the lower left corner, `to` the upper right one");
        }
    }
}
