//! Loads of a state-based body that do the work of stresses, or of strains that need no stress.

use super::StateParameters;
use super::body::{StateBody, cell_volume};
use super::weights::Set;
use crate::body::{Cell, plus};

/// What acts along a bond of a family, by its set and offset and by a value of the point.
type Action<'a> = dyn Fn(&Set, usize, [f64; 3]) -> f64 + 'a;

impl StateBody {
    /// Adds the forces `Σ_k V_k S_k : E_k` of stresses `[S_xx, S_yy, S_xy]`, Pa, of some points; none for all. The volumes
    /// are those of the energies, so that a uniform stress does the same work in the load and in the stiffness.
    pub(super) fn add_stress_work(
        &self,
        parameters: &StateParameters,
        points: Option<&[usize]>,
        stress: &dyn Fn(usize) -> [f64; 3],
        force: &mut [f64],
    ) {
        // What loads a border knows nothing of the materials behind it: inside, one stress is then no force whatever these are.
        let action = |_: &Set, k: usize, [xx, yy, xy]: [f64; 3]| {
            4.0 * along(self.families.offsets[k], [xx, yy, xy]) - xx - yy
        };
        self.add_actions(parameters, points, (stress, &action), force);
    }

    /// Adds the forces that a motion takes by which all points stretch by the strains t, three planes, and in a body of revolution
    /// around the axis as along x.
    pub(super) fn add_stretch_work(
        &self,
        parameters: &StateParameters,
        points: Option<&[usize]>,
        t: &[f64],
        force: &mut [f64],
    ) {
        let n = self.lattice.points();
        let strain = |p: usize| [t[p], t[n + p], 0.5 * t[2 * n + p]];
        let moduli = self.moduli(parameters);
        let stretches = |p: usize| strain(p).map(|e| 8.0 * moduli(p)[1] * e);
        let action = |set: &Set, k: usize, strain: [f64; 3]| {
            set.own(k).powi(2) * along(self.families.offsets[k], strain)
        };
        self.add_actions(parameters, points, (&stretches, &action), force);
        let theta = |p: usize| {
            let Some(number) = self.families.set_of[p] else { return 0.0 };
            let set = &self.families.sets[number as usize];
            if set.own.is_empty() {
                return t[p] + t[n + p];
            }
            let seen = |(k, (&step, w)): (usize, (&Cell, &f64))| {
                w * set.own(k) * f64::from(step[0] * step[0] + step[1] * step[1]) * along(step, strain(p))
            };
            2.0 / set.q * self.families.offsets.iter().zip(&set.weights).enumerate().map(seen).sum::<f64>()
        };
        let theta: Vec<f64> = (0..n).map(theta).collect();
        let hoop = if parameters.is_axisymmetric() { &t[..n] } else { &[] };
        self.term.families().iter().for_each(|families| families.add_work_of([&theta, hoop], force));
    }

    /// Adds forces along the bonds of some points by what acts on these, none for all: of a value of the point, `w/q` times the
    /// second function.
    fn add_actions(
        &self,
        parameters: &StateParameters,
        points: Option<&[usize]>,
        (value, action): (&dyn Fn(usize) -> [f64; 3], &Action),
        force: &mut [f64],
    ) {
        let n = self.lattice.points();
        let volume = cell_volume(parameters, self.lattice.spacing());
        let mut add = |point: usize| {
            let Some(number) = self.families.set_of[point] else { return };
            let value = value(point);
            let energy = volume * self.families.energy[point];
            if value == [0.0; 3] || energy == 0.0 {
                return;
            }
            let set = &self.families.sets[number as usize];
            let cell = self.lattice.cell(point);
            let scale = energy / (set.q * self.lattice.spacing());
            for (k, (&step, &w)) in self.families.offsets.iter().zip(&set.weights).enumerate() {
                let Some(other) = self.lattice.number(plus(cell, step)).filter(|_| w != 0.0) else {
                    continue;
                };
                let [x, y, _] = step.map(f64::from);
                let action = scale * w * action(set, k, value);
                for (plane, part) in [(0, x), (n, y)] {
                    force[plane + other] += action * part;
                    force[plane + point] -= action * part;
                }
            }
        };
        match points {
            Some(points) => points.iter().for_each(|&p| add(p)),
            None => (0..n).for_each(add),
        }
    }
}

/// The component of a tensor `[xx, yy, xy]` along a step.
fn along([a, b, _]: Cell, [xx, yy, xy]: [f64; 3]) -> f64 {
    let [x, y] = [a, b].map(f64::from);
    (xx * x * x + yy * y * y + 2.0 * xy * x * y) / (x * x + y * y)
}
