//! The elastic body beside one that breaks or softens: the same case with the bonds, edges and loads that it would have by
//! default.

use super::bonds::PlaneBonds;
use super::{PlaneScene, keys};
use crate::case::{Body, Case, Solver};
use crate::diagnostic::Faults;
use crate::input::Folder;

/// What the elastic body is resolved from.
#[derive(Clone, Debug)]
pub(super) struct Elastic {
    case: Case,
    folder: Folder,
    max_memory: Option<u64>,
}

impl Elastic {
    /// That of a case as it was written.
    pub(super) fn new(case: &Case, folder: &Folder, max_memory: Option<u64>) -> Self {
        let mut usual = keys::of(case.model.clone()).ok();
        usual.iter_mut().for_each(|keys| keys.take_usual_bonds());
        let case = Case {
            model: usual.map_or_else(|| case.model.clone(), |keys| keys.model()),
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
    pub(super) fn differs_from(&self, bonds: &PlaneBonds) -> bool {
        let is_cloud = matches!(self.case.body, Body::Points(_) | Body::Mesh(_));
        let usual = keys::of(self.case.model.clone())
            .ok()
            .and_then(|mut keys| keys.bonds(&self.case, is_cloud, &mut Faults::default()));
        usual
            .is_some_and(|usual| (usual.edges(), usual.calibration()) != (bonds.edges(), bonds.calibration()))
    }

    /// Its scene, if it has one.
    pub(super) fn scene(&self) -> Option<PlaneScene> {
        let keys = keys::of(self.case.model.clone()).ok()?;
        PlaneScene::new(self.case.clone(), keys, &self.folder, self.max_memory, Faults::default()).ok()
    }
}
