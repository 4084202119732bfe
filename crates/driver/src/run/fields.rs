//! Results of one state.

use super::SolvedState;
use super::certificate::Certificate;
use crate::case::FieldName;
use crate::scene::Scene;
use peristat_assembly::model::timoshenko_beam::{BeamFields, Grid};
use serde::Serialize;
use std::borrow::Cow;

/// What a support does to the beam.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Reaction {
    /// Position.
    pub x: f64,
    /// Force along w.
    pub force: f64,
    /// Moment along φ.
    pub moment: f64,
}

/// Fields of one line.
#[derive(Clone, Debug)]
pub struct LineFields {
    /// Positions of the real points.
    pub x: Vec<f64>,
    /// Number of the first of them.
    pub first: usize,
    /// Section forces and energy density, where they were asked for.
    pub recovered: Option<BeamFields>,
}

/// The result of one state.
#[derive(Clone, Debug)]
pub struct StateResult {
    /// Index among the states of the scene.
    pub index: usize,
    /// Name.
    pub name: String,
    /// Load factor.
    pub load_factor: f64,
    /// Unknowns, two planes over all points, ghosts included.
    pub u: Vec<f64>,
    /// Fields per line.
    pub lines: Vec<LineFields>,
    /// Reactions of the supports on points, in the order of the case.
    pub reactions: Vec<Reaction>,
    /// Numbers of the points of the reactions.
    held: Vec<usize>,
    /// Certificate.
    pub certificate: Certificate,
    /// Height over second moment of area / 2: stress per moment at the extreme fibre on the side of −w.
    stress_per_moment: Option<f64>,
}

/// Collects the result of a state.
pub(super) fn result(scene: &Scene, solved: SolvedState, recover: bool) -> StateResult {
    let SolvedState { state: index, load, solution, certificate } = solved;
    let state = &scene.states[index];
    let (beam, n) = (&scene.beam, scene.beam.points());
    let u = solution.u;
    let all = recover.then(|| forces_on_points(scene, load, &solution.held, &solution.multipliers, &u));
    let line = |c: usize| {
        let chain = &beam.chains()[c];
        LineFields {
            x: (0..chain.points).map(|k| chain.position(chain.ghosts[0] + k)).collect(),
            first: beam.first_real(c),
            recovered: all.as_ref().map(|all| beam.fields(c, &u, all, &state.loads)),
        }
    };
    let lines = (0..beam.chains().len()).map(line).collect();
    // The equations of supports come first, in this order.
    let mut multipliers = solution.multipliers.iter();
    let points = scene.held.iter().filter_map(|h| h.point.map(|point| (h, point)));
    let (held, reactions) = points
        .map(|(h, point)| {
            let mut of = |component: usize| match (h.prescribed[component], h.springs[component]) {
                (Some(_), _) => multipliers.next().copied().unwrap_or(0.0),
                (None, Some(stiffness)) => -stiffness * u[component * n + point],
                (None, None) => 0.0,
            };
            (point, Reaction { x: h.x, force: of(0), moment: of(1) })
        })
        .unzip();
    StateResult {
        index,
        name: state.name.clone(),
        load_factor: state.load_factor,
        u,
        lines,
        reactions,
        held,
        certificate,
        stress_per_moment: scene.section.height.map(|h| 0.5 * h / scene.section.second_moment),
    }
}

/// Loads and the forces of supports, links and springs, by unknown.
fn forces_on_points(
    scene: &Scene,
    load: &[f64],
    held: &[(usize, f64)],
    multipliers: &[f64],
    u: &[f64],
) -> Vec<f64> {
    let n = scene.beam.points();
    let mut forces = load.to_vec();
    if scene.beam.chains().iter().any(|c| c.line().grid == Grid::Cells) {
        // Ghost points alone hold the ends of a grid of cells: their forces stand for the support.
        held.iter().for_each(|&(k, force)| forces[k] += force);
    } else {
        for (equation, multiplier) in scene.equations.iter().zip(multipliers) {
            for (unknown, coefficient) in &equation.terms {
                forces[unknown.component * n + unknown.point] += coefficient * multiplier;
            }
        }
    }
    for spring in &scene.springs {
        let k = spring.component * n + spring.point;
        forces[k] -= spring.stiffness * u[k];
    }
    forces
}

