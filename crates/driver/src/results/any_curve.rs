//! The table and the plots of what is found on the way, whatever goes on.

use super::curve::Curve;
use super::path_curve::PathCurve;
use crate::case::Case;
use crate::output::plot::Diagram;
use crate::run::{Advance, RestartFrom};
use crate::scene::Scene;
use std::io;
use std::path::Path;

/// A table that grows with the run.
#[derive(Debug)]
pub(super) enum AnyCurve {
    /// Of a body that breaks.
    Break(Curve),
    /// Of a body that softens.
    Path(PathCurve),
}

impl AnyCurve {
    /// Begins the table of a scene that has one.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn begin(folder: &Path, scene: &Scene) -> io::Result<Option<Self>> {
        let case = scene.case();
        Ok(if case.fracture.is_some() {
            Some(Self::Break(Curve::begin(folder, case, &[])?))
        } else if let Some(path) = &case.path {
            Some(Self::Path(PathCurve::begin(folder, case, path, &[])?))
        } else {
            None
        })
    }

    /// Goes on with the table of what was found before a restart, if it is one of the case.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn resume(folder: &Path, case: &Case, from: &RestartFrom) -> io::Result<Option<Self>> {
        Ok(match (from, &case.path) {
            (RestartFrom::Break(kept), _) => Some(Self::Break(Curve::begin(folder, case, &kept.events)?)),
            (RestartFrom::Path(kept), Some(path)) => {
                Some(Self::Path(PathCurve::begin(folder, case, path, &kept.points)?))
            }
            (RestartFrom::Path(_), None) => None,
        })
    }

    /// Adds an equilibrium.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn add(&mut self, advance: &Advance<'_>) -> io::Result<()> {
        match (self, advance) {
            (Self::Break(curve), Advance::Break(event)) => curve.add(event),
            (Self::Path(curve), Advance::Path(point)) => curve.add(point),
            _ => unreachable!("a scene has equilibria of its own kind"),
        }
    }

    /// Number of equilibria.
    pub(super) fn rows(&self) -> usize {
        match self {
            Self::Break(curve) => curve.rows(),
            Self::Path(curve) => curve.rows(),
        }
    }

    /// Draws it.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn draw(&self, plots: &Path, case: &Case) -> io::Result<()> {
        match self {
            Self::Break(curve) => curve.draw(plots, case),
            Self::Path(curve) => curve.draw(plots, case),
        }
    }

    /// What it draws.
    pub(super) fn diagrams(&self, case: &Case) -> Vec<Diagram> {
        match self {
            Self::Break(curve) => curve.diagrams(case).into(),
            Self::Path(curve) => curve.diagrams(case).into_iter().map(|(_, diagram)| diagram).collect(),
        }
    }
}
