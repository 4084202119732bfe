//! Probes of a beam: which point answers, and whether it can.

use super::frame_place::{self, FramePlace};
use super::place::{Layout, Place};
use super::reduced;
use super::section::SectionAlong;
use super::supports::HeldPoint;
use crate::case::{Case, FieldName, Probe, Reduction};
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::model::Beam;
use crate::scene::words;
use std::ops::Range;

/// A value to report.
#[derive(Clone, Debug)]
pub struct BeamProbe {
    /// Name.
    pub name: String,
    /// Field.
    pub field: FieldName,
    /// Where it is read.
    pub site: ProbeSite,
}

/// Where a probe is read.
#[derive(Clone, Debug)]
pub enum ProbeSite {
    /// On a point.
    Point(ProbePoint),
    /// Between two points.
    Between(BetweenPoints),
    /// At all points of some lines.
    Lines {
        /// What is made of their values.
        of: Reduction,
        /// The lines.
        lines: Range<usize>,
        /// What the user calls them.
        place: String,
    },
}

impl BeamProbe {
    /// The point that it is read on, if that is one.
    pub fn point(&self) -> Option<&ProbePoint> {
        if let ProbeSite::Point(point) = &self.site { Some(point) } else { None }
    }

    /// What it makes of many points, if it does.
    pub fn reduction(&self) -> Option<Reduction> {
        if let ProbeSite::Lines { of, .. } = self.site { Some(of) } else { None }
    }
}

/// The point of a probe.
#[derive(Clone, Debug)]
pub struct ProbePoint {
    /// Line and real point on it.
    pub local: (usize, usize),
    /// Number of the point.
    pub point: usize,
    /// Position of the point on its line.
    pub x: f64,
    /// What the user calls the place, on a frame.
    pub place: Option<String>,
}

/// A place between two points.
#[derive(Clone, Debug)]
pub struct BetweenPoints {
    /// Line.
    pub line: usize,
    /// The real point before it.
    pub before: usize,
    /// Position on its line.
    pub x: f64,
    /// What the user calls the place, on a frame.
    pub place: Option<String>,
}

/// What the resolution of probes looks at.
pub(super) struct ProbedBeam<'a> {
    pub(super) model: &'a Beam,
    pub(super) layout: &'a Layout,
    pub(super) first: &'a [usize],
    pub(super) held: &'a [HeldPoint],
    pub(super) sections: &'a [SectionAlong],
    pub(super) has_axial: bool,
    /// Whether its bonds can break.
    pub(super) breaks: bool,
}

/// Probes of the case.
pub(super) fn probes(case: &Case, context: &ProbedBeam, faults: &mut Faults) -> Vec<BeamProbe> {
    let resolve = |probe: &Probe, path: &JsonPath, faults: &mut Faults| resolve(probe, context, path, faults);
    crate::scene::probes::probes(case, resolve, faults)
}

fn resolve(probe: &Probe, context: &ProbedBeam, path: &JsonPath, faults: &mut Faults) -> Option<BeamProbe> {
    let site = match probe.of {
        Some(of) => reduced::resolve(probe, of, context, path, faults)?,
        None => at_place(probe, context, path, faults)?,
    };
    Some(BeamProbe { name: probe.name.clone(), field: probe.field, site })
}