impl StateResult {
    /// Value of a field at a real point of a line; `None` where it was not recovered or does not exist.
    pub fn value(&self, field: FieldName, line: usize, point: usize) -> Option<f64> {
        let fields = &self.lines[line];
        let (n, number) = (self.u.len() / 2, fields.first + point);
        let forces = || fields.recovered.as_ref().map(|r| r.forces.at(point));
        let stress = |sign: f64| Some(sign * self.stress_per_moment? * forces()?.0);
        let reaction =
            || self.held.iter().zip(&self.reactions).filter(move |held| *held.0 == number).map(|held| held.1);
        match field {
            FieldName::W => Some(self.u[number]),
            FieldName::Phi => Some(self.u[n + number]),
            FieldName::M => forces().map(|f| f.0),
            FieldName::V => forces().map(|f| f.1),
            // A positive moment bends the ends towards +w and shortens the fibres on that side.
            FieldName::StressTop => stress(-1.0),
            FieldName::StressBottom => stress(1.0),
            FieldName::EnergyDensity => fields.recovered.as_ref().map(|r| r.energy_density[point]),
            FieldName::ReactionForce => Some(reaction().map(|r| r.force).sum()),
            FieldName::ReactionMoment => Some(reaction().map(|r| r.moment).sum()),
        }
    }

    /// The values of an unknown along a line, as they lie in `u`.
    fn unknown(&self, field: FieldName, line: usize) -> Option<&[f64]> {
        let fields = &self.lines[line];
        let plane = match field {
            FieldName::W => 0,
            FieldName::Phi => self.u.len() / 2,
            _ => return None,
        };
        Some(&self.u[plane + fields.first..][..fields.x.len()])
    }

    /// All values of a field along a line.
    pub fn values(&self, field: FieldName, line: usize) -> Option<Cow<'_, [f64]>> {
        match self.unknown(field, line) {
            Some(values) => Some(values.into()),
            None => (0..self.lines[line].x.len()).map(|point| self.value(field, line, point)).collect(),
        }
    }

    /// Section force, or stress from it, at both ends of every cell of a line, seen from inside.
    fn cells(&self, field: FieldName, line: usize) -> Option<Vec<[f64; 2]>> {
        let forces = &self.lines[line].recovered.as_ref()?.forces;
        let stress = |sign: f64| {
            let factor = sign * self.stress_per_moment?;
            Some(forces.moment.iter().map(|m| m.map(|m| factor * m)).collect())
        };
        match field {
            FieldName::M => Some(forces.moment.clone()),
            FieldName::V => Some(forces.shear.clone()),
            FieldName::StressTop => stress(-1.0),
            FieldName::StressBottom => stress(1.0),
            _ => None,
        }
    }

    /// Values of a field to the left of the points of a line, where it may jump.
    pub fn left_values(&self, field: FieldName, line: usize) -> Option<Vec<f64>> {
        let cells = self.cells(field, line)?;
        let first = cells.first().map(|c| c[0]);
        Some(first.into_iter().chain(cells.iter().map(|c| c[1])).collect())
    }

    /// Smallest and largest value of a field and their positions; both sides of a point where the field may jump.
    pub fn extremes(&self, field: FieldName) -> Option<[(f64, f64); 2]> {
        let mut extremes: Option<[(f64, f64); 2]> = None;
        for (line, fields) in self.lines.iter().enumerate() {
            let mut take = |values: &[f64]| {
                for (&value, &x) in values.iter().zip(&fields.x) {
                    let [low, high] = extremes.get_or_insert([(value, x); 2]);
                    if value < low.0 {
                        *low = (value, x);
                    }
                    if value > high.0 {
                        *high = (value, x);
                    }
                }
            };
            take(&self.values(field, line)?);
            if let Some(left) = self.left_values(field, line) {
                take(&left);
            }
        }
        extremes
    }
}
