//! What strains that need no stress are in results.

use super::fields::Recovered;
use super::of_stress::component;
use crate::model::Surface;
use crate::scene::body::{Eigenstrain, EigenstrainPart};
use peristat_assembly::model::solid::TENSOR;
use peristat_assembly::model::{BodyFields, BodyModel};
use std::array::from_fn;

/// The stresses that strains without stress would have as the bonds of a body see them.
#[derive(Clone, Debug)]
pub struct EigenStress {
    /// Kelvin by which the points of the model are warmer.
    pub(super) change: Vec<f64>,
    /// By component, at the points of the model.
    stress: Vec<Vec<f64>>,
    /// Across the plane or around the axis; empty where it is zero.
    across: Vec<f64>,
}

impl EigenStress {
    fn new(of: &Eigenstrain, surface: Surface, model: &dyn BodyModel) -> Self {
        let nothing = || vec![0.0; model.points()];
        let stress = model.tensor_components().iter().map(|_| nothing()).collect();
        let mut found = Self { change: of.change.clone(), stress, across: Vec::new() };
        for part in &of.parts {
            let (stress, across) = of_part(part, surface, model);
            found.stress.iter_mut().zip(stress).for_each(|(to, own)| add(to, &own));
            if found.across.is_empty() {
                found.across = across;
            } else if !across.is_empty() {
                add(&mut found.across, &across);
            }
        }
        found.add_beyond(of, model);
        found
    }

    /// Adds what bonds through several materials have beyond the strains of their points.
    fn add_beyond(&mut self, of: &Eigenstrain, model: &dyn BodyModel) {
        let Some(beyond) = model.as_plane().and_then(|plane| plane.free_stress_beyond(&of.strains())) else {
            return;
        };
        let across = |p: usize| model.across_of(from_fn(|k| beyond.get(k).map_or(0.0, |plane| plane[p])));
        self.across.iter_mut().enumerate().for_each(|(p, own)| *own += across(p));
        self.stress.iter_mut().zip(&beyond).for_each(|(to, own)| add(to, own));
    }

    /// Adds them to those of a sum over points.
    pub(super) fn add_to(
        &self,
        sum: impl Fn(&[f64]) -> f64,
        (mut stress, across): ([f64; TENSOR], f64),
    ) -> ([f64; TENSOR], f64) {
        stress.iter_mut().zip(&self.stress).for_each(|(own, s)| *own += sum(s));
        (stress, across + if self.across.is_empty() { 0.0 } else { sum(&self.across) })
    }
}

fn add(to: &mut [f64], own: &[f64]) {
    to.iter_mut().zip(own).for_each(|(to, own)| *to += own);
}

/// The stresses of a part by component, and those across the plane or around the axis where there are any.
fn of_part(part: &EigenstrainPart, surface: Surface, model: &dyn BodyModel) -> (Vec<Vec<f64>>, Vec<f64>) {
    let unit = &part.unit;
    // What stretches a body is no motion of one whose sides are joined; a cylinder widens.
    let joined = model.lattice().map_or([false; 3], |(_, mirrors)| mirrors.joined);
    let stretches = !joined[0] && (matches!(surface, Surface::Cylinder(_)) || !joined[1]) && !joined[2];
    // Points at edges and cracks that nothing completes have other moduli than those inside.
    let own = stretches.then(|| stretched(part, surface, model));
    let times = |value: f64, own: Option<&Vec<f64>>| -> Vec<f64> {
        match own {
            Some(own) => part.free.iter().zip(own).map(|(free, s)| free * s).collect(),
            None => {
                let at = |(p, free): (usize, &f64)| match *free {
                    0.0 => 0.0,
                    free => free * value * unit.stiffness(model, p),
                };
                part.free.iter().enumerate().map(at).collect()
            }
        }
    };
    let planes = unit.stress.iter().zip(model.tensor_components()).enumerate();
    let stress = planes.map(|(k, (s, _))| times(*s, own.as_ref().map(|own| &own.stress[k]))).collect();
    let across = match (&own, unit.across_stress == 0.0) {
        (_, true) => Vec::new(),
        (Some(own), _) if !own.across.is_empty() => times(unit.across_stress, Some(&own.across)),
        // What follows from the stresses in the plane, and what holds the plane besides.
        (Some(own), _) => {
            let besides = unit.across_stress - model.across_of(unit.stress);
            let at = |p: usize| from_fn(|k| own.stress.get(k).map_or(0.0, |values| values[p]));
            let across = |p: usize| model.across_of(at(p)) + besides * unit.stiffness(model, p);
            part.free.iter().enumerate().map(|(p, free)| free * across(p)).collect()
        }
        (None, _) => times(unit.across_stress, None),
    };
    (stress, across)
}

