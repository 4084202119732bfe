//! Tractions as cases give them.

use super::contact;
use super::on_border::{OnBorder, misses_at_mirrors};
use super::profile::Profile;
use crate::case::{ContactCentre, Hertz, LoadSharing, Traction, Vector};
use crate::diagnostic::{Faults, JsonPath, positive, tidy};
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::site::boundary::{self, Border, Stretch, is_aligned};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::plane::Calibration;
use std::sync::Arc;

/// The borders and the profile of a traction.
pub(crate) fn resolve(
    load: &Traction,
    context: &LoadContext,
    path: JsonPath,
    faults: &mut Faults,
) -> Option<Vec<OnBorder>> {
    let place = path.key("edge");
    let Some(edge) = &load.edge else {
        // A face has its fault already.
        if load.face.is_none() {
            faults.error(path, "`edge` is missing").hint("give the name of an edge or of a hole");
        }
        return None;
    };
    for name in context.ground.edges_of(edge) {
        crate::scene::body::hold::supports::not_mirrored(Some(&name), &place, context.symmetry, faults);
    }
    let borders = boundary::find(edge, context.ground, (context.curves, context.symmetry), &place, faults);
    one_value(load, &path, faults)?;
    if let Some(depth) = load.depth {
        positive(depth, "depth", path.key("depth"), faults);
    }
    let is_axis = |name: &String| context.symmetry.axis.contains(name);
    let borders = borders?.into_iter().filter(|(name, _)| !is_axis(name));
    let on: Vec<OnBorder> = borders
        .map(|(name, border)| OnBorder {
            name,
            border,
            profile: Profile::Pressure(0.0),
            sharing: load.sharing,
            depth: load.depth,
            path: path.clone(),
        })
        .collect();
    // An axis alone has its fault already.
    if on.is_empty() {
        return None;
    }
    if on.len() > 1 {
        only_one(load, on.len(), &path, faults)?;
    }
    let stretches: Vec<_> = on.iter().flat_map(|on| on.stretches(context.ground)).collect();
    let area = context.area(&stretches);
    if !positive(area, "area of the border", place.clone(), faults) {
        return None;
    }
    let profile = profile(load, (&on, area), context, &path, faults)?;
    if profile.is_formula() {
        has_values(&profile, &stretches, &path, faults)?;
    }
    let within = match profile {
        Profile::Hertz { centre, .. } => centre,
        _ => 0.5,
    };
    let is_zero = |q: &f64| profile.at(*q, [0.0; 2], [1.0, 0.0]) == [0.0; 3];
    if context.factor.is_none() && !profile.is_formula() && [0.0, within, 1.0].iter().all(is_zero) {
        faults.error(path.clone(), "this traction is zero");
    }
    let varies = match profile {
        Profile::Linear([a, b]) => (a != b).then_some("linear"),
        Profile::Parabolic(_) => Some("parabolic"),
        _ => None,
    };
    let is_hole = |on: &OnBorder| matches!(on.border, Border::Curved { hole: Some(_), .. });
    if let Some(key) = varies.filter(|_| on.iter().any(is_hole)) {
        faults
            .error(path.key(key), "a hole has neither start nor end")
            .hint("use `uniform`, `pressure` or `total` on holes");
    }
    if let Some(first) = on.first() {
        check_sharing(load, first, context, &path, faults);
    }
    Some(on.into_iter().map(|on| OnBorder { profile: profile.clone(), ..on }).collect())
}

