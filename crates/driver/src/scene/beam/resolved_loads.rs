//! The loads of one load case.

use super::eigenstrain::Eigenstrain;
use peristat_assembly::model::timoshenko_beam::BeamLoads;

/// Loads of one load case, and the points they split.
#[derive(Clone, Debug, Default)]
pub(super) struct ResolvedLoads {
    /// The loads.
    pub(super) loads: BeamLoads,
    /// Strains without stress.
    pub(super) eigenstrains: Vec<Eigenstrain>,
    /// Line and real point of concentrated loads that act on a point.
    pub(super) splits: Vec<(usize, usize)>,
}
