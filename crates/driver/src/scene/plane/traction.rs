//! Tractions on borders of a body in the plane.
//!
//! `consistent`: with a smooth stress S that has the traction `t = S n` on its edge, `∫ t·v = ∫ S : ε(v) + ∫ div S·v` for
//! every displacement v, with the strains that bonds measure. Where the tractions of
//! all edges are those of one stress, S is that stress everywhere and its linear displacement is the solution to
//! rounding; else S fades from the edge inwards. What S does on other borders is taken back there.
//! `lumped`: the force of every stretch of the border goes to the nearest point. Force and moment are exact either way.

use super::boundary::{self, Border, Stretch, is_aligned};
use super::ground::Ground;
use super::loads::{Context, PlaneLoads};
use super::lump;
use super::on_border;
use super::profile::Profile;
use super::stress_field::StressField;
use super::uniform_stress;
use crate::case::{Hertz, LoadSharing, Traction};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use peristat_assembly::body::BorderPart;
use peristat_assembly::model::plane::Calibration;

/// A traction on its border.
#[derive(Clone, Debug)]
pub(super) struct OnBorder {
    pub(super) name: String,
    pub(super) border: Border,
    pub(super) profile: Profile,
    pub(super) sharing: Option<LoadSharing>,
    /// How deep it reaches, if it is consistent, m.
    pub(super) depth: Option<f64>,
    /// Where it stands in the case.
    pub(super) path: JsonPath,
}

impl OnBorder {
    /// Stretches of the border.
    pub(super) fn stretches(&self, ground: &Ground) -> Vec<Stretch> {
        match &self.border {
            Border::Edge(edge) => boundary::of_edge(edge, ground),
            Border::Curved { stretches, .. } => stretches.clone(),
        }
    }

    /// Parts of the border with their places along it at start and end.
    pub(super) fn parts(&self, ground: &Ground) -> Vec<(BorderPart, [f64; 2])> {
        match (&self.border, ground.outline) {
            (Border::Edge(edge), _) => {
                let places = |part: &BorderPart| [0.0, 1.0].map(|s| boundary::place_on(edge, part.at(s)));
                boundary::parts_of_edge(edge, ground).into_iter().map(|part| (part, places(&part))).collect()
            }
            // On a hole every place is like any other.
            (Border::Curved { hole: Some(k), .. }, Some(outline)) => {
                outline.hole_parts(*k).into_iter().map(|part| (part, [0.0, 1.0])).collect()
            }
            (Border::Curved { stretches, .. }, _) => {
                stretches.iter().map(|s| (s.part, [s.place - s.half, s.place + s.half])).collect()
            }
        }
    }
}

