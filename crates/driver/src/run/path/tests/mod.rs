//! Small bodies on their paths: closed forms, energies, and what all controls have in common.

mod chains;
mod plates;
mod restarts;
mod steps;

use super::body::Body;
use super::control::{Control, Goal, Step};
use super::course::Course;
use super::displacement::Displacement;
use super::tangent::Tangent;
use super::{PathPoint, PathReport};
use crate::case::from_text;
use crate::input::Folder;
use crate::model::AnyBody;
use crate::run::body::BodyProblem;
use crate::run::{self, Advance, Problem, RunOptions, RunReport, Sink, StateResult, prepare};
use crate::scene::Scene;
use crate::scene::body::BodyScene;
use peristat_assembly::law::{Bilinear, History};
use peristat_assembly::stiffness::HistoryBonds;
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::io;
use std::path::Path;

/// What a run has reported.
#[derive(Default)]
struct Recorder {
    points: Vec<PathPoint>,
    states: Vec<StateResult>,
}

impl Sink for Recorder {
    fn take(&mut self, result: StateResult) -> io::Result<()> {
        self.states.push(result);
        Ok(())
    }

    fn advance(&mut self, advance: Advance<'_>, _: Option<&dyn Fn() -> run::Restart>) -> io::Result<()> {
        let Advance::Path(point) = advance else { panic!("a path") };
        self.points.push(point.clone());
        Ok(())
    }
}

struct Ran {
    points: Vec<PathPoint>,
    states: Vec<StateResult>,
    report: RunReport,
}

impl Ran {
    fn path(&self) -> &PathReport {
        self.report.path.as_ref().expect("a path")
    }

    fn last(&self) -> &PathPoint {
        self.points.last().expect("the body at rest")
    }

    fn peak(&self) -> &PathPoint {
        self.points.iter().max_by(|a, b| a.load.abs().total_cmp(&b.load.abs())).expect("the body at rest")
    }

    fn largest(&self, of: fn(&PathPoint) -> f64) -> f64 {
        self.points.iter().map(|p| of(p).abs()).fold(0.0, f64::max)
    }

    /// The load at a load factor on the way there, between the states next to it.
    fn load_at(&self, load_factor: f64) -> f64 {
        let pair = self
            .points
            .windows(2)
            .find(|p| (p[0].load_factor - load_factor) * (p[1].load_factor - load_factor) <= 0.0);
        let pair = pair.expect("the path comes there");
        let part = (load_factor - pair[0].load_factor) / (pair[1].load_factor - pair[0].load_factor);
        pair[0].load + part * (pair[1].load - pair[0].load)
    }
}

fn scene(case: &Value) -> Scene {
    let source = from_text("case", case.to_string(), &[], &Folder::default())
        .unwrap_or_else(|report| panic!("{report}"));
    Scene::new(source.case, Path::new("."), "case", &source.text, None)
        .unwrap_or_else(|report| panic!("{report}"))
}

fn solve(case: &Value) -> Ran {
    let mut told = Recorder::default();
    let report = run::run(&scene(case), &RunOptions::default(), None, &mut told);
    let report = report.unwrap_or_else(|error| panic!("{error}"));
    let ran = Ran { points: told.points, states: told.states, report };
    let is_number = |p: &PathPoint| {
        [p.load_factor, p.load, p.work, p.stored, p.dissipated, p.balance, p.identity, p.residual]
            .iter()
            .all(|v| v.is_finite())
    };
    assert!(ran.points.iter().all(is_number));
    ran
}

/// Changes a part of a case.
fn with(case: &Value, pointer: &str, value: Value) -> Value {
    let mut case = case.clone();
    let (parent, key) = pointer.rsplit_once('/').expect("a pointer");
    case.pointer_mut(parent).expect("a parent")[key] = value;
    case
}

fn controlled(case: &Value, control: &str, increment: f64) -> Value {
    with(&with(case, "/path/control", control.into()), "/path/increment", increment.into())
}

/// Stretches of the bonds of a chain, and its length in bonds.
const CHAIN: ([f64; 2], f64) = ([0.01, 0.03], 10.0);
/// Displacement of the end of a chain at a load factor of one, in yield stretches.
const PULLED: f64 = 12.0;

/// Chains of ten bonds side by side that do not feel each other: points move along them, and neighbours beside each other
/// move together. The bond in the middle of each can yield. With thickness 1, spacing 1 and δ = 1 its stiffness is
/// c = 48E/(5π); they are pulled by twelve times the yield stretch.
fn chains(rows: usize) -> Value {
    let [yielding, failing] = CHAIN.0;
    json!({
        "title": "chains", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 1000, "state": "plane_strain", "volume_factor": "full",
            "edges": "none", "bond_law": { "bilinear": { "yield_stretch": yielding, "failure_stretch": failing } } } },
        "body": { "rectangle": { "size": [11, rows], "spacing": 1 } },
        "horizon_ratio": 1,
        "regions": {
            "all": { "half_plane": { "point": [0, 0], "normal": [1, 0] } },
            "first": { "box": { "from": [0, 0], "to": [1, rows] } },
            "last": { "box": { "from": [10, 0], "to": [11, rows] } },
            "before": { "box": { "from": [0, 0], "to": [5, rows] } },
            "behind": { "box": { "from": [7, 0], "to": [11, rows] } } },
        "supports": [
            { "at": { "region": "all" }, "uy": 0 },
            { "at": { "region": "first" }, "ux": 0 },
            { "at": { "region": "last" }, "ux": PULLED * yielding } ],
        "probes": [ { "name": "load", "at": { "region": "last" }, "field": "reaction_x" } ],
        "path": { "load": "load", "no_damage": ["before", "behind"] }
    })
}

