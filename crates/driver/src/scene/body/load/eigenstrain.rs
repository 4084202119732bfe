//! Strains that need no stress: of a change of temperature, or there from the beginning.
//!
//! A bond of a point whose material stretches by ε* is free of force at that stretch, so that the energy of a state is that of the
//! strains less ε*. The load that follows does the work of the stresses `S = C ε*`: `f·v = Σ V S : E(v)`, with the strain E of a point as
//! its bonds have it, and the stress of a point is that of its strains less S. A body that stretches by ε* everywhere is then the solution
//! to rounding, whatever its edges.

use super::context::LoadContext;
use crate::diagnostic::{Faults, JsonPath};
use crate::model::Material;
use peristat_assembly::bonds::Mat;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::solid::TENSOR;

/// What differs less, over the largest, is the same but for rounding.
const ROUNDING: f64 = 1e-9;

/// Strains that need no stress, a sum of parts.
#[derive(Clone, Debug)]
pub struct Eigenstrain {
    /// Kelvin by which the points of the model are warmer, images among them.
    pub change: Vec<f64>,
    /// The parts.
    pub parts: Vec<EigenstrainPart>,
}

/// Strains that differ by a factor from point to point.
#[derive(Clone, Debug)]
pub struct EigenstrainPart {
    /// What points of the model stretch by without stress, images among them, in units of what follows.
    pub free: Vec<f64>,
    /// The unit.
    pub unit: UnitStrain,
}

/// A strain, and what it does in the base material, or one of its stiffness with other fibres, where nothing moves, in the order of [`BodyModel::tensor_components`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UnitStrain {
    /// Strains, shears as γ.
    pub strain: [f64; TENSOR],
    /// Strain across the plane, or around the axis.
    pub across_strain: f64,
    /// What the material has in the plane at the stresses that follow.
    in_plane: [f64; TENSOR],
    /// Stresses C ε*.
    pub stress: [f64; TENSOR],
    /// The same across the plane, or around the axis.
    pub across_stress: f64,
}

impl UnitStrain {
    /// Of the strain `of` each component, shears as γ; none of a model without stiffness in all directions. `lamina` is the stiffness
    /// of other fibres than those of the base material.
    pub(super) fn new(
        of: impl Fn(&str) -> f64,
        (model, material): (&dyn BodyModel, &dyn Material),
        lamina: Option<Mat<3, 3>>,
    ) -> Option<Self> {
        let none = [0.0; TENSOR];
        let mut unit =
            Self { strain: none, across_strain: 0.0, in_plane: none, stress: none, across_stress: 0.0 };
        unit.strain.iter_mut().zip(model.tensor_components()).for_each(|(value, name)| *value = of(name));
        if let Some(solid) = model.as_solid() {
            let c = solid.stiffness();
            unit.stress = c.map(|row| row.iter().zip(unit.strain).map(|(c, e)| c * e).sum());
            unit.in_plane = model.strains_of(unit.stress, 0.0);
            return Some(unit);
        }
        let plane = model.as_plane()?;
        let c = lamina.unwrap_or_else(|| plane.stiffness());
        (0..3).for_each(|q| unit.stress[q] = (0..3).map(|k| c[q][k] * unit.strain[k]).sum());
        if material.holds_across() {
            // Of an isotropic material: what is stretched across presses on the plane as the other axis in it does.
            let ([x, y, ..], across) = (unit.strain, of("zz"));
            unit.across_strain = across;
            unit.stress[..2].iter_mut().for_each(|s| *s += c[0][1] * across);
            unit.across_stress = c[0][1] * (x + y) + c[0][0] * across;
        }
        // What is flat and free is as long as its stresses make it.
        unit.in_plane = match lamina {
            Some(_) => unit.strain,
            None => model.strains_of(unit.stress, unit.across_stress),
        };
        Some(unit)
    }

    /// Strains in the plane of these stresses, in the order of the components.
    pub(crate) fn in_plane(&self) -> [f64; TENSOR] {
        self.in_plane
    }

