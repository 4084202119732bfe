//! The elastic body beside one that breaks or softens: the same case with the bonds, edges and loads that it would have by
//! default.

use crate::case::{Case, Solver};
use crate::diagnostic::Faults;
use crate::input::Folder;
use crate::model::{Keys, Material};
use crate::scene::body::site::of_case;

/// What the elastic body is resolved from.
#[derive(Clone, Debug)]
pub(crate) struct Elastic {
    pub(crate) case: Case,
    pub(crate) folder: Folder,
    pub(crate) max_memory: Option<u64>,
}

impl Elastic {
    /// That of a case as it was written; with `usual`, the horizon per spacing of a case that gives none.
    pub(crate) fn new(case: &Case, usual: f64, folder: &Folder, max_memory: Option<u64>) -> Self {
        let model = case.model.keys().map_or_else(|_| case.model.clone(), |keys| keys.with_usual_bonds());
        let case = Case {
            model,
            // What breaks has its own usual horizon, and both are to be compared.
            horizon_ratio: case.horizon_ratio.or(case.horizon.is_none().then_some(usual)),
            fracture: None,
            path: None,
            solver: Solver::default(),
            probes: Vec::new(),
            lines: Vec::new(),
            stress_intensity: Vec::new(),
            checks: Vec::new(),
            ..case.clone()
        };
        Self { case, folder: folder.clone(), max_memory }
    }

    /// Whether its bonds and edges are others than these.
    pub(crate) fn differs_from(&self, material: &dyn Material) -> bool {
        let resolve = |keys: &dyn Keys| keys.resolve(&of_case::asked(&self.case), &mut Faults::default());
        let usual = self.case.model.keys().ok().and_then(resolve).map(|usual| usual.about());
        let own = material.about();
        usual.is_some_and(|usual| (usual.edges, usual.calibration) != (own.edges, own.calibration))
    }
}
