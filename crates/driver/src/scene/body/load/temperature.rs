//! Changes of temperature: strains that need no stress in a material that they stretch.

use super::context::LoadContext;
use super::eigenstrain::{self, Eigenstrain, EigenstrainPart, UnitStrain};
use super::sums::BodyLoads;
use crate::case::Temperature;
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::expansion;
use peristat_assembly::model::BodyModel;

/// The directions in which materials of a body stretch by heat, each by its own number: strains along x and y, their shear γ, and
/// across the plane. The angle of fibres from x is in rad.
fn directions(fibre_angle: Option<f64>) -> Vec<[f64; 4]> {
    let Some(angle) = fibre_angle else { return vec![[1.0, 1.0, 0.0, 1.0]] };
    let (s, c) = angle.sin_cos();
    vec![[c * c, s * s, 2.0 * s * c, 0.0], [s * s, c * c, -2.0 * s * c, 1.0]]
}

/// The units by which fibres at an angle, degrees, stretch, or those of the base material; none of a model without stiffness in all
/// directions.
fn units(angle: Option<f64>, model: &dyn BodyModel, context: &LoadContext) -> Option<Vec<UnitStrain>> {
    let base = context.material.fibres().map(|fibres| fibres.angle);
    let lamina = eigenstrain::of_fibres(angle, context);
    let unit = |[x, y, gamma, across]: [f64; 4]| {
        let of = |component: &str| match component {
            "xx" => x,
            "yy" => y,
            "zz" => across,
            "xy" => gamma,
            _ => 0.0,
        };
        UnitStrain::new(of, (model, context.material), lamina)
    };
    directions(angle.map(f64::to_radians).or(base)).into_iter().map(unit).collect()
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
    let foreign = [
        ("difference", load.difference.is_some(), "beams, frames and plates in bending"),
        ("member", load.member.is_some(), "frames"),
    ];
    for (key, _, what) in foreign.iter().filter(|key| key.1) {
        faults.error(path.key(*key), format!("`{key}` is for {what}")).hint(
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
    let points = eigenstrain::points(load.region.as_ref(), context, path, faults);
    let (Some(expansion), Some(change), Some(points), true) = (expansion, change, points, is_fine) else {
        return;
    };
    let (Some(model), materials) = (context.model, &context.inputs.materials) else { return };
    let angles = materials.fibre_angles();
    let Some(units) = angles.iter().map(|angle| units(*angle, model, context)).collect::<Option<Vec<_>>>()
    else {
        return;
    };
    let mut change_of = vec![0.0; model.points()];
    let mut free: Vec<Vec<Vec<f64>>> = units.iter().map(|of| vec![change_of.clone(); of.len()]).collect();
    for p in points {
        match change.at(ground.body.position(p as usize)) {
            Ok(value) => {
                let (number, other) = (context.inputs.number(model, p), materials.of(p as usize));
                let own_angle = materials.fibre_angle(p as usize);
                let lamina = angles.iter().position(|angle| *angle == own_angle).unwrap_or(0);
                let own =
                    other.and_then(|other| other.thermal_expansion).unwrap_or(expansion.along_and_across());
                change_of[number as usize] = value;
                for (free, alpha) in free[lamina].iter_mut().zip(own) {
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
    for free in free.iter_mut().flatten() {
        eigenstrain::give_images(free, "", model);
    }
    let parts = free
        .into_iter()
        .flatten()
        .zip(units.into_iter().flatten())
        .map(|(free, unit)| EigenstrainPart { free, unit });
    // Of laminae that are not heated there is none.
    let parts = parts.filter(|part| part.free.iter().any(|free| *free != 0.0));
    let own = Eigenstrain { change: change_of, parts: parts.collect() };
    eigenstrain::check("temperature", &own, context, path, faults);
    to.stretch(own);
}
