//! A scene: a case with every default resolved and every fault found. The rest of the program sees only this.
//!
//! Every family of models has its own kind of scene; what they share is here.

pub mod beam;
mod bending_criterion;
pub mod body;
mod drawing;
mod expansion;
mod expectation;
mod files;
mod fingerprint;
mod formula;
pub mod fracture;
mod horizon;
mod mass;
mod numbers;
pub mod path;
pub mod plate;
mod plates_only;
mod prescribed;
mod probes;
mod resultant;
mod solids_only;
mod states;
pub(crate) mod words;

pub use beam::BeamScene;
pub use body::BodyScene;
pub use expectation::{Bound, Expectation, ExpectationKind};
pub use files::{INPUTS, InputFile};
pub use plate::PlateScene;
pub(crate) use resultant::ASKED;
pub use resultant::{Counted, Resultant};

use crate::case::{Case, FieldName};
use crate::diagnostic::{Faults, Report, root};
use crate::input::Folder;

/// A problem, resolved.
#[derive(Debug)]
pub enum Scene {
    /// A beam, or a frame of beams.
    Beam(Box<BeamScene>),
    /// A body in the plane.
    Body(Box<BodyScene>),
    /// A plate in bending.
    Plate(Box<PlateScene>),
}

fn check_title(title: &str, faults: &mut Faults) {
    if title.chars().any(char::is_control) {
        faults.error(root("title"), "`title` must not hold control characters such as line ends");
    }
}

/// Adds faults of materials that are named and come from nowhere.
fn check_library(case: &Case, faults: &mut Faults) {
    if case.library.is_some() {
        return;
    }
    let of_case = case.material.as_ref().map(|_| root("material"));
    let named = case.materials.iter().filter(|(_, given)| given.material.is_some());
    for path in of_case.into_iter().chain(named.map(|(own, _)| root("materials").key(own).key("material"))) {
        let hint = "name its file beside `model`: `\"library\": \"office.json\"`";
        faults.error(path, "a `material` is one of a `library`, and this case has none").hint(hint);
    }
}

impl Scene {
    /// Resolves a case. `folder` is where files that the case names are looked for, `file` and `text` are for messages;
    /// `max_memory` is in bytes, without it there is what the machine has.
    ///
    /// # Errors
    /// All faults of the case in one [`Report`].
    pub fn new(
        case: Case,
        folder: impl Into<Folder>,
        file: &str,
        text: &str,
        max_memory: Option<u64>,
    ) -> Result<Self, Report> {
        let folder = &folder.into();
        let mut faults = Faults::default();
        numbers::check(&case, &mut faults);
        mass::check(&case, &mut faults);
        check_title(&case.title, &mut faults);
        check_library(&case, &mut faults);
        drawing::check(&case, &mut faults);
        let bends = case.model.keys().is_ok_and(|keys| keys.bends());
        if !bends {
            plates_only::refuse(&case, &mut faults);
        }
        let resolved = match case.model.keys().map_err(Clone::clone) {
            Ok(_) if bends => {
                PlateScene::new(case, folder, max_memory, faults).map(|scene| Self::Plate(Box::new(scene)))
            }
            Ok(_) => {
                BodyScene::new(case, folder, max_memory, faults).map(|scene| Self::Body(Box::new(scene)))
            }
            Err(beam) => BeamScene::new(case, beam, folder, max_memory, faults)
                .map(|scene| Self::Beam(Box::new(scene))),
        };
        let refuse = |faults: Faults| faults.into_report(file, text);
        let scene = resolved.map_err(refuse)?;
        let faults = drawing::check_maps(&scene);
        if faults.has_errors() { Err(refuse(faults)) } else { Ok(scene) }
    }

    /// The case with its defaults filled in.
    pub fn case(&self) -> &Case {
        match self {
            Self::Beam(scene) => &scene.case,
            Self::Body(scene) => &scene.case,
            Self::Plate(scene) => &scene.case,
        }
    }

    /// Files that the case names, as its results keep them.
    pub fn files(&self) -> &[InputFile] {
        match self {
            Self::Beam(scene) => &scene.files,
            Self::Body(scene) => &scene.files,
            Self::Plate(scene) => &scene.files,
        }
    }

    /// Faults that do not keep the case from running.
    pub fn warnings(&self) -> &Faults {
        match self {
            Self::Beam(scene) => &scene.warnings,
            Self::Body(scene) => &scene.warnings,
            Self::Plate(scene) => &scene.warnings,
        }
    }

    /// Number of right-hand sides.
    pub fn states(&self) -> usize {
        match self {
            Self::Beam(scene) => scene.states.len(),
            Self::Body(scene) => scene.states.len(),
            Self::Plate(scene) => scene.states.len(),
        }
    }

    /// Horizon over spacing, of the first line of a beam.
    pub fn horizon_ratio(&self) -> f64 {
        match self {
            Self::Beam(scene) => scene.horizon_ratio(),
            Self::Body(scene) => scene.horizon() / scene.spacing(),
            Self::Plate(scene) => scene.plate.parameters().horizon_ratio,
        }
    }

    /// The fields that probes of some case with the same model can ask for.
    pub fn askable(&self) -> Vec<FieldName> {
        match self {
            Self::Beam(_) => BeamScene::askable(),
            Self::Body(scene) => scene.askable(),
            Self::Plate(_) => PlateScene::askable(),
        }
    }

    /// Whether the states are load cases and combinations, so that an envelope makes sense.
    pub fn has_envelope(&self) -> bool {
        !self.case().load_cases.is_empty()
    }

    /// The scene of a beam or frame.
    pub fn into_beam(self) -> Option<BeamScene> {
        match self {
            Self::Beam(scene) => Some(*scene),
            Self::Body(_) | Self::Plate(_) => None,
        }
    }

    /// The scene of a body in the plane.
    pub fn into_body(self) -> Option<BodyScene> {
        match self {
            Self::Beam(_) | Self::Plate(_) => None,
            Self::Body(scene) => Some(*scene),
        }
    }
}
