//! Bodies in the plane that break.

use super::fields::{BodyResult, parted};
use super::verdict;
use crate::case::CrackDirection;
use crate::run::body::BodyProblem;
use crate::run::fracture::{BreakingBody, Facts, FreeLoad};
use crate::run::{Problem, SolvedState, StateRecord, StateResult};
use crate::scene::Resultant;
use crate::scene::body::{BodyFracture, Quantity};
use crate::scene::fracture::FractureScene;
use crate::units::number;
use peristat_assembly::model::plane::{BreakingModel, CriticalStretch};

/// A body in the plane whose bonds break.
pub(super) struct BreakingPlane<'a, const D: usize> {
    pub(super) problem: BodyProblem<'a, dyn BreakingModel<D>>,
    pub(super) fracture: &'a BodyFracture,
    pub(super) recover: bool,
    /// Whether points have come off; empty as long as none has.
    pub(super) off: Vec<bool>,
}

impl<const D: usize> BreakingPlane<'_, D> {
    /// The middles of the broken bonds in the part of a direction.
    fn broken_in(&self, part: &CrackDirection, broken: &[u64]) -> Vec<[f64; 2]> {
        let model = &self.problem.model;
        let middle = |&bond: &u64| {
            let [a, b] = model.ends(bond).map(|p| model.place(p));
            [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])]
        };
        let inside = |at: &[f64; 2]| (0..2).all(|k| part.from[k] < at[k] && at[k] < part.to[k]);
        broken.iter().map(middle).filter(inside).collect()
    }
}

impl<const D: usize> BreakingBody<D> for BreakingPlane<'_, D> {
    type Model = dyn BreakingModel<D>;

    fn model(&self) -> &Self::Model {
        &*self.problem.model
    }

    fn problem(&self) -> &dyn Problem<D> {
        &self.problem
    }

    fn fracture(&self) -> &FractureScene<CriticalStretch> {
        &self.fracture.steps
    }

    fn model_mut(&mut self) -> &mut Self::Model {
        &mut *self.problem.model
    }

    fn free_load(&self) -> Option<FreeLoad> {
        let plane = self.problem.model.as_plane()?;
        let mut t = self.fracture.steps.critical.free()?.to_vec();
        let points = self.problem.model.points();
        let off = self.off.iter().enumerate().filter(|(_, off)| **off);
        off.for_each(|(point, _)| (0..3).for_each(|q| t[q * points + point] = 0.0));
        let energy = plane.energy_at_rest(&t)?;
        let mut load = vec![0.0; D * points];
        plane.add_strain_work(&mut t, None, &mut load);
        Some(FreeLoad { load, energy })
    }

    fn come_off(&mut self, off: &[bool]) {
        self.off = off.to_vec();
    }

    fn load(&self, u: &[f64], multipliers: &[f64]) -> f64 {
        let scene = self.problem.scene;
        let quantity = &scene.probes[self.fracture.steps.load].quantity;
        verdict::mechanical(scene, quantity, u, multipliers).unwrap_or(0.0)
    }

    fn load_is_force(&self) -> bool {
        let probe = &self.problem.scene.probes[self.fracture.steps.load];
        matches!(probe.quantity, Quantity::Reaction { .. })
    }

    fn facts(&self, broken: &[u64]) -> Vec<(String, f64)> {
        let (model, mut facts) = (&self.problem.model, Vec::new());
        if !self.fracture.fibres.is_empty() {
            let fibres = broken.iter().filter(|&&bond| self.fracture.fibres[model.offset(bond)]).count();
            facts.push(("broken_fibre_bonds".into(), fibres as f64));
        }
        for part in &self.fracture.directions {
            let middles = self.broken_in(part, broken);
            let known = [direction(&middles).map(|(angle, _)| angle), Some(middles.len() as f64)];
            facts
                .extend(part.facts().into_iter().zip(known).filter_map(|(name, value)| Some((name, value?))));
        }
        facts
    }

    fn doubts(&self, broken: &[u64]) -> Vec<String> {
        let horizon = self.problem.scene.horizon();
        let doubt = |part: &CrackDirection| {
            let (_, across) = direction(&self.broken_in(part, broken))?;
            // Middles of the bonds that cross a line are within half a horizon of it.
            (across > 0.5 * horizon).then(|| {
                let (name, across) = (&part.name, number(across));
                format!("the broken bonds of the direction `{name}` are on no one line: they spread {across} to its sides")
            })
        };
        self.fracture.directions.iter().filter_map(doubt).collect()
    }

    fn result(
        &mut self,
        solved: SolvedState,
        name: String,
        load_factor: f64,
        facts: Facts,
        broken: &[u64],
    ) -> StateResult {
        let SolvedState { state: index, solution, certificate, load, .. } = solved;
        let record = StateRecord { index, name, load_factor, u: solution.u, certificate, facts: Some(facts) };
        let (scene, model) = (self.problem.scene, &*self.problem.model);
        let mut asked = Resultant::default();
        asked.add_multiple(load_factor, &scene.asked(&scene.states[0]));
        let eigenstrain = scene.eigenstrain(&scene.states[0]);
        let eigenstrain = eigenstrain.map(|own| own.times(load_factor).without(&self.off));
        let mut result = BodyResult::new(
            (scene, model, eigenstrain),
            record,
            (solution.multipliers, load, asked),
            Vec::new(),
            self.recover,
        );
        result.parted = parted(model, broken.iter().map(|&bond| model.ends(bond)));
        StateResult::Body(result)
    }
}

/// Direction in which points spread most, degrees from x, −45 to 135: not 0 nor 90 is at an end; and the root of their mean
/// squared distance from the line through them. Fewer than two have none.
fn direction(points: &[[f64; 2]]) -> Option<(f64, f64)> {
    if points.len() < 2 {
        return None;
    }
    let n = points.len() as f64;
    let mean = [0, 1].map(|k| points.iter().map(|p| p[k]).sum::<f64>() / n);
    let moment =
        |a: usize, b: usize| points.iter().map(|p| (p[a] - mean[a]) * (p[b] - mean[b])).sum::<f64>() / n;
    let (xx, xy, yy) = (moment(0, 0), moment(0, 1), moment(1, 1));
    let angle = 0.5 * (2.0 * xy).atan2(xx - yy);
    let (s, c) = angle.sin_cos();
    let across = (s * s * xx - 2.0 * s * c * xy + c * c * yy).max(0.0).sqrt();
    Some(((angle.to_degrees() + 45.0).rem_euclid(180.0) - 45.0, across))
}

#[cfg(test)]
mod tests {
    use super::direction;

    #[test]
    fn directions_are_those_of_lines() {
        for degrees in [-44.0, 0.0, 30.0, 90.0, 134.0_f64] {
            let (s, c) = degrees.to_radians().sin_cos();
            let points: Vec<[f64; 2]> = (0..9).map(f64::from).map(|t| [1.0 + t * c, t * s - 3.0]).collect();
            let (found, across) = direction(&points).unwrap();
            assert!((found - degrees).abs() < 1e-9 && across < 1e-7, "{found} {across}");
        }
        assert!(direction(&[[0.0, 1e-16], [1.0, 0.0]]).unwrap().0.abs() < 1e-12);
        // Two rows, one above and one below.
        let (_, across) = direction(&[[0.0, 1.0], [9.0, 1.0], [0.0, -1.0], [9.0, -1.0]]).unwrap();
        assert!((across - 1.0).abs() < 1e-15);
    }

    #[test]
    fn fewer_than_two_places_have_no_direction() {
        assert_eq!([direction(&[]), direction(&[[1.0, 2.0]])], [None; 2]);
    }
}
