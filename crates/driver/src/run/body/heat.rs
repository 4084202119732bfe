//! What a change of temperature is in results: strains without stress.

use super::fields::Recovered;
use super::of_stress::component;
use crate::scene::body::Heat;
use peristat_assembly::model::solid::TENSOR;
use peristat_assembly::model::{BodyFields, BodyModel};
use std::array::from_fn;

/// The stresses that strains without stress would have as the bonds of a body see them.
#[derive(Clone, Debug)]
pub struct HeatStress {
    /// Kelvin by which the points of the model are warmer.
    pub(super) change: Vec<f64>,
    /// By component, at the points of the model.
    stress: Vec<Vec<f64>>,
    /// Across the plane or around the axis; empty where it is zero.
    across: Vec<f64>,
}

impl HeatStress {
    fn new(heat: &Heat, radius: Option<f64>, model: &dyn BodyModel) -> Self {
        let unit = &heat.unit;
        // What stretches a body is no motion of one whose sides are joined; a cylinder widens.
        let joined = model.lattice().map_or([false; 3], |(_, mirrors)| mirrors.joined);
        let stretches = !joined[0] && (radius.is_some() || !joined[1]) && !joined[2];
        // Points at edges and cracks that nothing completes have other moduli than those inside.
        let own = stretches.then(|| stretched(heat, radius, model));
        let times = |value: f64, own: Option<&Vec<f64>>| -> Vec<f64> {
            match own {
                Some(own) => heat.free.iter().zip(own).map(|(free, s)| free * s).collect(),
                None => {
                    let at = |(p, free): (usize, &f64)| free * value * heat.stiffness(model, p);
                    heat.free.iter().enumerate().map(at).collect()
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
                let each = heat.free.iter().enumerate();
                let across = |p: usize| model.across_of(at(p)) + besides * heat.stiffness(model, p);
                each.map(|(p, free)| free * across(p)).collect()
            }
            (None, _) => times(unit.across_stress, None),
        };
        Self { change: heat.change.clone(), stress, across }
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

/// What is recovered where a body stretches by a unit.
fn stretched(heat: &Heat, radius: Option<f64>, model: &dyn BodyModel) -> BodyFields {
    let strain = model.strains_of(heat.unit.stress, heat.unit.across_stress);
    let of = |name: &str| component(model, name).map_or(0.0, |k| strain[k]);
    let (x, y, z, half) = (of("xx"), of("yy"), of("zz"), 0.5 * of("xy"));
    let n = model.points();
    let mut u = vec![0.0; n * model.components().len()];
    for axis in 0..3 {
        let Some(plane) = model.along(axis) else { continue };
        for p in 0..n {
            let at = model.position(p);
            u[plane * n + p] = match (axis, radius) {
                (0, Some(_)) => x * at[0],
                (1, Some(_)) => 0.0,
                (_, Some(radius)) => y * radius,
                (0, None) => x * at[0] + half * at[1],
                (1, None) => half * at[0] + y * at[1],
                (_, None) => z * at[2],
            };
        }
    }
    model.recover(&u)
}

impl Recovered {
    /// Takes the stresses of strains that need no stress off those of all strains; what is stored is what the rest has.
    pub(super) fn take_off(&mut self, heat: &Heat, radius: Option<f64>, model: &dyn BodyModel) {
        let own = HeatStress::new(heat, radius, model);
        if !own.across.is_empty() && self.across.is_empty() {
            self.across = (0..heat.change.len()).map(|p| model.across_at(p, self.at(|s| s[p]))).collect();
        }
        for p in 0..heat.change.len() {
            let (held, across) = own.add_to(|s| s[p], ([0.0; TENSOR], 0.0));
            self.stress.iter_mut().zip(held).for_each(|(values, s)| values[p] -= s);
            if let Some(value) = self.across.get_mut(p) {
                *value -= across;
            }
            let across = self.across.get(p).copied().unwrap_or_default();
            self.energy_density[p] = stored(heat, (p, model), self.at(|s| s[p]), across);
        }
        self.heat = Some(Box::new(own));
    }

    /// Energy of all points, J.
    pub(super) fn energy(&self, model: &dyn BodyModel) -> f64 {
        self.energy_density.iter().enumerate().map(|(p, density)| model.volume(p) * density).sum()
    }
}

/// Energy density of stresses, `½ σ : C⁻¹ σ` in space.
fn stored(heat: &Heat, (point, model): (usize, &dyn BodyModel), stress: [f64; TENSOR], across: f64) -> f64 {
    let (unit, strain) = (&heat.unit, model.strains_at(point, stress, across));
    let in_plane: f64 = stress.iter().zip(strain).map(|(s, e)| s * e).sum();
    let besides = if model.is_revolved() {
        // Around the axis the material is as it is along the radius.
        let [x, y, shear, ..] = stress;
        across * model.strains_at(point, [across, y, shear, 0.0, 0.0, 0.0], x)[0]
    } else if unit.across_strain != 0.0 {
        // Beyond the stress that follows from those in the plane there is one that acts alone.
        let modulus = (unit.across_stress - model.across_of(unit.stress)) / unit.across_strain;
        let modulus = modulus * heat.stiffness(model, point);
        (across - model.across_of(stress)).powi(2) / modulus
    } else {
        0.0
    };
    0.5 * (in_plane + besides)
}
