//! Changes of temperature: strains that need no stress.
//!
//! A bond of a point whose material stretches by ε* is free of force at that stretch, so that the energy of a state is that of the
//! strains less ε*. The load that follows does the work of the stresses `S = C ε*`: `f·v = Σ V S : E(v)`, with the strain E of a point as
//! its bonds have it, and the stress of a point is that of its strains less S. A body that stretches by ε* everywhere is then the solution
//! to rounding, whatever its edges.

use super::context::LoadContext;
use super::sums::BodyLoads;
use crate::case::{Expansion, Temperature};
use crate::diagnostic::{Faults, JsonPath};
use crate::model::{Fibres, Material};
use crate::scene::expansion;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::solid::TENSOR;

/// Strains that need no stress, and the stresses that keep a body from them.
#[derive(Clone, Debug)]
pub struct Heat {
    /// Kelvin by which the points of the model are warmer, images among them.
    pub change: Vec<f64>,
    /// What they stretch by without stress, in units of what follows.
    pub free: Vec<f64>,
    /// A unit: a strain of one, or with fibres that of one kelvin.
    pub unit: UnitHeat,
}

/// What a unit does in the base material where nothing moves, in the order of [`BodyModel::tensor_components`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitHeat {
    /// Strains, shears as γ.
    pub strain: [f64; TENSOR],
    /// Strain across the plane, or around the axis.
    pub across_strain: f64,
    /// Stresses C ε*.
    pub stress: [f64; TENSOR],
    /// The same across the plane, or around the axis.
    pub across_stress: f64,
}

impl UnitHeat {
    fn new(expansion: Expansion, model: &dyn BodyModel, material: &dyn Material) -> Option<Self> {
        let mut unit =
            Self { strain: [0.0; TENSOR], across_strain: 0.0, stress: [0.0; TENSOR], across_stress: 0.0 };
        let [x, y, gamma, across] = in_plane(expansion, material.fibres());
        for (value, name) in unit.strain.iter_mut().zip(model.tensor_components()) {
            *value = match *name {
                "xx" => x,
                "yy" => y,
                "zz" => across,
                "xy" => gamma,
                _ => 0.0,
            };
        }
        if let Some(solid) = model.as_solid() {
            let c = solid.stiffness();
            unit.stress = c.map(|row| row.iter().zip(unit.strain).map(|(c, e)| c * e).sum());
            return Some(unit);
        }
        let c = model.as_plane()?.stiffness();
        (0..3).for_each(|q| unit.stress[q] = (0..3).map(|k| c[q][k] * unit.strain[k]).sum());
        if material.holds_across() {
            // Of an isotropic material: what is stretched across presses on the plane as the other axis in it does.
            unit.across_strain = across;
            unit.stress[..2].iter_mut().for_each(|s| *s += c[0][1] * across);
            unit.across_stress = c[0][1] * (x + y) + c[0][0] * across;
        }
        Some(unit)
    }
}

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

impl Heat {
    /// Adds the load times a factor to forces on the unknowns of a model.
    pub(crate) fn add_to(&self, model: &dyn BodyModel, factor: f64, force: &mut [f64]) {
        let points: Vec<usize> = (0..self.free.len()).filter(|&p| self.free[p] != 0.0).collect();
        let some = (points.len() < self.free.len()).then_some(&points[..]);
        if let Some(plane) = model.as_plane() {
            let strain = model.strains_of(self.unit.stress, self.unit.across_stress);
            let mut t: Vec<f64> = strain[..3]
                .iter()
                .flat_map(|e| self.free.iter().map(move |free| factor * free * e))
                .collect();
            plane.add_strain_work(&mut t, some, force);
        } else if let Some(solid) = model.as_solid() {
            let of = |point: usize| factor * self.free[point] * self.stiffness(model, point);
            solid.add_stress_load(&|p, _| self.unit.stress.map(|s| of(p) * s), force);
        }
    }

    /// How much stiffer the material of a point is than the base one.
    pub(crate) fn stiffness(&self, model: &dyn BodyModel, point: usize) -> f64 {
        let (stress, across) = (self.unit.stress, self.unit.across_stress);
        let (base, own) = (model.strains_of(stress, across), model.strains_at(point, stress, across));
        let largest =
            (0..TENSOR).max_by(|&a, &b| base[a].abs().total_cmp(&base[b].abs())).unwrap_or_default();
        base[largest] / own[largest]
    }

