//! The fields of a body: which its points have, and which its probes can ask for.

use crate::case::{Case, FieldName, Origin};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::words;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::Component;

/// How the points of a body have a field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Has {
    /// They do not.
    No,
    /// It is zero by the nature of the body: it is answered, but no table shows it.
    Zero,
    /// It varies.
    Values,
}

/// How the points of a body have a field; of a damaged one bonds are cut, or can fail.
pub(crate) fn of_points(field: FieldName, model: &dyn BodyModel, is_damaged: bool) -> Has {
    let or = |is_there: bool, otherwise: Has| if is_there { Has::Values } else { otherwise };
    match field.about().origin {
        Origin::Unknown => or(model.component(field.name()).is_some(), Has::No),
        Origin::Damage => or(is_damaged, Has::Zero),
        Origin::Strain(name, _) | Origin::Stress(name) if model.tensor_components().contains(&name) => {
            Has::Values
        }
        // That across a section follows from the others, or is zero.
        Origin::Stress("zz") => {
            or(model.is_revolved() || model.across_of([1.0, 1.0, 0.0, 0.0, 0.0, 0.0]) != 0.0, Has::Zero)
        }
        Origin::Strain(..) | Origin::Stress(_) => Has::No,
        Origin::VonMises | Origin::Energy => Has::Values,
        Origin::Beam | Origin::Opening | Origin::Reaction(_) => Has::No,
    }
}

/// The fields that points have, whether zero or not, in the order of tables.
pub(crate) fn answered(model: &dyn BodyModel) -> impl Iterator<Item = FieldName> {
    FieldName::BODY.into_iter().filter(move |&field| of_points(field, model, false) != Has::No)
}

/// Forces and moments of supports, in the order of messages.
const REACTIONS: [FieldName; 5] = [
    FieldName::ReactionX,
    FieldName::ReactionY,
    FieldName::ReactionZ,
    FieldName::ReactionMoment,
    FieldName::ReactionForce,
];

/// The unknown that a reaction holds: its index and what is known of it.
pub(crate) fn held(reaction: FieldName, model: &dyn BodyModel) -> Option<(usize, Component)> {
    let Origin::Reaction(component) = reaction.about().origin else { return None };
    model.component(component)
}

/// The fields that probes can ask for: those of points, reactions, rotations of rigid regions and openings of cracks.
pub(crate) fn probed(model: &dyn BodyModel, case: &Case) -> Vec<FieldName> {
    let reactions = REACTIONS.into_iter().filter(|&reaction| held(reaction, model).is_some());
    let turns = (model.turning().is_none() && !case.rigid.is_empty()).then_some(FieldName::Phi);
    let opens = (!case.cracks.is_empty() && model.along(0).is_some()).then_some(FieldName::Opening);
    answered(model).chain(turns).chain(reactions).chain(opens).collect()
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
        FieldName::Phi => {
            format!("points of `{model}` do not turn, and no region is rigid: there is no `phi`")
        }
        FieldName::Opening => "`opening` is that of a crack, and there is none".into(),
        _ => format!("`{name}` is no field of `{model}`"),
    };
    faults.error(path, message).hint(words::there_are(there_are));
}
