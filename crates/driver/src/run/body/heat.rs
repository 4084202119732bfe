//! What a change of temperature is in results: strains without stress.

use super::fields::Recovered;
use crate::scene::body::Heat;
use peristat_assembly::model::solid::TENSOR;
use peristat_assembly::model::{BodyFields, BodyModel};

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
    fn new(heat: &Heat, model: &dyn BodyModel) -> Self {
        let unit = &heat.unit;
        let joined = model.lattice().is_some_and(|(_, mirrors)| mirrors.joined != [false; 3]);
        // Points at edges and cracks that nothing completes have other moduli than those inside.
        let own = (!joined).then(|| stretched(heat, model));
        let times = |value: f64, own: Option<&Vec<f64>>| -> Vec<f64> {
            match own {
                Some(own) => heat.change.iter().zip(own).map(|(change, s)| change * s).collect(),
                None => heat.change.iter().map(|change| change * value).collect(),
            }
        };
        let planes = unit.stress.iter().zip(model.tensor_components()).enumerate();
        let stress = planes.map(|(k, (s, _))| times(*s, own.as_ref().map(|own| &own.stress[k]))).collect();
        let of_own = own.as_ref().map(|own| &own.across).filter(|across| !across.is_empty());
        let across = if unit.across_stress == 0.0 { Vec::new() } else { times(unit.across_stress, of_own) };
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

/// What is recovered where a body stretches as one kelvin stretches it.
fn stretched(heat: &Heat, model: &dyn BodyModel) -> BodyFields {
    let strain = model.strains_of(heat.unit.stress, heat.unit.across_stress);
    let of =
        |name: &str| model.tensor_components().iter().position(|own| *own == name).map_or(0.0, |k| strain[k]);
    let (x, y, z, half) = (of("xx"), of("yy"), of("zz"), 0.5 * of("xy"));
    let rows = [[x, half, 0.0], [half, y, 0.0], [0.0, 0.0, z]];
    let n = model.points();
    let mut u = vec![0.0; n * model.components().len()];
    for (axis, row) in rows.iter().enumerate() {
        let Some(plane) = model.along(axis) else { continue };
        for p in 0..n {
            u[plane * n + p] = row.iter().zip(model.position(p)).map(|(e, x)| e * x).sum();
        }
    }
    model.recover(&u)
}

impl Recovered {
    /// Takes the stresses and energies of strains that need no stress off those of all strains.
    pub(super) fn take_off(&mut self, heat: &Heat, model: &dyn BodyModel) {
        let (unit, own) = (&heat.unit, HeatStress::new(heat, model));
        if !own.across.is_empty() && self.across.is_empty() {
            self.across = (0..heat.change.len()).map(|p| model.across_of(self.at(|s| s[p]))).collect();
        }
        let work = |stress: [f64; TENSOR], across: f64| -> f64 {
            unit.strain.iter().zip(stress).map(|(e, s)| e * s).sum::<f64>() + unit.across_strain * across
        };
        for (p, &change) in heat.change.iter().enumerate().filter(|(_, change)| **change != 0.0) {
            let all = (self.at(|s| s[p]), self.across.get(p).copied().unwrap_or_default());
            let held = own.add_to(|s| s[p], ([0.0; TENSOR], 0.0));
            self.energy_density[p] += change * (0.5 * work(held.0, held.1) - work(all.0, all.1));
            self.stress.iter_mut().zip(held.0).for_each(|(values, s)| values[p] -= s);
            if let Some(across) = self.across.get_mut(p) {
                *across -= held.1;
            }
        }
        self.heat = Some(own);
    }
}

/// Energy of a state with strains that need no stress, beyond that of all strains: `½ Σ V ε*·S − u·f`, f the load of them.
pub(super) fn energy(heat: &Heat, model: &dyn BodyModel, u: &[f64]) -> f64 {
    let mut force = vec![0.0; u.len()];
    heat.add_to(model, 1.0, &mut force);
    let work: f64 = u.iter().zip(&force).map(|(u, f)| u * f).sum();
    let (unit, own) = (&heat.unit, HeatStress::new(heat, model));
    let held = heat.change.iter().enumerate().filter(|(_, change)| **change != 0.0).map(|(p, change)| {
        let (stress, across) = own.add_to(|s| s[p], ([0.0; TENSOR], 0.0));
        let in_plane: f64 = unit.strain.iter().zip(stress).map(|(e, s)| e * s).sum();
        model.volume(p) * change * (in_plane + unit.across_strain * across)
    });
    0.5 * held.sum::<f64>() - work
}
