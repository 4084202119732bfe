//! Bodies in the plane: running a case, fields at all points, values of probes.

use peristat::case::{FieldName, from_text};
use peristat::input::Folder;
use peristat::run::body::{self, BodyResult};
use peristat::run::{RunOptions, RunReport};
use peristat::scene::{BodyScene, Scene};
use serde_json::{Value, json};
use std::path::Path;

/// A scene in the plane with its results.
pub(crate) struct PlaneRun {
    pub(crate) scene: BodyScene,
    pub(crate) states: Vec<BodyResult>,
    pub(crate) report: RunReport,
}

/// Solves a case in the plane with all fields.
pub(crate) fn solve(case: &Value) -> PlaneRun {
    solve_with(case, true)
}

/// Solves a case in the plane for its displacements.
pub(crate) fn displacements(case: &Value) -> PlaneRun {
    solve_with(case, false)
}

fn solve_with(case: &Value, recover: bool) -> PlaneRun {
    let scene = scene(case).unwrap_or_else(|faults| panic!("{faults}"));
    let mut states = Vec::new();
    let report = body::run(&scene, &RunOptions { recover, max_memory: None, compare: false }, &mut |state| {
        states.push(state);
        Ok(())
    });
    let report = report.unwrap_or_else(|error| panic!("{error}: {case}"));
    assert!(report.converged, "not converged: {case}");
    PlaneRun { scene, states, report }
}

/// Resolves a case in the plane, or returns the report of its faults as text.
pub(crate) fn scene(case: &Value) -> Result<BodyScene, String> {
    let source =
        from_text("case", format!("{case:#}"), &[], &Folder::default()).map_err(|e| e.to_string())?;
    let scene = Scene::new(source.case, Path::new("."), "case", &source.text, None);
    Ok(scene.map_err(|e| e.to_string())?.into_body().expect("a body in the plane"))
}

/// What is said about a case that cannot be solved.
pub(crate) fn refusal(case: &Value) -> String {
    let error = peristat::solve_text(&format!("{case:#}")).expect_err("the case should be refused");
    error.to_string()
}

/// Value of a probe of a case with one state.
pub(crate) fn probe(case: &Value, name: &str) -> f64 {
    let summary =
        peristat::solve_text(&format!("{case:#}")).unwrap_or_else(|e| panic!("{e}: {case}")).summary;
    summary.probes.iter().find(|p| p.name == name).expect("a probe of this name").value
}

impl PlaneRun {
    /// Positions of the points.
    pub(crate) fn positions(&self) -> Vec<[f64; 2]> {
        (0..self.scene.body().points()).map(|p| self.scene.body().place(p)).collect()
    }

    /// A field at all points.
    pub(crate) fn field(&self, state: usize, field: FieldName) -> Vec<f64> {
        self.states[state].values(&self.scene, field).expect("the field is recovered").into_owned()
    }

    /// Iterations of the first state.
    pub(crate) fn iterations(&self) -> usize {
        self.report.solver.iterations[0]
    }

    /// Largest distance between the displacement and another one, relative to the largest of that.
    pub(crate) fn error(&self, state: usize, exact: impl Fn([f64; 2]) -> [f64; 2]) -> f64 {
        let u = [FieldName::Ux, FieldName::Uy].map(|f| self.field(state, f));
        let (mut difference, mut size) = (0.0_f64, 0.0_f64);
        for (p, at) in self.positions().into_iter().enumerate() {
            let expected = exact(at);
            let d = (u[0][p] - expected[0]).hypot(u[1][p] - expected[1]);
            difference = difference.max(if d.is_nan() { f64::INFINITY } else { d });
            size = size.max(expected[0].hypot(expected[1]));
        }
        difference / size
    }
}

/// A plate of n × n points on a side of 1 that is clamped on the left and pulled down on the right.
pub(crate) fn clamped_square(n: usize) -> Value {
    json!({
        "title": "clamped square",
        "model": { "bond_plane": { "youngs_modulus": 1e9, "state": "plane_stress" } },
        "body": { "rectangle": { "size": [n, n], "spacing": 1 } },
        "supports": [{ "at": { "region": "left" }, "ux": 0, "uy": 0 }],
        "loads": [{ "traction": { "edge": "right", "uniform": [0, -1e3] } }],
        "solver": "multigrid"
    })
}
