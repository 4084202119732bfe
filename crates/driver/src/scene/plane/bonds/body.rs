//! The bodies that models of the plane make: on lattices, and of listed points.

use super::super::any_body::AnyBody;
use super::PlaneBonds;
use peristat_assembly::body::{Cell, SquareLattice};
use peristat_assembly::model::beam_bond_orthotropic::{BeamBondOrthotropic, OrthotropicError};
use peristat_assembly::model::bond_plane::{BondPlane, BondPlaneError};
use peristat_assembly::model::plane::{FindCuts, Mirrors};
use peristat_assembly::model::shell_membrane::{ShellError, ShellMembrane};
use peristat_assembly::model::state_based::{BorderedState, StateBased, StateEdges, StateError};
use std::sync::Arc;

/// Why a model of a body in the plane cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlaneModelError {
    /// Of central bonds.
    #[error(transparent)]
    Central(#[from] BondPlaneError),
    /// Of beam bonds.
    #[error(transparent)]
    Beams(#[from] OrthotropicError),
    /// Of state-based families.
    #[error(transparent)]
    State(#[from] StateError),
    /// Of a shell membrane.
    #[error(transparent)]
    Shell(#[from] ShellError),
    /// There is no such model of listed points.
    #[error("the model `{0}` needs a body that fills a lattice; use `rectangle` or `outline`")]
    NeedsLattice(&'static str),
}

impl PlaneBonds {
    /// Offsets to the neighbours of a point on a lattice.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn offsets(&self) -> Result<Vec<Cell>, PlaneModelError> {
        Ok(match self {
            Self::Central(parameters) => BondPlane::offsets(parameters)?,
            Self::Beams(parameters) => BeamBondOrthotropic::offsets(parameters)?,
            Self::State(parameters) => StateBased::offsets(parameters),
            Self::Shell(parameters) => ShellMembrane::offsets(parameters)?,
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
            Self::State(parameters) => parameters.horizon_ratio.floor() as i32,
            Self::Shell(parameters) => ShellMembrane::depth(parameters)?,
        })
    }

    /// A body on the cells of a lattice without images. `cuts` finds the cut bonds on the lattice with them, given the
    /// offsets, by index of the offset and lower point; `separated` tells whether something stands between two cells.
    ///
    /// # Errors
    /// [`PlaneModelError`].
    pub fn on_lattice(
        &self,
        real: &SquareLattice,
        mirrors: Mirrors,
        cuts: &FindCuts,
        separated: &(dyn Fn(Cell, Cell) -> bool + '_),
    ) -> Result<AnyBody, PlaneModelError> {
        let offsets = self.offsets()?;
        let extended = || -> Result<_, PlaneModelError> {
            let extended = mirrors.extended(real, self.depth()?);
            let cuts = cuts(&extended, &offsets);
            Ok((Arc::new(extended), cuts))
        };
        Ok(match self {
            Self::Central(parameters) => {
                let (lattice, cuts) = extended()?;
                AnyBody::Two(Box::new(BondPlane::on_lattice(lattice, mirrors, *parameters, &cuts)?))
            }
            Self::Beams(parameters) => {
                let (lattice, cuts) = extended()?;
                AnyBody::Three(Box::new(BeamBondOrthotropic::on_lattice(
                    lattice,
                    mirrors,
                    *parameters,
                    &cuts,
                )?))
            }
            Self::State(parameters) => {
                let real = Arc::new(real.clone());
                if parameters.edges == StateEdges::Border {
                    return Ok(AnyBody::Two(Box::new(BorderedState::on_lattice(
                        &real,
                        mirrors,
                        *parameters,
                    )?)));
                }
                let cut = |lattice: &SquareLattice| cuts(lattice, &offsets);
                AnyBody::Two(Box::new(StateBased::on_lattice(real, mirrors, *parameters, separated, &cut)?))
            }
            Self::Shell(parameters) => {
                let (lattice, _) = extended()?;
                AnyBody::Three(Box::new(ShellMembrane::on_lattice(lattice, mirrors, *parameters)?))
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
    ) -> Result<AnyBody, PlaneModelError> {
        match self {
            Self::Central(parameters) => {
                let model = BondPlane::on_cloud(positions, areas, horizon, *parameters, cut)?;
                Ok(AnyBody::Two(Box::new(model)))
            }
            Self::Beams(_) | Self::State(_) | Self::Shell(_) => {
                Err(PlaneModelError::NeedsLattice(self.name()))
            }
        }
    }
}
