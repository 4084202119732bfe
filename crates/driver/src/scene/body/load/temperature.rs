//! Changes of temperature: strains that need no stress in a material that they stretch.

use super::context::LoadContext;
use super::eigenstrain::{self, Eigenstrain, EigenstrainPart, UnitStrain};
use super::sums::BodyLoads;
use crate::case::{Expansion, Temperature};
use crate::diagnostic::{Faults, JsonPath};
use crate::model::Fibres;
use crate::scene::expansion;

/// The strains of one kelvin: along x and y, their shear γ, and across the plane.
fn in_plane(expansion: Expansion, fibres: Option<Fibres>) -> [f64; 4] {
    match (expansion, fibres) {
        (Expansion::Fibres([along, across]), Some(fibres)) => {
            let (s, c) = fibres.angle.sin_cos();
            let (x, y) = (along * c * c + across * s * s, along * s * s + across * c * c);
            [x, y, 2.0 * s * c * (along - across), across]
        }
        (Expansion::Alike(alpha) | Expansion::Fibres([alpha, _]), _) => [alpha, alpha, 0.0, alpha],
    }
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
    // Materials differ by a number, fibres have directions.
    let (unit, base) = match expansion {
        Expansion::Alike(alpha) => (Expansion::Alike(1.0), alpha),
        fibres => (fibres, 1.0),
    };
    let [x, y, gamma, across] = in_plane(unit, context.material.fibres());
    let of = |component: &str| match component {
        "xx" => x,
        "yy" => y,
        "zz" => across,
        "xy" => gamma,
        _ => 0.0,
    };
    let Some(unit) = UnitStrain::new(of, model, context.material) else { return };
    let mut change_of = vec![0.0; model.points()];
    let mut free = change_of.clone();
    for p in points {
        match change.at(ground.body.position(p as usize)) {
            Ok(value) => {
                let (number, other) =
                    (context.inputs.number(model, p), context.inputs.materials.of(p as usize));
                let alpha = other.and_then(|other| other.thermal_expansion).unwrap_or(base);
                change_of[number as usize] = value;
                free[number as usize] = alpha * value;
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
    eigenstrain::give_images(&mut free, "", model);
    let own = Eigenstrain { change: change_of, parts: vec![EigenstrainPart { free, unit }] };
    eigenstrain::check("temperature", &own, context, path, faults);
    to.stretch(own);
}