/// What is recovered where a body stretches by a unit, a linear motion of no rotation.
fn stretched(part: &EigenstrainPart, surface: Surface, model: &dyn BodyModel) -> BodyFields {
    let strain = part.unit.in_plane();
    let of = |name: &str| component(model, name).map_or(0.0, |k| strain[k]);
    let (half_xy, half_yz, half_xz) = (0.5 * of("xy"), 0.5 * of("yz"), 0.5 * of("xz"));
    let rows = [[of("xx"), half_xy, half_xz], [half_xy, of("yy"), half_yz], [half_xz, half_yz, of("zz")]];
    let n = model.points();
    let mut u = vec![0.0; n * model.components().len()];
    for axis in 0..3 {
        let Some(plane) = model.along(axis) else { continue };
        for p in 0..n {
            let at = model.position(p);
            u[plane * n + p] = match (axis, surface) {
                (0, Surface::Cylinder(_)) => of("xx") * at[0],
                (1, Surface::Cylinder(_)) => of("xy") * at[0],
                (_, Surface::Cylinder(radius)) => of("yy") * radius,
                _ => (0..3).map(|k| rows[axis][k] * at[k]).sum(),
            };
        }
    }
    model.recover(&u)
}

impl Recovered {
    /// Takes the stresses of strains that need no stress off those of all strains; what is stored is what the rest has.
    pub(super) fn take_off(&mut self, of: &Eigenstrain, surface: Surface, model: &dyn BodyModel) {
        let own = EigenStress::new(of, surface, model);
        if !own.across.is_empty() && self.across.is_empty() {
            self.across = (0..of.change.len()).map(|p| model.across_at(p, self.at(|s| s[p]))).collect();
        }
        for p in 0..of.change.len() {
            let (held, across) = own.add_to(|s| s[p], ([0.0; TENSOR], 0.0));
            self.stress.iter_mut().zip(held).for_each(|(values, s)| values[p] -= s);
            if let Some(value) = self.across.get_mut(p) {
                *value -= across;
            }
            let across = self.across.get(p).copied().unwrap_or_default();
            self.energy_density[p] = stored(of, (p, model, surface), self.at(|s| s[p]), across);
        }
        self.eigenstrain = Some(Box::new(own));
    }

    /// Energy of all points, J.
    pub(super) fn energy(&self, model: &dyn BodyModel) -> f64 {
        self.energy_density.iter().enumerate().map(|(p, density)| model.volume(p) * density).sum()
    }
}

/// Energy density of stresses, `½ σ : C⁻¹ σ` in space.
fn stored(
    of: &Eigenstrain,
    (point, model, surface): (usize, &dyn BodyModel, Surface),
    stress: [f64; TENSOR],
    across: f64,
) -> f64 {
    let strain = model.strains_at(point, stress, across);
    let in_plane: f64 = stress.iter().zip(strain).map(|(s, e)| s * e).sum();
    let held = of.parts.iter().map(|part| &part.unit).find(|unit| unit.across_strain != 0.0);
    let besides = match held {
        // Around the axis the material is as it is along the radius.
        _ if surface == Surface::Section => {
            let [x, y, shear, ..] = stress;
            across * model.strains_at(point, [across, y, shear, 0.0, 0.0, 0.0], x)[0]
        }
        // Beyond the stress that follows from those in the plane there is one that acts alone.
        Some(unit) => {
            let modulus = (unit.across_stress - model.across_of(unit.stress)) / unit.across_strain;
            let modulus = modulus * unit.stiffness(model, point);
            (across - model.across_of(stress)).powi(2) / modulus
        }
        None => 0.0,
    };
    0.5 * (in_plane + besides)
}
