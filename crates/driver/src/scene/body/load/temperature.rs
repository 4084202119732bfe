//! Changes of temperature: strains that need no stress in a material that they stretch.

use super::context::LoadContext;
use super::eigenstrain::{self, Eigenstrain, EigenstrainPart, UnitStrain};
use super::sums::BodyLoads;
use crate::case::Temperature;
use crate::diagnostic::{Faults, JsonPath};
use crate::model::Fibres;
use crate::scene::expansion;

/// The directions in which materials of a body stretch by heat, each by its own number: strains along x and y, their shear γ, and
/// across the plane.
fn directions(fibres: Option<Fibres>) -> Vec<[f64; 4]> {
    let Some(fibres) = fibres else { return vec![[1.0, 1.0, 0.0, 1.0]] };
    let (s, c) = fibres.angle.sin_cos();
    vec![[c * c, s * s, 2.0 * s * c, 0.0], [s * s, c * c, -2.0 * s * c, 1.0]]
}

/// Adds a change of temperature.
pub(crate) fn resolve(
    load: &Temperature,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let ground = context.ground;
    let is_fine = eigenstrain::is_borne("temperature", context, path, faults);
    let has_fibres = context.material.fibres().is_some();
    let expansion = expansion::of(ground.case, has_fibres, path, faults);
    for (key, _) in
        [("difference", load.difference.is_some()), ("member", load.member.is_some())].iter().filter(|k| k.1)
    {
        faults.error(path.key(*key), format!("`{key}` is for beams")).hint(
            "a formula such as `\"change\": \"50*(1 - y/20)\"` says how a temperature varies in a body",
        );
    }
    let Some(change) = &load.change else {
        faults
            .error(path.clone(), "`change` is missing")
            .hint("kelvin, positive where the body becomes warmer");
        return;
    };
    let change = context.prescribed(change, &path.key("change"), faults);
    let points = match &load.region {
        Some(name) => ground.region(name, &path.key("region"), faults),
        None => Some((0..ground.body.points() as u32).collect()),
    };
    let (Some(expansion), Some(change), Some(points), true) = (expansion, change, points, is_fine) else {
        return;
    };
    let Some(model) = context.model else { return };
    let unit = |[x, y, gamma, across]: [f64; 4]| {
        let of = |component: &str| match component {
            "xx" => x,
            "yy" => y,
            "zz" => across,
            "xy" => gamma,
            _ => 0.0,
        };
        UnitStrain::new(of, model, context.material)
    };
    let units = directions(context.material.fibres()).into_iter().map(unit).collect::<Option<Vec<_>>>();
    let Some(units) = units else { return };
    let mut change_of = vec![0.0; model.points()];
    let mut free = vec![change_of.clone(); units.len()];
    for p in points {
        match change.at(ground.body.position(p as usize)) {
            Ok(value) => {
                let (number, other) =
                    (context.inputs.number(model, p), context.inputs.materials.of(p as usize));
                let own =
                    other.and_then(|other| other.thermal_expansion).unwrap_or(expansion.along_and_across());
                change_of[number as usize] = value;
                for (free, alpha) in free.iter_mut().zip(own) {
                    free[number as usize] = alpha * value;
                }
            }
            Err(reason) => {
                faults.error(path.key("change"), reason);
                return;
            }
        }
    }
    if context.factor.is_none() && change_of.iter().all(|change| *change == 0.0) {
        faults.error(path.clone(), "this load is zero");
    }
    // Shears of fibres are alike on both sides of a mirror only where these lie along it, and then they are none.
    eigenstrain::give_images(&mut change_of, "", model);
    for free in &mut free {
        eigenstrain::give_images(free, "", model);
    }
    let parts = free.into_iter().zip(units).map(|(free, unit)| EigenstrainPart { free, unit });
    let own = Eigenstrain { change: change_of, parts: parts.collect() };
    eigenstrain::check("temperature", &own, context, path, faults);
    to.stretch(own);
}
