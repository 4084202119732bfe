//! How much softer a body that breaks or softens is than the same elastic one, because its edges are not completed.

use crate::diagnostic::JsonPath;
use crate::model::with_body;
use crate::run::body::BodyProblem;
use crate::run::{RunOptions, RunReport, prepare, solve_states};
use crate::scene::body::BodyScene;
use peristat_assembly::model::plane::{Calibration, Edges};
use peristat_assembly::sum::Sum;

/// Energy over the sum of the loads times the largest displacement, below which it is rounding.
const STRAINED: f64 = 1e-12;

/// What is softer by no more than this is not reported.
const TOLD: f64 = 0.01;

/// Solves the body without its fracture or path, and the elastic one beside it, under the same loads and motions, and warns of
/// what the one is softer than the other. Where a solve fails, nothing is known.
pub(super) fn tell(scene: &BodyScene, options: &RunOptions, report: &mut RunReport) {
    let Some(elastic) = scene.elastic() else { return };
    if scene.eigenstrain(&scene.states[0]).is_some() {
        // What heat does is not stiffness.
        return;
    }
    let [own, usual] = [scene, &elastic].map(|scene| Stored::of(scene, options, report));
    let Some(softness) = own.zip(usual).map(|(own, usual)| own.softness(&usual)) else { return };
    if softness.is_nan() || softness <= TOLD {
        return;
    }
    let key = if scene.path.is_some() { "path" } else { "fracture" };
    let about = scene.material().about();
    let lacks = match about.calibration {
        Calibration::Published if about.edges == Some(Edges::None) => {
            "its edges are not completed, and its bonds have the published constants"
        }
        Calibration::Published => "its bonds have the published constants",
        Calibration::Matched => "its edges are not completed",
    };
    let message =
        format!("the body is {:.1} % softer than the same body without `{key}`: {lacks}", 100.0 * softness);
    report.warnings.warning(JsonPath::default().key(key), message).hint(hint(scene));
}

/// What makes the body stiffer.
fn hint(scene: &BodyScene) -> &'static str {
    if scene.path.is_some() {
        "hold and move points of a `box` as deep as the horizon, not an edge, and list it under `no_damage`"
    } else {
        "leave `edges` out of the model"
    }
}

/// What a body holds under the loads and motions of its first state.
struct Stored {
    energy: f64,
    /// The energy less what the loads do on their displacements.
    potential: f64,
}

impl Stored {
    /// That of the linear body of a scene, if it can be solved; what that costs goes to the report.
    fn of(scene: &BodyScene, options: &RunOptions, report: &mut RunReport) -> Option<Self> {
        let mut found = None;
        let solved = with_body!(&scene.model, body => {
            let problem = BodyProblem::new(scene, body.clone());
            let (system, sizes) = prepare(&problem, options).ok()?;
            solve_states(&problem, (&system, sizes), &mut |solved| {
                let mut work = Sum::default();
                solved.load.iter().zip(&solved.solution.u).for_each(|(f, u)| work.add(f * u));
                let energy = solved.certificate.energy;
                // Loads on what is held strain nothing: what is left is rounding.
                let size: f64 = solved.load.iter().map(|f| f.abs()).sum();
                let moved = solved.solution.u.iter().fold(0.0, |a: f64, u| a.max(u.abs()));
                if energy > STRAINED * size * moved || size == 0.0 {
                    found.get_or_insert(Self { energy, potential: energy - work.total() });
                }
                Ok(())
            })
        });
        let solved = solved.ok()?;
        super::add(&mut report.counters, &solved.counters);
        report.timing.solve += solved.timing.factor + solved.timing.solve;
        found.filter(|_| solved.converged)
    }

    /// By how much it gives way more than another one: of its force where motions are prescribed, of its stiffness where loads
    /// act; both lower the potential.
    fn softness(&self, other: &Self) -> f64 {
        (other.potential - self.potential) / self.energy.max(other.energy)
    }
}