    /// How much stiffer the material of a point with such fibres is than the base one.
    pub(crate) fn stiffness(&self, model: &dyn BodyModel, point: usize) -> f64 {
        let (base, own) = (self.in_plane, model.strains_at(point, self.stress, self.across_stress));
        let largest =
            (0..TENSOR).max_by(|&a, &b| base[a].abs().total_cmp(&base[b].abs())).unwrap_or_default();
        base[largest] / own[largest]
    }
}

impl EigenstrainPart {
    /// Strains of all points in the plane, three planes.
    fn strains(&self) -> impl Iterator<Item = f64> {
        self.unit.in_plane.into_iter().take(3).flat_map(|e| self.free.iter().map(move |free| free * e))
    }

    fn add_to(&self, model: &dyn BodyModel, factor: f64, force: &mut [f64]) {
        let points: Vec<usize> = (0..self.free.len()).filter(|&p| self.free[p] != 0.0).collect();
        let some = (points.len() < self.free.len()).then_some(&points[..]);
        if let Some(plane) = model.as_plane() {
            let mut t: Vec<f64> = self.strains().map(|strain| factor * strain).collect();
            plane.add_free_work(&mut t, some, force);
        } else if let Some(solid) = model.as_solid() {
            let of = |point: usize| factor * self.free[point] * self.unit.stiffness(model, point);
            solid.add_stress_load(&|p, _| self.unit.stress.map(|s| of(p) * s), force);
        }
    }
}

impl Eigenstrain {
    /// Adds the load times a factor to forces on the unknowns of a model.
    pub(crate) fn add_to(&self, model: &dyn BodyModel, factor: f64, force: &mut [f64]) {
        self.parts.iter().for_each(|part| part.add_to(model, factor, force));
    }

    /// Strains of all points of a body in the plane, three planes, as its stresses in the plane would have them.
    pub(crate) fn strains(&self) -> Vec<f64> {
        let mut sum = vec![0.0; 3 * self.change.len()];
        for part in &self.parts {
            sum.iter_mut().zip(part.strains()).for_each(|(own, strain)| *own += strain);
        }
        sum
    }

    /// The load alone, on as many unknowns.
    pub(crate) fn load(&self, model: &dyn BodyModel, unknowns: usize) -> Vec<f64> {
        let mut force = vec![0.0; unknowns];
        self.add_to(model, 1.0, &mut force);
        force
    }

    /// The sum of this and a multiple of another one of the same material.
    pub(crate) fn plus(mut self, factor: f64, other: &Self) -> Self {
        let add = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(own, other)| *own += factor * other);
        };
        add(&mut self.change, &other.change);
        for part in &other.parts {
            match self.parts.iter_mut().find(|own| own.unit == part.unit) {
                Some(own) => add(&mut own.free, &part.free),
                None => {
                    let free = part.free.iter().map(|free| factor * free).collect();
                    self.parts.push(EigenstrainPart { free, unit: part.unit });
                }
            }
        }
        self
    }

    /// The same without that of some points, by their numbers.
    pub(crate) fn without(mut self, points: &[bool]) -> Self {
        for part in &mut self.parts {
            let off = part.free.iter_mut().zip(points).filter(|(_, off)| **off);
            off.for_each(|(free, _)| *free = 0.0);
        }
        self
    }

    /// A multiple.
    pub(crate) fn times(mut self, factor: f64) -> Self {
        let free = self.parts.iter_mut().flat_map(|part| &mut part.free);
        self.change.iter_mut().chain(free).for_each(|value| *value *= factor);
        self
    }
}

/// What fibres at an angle, degrees, resist to uniform strains at the factor one; none of those of the base material.
pub(super) fn of_fibres(angle: Option<f64>, context: &LoadContext) -> Option<Mat<3, 3>> {
    let (materials, plane) = (&context.inputs.materials, context.model?.as_plane()?);
    let is_own = |p: &usize| materials.fibre_angle(*p) == angle;
    let point = (0..context.ground.body.points()).find(is_own).filter(|_| angle.is_some())?;
    let number = context.inputs.number(context.model?, point as u32) as usize;
    let factor = 1.0 / materials.factors[point];
    Some(plane.stiffness_at(number).map(|row| row.map(|c| factor * c)))
}