/// The border and the profile of a traction.
pub(super) fn resolve(
    load: &Traction,
    context: &Context,
    path: JsonPath,
    faults: &mut Faults,
) -> Option<OnBorder> {
    let place = path.key("edge");
    super::supports::not_mirrored(Some(&load.edge), &place, context.symmetry, faults);
    let border = boundary::find(&load.edge, context.ground, context.curves, &place, faults);
    let given = [
        ("uniform", load.uniform.is_some()),
        ("linear", load.linear.is_some()),
        ("parabolic", load.parabolic.is_some()),
        ("pressure", load.pressure.is_some()),
        ("total", load.total.is_some()),
        ("hertz", load.hertz.is_some()),
    ];
    let keys: Vec<&str> = given.iter().filter(|g| g.1).map(|g| g.0).collect();
    match keys[..] {
        [_] => {}
        [] => {
            faults
                .error(path, "the value of this traction is missing")
                .hint("give one of `uniform`, `linear`, `parabolic`, `pressure`, `total` and `hertz`");
            return None;
        }
        [first, second, ..] => {
            faults
                .error(path.key(second), format!("`{first}` and `{second}` are both given"))
                .hint("give one of `uniform`, `linear`, `parabolic`, `pressure`, `total` and `hertz`");
            return None;
        }
    }
    if let Some(depth) = load.depth {
        positive(depth, "depth", path.key("depth"), faults);
    }
    let border = border.filter(|_| !context.symmetry.axis.contains(&load.edge))?;
    let on = OnBorder {
        name: load.edge.clone(),
        border,
        profile: Profile::Pressure(0.0),
        sharing: load.sharing,
        depth: load.depth,
        path: path.clone(),
    };
    let stretches = on.stretches(context.ground);
    let area = area(&stretches, context);
    if !positive(area, "area of the border", place.clone(), faults) {
        return None;
    }
    let profile = match load {
        Traction { uniform: Some(t), .. } => Profile::Linear([*t; 2]),
        Traction { linear: Some(ends), .. } => Profile::Linear(*ends),
        Traction { parabolic: Some(t), .. } => Profile::Parabolic(*t),
        Traction { total: Some(force), .. } => Profile::Linear([force.map(|f| f / area); 2]),
        Traction { hertz: Some(hertz), .. } => {
            on_edge(hertz, &on.border, context.ground.body.spacing(), &path.key("hertz"), faults)?
        }
        _ => Profile::Pressure(load.pressure.unwrap_or(0.0)),
    };
    let within = match profile {
        Profile::Hertz { centre, .. } => centre,
        _ => 0.5,
    };
    if [0.0, within, 1.0].iter().all(|&q| profile.at(q, [1.0, 0.0]) == [0.0; 2]) {
        faults.error(path.clone(), "this traction is zero");
    }
    let varies = match profile {
        Profile::Linear([a, b]) => (a != b).then_some("linear"),
        Profile::Parabolic(_) => Some("parabolic"),
        _ => None,
    };
    if let (Border::Curved { hole: Some(_), .. }, Some(key)) = (&on.border, varies) {
        faults
            .error(path.key(key), "a hole has neither start nor end")
            .hint("use `uniform`, `pressure` or `total` on holes");
    }
    check_sharing(load, &on, context, &path, faults);
    Some(OnBorder { profile, ..on })
}

/// Area of some stretches, m².
pub(super) fn area(stretches: &[Stretch], context: &Context) -> f64 {
    stretches.iter().flat_map(Stretch::samples).map(|s| s.length * context.material.across(s.at)).sum()
}