/// The point that answers for a probe, or the two around it.
fn at_place(probe: &Probe, context: &ProbedBeam, path: &JsonPath, faults: &mut Faults) -> Option<ProbeSite> {
    let layout = context.layout;
    let at = path.key("at");
    let spot = frame_place::find(&probe.at, layout, &at, "the probe", faults)?;
    let fits = fits_body(probe.field, context, &path.key("field"), faults);
    let (chain, k) = match spot {
        FramePlace::Joint(joint) => of_joint(probe.field, joint, layout, path, faults)?,
        FramePlace::On(Place::Point { chain, point }) => (chain, point),
        FramePlace::On(place) => {
            let x = probe.at.x.unwrap_or(0.0);
            // Bonds that break between two points leave no element.
            let reads_points = probe.field.is_reaction() || context.breaks;
            if let Some(before) = layout.lines[place.chain()].before(x).filter(|_| !reads_points) {
                let line = place.chain();
                let knows = needs_section(probe.field, &context.sections[line], context.model, path, faults);
                let place = layout.frame.is_some().then(|| layout.words(spot, x));
                return (fits && knows).then_some(ProbeSite::Between(BetweenPoints {
                    line,
                    before,
                    x,
                    place,
                }));
            }
            layout.needs_point(place.chain(), x, &at.key("x"), "the probe", faults);
            return None;
        }
    };
    let (point, x) = (context.first[chain] + k, layout.lines[chain].position(k));
    needs_section(probe.field, &context.sections[chain], context.model, path, faults);
    if fits && probe.field.is_reaction() && !context.held.iter().any(|h| h.point == Some(point)) {
        let place = match spot {
            FramePlace::On(_) if layout.frame.is_none() => format!("on a point at x = {}", tidy(x)),
            _ => format!("at {}", layout.words(spot, x)),
        };
        let held: Vec<&str> =
            context.held.iter().filter(|h| h.point.is_some()).map(|h| h.name.as_str()).collect();
        faults
            .error(at, format!("there is no support {place}, so there is no reaction"))
            .hint(format!("supports on points are at {}", held.join(", ")));
    }
    Some(ProbeSite::Point(ProbePoint {
        local: (chain, k),
        point,
        x,
        place: layout.frame.is_some().then(|| layout.words(spot, x)),
    }))
}

/// The fields that probes can ask for.
fn probed(on_frame: bool, has_axial: bool) -> Vec<FieldName> {
    use FieldName::{ReactionForce, ReactionMoment, ReactionX, ReactionY};
    let reactions: &[FieldName] = match (on_frame, has_axial) {
        (true, _) => &[ReactionX, ReactionY, ReactionMoment],
        (false, true) => &[ReactionX, ReactionForce, ReactionMoment],
        (false, false) => &[ReactionForce, ReactionMoment],
    };
    [FieldName::of_beam(on_frame, has_axial), reactions].concat()
}

/// The fields that probes of some line or frame can ask for.
pub(super) fn askable() -> Vec<FieldName> {
    let mut all = probed(false, true);
    for field in probed(true, true).into_iter().chain(probed(false, false)) {
        if !all.contains(&field) {
            all.push(field);
        }
    }
    all
}

/// Whether a field exists on a body of this kind.
pub(super) fn fits_body(
    field: FieldName,
    context: &ProbedBeam,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    use FieldName::{N, ReactionForce, ReactionX, ReactionY, U, Ux, Uy};
    let on_frame = context.layout.frame.is_some();
    let there_are = probed(on_frame, context.has_axial);
    if there_are.contains(&field) {
        return true;
    }
    let name = field.name();
    let (message, instead) = match (on_frame, field) {
        (true, ReactionForce) => (format!("`{name}` is for lines"), "take `reaction_x` and `reaction_y`; "),
        (false, Ux) => (format!("`{name}` is for frames"), "on a line take `u`; "),
        (false, Uy) => (format!("`{name}` is for frames"), "on a line take `w`; "),
        (false, ReactionY) => (format!("`{name}` is for frames"), "on a line take `reaction_force`; "),
        (false, N | U | ReactionX) => (
            "nothing moves this beam along its axis".into(),
            "an axial load or a support with `ux` gives it axial displacements and forces; ",
        ),
        _ => (format!("`{name}` is no field of a beam"), ""),
    };
    faults.error(path.clone(), message).hint(format!("{instead}{}", words::there_are(&there_are)));
    false
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

/// Whether the case says what a field needs to know of the section; a fault if not.
pub(super) fn needs_section(
    field: FieldName,
    section: &SectionAlong,
    model: &Beam,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let (needs, missing) = match field {
        FieldName::StressTop | FieldName::StressBottom => {
            ("the height of the section", !section.has_stress())
        }
        FieldName::EnergyDensity => ("the area of the section", section.area.is_none()),
        _ => return true,
    };
    if !missing {
        return true;
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
    false
}
