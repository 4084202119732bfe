//! The fields of a body: which its points have, and which its probes can ask for.

use crate::case::{Case, FieldName, Load, Origin};
use crate::diagnostic::{Faults, JsonPath};
use crate::model::{Material, Surface};
use crate::scene::body::hold::rigid::{self, MOTIONS};
use crate::scene::words;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::Component;

/// How the points of a body have a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Has {
    /// They do not.
    No,
    /// It is answered, but no table shows it: it is zero by the nature of the body, or found on demand.
    Unlisted,
    /// It varies.
    Values,
}

/// What a case says of its material beyond what a model needs.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Says {
    has_fibres: bool,
    has_strengths: bool,
    is_heated: bool,
    has_materials: bool,
    /// What the plane stands for; around an axis there is a stress of its own.
    surface: Option<Surface>,
}

impl Says {
    /// What a case says of a material.
    pub(crate) fn of(case: &Case, material: &dyn Material) -> Self {
        let heats = |load: &Load| matches!(load, Load::Temperature(_));
        let mut loads = case.loads.iter().chain(case.load_cases.iter().flat_map(|c| &c.loads));
        Self {
            has_fibres: material.fibres().is_some(),
            has_strengths: case.strengths.is_some(),
            is_heated: loads.any(heats),
            has_materials: !case.materials.is_empty(),
            surface: Some(material.surface()),
        }
    }
}

/// How the points of a body have a field; of a damaged one bonds are cut, or can fail.
pub(crate) fn of_points(field: FieldName, model: &dyn BodyModel, is_damaged: bool, says: Says) -> Has {
    let or = |is_there: bool, otherwise: Has| if is_there { Has::Values } else { otherwise };
    match field.about().origin {
        Origin::Unknown => or(model.component(field.name()).is_some(), Has::No),
        Origin::Damage => or(is_damaged, Has::Unlisted),
        Origin::Temperature => or(says.is_heated, Has::No),
        Origin::Strain(name, _) | Origin::Stress(name) if model.tensor_components().contains(&name) => {
            Has::Values
        }
        // That across a section follows from the others, or is zero.
        Origin::Stress("zz") => {
            let is_around = says.surface.is_some_and(|surface| surface.axis().is_some());
            or(is_around || model.across_of([1.0, 1.0, 0.0, 0.0, 0.0, 0.0]) != 0.0, Has::Unlisted)
        }
        Origin::Strain(..) | Origin::Stress(_) => Has::No,
        Origin::Material => or(says.has_materials, Has::No),
        Origin::VonMises | Origin::Energy => Has::Values,
        Origin::Principal(_) | Origin::MaxShear | Origin::Hydrostatic => Has::Unlisted,
        Origin::PrincipalDirection => {
            let is_there = model.as_solid().is_none() && model.tensor_components().contains(&"xy");
            if is_there { Has::Unlisted } else { Has::No }
        }
        Origin::FibreStress(_) | Origin::FibreStrain(_) if says.has_fibres => Has::Unlisted,
        Origin::TsaiHill | Origin::TsaiWu | Origin::HashinFibre | Origin::HashinMatrix
            if says.has_fibres && says.has_strengths =>
        {
            Has::Unlisted
        }
        Origin::Utilisation if says.has_strengths => Has::Unlisted,
        Origin::FibreStress(_)
        | Origin::FibreStrain(_)
        | Origin::TsaiHill
        | Origin::TsaiWu
        | Origin::HashinFibre
        | Origin::HashinMatrix
        | Origin::Utilisation => Has::No,
        Origin::Beam | Origin::Opening | Origin::Plate(_) | Origin::Reaction(_) | Origin::Turn(_) => Has::No,
    }
}

/// The fields that points have, whether zero or not, in the order of tables.
pub(crate) fn answered(model: &dyn BodyModel, says: Says) -> impl Iterator<Item = FieldName> {
    FieldName::BODY.into_iter().filter(move |&field| of_points(field, model, false, says) != Has::No)
}

/// Forces and moments of supports, in the order of messages.
const REACTIONS: [FieldName; 8] = [
    FieldName::ReactionX,
    FieldName::ReactionY,
    FieldName::ReactionZ,
    FieldName::ReactionMoment,
    FieldName::ReactionMomentX,
    FieldName::ReactionMomentY,
    FieldName::ReactionMomentZ,
    FieldName::ReactionForce,
];

