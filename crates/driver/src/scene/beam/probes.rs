//! Probes of a beam: which point answers, and whether it can.

use super::place::{Layout, Place};
use super::spot::{self, Spot};
use super::words::tidy;
use super::{HeldPoint, SectionAlong};
use crate::case::{Beam, Case, FieldName, Probe};
use crate::diagnostic::{Faults, JsonPath};

/// A probe on a point.
#[derive(Clone, Debug)]
pub struct ProbePoint {
    /// Name.
    pub name: String,
    /// Field.
    pub field: FieldName,
    /// Line and real point on it.
    pub local: (usize, usize),
    /// Number of the point.
    pub point: usize,
    /// Position of the point on its line.
    pub x: f64,
    /// What the user calls the place, on a frame.
    pub place: Option<String>,
}

/// What the resolution of probes looks at.
pub(super) struct Context<'a> {
    pub(super) model: &'a Beam,
    pub(super) layout: &'a Layout,
    pub(super) first: &'a [usize],
    pub(super) held: &'a [HeldPoint],
    pub(super) sections: &'a [SectionAlong],
    pub(super) has_axial: bool,
}

/// Probes of the case.
pub(super) fn probes(case: &Case, context: &Context, faults: &mut Faults) -> Vec<ProbePoint> {
    let resolve = |probe: &Probe, path: &JsonPath, faults: &mut Faults| resolve(probe, context, path, faults);
    crate::scene::probes::probes(case, resolve, faults)
}

fn resolve(probe: &Probe, context: &Context, path: &JsonPath, faults: &mut Faults) -> Option<ProbePoint> {
    let layout = context.layout;
    let at = path.key("at");
    let spot = spot::find(&probe.at, layout, &at, "the probe", faults)?;
    let fits = fits_body(probe.field, context, &path.key("field"), faults);
    let (chain, k) = match spot {
        Spot::Joint(joint) => of_joint(probe.field, joint, layout, path, faults)?,
        Spot::On(Place::Point { chain, point }) => (chain, point),
        Spot::On(place) => {
            let x = probe.at.x.unwrap_or(0.0);
            layout.needs_point(place.chain(), x, &at.key("x"), "the probe", faults);
            return None;
        }
    };
    let (point, x) = (context.first[chain] + k, layout.lines[chain].position(k));
    needs_section(probe.field, &context.sections[chain], context.model, path, faults);
    if fits && probe.field.is_reaction() && !context.held.iter().any(|h| h.point == Some(point)) {
        let place = match spot {
            Spot::On(_) if layout.frame.is_none() => format!("on a point at x = {}", tidy(x)),
            _ => format!("at {}", layout.words(spot, x)),
        };
        let held: Vec<&str> =
            context.held.iter().filter(|h| h.point.is_some()).map(|h| h.name.as_str()).collect();
        faults
            .error(at, format!("there is no support {place}, so there is no reaction"))
            .hint(format!("supports on points are at {}", held.join(", ")));
    }
    Some(ProbePoint {
        name: probe.name.clone(),
        field: probe.field,
        local: (chain, k),
        point,
        x,
        place: layout.frame.is_some().then(|| layout.words(spot, x)),
    })
}

/// Whether a field exists on a body of this kind.
fn fits_body(field: FieldName, context: &Context, path: &JsonPath, faults: &mut Faults) -> bool {
    use FieldName::{Damage, StrainXx, StrainXy, StrainYy, StressXx, StressXy, StressYy, VonMises};
    use FieldName::{N, ReactionForce, ReactionX, ReactionY, U, Ux, Uy};
    let name = field.name();
    let misfit = match (context.layout.frame.is_some(), field) {
        (_, StrainXx | StrainYy | StrainXy | StressXx | StressYy | StressXy | VonMises | Damage) => Some((
            format!("`{name}` is for bodies in the plane"),
            "on beams there are `stress_top` and `stress_bottom`",
        )),
        (true, ReactionForce) => {
            Some((format!("`{name}` is for lines"), "on a frame take `reaction_x` and `reaction_y`"))
        }
        (false, Ux) => Some((format!("`{name}` is for frames"), "on a line take `u`")),
        (false, Uy) => Some((format!("`{name}` is for frames"), "on a line take `w`")),
        (false, ReactionY) => Some((format!("`{name}` is for frames"), "on a line take `reaction_force`")),
        (false, N | U | ReactionX) if !context.has_axial => Some((
            "nothing moves this beam along its axis".to_string(),
            "an axial load or a support with `ux` gives it axial displacements and forces",
        )),
        _ => None,
    };
    if let Some((message, hint)) = &misfit {
        faults.error(path.clone(), message.clone()).hint(*hint);
    }
    misfit.is_none()
}

/// Line and point that answer for a joint: fields that its members do not share have no value there.
fn of_joint(
    field: FieldName,
    joint: usize,
    layout: &Layout,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<(usize, usize)> {
    let frame = layout.frame.as_ref()?;
    let joint = &frame.joints[joint];
    let example = || format!("name the end of one: {}", layout.example(joint.first()));
    match field {
        FieldName::Ux | FieldName::Uy => Some(layout.end(joint.first())),
        FieldName::Phi => {
            let turning = joint.turning();
            if turning.is_none() {
                faults
                    .error(
                        path.key("at"),
                        format!("all members are hinged at the joint `{}`: it has no rotation", joint.name),
                    )
                    .hint(example());
            }
            turning.map(|end| layout.end(end))
        }
        field if field.is_reaction() => Some(layout.end(joint.first())),
        _ if joint.ends.len() == 1 => Some(layout.end(joint.first())),
        _ => {
            let name = field.name();
            faults
                .error(
                    path.key("at"),
                    format!(
                        "`{name}` differs between the {} members at the joint `{}`",
                        joint.ends.len(),
                        joint.name
                    ),
                )
                .hint(example());
            None
        }
    }
}

/// A fault for a field that needs to know more of the section than the case says.
fn needs_section(
    field: FieldName,
    section: &SectionAlong,
    model: &Beam,
    path: &JsonPath,
    faults: &mut Faults,
) {
    let (needs, missing) = match field {
        FieldName::StressTop | FieldName::StressBottom => {
            ("the height of the section", !section.has_stress())
        }
        FieldName::EnergyDensity => ("the area of the section", section.area.is_none()),
        _ => return,
    };
    if !missing {
        return;
    }
    let (needs, hint) = match (field, &model.stiffness, &model.power_law) {
        (_, _, Some(_)) => ("a section of one modulus", "stresses are M z / I only there: probe `M` instead"),
        (FieldName::EnergyDensity, ..) => (needs, "give `area` in `stiffness`"),
        (_, Some(_), _) => {
            (needs, "give `height`, `area` and a uniform `axial` in `stiffness`: E is then `axial` / `area`")
        }
        _ => (needs, "give `height` with the general section"),
    };
    faults.error(path.key("field"), format!("`{}` needs {needs}", field.name())).hint(hint);
}
