//! A traction and the border that it acts on.

use super::profile::Profile;
use crate::case::LoadSharing;
use crate::diagnostic::JsonPath;
use crate::scene::body::load::context::LoadContext;
use crate::scene::body::site::boundary::{self, Border, Stretch};
use crate::scene::body::site::ground::Ground;
use peristat_assembly::body::BorderPart;
use peristat_assembly::model::plane::{Calibration, Edges};

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
        None => matched && misses_at_mirrors(context).is_none(),
    }
}

/// Why the rows of bonds have not the forces of a stress beside lines of symmetry: without a mirror the other end of the body gives what
/// this one lacks, a mirror shows it.
pub(crate) fn misses_at_mirrors(context: &LoadContext) -> Option<&'static str> {
    let about = context.material.about();
    let mirrors = &context.symmetry.mirrors;
    let has_mirror = |axis: usize| !mirrors.joined[axis] && mirrors.lines[axis].iter().any(Option::is_some);
    if !(0..2).any(has_mirror) {
        return None;
    }
    if about.edges.is_some_and(|edges| !edges.is_exact()) {
        return Some("beside a mirror they need the edges `border` or `overlay`");
    }
    let lattice = context.ground.body.cells()?;
    let (columns, rows) = (lattice.columns().len(), lattice.rows().len());
    // Bonds reach from an image past all of the body.
    let reach = about.horizon_ratio + about.partial_neighbours;
    let is_thin = |axis: usize, cells: usize| has_mirror(axis) && cells as f64 <= reach;
    let completes = about.edges == Some(Edges::Overlay);
    (completes && (is_thin(0, columns) || is_thin(1, rows)))
        .then_some("beside a mirror they need a body wider than the horizon")
}
