//! The same beam as it is by default: exact bonds, covered ends, points on the ends of cells.
//!
//! Such a beam has the values of the local one at its points, on any grid. It is solved on points among which are those of
//! the beam it stands for, bonded to the next ones only: with exact bonds the horizon changes nothing but the cost.

use crate::case::{Body, Case, Model, Solver};
use crate::diagnostic::{Faults, JsonPath};
use crate::scene::Scene;
use crate::scene::beam::BeamScene;
use peristat_assembly::model::timoshenko_beam::{Grid, VolumeFactor};
use std::path::Path;

/// Keys of a case that others stand beside.
const BOND_LAW: &str = "bond_law";
const END_TREATMENT: &str = "end_treatment";
const GRID: &str = "grid";

/// A beam by default, and where on it the points of another one are.
pub(super) struct Twin {
    /// The beam.
    pub(super) scene: BeamScene,
    /// By line: its first point that is one of the other beam, too, and how many points further the next one is.
    pub(super) shared: Vec<[usize; 2]>,
}

/// Something by which a beam is not the default.
pub(super) struct Departure {
    key: &'static str,
    path: JsonPath,
    words: String,
}

/// All of them.
pub(super) fn departures(scene: &BeamScene) -> Vec<Departure> {
    let parameters = scene.beam.parameters();
    let model = JsonPath::default().key("model").key("timoshenko_beam");
    let mut found = Vec::new();
    let mut add = |key: &'static str, of: &JsonPath, words: String| {
        found.push(Departure { key, path: of.key(key), words })
    };
    if !parameters.bond_law.is_element {
        add(BOND_LAW, &model, format!("the law `{}`", parameters.bond_law.name));
    }
    let treatment = parameters.end_treatment;
    let on_cells = grid_of_cells(scene);
    // Ghosts are what a grid of cells has if nothing is said.
    if !(treatment.covers() || on_cells.is_some() && treatment.name == "ghost") {
        add(END_TREATMENT, &model, format!("the end treatment `{}`", treatment.name));
    }
    if let Some(line) = &on_cells {
        add(GRID, line, "the grid `cells`".into());
    }
    let has_classes = scene.beam.chains().iter().any(|chain| chain.weights.classes() > 1);
    if parameters.volume_factor == VolumeFactor::Full && has_classes {
        add("volume_factor", &model, "the volume factor `full`".into());
    }
    // Foundations and other ends have lumped loads by default.
    let is_loaded =
        scene.states.iter().any(|state| state.loads.lumped && !state.loads.distributed.is_empty());
    if treatment.covers() && scene.case.foundation.is_empty() && is_loaded {
        add("distributed_loads", &model, "`lumped` loads".into());
    }
    found
}

/// The first line that has its points in the middle of cells.
fn grid_of_cells(scene: &BeamScene) -> Option<JsonPath> {
    let body = JsonPath::default().key("body");
    let line = scene.case.body.lines().iter().position(|line| line.grid == Grid::Cells)?;
    Some(match &scene.case.body {
        Body::Lines(_) => body.key("lines").index(line),
        _ => body.key("line"),
    })
}

/// What departs in words, such as `the law ...`, or `the beam with ... and ...`.
pub(super) fn words(departures: &[Departure]) -> String {
    let all: Vec<&str> = departures.iter().map(|d| d.words.as_str()).collect();
    match all.split_last() {
        Some((law, [])) if is_law(departures) => (*law).into(),
        Some((only, [])) => format!("the beam with {only}"),
        Some((last, others)) => format!("the beam with {} and {last}", others.join(", ")),
        None => "the beam".into(),
    }
}

fn is_law(departures: &[Departure]) -> bool {
    matches!(departures, [only] if only.key == BOND_LAW)
}

/// Warns of what departs, by a message on it.
pub(super) fn warn(departures: &[Departure], message: String, warnings: &mut Faults) {
    let Some(first) = departures.first() else { return };
    let hint = if is_law(departures) {
        "leave `bond_law` out: the default is exact on any grid; other laws are for studies of the nonlocal beam".into()
    } else {
        let mut keys: Vec<&str> = departures.iter().map(|d| d.key).collect();
        // On nodes the ghosts of a grid of cells would stay, where they are written.
        if keys.contains(&GRID) && !keys.contains(&END_TREATMENT) {
            keys.push(END_TREATMENT);
        }
        let keys: Vec<String> = keys.iter().map(|key| format!("`{key}`")).collect();
        format!(
            "leave {} out: by default a beam is exact on any grid; all else is for studies of the nonlocal beam",
            keys.join(", ")
        )
    };
    warnings.warning(first.path.clone(), message).hint(hint);
}

/// A beam as it is before its first bond breaks, which tells nothing but its displacements.
///
/// # Errors
/// It is none, for instance for lack of memory.
pub(super) fn intact(scene: &BeamScene, max_memory: Option<u64>) -> Result<BeamScene, String> {
    let mut case = scene.case.clone();
    (case.checks, case.probes, case.fracture) = (Vec::new(), Vec::new(), None);
    resolved(case, max_memory)
}

fn resolved(case: Case, max_memory: Option<u64>) -> Result<BeamScene, String> {
    // Only checks of beams name files.
    let scene = Scene::new(case, Path::new(""), "", "", max_memory).map_err(|e| e.to_string())?;
    scene.into_beam().ok_or_else(|| "it is no beam".into())
}

impl Twin {
    /// The beam that stands for another one.
    ///
    /// # Errors
    /// It is none, for instance for lack of memory.
    pub(super) fn new(scene: &BeamScene, max_memory: Option<u64>) -> Result<Self, String> {
        let mut case = scene.case.clone();
        (case.checks, case.fracture, case.solver) = (Vec::new(), None, Solver::default());
        (case.horizon, case.horizon_ratio) = (None, Some(1.0));
        if let Model::TimoshenkoBeam(beam) = &mut case.model {
            (beam.bond_law, beam.end_treatment, beam.volume_factor) = (None, None, VolumeFactor::default());
            beam.distributed_loads = None;
        }
        let lines = match &mut case.body {
            Body::Line(line) => std::slice::from_mut(line),
            Body::Lines(lines) => lines,
            _ => &mut [],
        };
        let mut shared = vec![[0, 1]; scene.beam.chains().len()];
        for (line, shared) in lines.iter_mut().zip(&mut shared) {
            if line.grid == Grid::Cells {
                (line.grid, line.cells) = (Grid::Nodes, 2 * line.cells);
                *shared = [1, 2];
            }
        }
        Ok(Self { scene: resolved(case, max_memory)?, shared })
    }
}