fn chain_stiffness() -> f64 {
    48.0 * 1000.0 / (5.0 * PI)
}

/// A plate of 12 × 8 points with a crack from the left, pulled apart by its upper and lower two rows.
fn plate() -> Value {
    json!({
        "title": "plate", "units": "mm-N-MPa",
        "model": { "bond_plane": { "youngs_modulus": 73100, "state": "plane_strain", "thickness": 25,
            "edges": "none", "bond_law": { "bilinear": { "yield_stretch": 0.0028, "failure_stretch": 0.014 } } } },
        "body": { "rectangle": { "size": [12, 8], "spacing": 1 } },
        "horizon_ratio": 2,
        "cracks": [ { "path": [[-1, 4], [4, 4]] } ],
        "regions": { "lower": { "box": { "from": [0, 0], "to": [12, 2] } },
            "upper": { "box": { "from": [0, 6], "to": [12, 8] } } },
        "supports": [ { "at": { "region": "lower" }, "ux": 0, "uy": 0 },
            { "at": { "region": "upper" }, "ux": 0, "uy": 0.06 } ],
        "probes": [ { "name": "load", "at": { "region": "upper" }, "field": "reaction_y" } ],
        "path": { "load": "load" }
    })
}

const LAW: &str = "/model/bond_plane/bond_law/bilinear";

fn law(case: &Value, key: &str, value: impl Into<Value>) -> Value {
    with(case, &format!("{LAW}/{key}"), value.into())
}

/// Turns of a path.
fn turning(case: &Value, turns: Value) -> Value {
    with(case, "/path/turns", turns)
}

/// The plate hung up at its lower rows and pulled by forces, `factor` of what it can bear with its upper rows kept straight.
fn forced(case: &Value, force: f64) -> Value {
    let case = with(case, "/supports", json!([{ "at": { "region": "lower" }, "ux": 0, "uy": 0 }]));
    let case = with(&case, "/loads", json!([{ "point": { "at": { "region": "upper" }, "force_y": force } }]));
    with(&case, "/probes", json!([{ "name": "load", "at": { "region": "lower" }, "field": "reaction_y" }]))
}

/// Two cracks leave a ligament of four points.
fn notched() -> Value {
    with(&plate(), "/cracks", json!([{ "path": [[-1, 4], [4, 4]] }, { "path": [[13, 4], [8, 4]] }]))
}

/// A body on its path, at rest.
fn course(scene: &BodyScene) -> Course<2> {
    let AnyBody::Two(body) = &scene.model else { panic!("central bonds") };
    let model = body.softening().unwrap();
    let problem = BodyProblem::new(scene, body.clone());
    let (system, _) = prepare::<2>(&problem, &RunOptions::default()).unwrap();
    let path = scene.path.as_ref().unwrap();
    let law = |[i, j]: [usize; 2]| Some(usize::from(path.exempt[i] || path.exempt[j]));
    let laws = vec![path.law, Bilinear::elastic()];
    let bonds = HistoryBonds::new(model.points(), path.kinematics, laws, model.history_bonds(&law));
    let mut loads = vec![0.0; system.size()];
    problem.add_load(0, &mut loads);
    let body = Body::new(system, bonds, loads, Problem::<2>::positions(&problem)).unwrap();
    Course::new(body, path.increment).unwrap()
}

/// Load factor and energies of the states that steps of the load factor find.
fn climb(course: &mut Course<2>, increment: f64) -> (Vec<[f64; 3]>, usize) {
    let mut control = Displacement::<2>::new(increment);
    let (mut found, mut refused) = (Vec::new(), 0);
    for _ in 0..1000 {
        let before: Vec<History> = course.body.bonds.history().to_vec();
        let at = course.state.u.clone();
        let step = control.step(course, Goal::LoadFactor(1.0), &|_, _| 0.0).unwrap();
        // Whatever was tried, nothing was committed.
        assert!(before == course.body.bonds.history() && at == course.state.u);
        let Step::To(state, cost, arrived) = step else { return (found, refused) };
        let point = course.accept(state, cost);
        control.committed(course, false);
        refused += cost.refused;
        found.push([point.load_factor, point.stored, point.dissipated]);
        if arrived {
            break;
        }
    }
    (found, refused)
}
