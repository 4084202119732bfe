//! Tractions on borders of a body in the plane.
//!
//! `consistent`: with a smooth stress S that has the traction `t = S n` on its edge, `∫ t·v = ∫ S : ε(v) + ∫ div S·v` for
//! every displacement v, with the strains that bonds measure. Where the tractions of
//! all edges are those of one stress, S is that stress everywhere and its linear displacement is the solution to
//! rounding; else S fades from the edge inwards. What S does on other borders is taken back there.
//! `lumped`: the force of every stretch of the border goes to the nearest point. Force and moment are exact either way.

use super::on_border::OnBorder;
use super::{fading, lump, round, slanted, through_border, uniform_stress};
use crate::case::LoadSharing;
use crate::diagnostic::Faults;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::load::stress_field::StressField;
use crate::scene::body::load::sums::BodyLoads;
use crate::scene::body::site::boundary::Border;
use peristat_assembly::model::plane::Calibration;

/// Adds the tractions of one load case.
pub(crate) fn add(tractions: &[OnBorder], context: &LoadContext, to: &mut BodyLoads, faults: &mut Faults) {
    let matched = context.material.about().calibration == Calibration::Matched;
    let pulled = context.ground.case.periodic.iter().any(|p| p.force.is_some());
    if tractions.is_empty() && !(pulled && matched) {
        return;
    }
    // A formula with one value is that number: it is the same load and acts the same way.
    let plain: Vec<OnBorder> = tractions
        .iter()
        .map(|t| OnBorder { profile: t.profile.plain(&t.stretches(context.ground)), ..t.clone() })
        .collect();
    let tractions = &plain[..];
    // Stresses that go with a traction are those in the plane.
    let acts_across = tractions.iter().any(|t| t.profile.acts_across());
    // Chords of round borders are known to one stress to rounding; what it does to images is not what goes into a mirror.
    let knows_chords =
        context.symmetry.mirrors.is_none() && context.model.is_some_and(|model| model.follows_border());
    if (context.material.has("phi") || knows_chords) && !acts_across && add_uniform(tractions, context, to) {
        // Beside the border rotations of one stress are in balance by its own loads only.
        return;
    }
    let pulled = pulled && context.inputs.materials.is_one();
    let through = tractions.iter().map(|t| through_border::forces(t, context)).collect::<Option<Vec<_>>>();
    if let Some(forces) = through.filter(|_| !pulled) {
        for traction in tractions.iter().filter(|t| t.depth.is_some()) {
            let message = "a traction that acts through the border has no depth";
            faults.warning(traction.path.key("depth"), message).hint("leave `depth` out");
        }
        to.through_border.extend(forces.into_iter().flatten());
        return;
    }
    if !acts_across && add_uniform(tractions, context, to) {
        return;
    }
    let mut lumped: Vec<&OnBorder> = Vec::new();
    for traction in tractions {
        let faded = match (&traction.border, traction.depth, traction.sharing) {
            _ if traction.profile.acts_across() => Err("it acts across the plane"),
            (Border::Edge(_), ..) => fading::fade(traction, context),
            (Border::Curved { .. }, Some(_), _)
            | (Border::Curved { .. }, _, Some(LoadSharing::Consistent)) => round::fade(traction, context),
            _ => Err("holes have lumped tractions unless a `depth` is given"),
        };
        match faded {
            Ok((field, forces)) => {
                let inside = fading::inside(traction, context);
                (0..3).for_each(|k| to.inside[k] |= inside[k]);
                to.stresses.push(field);
                to.forces.extend(forces);
            }
            Err(why) => {
                if traction.sharing == Some(LoadSharing::Consistent) && !faults.has_errors() {
                    faults
                        .error(
                            traction.path.key("sharing"),
                            format!("this traction cannot be `consistent`: {why}"),
                        )
                        .hint("leave `sharing` out: it is `lumped` then");
                } else if traction.depth.is_some() && !faults.has_errors() {
                    let message = match traction.sharing {
                        Some(LoadSharing::Lumped) => "a lumped traction has no depth".to_string(),
                        _ => format!("this traction is lumped, which has no depth: {why}"),
                    };
                    faults.warning(traction.path.key("depth"), message).hint("leave `depth` out");
                }
                lumped.push(traction);
            }
        }
    }
    for together in lumped.chunk_by(|a, b| a.path == b.path) {
        to.forces.extend(lump::forces(together, context));
    }
}

/// Adds the load of one stress that has all tractions, if there is one.
fn add_uniform(tractions: &[OnBorder], context: &LoadContext, to: &mut BodyLoads) -> bool {
    // One stress has one linear displacement in one material alone. The rows of families know no materials, and bodies whose points
    // turn take those of one material.
    let knows_no_materials = context.material.about().has_families || context.material.has("phi");
    if !context.inputs.materials.is_one() && !knows_no_materials {
        return false;
    }
    let Some(uniform) = uniform_stress::find(tractions, context) else { return false };
    to.carry_ends = true;
    let stress = StressField::uniform(uniform.stress);
    to.into_lines.extend(slanted::into_lines((&stress, &uniform.forces), tractions, context));
    to.stresses.push(stress);
    to.forces.extend(uniform.forces);
    true
}