/// A contact pressure by places along its edge.
fn on_edge(
    load: &Hertz,
    border: &Border,
    spacing: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Profile> {
    let Border::Edge(edge) = border else {
        faults
            .error(path.clone(), "a contact pressure needs a straight edge")
            .hint("use `pressure` on holes");
        return None;
    };
    if !positive(load.radius, "radius", path.key("radius"), faults) {
        return None;
    }
    // Along the axis in which the edge runs.
    let along = usize::from((edge.to[1] - edge.from[1]).abs() > (edge.to[0] - edge.from[0]).abs());
    let extent = edge.to[along] - edge.from[along];
    let length = (edge.to[0] - edge.from[0]).hypot(edge.to[1] - edge.from[1]);
    let reach = load.radius * extent.abs() / length;
    let [low, high] = [edge.from[along].min(edge.to[along]), edge.from[along].max(edge.to[along])];
    if load.centre + reach <= low || high <= load.centre - reach {
        let (at, name) = (path.key("centre"), ["x", "y"][along]);
        faults
            .error(
                at,
                format!("the contact is beside the edge, which reaches from {} to {}", tidy(low), tidy(high)),
            )
            .hint(format!("`centre` is the {name} of its middle"));
        return None;
    }
    if load.radius < spacing {
        faults
            .error(path.key("radius"), "the contact is narrower than two spacings: points hardly feel it")
            .hint("use a smaller spacing, ten over the radius, or a `point` load");
        return None;
    }
    if load.radius < 4.0 * spacing {
        faults
            .warning(
                path.key("radius"),
                format!("the contact is {} spacings wide at most", tidy(2.0 * load.radius / spacing)),
            )
            .hint("stresses near it need ten spacings or more over its radius");
    }
    let place = (load.centre - edge.from[along]) / extent;
    Some(Profile::Hertz { centre: place, radius: load.radius / length, peak: load.peak })
}

/// A fault where consistent sharing is asked for and cannot be.
fn check_sharing(load: &Traction, on: &OnBorder, context: &Context, path: &JsonPath, faults: &mut Faults) {
    if load.sharing != Some(LoadSharing::Consistent) {
        return;
    }
    if let Border::Curved { hole: None, .. } = &on.border {
        faults
            .error(path.key("sharing"), "`consistent` tractions need an edge or a hole of an outline")
            .hint("leave `sharing` out: on meshes tractions are `lumped`");
        return;
    }
    if let Border::Edge(edge) = &on.border
        && !is_aligned(edge, context.ground.body)
    {
        faults.error(path.key("sharing"), "`consistent` tractions need an edge along the lattice").hint(
            "leave `sharing` out: on slanted edges tractions are `lumped` unless one stress has all of them",
        );
    }
    if context.material.about().calibration == Calibration::Published {
        faults
            .warning(
                path.key("sharing"),
                "`consistent` tractions hide the wrong moduli of the calibration `published`",
            )
            .hint(
                "the rows of its bonds are wrong in stiffness and load alike: use `lumped` to see the error",
            );
    }
}

/// Adds the tractions of one load case.
pub(super) fn add(tractions: &[OnBorder], context: &Context, to: &mut PlaneLoads, faults: &mut Faults) {
    let matched = context.material.about().calibration == Calibration::Matched;
    let pulled = context.ground.case.periodic.iter().any(|p| p.force.is_some());
    if tractions.is_empty() && !(pulled && matched) {
        return;
    }
    // Chords of round borders are known to one stress to rounding; what it does to images is not what goes into a mirror.
    let knows_chords =
        context.symmetry.mirrors.is_none() && context.model.is_some_and(|model| model.follows_border());
    if (context.material.has("phi") || knows_chords) && add_uniform(tractions, context, to) {
        // Beside the border rotations of one stress are in balance by its own loads only.
        return;
    }
    let through = tractions.iter().map(|t| on_border::forces(t, context)).collect::<Option<Vec<_>>>();
    if let Some(forces) = through.filter(|_| !pulled) {
        for traction in tractions.iter().filter(|t| t.depth.is_some()) {
            let message = "a traction that acts through the border has no depth";
            faults.warning(traction.path.key("depth"), message).hint("leave `depth` out");
        }
        to.through_border.extend(forces.into_iter().flatten());
        return;
    }
    if add_uniform(tractions, context, to) {
        return;
    }
    for traction in tractions {
        let faded = match (&traction.border, traction.depth, traction.sharing) {
            (Border::Edge(_), ..) => super::fading::fade(traction, context),
            (Border::Curved { .. }, Some(_), _)
            | (Border::Curved { .. }, _, Some(LoadSharing::Consistent)) => {
                super::round::fade(traction, context)
            }
            _ => Err("holes have lumped tractions unless a `depth` is given"),
        };
        match faded {
            Ok((field, forces)) => {
                let inside = super::fading::inside(traction, context);
                (0..2).for_each(|k| to.inside[k] |= inside[k]);
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
                to.forces.extend(lump::forces(traction, context));
            }
        }
    }
}

/// Adds the load of one stress that has all tractions, if there is one.
fn add_uniform(tractions: &[OnBorder], context: &Context, to: &mut PlaneLoads) -> bool {
    let Some(uniform) = uniform_stress::find(tractions, context) else { return false };
    to.carry_ends = true;
    to.stresses.push(StressField::uniform(uniform.stress));
    to.forces.extend(uniform.forces);
    true
}

/// Whether a traction may be consistent, by what is asked for and by the calibration.
pub(super) fn may_be_consistent(traction: &OnBorder, context: &Context) -> bool {
    let matched = context.material.about().calibration == Calibration::Matched;
    match traction.sharing {
        Some(sharing) => sharing == LoadSharing::Consistent,
        None => matched,
    }
}
