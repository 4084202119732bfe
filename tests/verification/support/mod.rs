//! What the tests share: building a case, running it, measuring an error.

pub(crate) mod bending;
pub(crate) mod breaking;
pub(crate) mod chain;
pub(crate) mod goodier;
pub(crate) mod handbook;
pub(crate) mod mixed;
pub(crate) mod noise;
pub(crate) mod notched_block;
pub(crate) mod orthotropic;
pub(crate) mod plane;
pub(crate) mod plane_frame;
pub(crate) mod sections;
pub(crate) mod standard;

use peristat::case::from_text;
use peristat::input::Folder;
use peristat::run::beam::{self, BeamResult, LineFields};
use peristat::run::{RunOptions, RunReport};
use peristat::scene::{BeamScene, Scene};
use serde_json::Value;
use std::path::Path;

/// A scene with its results.
pub(crate) struct Run {
    pub(crate) scene: BeamScene,
    pub(crate) states: Vec<BeamResult>,
    pub(crate) report: RunReport,
}

/// Resolves a case, or returns the report of its faults as text.
pub(crate) fn try_scene(case: &Value) -> Result<BeamScene, String> {
    let text = format!("{case:#}");
    let source = from_text("case", text, &[], &Folder::default()).map_err(|e| e.to_string())?;
    let scene =
        Scene::new(source.case, Path::new("."), "case", &source.text, None).map_err(|e| e.to_string())?;
    Ok(scene.into_beam().expect("a beam"))
}

/// Resolves a case that has no faults.
pub(crate) fn scene(case: &Value) -> BeamScene {
    try_scene(case).unwrap_or_else(|faults| panic!("{faults}"))
}

fn run_with(case: &Value, recover: bool) -> Run {
    let scene = scene(case);
    let mut states = Vec::new();
    let options = RunOptions { recover, max_memory: None, compare: true };
    let report = beam::run(&scene, &options, &mut |state| {
        states.push(state);
        Ok(())
    });
    let report = report.unwrap_or_else(|error| panic!("{error}: {case}"));
    assert!(report.converged, "not converged: {case}");
    Run { scene, states, report }
}

/// Unknowns and reactions of a case.
pub(crate) fn run(case: &Value) -> Run {
    run_with(case, false)
}

/// The same with section forces.
pub(crate) fn run_recovered(case: &Value) -> Run {
    run_with(case, true)
}

/// Faults of a case that must have some.
pub(crate) fn refusal(case: &Value) -> String {
    match try_scene(case) {
        Ok(_) => panic!("the case should be refused: {case}"),
        Err(faults) => faults,
    }
}

impl Run {
    /// Deflections and rotations of the real points of all lines.
    pub(crate) fn unknowns(&self, state: usize) -> [Vec<f64>; 2] {
        let state = &self.states[state];
        let of_line = |line: &LineFields, plane: usize| &state.record.u[plane + line.first..][..line.x.len()];
        [0, state.record.u.len() / 2]
            .map(|plane| state.lines.iter().flat_map(|line| of_line(line, plane)).copied().collect())
    }

    /// Deflection at a real point of the only line.
    pub(crate) fn w(&self, point: usize) -> f64 {
        self.unknowns(0)[0][point]
    }

    /// Positions of the real points.
    pub(crate) fn x(&self) -> Vec<f64> {
        let lines = self.states[0].lines.iter();
        lines.flat_map(|l| l.x.iter().copied()).collect()
    }

    /// Applied nodal forces of the first state, two planes.
    pub(crate) fn load(&self) -> Vec<f64> {
        let mut load = vec![0.0; self.states[0].record.u.len()];
        self.scene.states[0].loads.add_to(&self.scene.beam, &mut load);
        load
    }

    /// Largest difference of w and of φ from `exact(x)`, each relative to its largest value.
    pub(crate) fn errors(&self, exact: impl Fn(f64) -> (f64, f64)) -> [f64; 2] {
        let expected: Vec<(f64, f64)> = self.x().into_iter().map(exact).collect();
        let [w, phi] = self.unknowns(0);
        [
            error(&w, &expected.iter().map(|e| e.0).collect::<Vec<_>>()),
            error(&phi, &expected.iter().map(|e| e.1).collect::<Vec<_>>()),
        ]
    }
}

/// Largest magnitude; infinite where there is something that is not a number.
pub(crate) fn largest(values: &[f64]) -> f64 {
    let magnitude = |v: &f64| if v.is_nan() { f64::INFINITY } else { v.abs() };
    values.iter().map(magnitude).fold(0.0, f64::max)
}

/// Largest difference relative to the largest expected magnitude.
pub(crate) fn error(found: &[f64], expected: &[f64]) -> f64 {
    assert_eq!(found.len(), expected.len(), "one value per place");
    let difference: Vec<f64> = found.iter().zip(expected).map(|(f, e)| f - e).collect();
    largest(&difference) / largest(expected)
}

/// Relative difference of two numbers.
pub(crate) fn relative(found: f64, expected: f64) -> f64 {
    error(&[found], &[expected])
}
