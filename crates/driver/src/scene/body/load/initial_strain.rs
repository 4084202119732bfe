//! Strains that regions of a body have from the beginning: swelling, shrinkage, misfit, prestress.

use super::context::LoadContext;
use super::eigenstrain::{self, Eigenstrain, EigenstrainPart, UnitStrain};
use super::sums::BodyLoads;
use crate::case::{Amount, InitialStrain};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::prescribed::Prescribed;
use peristat_assembly::model::BodyModel;

/// Adds an initial strain.
pub(super) fn resolve(
    load: &InitialStrain,
    context: &LoadContext,
    path: &JsonPath,
    to: &mut BodyLoads,
    faults: &mut Faults,
) {
    let mut is_fine = eigenstrain::is_borne("initial_strain", context, path, faults);
    if context.material.surface().axis().is_some() {
        faults
            .error(path.clone(), "a body of revolution has no `initial_strain`")
            .hint("a `temperature` stretches it alike in all directions");
        is_fine = false;
    }
    for key in load.of_lines() {
        faults.error(path.key(key), format!("`{key}` is for lines and members")).hint(
            "a body has the components `xx`, `yy` and `xy`, and a solid those with z, of a `region` or all of it",
        );
    }
    let given = load.components().into_iter().filter_map(|(name, amount)| Some((name, amount.as_ref()?)));
    let mut components = Vec::new();
    for (name, amount) in given {
        let path = path.key(name);
        if check_component(name, context, &path, faults)
            && let Some(value) = context.prescribed(amount, &path, faults)
        {
            components.push((name, value));
        }
    }
    let is_zero = |amount: &Option<Amount>| amount.as_ref().is_none_or(|a| a.number() == Some(0.0));
    let says_nothing = load.of_lines().next().is_none() && context.factor.is_none();
    if says_nothing && load.components().iter().all(|(_, amount)| is_zero(amount)) {
        faults
            .error(path.clone(), "this load is zero")
            .hint("give components, numbers or formulas, such as `\"xx\": 1e-3`");
    }
    let points = eigenstrain::points(load.region.as_ref(), context, path, faults);
    let (Some(points), Some(model), true) = (points, context.model, is_fine) else { return };
    let mut own = Eigenstrain { change: vec![0.0; model.points()], parts: Vec::new() };
    for (name, value) in components.iter().filter(|(_, value)| !value.is_zero()) {
        match part((name, value), (&points, model), context) {
            Ok(part) => own.parts.extend(part),
            Err(reason) => {
                faults.error(path.key(*name), reason);
                return;
            }
        }
    }
    eigenstrain::check("initial_strain", &own, context, path, faults);
    to.stretch(own);
}

/// A component of some points of the body, a part for each angle of fibres; none of a model without stiffness in all directions.
///
/// # Errors
/// A formula has no value at one of them.
fn part(
    (name, value): (&str, &Prescribed),
    (points, model): (&[u32], &dyn BodyModel),
    context: &LoadContext,
) -> Result<Vec<EigenstrainPart>, String> {
    // Shears are given as halves of γ.
    let size = if is_shear(name) { 2.0 } else { 1.0 };
    let of = |component: &str| if component == name { size } else { 0.0 };
    let materials = &context.inputs.materials;
    let mut parts = Vec::new();
    for angle in materials.fibre_angles() {
        let lamina = eigenstrain::of_fibres(angle, context);
        let Some(unit) = UnitStrain::new(of, (model, context.material), lamina) else {
            return Ok(Vec::new());
        };
        let mut free = vec![0.0; model.points()];
        for &p in points.iter().filter(|p| materials.fibre_angle(**p as usize) == angle) {
            let number = context.inputs.number(model, p) as usize;
            free[number] = value.at(context.ground.body.position(p as usize))?;
        }
        eigenstrain::give_images(&mut free, name, model);
        parts.push(EigenstrainPart { free, unit });
    }
    Ok(parts)
}

fn is_shear(name: &str) -> bool {
    name.as_bytes()[0] != name.as_bytes()[1]
}

/// Whether a body can have a component.
fn check_component(name: &str, context: &LoadContext, path: &JsonPath, faults: &mut Faults) -> bool {
    let Some(model) = context.model else { return true };
    let is_across = name == "zz" && context.material.holds_across();
    if !model.tensor_components().contains(&name) && !is_across {
        let hint = match name {
            "zz" => "in plane stress the body is free to stretch across the plane, and nothing comes of it",
            _ => "the components of a body in the plane are `xx`, `yy` and `xy`",
        };
        faults.error(path.clone(), format!("this body has no component `{name}`")).hint(hint);
        return false;
    }
    true
}
