//! A beam of whose one-way parts some act, under one state, as a linear problem.

use crate::case::Solver;
use crate::run::prepare::assembled;
use crate::run::{Problem, RunError, constrained};
use crate::scene::beam::{BeamScene, OneWay, Part};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::Model;
use peristat_assembly::model::timoshenko_beam::{PHI, TimoshenkoBeam};
use peristat_assembly::stiffness::Spring;
use peristat_assembly::system::{FreeMotion, System};
use peristat_solve::SmoothVectors;

/// Stiffness of springs that keep a mechanism in place, over EI/L³ of the softest line: it then moves far until something stops it.
const SOFT: f64 = 1e-4;

/// A beam of whose one-way parts some act.
pub(super) struct Acting<'a> {
    scene: &'a BeamScene,
    state: usize,
    /// Whether each of them acts.
    pub(super) acts: Vec<bool>,
    equations: Vec<Equation>,
    /// Numbers in the scene of the equations.
    numbers: Vec<usize>,
    springs: Vec<Spring>,
}

impl<'a> Acting<'a> {
    /// The beam, under a state.
    pub(super) fn new(scene: &'a BeamScene, state: usize, acts: Vec<bool>) -> Self {
        let mut problem =
            Self { scene, state, acts, equations: Vec::new(), numbers: Vec::new(), springs: Vec::new() };
        problem.fill();
        problem
    }

    /// Takes the equations and springs of what acts; equations that act one way are the last ones.
    fn fill(&mut self) {
        let factor = self.scene.states[self.state].motion_factor;
        let mut is_two_way = vec![true; self.scene.equations.len()];
        for part in &self.scene.one_way {
            if let Part::Equation(k) = part.part {
                is_two_way[k] = false;
            }
        }
        (self.equations, self.numbers) = (Vec::new(), Vec::new());
        for (k, equation) in self.scene.equations.iter().enumerate().filter(|(k, _)| is_two_way[*k]) {
            self.equations.push(Equation { value: factor * equation.value, ..equation.clone() });
            self.numbers.push(k);
        }
        for part in self.acting() {
            if let Part::Equation(k) = part.part {
                let value = self.target(part, k);
                self.equations.push(Equation { value, ..self.scene.equations[k].clone() });
                self.numbers.push(k);
            }
        }
        self.springs = self.springs_of_scene();
        self.springs.retain(|spring| spring.stiffness > 0.0);
    }

    fn acting(&self) -> impl Iterator<Item = &'a OneWay> + use<'a> {
        let acts = self.acts.clone();
        self.scene.one_way.iter().zip(acts).filter(|(_, acts)| *acts).map(|(part, _)| part)
    }

    /// The motion at which an equation that acts one way begins to act.
    pub(super) fn target(&self, part: &OneWay, equation: usize) -> f64 {
        self.scene.states[self.state].motion_factor * self.scene.equations[equation].value
            - part.sign * part.gap
    }

    /// The springs of the scene in their order, those that do not act without stiffness.
    pub(super) fn springs_of_scene(&self) -> Vec<Spring> {
        let mut springs = self.scene.springs.clone();
        for (part, _) in self.scene.one_way.iter().zip(&self.acts).filter(|(_, acts)| !**acts) {
            if let Part::Spring(k) = part.part {
                springs[k].stiffness = 0.0;
            }
        }
        springs
    }

    /// Its system. What contradicts the rest, such as the second of two stops of one motion, does not act.
    ///
    /// # Errors
    /// A contradiction of what acts both ways.
    pub(super) fn system<const D: usize>(&mut self) -> Result<System<D>, RunError>
    where
        TimoshenkoBeam: Model<D>,
    {
        loop {
            let contradiction = match assembled(self) {
                Ok(system) => return Ok(system),
                Err(contradiction) => contradiction,
            };
            let is_it = |part: &OneWay| match part.part {
                Part::Equation(k) => self.scene.equations[k].origin == contradiction.origin,
                Part::Spring(_) => false,
            };
            let found = (0..self.acts.len()).rev().find(|&k| self.acts[k] && is_it(&self.scene.one_way[k]));
            // Others contradict each other whatever acts: they get their message.
            let Some(k) = found else { return constrained(self, None) };
            self.acts[k] = false;
            self.fill();
        }
    }

    /// Adds soft springs to every point that something one-way does not hold, so that it is no mechanism.
    pub(super) fn soften(&mut self) {
        let lines = self.scene.beam.chains().iter().map(|chain| chain.line());
        let [stiffness, length] = lines.fold([f64::INFINITY, 0.0_f64], |[stiffness, length], line| {
            [stiffness.min(line.stiffness.bending.value(0.0) / line.length.powi(3)), length.max(line.length)]
        });
        let soft = |component: usize| SOFT * stiffness * if component == PHI { length * length } else { 1.0 };
        for (part, _) in self.scene.one_way.iter().zip(&self.acts).filter(|(_, acts)| !**acts) {
            match part.part {
                Part::Equation(k) => {
                    let unknowns = self.scene.equations[k].terms.iter().map(|(unknown, _)| unknown);
                    self.springs
                        .extend(unknowns.map(|u| Spring::on(u.component, u.point, soft(u.component))));
                }
                Part::Spring(k) => {
                    let Spring { point, shares, .. } = self.scene.springs[k];
                    let component = shares[0].0;
                    self.springs.push(Spring { point, shares, stiffness: soft(component) });
                }
            }
        }
    }

    /// Forces of all equations of the scene, from those of what acts.
    pub(super) fn of_all(&self, multipliers: &[f64]) -> Vec<f64> {
        let mut all = vec![0.0; self.scene.equations.len()];
        self.numbers.iter().zip(multipliers).for_each(|(&k, multiplier)| all[k] = *multiplier);
        all
    }
}

impl<const D: usize> Problem<D> for Acting<'_>
where
    TimoshenkoBeam: Model<D>,
{
    fn model(&self) -> &dyn Model<D> {
        &self.scene.beam
    }

    fn springs(&self) -> &[Spring] {
        &self.springs
    }

    fn equations(&self) -> &[Equation] {
        &self.equations
    }

    fn solver(&self) -> Solver {
        self.scene.solver
    }

    fn states(&self) -> usize {
        self.scene.states.len()
    }

    fn add_load(&self, state: usize, force: &mut [f64]) -> f64 {
        self.scene.states[state].loads.add_to(&self.scene.beam, force);
        // Its equations have their values.
        1.0
    }

    fn soft_motions(&self, system: &System<D>) -> Option<Box<dyn SmoothVectors>> {
        self.scene.soft_motions(system)
    }

    fn describe(&self, motion: &FreeMotion) -> String {
        self.scene.describe_motion(motion)
    }

    fn remedy(&self) -> &'static str {
        self.scene.remedy()
    }
}