    /// The load alone, on as many unknowns.
    pub(crate) fn load(&self, model: &dyn BodyModel, unknowns: usize) -> Vec<f64> {
        let mut force = vec![0.0; unknowns];
        self.add_to(model, 1.0, &mut force);
        force
    }

    /// The sum of this and a multiple of another one of the same material.
    pub(crate) fn plus(mut self, factor: f64, other: &Self) -> Self {
        self.change.iter_mut().zip(&other.change).for_each(|(own, other)| *own += factor * other);
        self.free.iter_mut().zip(&other.free).for_each(|(own, other)| *own += factor * other);
        self
    }

    /// A multiple.
    pub(crate) fn times(mut self, factor: f64) -> Self {
        self.change.iter_mut().chain(&mut self.free).for_each(|value| *value *= factor);
        self
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
    let is_fine = is_borne(context, path, faults);
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
    let Some(unit) = UnitHeat::new(unit, model, context.material) else { return };
    let mut heat = Heat { change: vec![0.0; model.points()], free: vec![0.0; model.points()], unit };
    for p in points {
        match change.at(ground.body.position(p as usize)) {
            Ok(value) => {
                let (number, other) =
                    (context.inputs.number(model, p), context.inputs.materials.of(p as usize));
                let alpha = other.and_then(|other| other.thermal_expansion).unwrap_or(base);
                heat.change[number as usize] = value;
                heat.free[number as usize] = alpha * value;
            }
            Err(reason) => {
                faults.error(path.key("change"), reason);
                return;
            }
        }
    }
    if context.factor.is_none() && heat.change.iter().all(|change| *change == 0.0) {
        faults.error(path.clone(), "this load is zero");
    }
    if context.material.about().has_families && !ground.case.cracks.is_empty() {
        faults
            .warning(path.clone(), "families beside cracks are not complete: there stresses are off by some tenths of E times the free strain")
            .hint("models of bonds are exact beside cracks");
    }
    give_images(&mut heat.change, model);
    give_images(&mut heat.free, model);
    to.heat = Some(match to.heat.take() {
        Some(other) => other.plus(1.0, &heat),
        None => heat,
    });
}

/// Gives images the values of their points.
fn give_images(values: &mut [f64], model: &dyn BodyModel) {
    let Some((lattice, mirrors)) = model.lattice() else { return };
    for &ghost in model.ghosts() {
        let (cell, _) = mirrors.image(lattice.cell(ghost as usize));
        if let Some(real) = lattice.number(cell) {
            values[ghost as usize] = values[real];
        }
    }
}

/// Whether the body can bear a change of temperature.
fn is_borne(context: &LoadContext, path: &JsonPath, faults: &mut Faults) -> bool {
    let case = context.ground.case;
    let (message, hint) = if let Some(reason) = context.material.feels_no_heat() {
        (reason, "remove it, or take another model")
    } else if leaves_sides_open(context) {
        (
            "joined sides take a `temperature` where edges are completed only",
            "leave `edges` and `calibration` out",
        )
    } else if case.is_traced() {
        (
            "bodies that break or soften have no `temperature`",
            "find the stresses of the body with its cracks, without `fracture` and `path`",
        )
    } else if differ_in_contraction(context) {
        (
            "bodies of materials with other Poisson's ratios have no `temperature`",
            "give all of them the `poisson_ratio` of `model`",
        )
    } else if !case.stress_intensity.is_empty() {
        ("stress intensities of bodies with a `temperature` are not found", "remove `stress_intensity`")
    } else {
        return true;
    };
    faults.error(path.clone(), message).hint(hint);
    false
}

/// Whether materials are other than the base one not by a factor alone.
fn differ_in_contraction(context: &LoadContext) -> bool {
    let known = context.material.other_materials().unwrap_or_default();
    let base = known.iter().find(|(key, _)| *key == "poisson_ratio").map(|(_, value)| *value);
    let mut ratios = context.inputs.materials.others.iter().filter_map(|other| other.poisson_ratio);
    ratios.any(|ratio| Some(ratio) != base)
}

/// Whether sides are joined and edges are not complete, which leaves the free stresses of points beside them unknown.
fn leaves_sides_open(context: &LoadContext) -> bool {
    let is_cylinder = context.material.cylinder_radius().is_some();
    let joined = context.symmetry.mirrors.joined;
    joined != [false; 3] && !is_cylinder && !context.material.about().is_exact_at_edges
}
