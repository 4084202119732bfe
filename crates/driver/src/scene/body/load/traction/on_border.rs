//! A traction and the border that it acts on.

use super::profile::Profile;
use crate::case::LoadSharing;
use crate::diagnostic::JsonPath;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::site::boundary::{self, Border, Stretch};
use crate::scene::body::site::ground::Ground;
use peristat_assembly::body::BorderPart;
use peristat_assembly::model::plane::Calibration;

/// A traction on its border.
#[derive(Clone, Debug)]
pub(crate) struct OnBorder {
    pub(crate) name: String,
    pub(crate) border: Border,
    pub(crate) profile: Profile,
    pub(crate) sharing: Option<LoadSharing>,
    /// How deep it reaches, if it is consistent, m.
    pub(crate) depth: Option<f64>,
    /// Where it stands in the case.
    pub(crate) path: JsonPath,
}

impl OnBorder {
    /// Stretches of the border.
    pub(crate) fn stretches(&self, ground: &Ground) -> Vec<Stretch> {
        match &self.border {
            Border::Edge(edge) => boundary::of_edge(edge, ground),
            Border::Curved { stretches, .. } => stretches.clone(),
        }
    }

    /// Parts of the border with their places along it at start and end.
    pub(crate) fn parts(&self, ground: &Ground) -> Vec<(BorderPart, [f64; 2])> {
        match (&self.border, ground.outline) {
            (Border::Edge(edge), _) => {
                let places = |part: &BorderPart| [0.0, 1.0].map(|s| boundary::place_on(edge, part.at(s)));
                boundary::parts_of_edge(edge, ground).into_iter().map(|part| (part, places(&part))).collect()
            }
            // On a hole every place is like any other.
            (Border::Curved { hole: Some(k), .. }, Some(outline)) => {
                outline.hole_parts(*k).into_iter().map(|part| (part, [0.0, 1.0])).collect()
            }
            (Border::Curved { stretches, .. }, _) => {
                stretches.iter().map(|s| (s.part, [s.place - s.half, s.place + s.half])).collect()
            }
        }
    }
}

/// Whether a traction may be consistent, by what is asked for and by the calibration.
pub(crate) fn may_be_consistent(traction: &OnBorder, context: &LoadContext) -> bool {
    let matched = context.material.about().calibration == Calibration::Matched;
    match traction.sharing {
        Some(sharing) => sharing == LoadSharing::Consistent,
        None => matched,
    }
}