/// How a traction varies along borders of some area, m².
fn profile(
    load: &Traction,
    (on, area): (&[OnBorder], f64),
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Profile> {
    let mut force = |given: &Vector, key: &str| context.force(*given, key, &path.key(key), faults);
    Some(match load {
        Traction { uniform: Some(t), .. } => Profile::Linear([force(t, "uniform")?; 2]),
        Traction { linear: Some([from, to]), .. } => {
            Profile::Linear([force(from, "linear")?, force(to, "linear")?])
        }
        Traction { parabolic: Some(t), .. } => Profile::Parabolic(force(t, "parabolic")?),
        Traction { total: Some(total), .. } => Profile::Linear([force(total, "total")?.map(|f| f / area); 2]),
        Traction { hertz: Some(hertz), .. } => {
            on_edge(hertz, &on.first()?.border, context.ground.body.spacing(), &path.key("hertz"), faults)?
        }
        Traction { formula: Some(given), .. } => {
            Profile::Formula(Arc::new(context.along(given, "formula", &path.key("formula"), faults)?))
        }
        _ => pressure(load, context, path, faults)?,
    })
}

/// A pressure, a number or a formula.
fn pressure(load: &Traction, context: &LoadContext, path: &JsonPath, faults: &mut Faults) -> Option<Profile> {
    let Some(given) = &load.pressure else { return Some(Profile::Pressure(0.0)) };
    let given = context.prescribed(given, &path.key("pressure"), faults)?;
    Some(match given {
        Prescribed::Number(pressure) => Profile::Pressure(pressure),
        formula => Profile::PressureFormula(Arc::new(formula)),
    })
}

/// A fault where formulas have no value on a border.
fn has_values(profile: &Profile, stretches: &[Stretch], path: &JsonPath, faults: &mut Faults) -> Option<()> {
    let mut on = stretches.iter().flat_map(|stretch| profile.on(stretch));
    let Some((at, _)) = on.find(|(_, t)| t.iter().any(|t| !t.is_finite())) else { return Some(()) };
    let [x, y] = at.map(tidy);
    faults.error(path.clone(), format!("the formula has no value on the border at ({x}, {y})"));
    None
}

/// A fault for a traction with no value, or with two.
fn one_value(load: &Traction, path: &JsonPath, faults: &mut Faults) -> Option<()> {
    let given = [
        ("uniform", load.uniform.is_some()),
        ("linear", load.linear.is_some()),
        ("parabolic", load.parabolic.is_some()),
        ("formula", load.formula.is_some()),
        ("pressure", load.pressure.is_some()),
        ("total", load.total.is_some()),
        ("hertz", load.hertz.is_some()),
    ];
    let keys: Vec<&str> = given.iter().filter(|g| g.1).map(|g| g.0).collect();
    match keys[..] {
        [_] => Some(()),
        [] => {
            faults.error(path.clone(), "the value of this traction is missing").hint(
                "give one of `uniform`, `linear`, `parabolic`, `formula`, `pressure`, `total` and `hertz`",
            );
            None
        }
        [first, second, ..] => {
            faults.error(path.key(second), format!("`{first}` and `{second}` are both given")).hint(
                "give one of `uniform`, `linear`, `parabolic`, `formula`, `pressure`, `total` and `hertz`",
            );
            None
        }
    }
}

/// A fault for a profile that runs along one edge where there are several.
fn only_one(load: &Traction, count: usize, path: &JsonPath, faults: &mut Faults) -> Option<()> {
    let along = [
        ("linear", load.linear.is_some()),
        ("parabolic", load.parabolic.is_some()),
        ("hertz", load.hertz.is_some()),
    ];
    let Some((key, _)) = along.iter().find(|a| a.1) else { return Some(()) };
    faults
        .error(path.key(*key), format!("`{key}` runs along one straight edge, and here are {count}"))
        .hint("give every edge its own traction, or use `uniform`, `pressure` or `total`");
    None
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
    let name = ["x", "y"][along];
    let centre = match load.centre {
        Some(ContactCentre::Along(centre)) => centre,
        None => 0.0,
        Some(ContactCentre::At(_)) => {
            let message = "three numbers are a point of a face: this is an edge in the plane";
            faults.error(path.key("centre"), message).hint(format!("`centre` is the {name} of its middle"));
            return None;
        }
    };
    if centre + reach <= low || high <= centre - reach {
        let message =
            format!("the contact is beside the edge, which reaches from {} to {}", tidy(low), tidy(high));
        faults.error(path.key("centre"), message).hint(format!("`centre` is the {name} of its middle"));
        return None;
    }
    if !contact::is_wide_enough(load.radius, spacing, path, faults) {
        return None;
    }
    let place = (centre - edge.from[along]) / extent;
    Some(Profile::Hertz { centre: place, radius: load.radius / length, peak: load.peak })
}

/// A fault where consistent sharing is asked for and cannot be.
fn check_sharing(
    load: &Traction,
    on: &OnBorder,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) {
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
    if let Some(why) = misses_at_mirrors(context) {
        let message = format!("these tractions cannot be `consistent`: {why}");
        faults.error(path.key("sharing"), message).hint("leave `sharing` out: it is `lumped` then");
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