/// Gives images the values of their points, with the sign of a component of a tensor.
pub(super) fn give_images(values: &mut [f64], component: &str, model: &dyn BodyModel) {
    let Some((lattice, mirrors)) = model.lattice() else { return };
    for &ghost in model.ghosts() {
        let (cell, signs) = mirrors.image(lattice.cell(ghost as usize));
        if let Some(real) = lattice.number(cell) {
            let sign: f64 = component.bytes().map(|axis| signs[usize::from(axis - b'x')]).product();
            values[ghost as usize] = sign * values[real];
        }
    }
}

/// The points of a region that is no part of the border, or of all of the body.
pub(super) fn points(
    region: Option<&String>,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Vec<u32>> {
    let ground = context.ground;
    let Some(name) = region else { return Some((0..ground.body.points() as u32).collect()) };
    let is_border = ground.outline.is_some_and(|outline| outline.members(name).is_some());
    if is_border && !ground.case.regions.contains_key(name) {
        faults
            .error(
                path.key("region"),
                format!("`{name}` is a part of the border: its points are a row beside it"),
            )
            .hint("name one of the `regions`; without `region` all of the body has it");
        return None;
    }
    ground.region(name, &path.key("region"), faults)
}

/// Whether the body can bear strains that need no stress, of the load `name`; faults where it cannot.
pub(super) fn is_borne(name: &str, context: &LoadContext, path: &JsonPath, faults: &mut Faults) -> bool {
    let case = context.ground.case;
    let (message, hint) = if let Some(reason) = context.material.resists_eigenstrain() {
        (reason.into(), "remove it, or take another model")
    } else if leaves_sides_open(context) {
        (
            format!("joined sides take `{name}` where edges are completed only"),
            "leave `edges` and `calibration` out",
        )
    } else if case.path.is_some() {
        (
            format!("bodies that soften have no `{name}`"),
            "find the stresses of the body with its cracks, without `path`",
        )
    } else if case.fracture.is_some() && !breaks_with_it(context) {
        (
            format!("of bodies that break only lattices of bonds in the plane take a `{name}`"),
            "find the stresses of the body with its cracks, without `fracture`",
        )
    } else if differ_in_contraction(context) {
        (
            format!("bodies of materials with other Poisson's ratios have no `{name}`"),
            "give all of them the `poisson_ratio` of `model`",
        )
    } else if !case.stress_intensity.is_empty() {
        (format!("stress intensities of bodies with `{name}` are not found"), "remove `stress_intensity`")
    } else {
        return true;
    };
    faults.error(path.clone(), message).hint(hint);
    false
}

/// Whether the elements of the body are known to be free at such strains; a body that cannot be made has other faults.
fn breaks_with_it(context: &LoadContext) -> bool {
    let Some(model) = context.model else { return true };
    let nothing = vec![0.0; 3 * model.points()];
    model.as_plane().is_some_and(|plane| plane.energy_at_rest(&nothing).is_some())
}

/// Adds doubts about the strains of the load `name` at some points of the body, and a fault where these vary in a material whose points
/// share dilatations.
pub(super) fn check(
    name: &str,
    own: &Eigenstrain,
    context: &LoadContext,
    path: &JsonPath,
    faults: &mut Faults,
) {
    let (case, material) = (context.ground.case, context.material);
    if material.about().has_families && !case.cracks.is_empty() {
        faults
            .warning(path.clone(), format!("families beside cracks are not complete: there stresses of `{name}` are off by E times the free strain and more"))
            .hint("models of bonds are exact beside cracks");
    }
    let Some(model) = context.model.filter(|_| material.shares_dilatations()) else { return };
    let varies = |part: &EigenstrainPart| {
        let of = |p: usize| part.free[context.inputs.number(model, p as u32) as usize];
        let values = || (0..context.ground.body.points()).map(of);
        let [least, most] = [f64::min as fn(f64, f64) -> f64, f64::max].map(|best| values().reduce(best));
        let largest = values().fold(0.0, |most: f64, value| most.max(value.abs()));
        least.zip(most).is_some_and(|(least, most)| most - least > ROUNDING * largest)
    };
    if own.parts.iter().any(varies) {
        faults
            .error(path.clone(), format!("`{name}` that varies makes stresses that alternate from point to point, with the dilatation `blocks`"))
            .hint("make it the same everywhere, or take a Poisson's ratio up to 0.45, which has the dilatation `points`");
    }
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