/// Rotations of rigid regions of solids.
const TURNS: [FieldName; 3] = [FieldName::PhiX, FieldName::PhiY, FieldName::PhiZ];

/// What a reaction holds.
pub(crate) struct ReactionOf {
    /// Its name, such as `ux`.
    pub(crate) name: &'static str,
    /// The unknown of points: its index and what is known of it; none of rotations where points do not turn.
    pub(crate) unknown: Option<(usize, Component)>,
    /// The motion of rigid regions, among those that they have.
    pub(crate) motion: Option<usize>,
}

/// What a reaction holds; none where points have no such unknown, nor a solid rigid regions that move so.
pub(crate) fn reaction_of(reaction: FieldName, model: &dyn BodyModel, has_rigid: bool) -> Option<ReactionOf> {
    let Origin::Reaction(name) = reaction.about().origin else { return None };
    let (unknown, axes) = (model.component(name), if model.as_solid().is_some() { 3 } else { 2 });
    let motion = (0..MOTIONS).find(|&motion| rigid::key(motion, axes) == Some(name));
    let is_turn = axes > 2 && motion.is_some() && has_rigid;
    (unknown.is_some() || is_turn).then_some(ReactionOf { name, unknown, motion })
}

/// The fields that probes can ask for: those of points, reactions, rotations of rigid regions and openings of cracks.
pub(crate) fn probed(model: &dyn BodyModel, case: &Case, says: Says) -> Vec<FieldName> {
    of_probes(model, (!case.rigid.is_empty(), !case.cracks.is_empty()), says)
}

/// The fields that probes of a case can ask for which has this model and whatever gives fields: rigid regions, cracks, strengths.
pub(crate) fn askable(model: &dyn BodyModel, material: &dyn Material) -> Vec<FieldName> {
    let (has_fibres, has_materials) = (material.fibres().is_some(), material.other_materials().is_ok());
    let surface = Some(material.surface());
    let says = Says { has_fibres, has_strengths: true, is_heated: true, has_materials, surface };
    of_probes(model, (true, true), says)
}

fn of_probes(model: &dyn BodyModel, (has_rigid, has_cracks): (bool, bool), says: Says) -> Vec<FieldName> {
    let reactions =
        REACTIONS.into_iter().filter(|&reaction| reaction_of(reaction, model, has_rigid).is_some());
    let turns: &[FieldName] = match (model.turning().is_none() && has_rigid, model.as_solid()) {
        (false, _) => &[],
        (true, None) => &[FieldName::Phi],
        (true, Some(_)) => &TURNS,
    };
    let opens = (has_cracks && model.along(0).is_some()).then_some(FieldName::Opening);
    answered(model, says).chain(turns.iter().copied()).chain(reactions).chain(opens).collect()
}

/// Whether a field judges stresses by strengths.
fn needs_strengths(field: FieldName) -> bool {
    use Origin::{HashinFibre, HashinMatrix, TsaiHill, TsaiWu, Utilisation};
    matches!(field.about().origin, TsaiHill | TsaiWu | HashinFibre | HashinMatrix | Utilisation)
}

/// Adds the fault of a field that a probe asks for at `path`, and that is none of those that there are.
pub(crate) fn refuse(
    field: FieldName,
    there_are: &[FieldName],
    case: &Case,
    path: JsonPath,
    faults: &mut Faults,
) {
    let (name, model) = (field.name(), case.model.name());
    let message = match field {
        FieldName::Phi if case.model.keys().is_ok_and(|keys| keys.is_solid()) => {
            "rotations of a solid are `phi_x`, `phi_y` and `phi_z` of a rigid region".into()
        }
        FieldName::Phi => {
            format!("points of `{model}` do not turn, and no region is rigid: there is no `phi`")
        }
        _ if TURNS.contains(&field) && case.rigid.is_empty() => {
            format!("no region of the body is rigid: there is no `{name}`")
        }
        _ if needs_strengths(field) && case.strengths.is_none() => {
            format!("`{name}` needs the `strengths` of the material, beside `model`")
        }
        FieldName::Temperature => "`temperature` is that of a load `temperature`, and there is none".into(),
        FieldName::Material => "`material` is the number of one of `materials`, and there are none".into(),
        FieldName::Opening => "`opening` is that of a crack, and there is none".into(),
        _ => format!("`{name}` is no field of `{model}`"),
    };
    faults.error(path, message).hint(words::there_are(there_are));
}
