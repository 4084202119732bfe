//! The models of bodies in the plane: what they are made of, and the bodies made of them.

use super::orthotropic;
use peristat_assembly::body::{Cell, SquareLattice};
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamBondOrthotropic, OrthotropicError, OrthotropicParameters,
};
use peristat_assembly::model::bond_plane::{BondPlane, BondPlaneError, PlaneParameters};
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors, PlaneModel};
use std::ops::Deref;
use std::sync::Arc;

/// Material and bonds of a body in the plane.
#[derive(Clone, Copy, Debug)]
pub enum PlaneBonds {
    /// Central bonds.
    Central(PlaneParameters),
    /// Beam bonds on a lattice.
    Beams(OrthotropicParameters),
}

/// A body in the plane with its bonds.
#[derive(Clone, Debug)]
pub enum AnyPlaneModel {
    /// Of central bonds.
    Central(BondPlane),
    /// Of beam bonds.
    Beams(BeamBondOrthotropic),
}

impl Deref for AnyPlaneModel {
    type Target = dyn PlaneModel;

    fn deref(&self) -> &Self::Target {
        match self {
            Self::Central(model) => model,
            Self::Beams(model) => model,
        }
    }
}

impl AnyPlaneModel {
    /// Makes cut bonds of a lattice, by index of the offset and lower point, ones that never were.
    pub(super) fn never_joined(self, bonds: &[(usize, usize)]) -> Self {
        match self {
            Self::Central(model) => Self::Central(model.never_joined(bonds)),
            Self::Beams(model) => Self::Beams(model.never_joined(bonds)),
        }
    }
}

/// Why a model of a body in the plane cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlaneModelError {
    /// Of central bonds.
    #[error(transparent)]
    Central(#[from] BondPlaneError),
    /// Of beam bonds.
    #[error(transparent)]
    Beams(#[from] OrthotropicError),
    /// There is no such model of listed points.
    #[error("beam bonds need a lattice")]
    NeedsLattice,
}

impl PlaneBonds {
    /// Name of the model in case files.
    pub fn name(&self) -> &'static str {
        match self {
            Self::Central(_) => "bond_plane",
            Self::Beams(_) => "beam_bond_orthotropic",
        }
    }

    /// Whether points have rotations of their own.
    pub fn points_turn(&self) -> bool {
        matches!(self, Self::Beams(_))
    }

    /// The same on a lattice whose rows run at an angle to x, rad.
    pub fn with_lattice_angle(self, lattice_angle: f64) -> Self {
        match self {
            Self::Central(_) => self,
            Self::Beams(parameters) => Self::Beams(OrthotropicParameters { lattice_angle, ..parameters }),
        }
    }

    /// Horizon per spacing of a case that gives none.
    pub(super) fn usual_horizon_ratio(&self) -> f64 {
        match self {
            Self::Central(_) => 3.0,
            Self::Beams(parameters) => orthotropic::horizon_ratio(parameters),
        }
    }

    /// Horizon per spacing.
    pub fn horizon_ratio(&self) -> f64 {
        match self {
            Self::Central(parameters) => parameters.horizon_ratio,
            Self::Beams(parameters) => parameters.horizon_ratio,
        }
    }

    /// The same with another horizon.
    pub fn with_horizon_ratio(self, horizon_ratio: f64) -> Self {
        match self {
            Self::Central(parameters) => Self::Central(PlaneParameters { horizon_ratio, ..parameters }),
            Self::Beams(parameters) => Self::Beams(OrthotropicParameters { horizon_ratio, ..parameters }),
        }
    }

    /// Treatment of edges.
    pub fn edges(&self) -> Edges {
        match self {
            Self::Central(parameters) => parameters.edges,
            Self::Beams(parameters) => parameters.edges,
        }
    }

    /// Where the stiffness of bonds comes from.
    pub fn calibration(&self) -> Calibration {
        match self {
            Self::Central(parameters) => parameters.calibration,
            Self::Beams(parameters) => parameters.calibration,
        }
    }

    /// Thickness.
    pub fn thickness(&self) -> f64 {
        match self {
            Self::Central(parameters) => parameters.material.thickness,
            Self::Beams(parameters) => parameters.material.thickness,
        }
    }

    /// Offsets to the neighbours of a point on a lattice.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn offsets(&self) -> Result<Vec<Cell>, PlaneModelError> {
        Ok(match self {
            Self::Central(parameters) => BondPlane::offsets(parameters)?,
            Self::Beams(parameters) => BeamBondOrthotropic::offsets(parameters)?,
        })
    }

    /// Rows or columns of images that a lattice needs beyond a line of symmetry.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn depth(&self) -> Result<i32, PlaneModelError> {
        Ok(match self {
            Self::Central(parameters) => BondPlane::depth(parameters)?,
            Self::Beams(parameters) => BeamBondOrthotropic::depth(parameters)?,
        })
    }

    /// A body on a lattice with cuts by index of the offset and lower point.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn on_lattice(
        &self,
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        cuts: &[(usize, usize)],
    ) -> Result<AnyPlaneModel, PlaneModelError> {
        Ok(match self {
            Self::Central(parameters) => {
                AnyPlaneModel::Central(BondPlane::on_lattice(lattice, mirrors, *parameters, cuts)?)
            }
            Self::Beams(parameters) => {
                AnyPlaneModel::Beams(BeamBondOrthotropic::on_lattice(lattice, mirrors, *parameters, cuts)?)
            }
        })
    }

    /// A body of listed points with a horizon, m; `cut` tells whether something separates two positions.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn on_cloud(
        &self,
        (positions, areas): (Vec<[f64; 2]>, Vec<f64>),
        horizon: f64,
        cut: &dyn Fn([f64; 2], [f64; 2]) -> bool,
    ) -> Result<AnyPlaneModel, PlaneModelError> {
        match self {
            Self::Central(parameters) => {
                let model = BondPlane::on_cloud(positions, areas, horizon, *parameters, cut)?;
                Ok(AnyPlaneModel::Central(model))
            }
            Self::Beams(_) => Err(PlaneModelError::NeedsLattice),
        }
    }
}
