//! The loads of one load case.

use peristat_assembly::model::timoshenko_beam::BeamLoads;

/// Loads of one load case, and the points they split.
#[derive(Clone, Debug, Default)]
pub(super) struct ResolvedLoads {
    /// The loads.
    pub(super) loads: BeamLoads,
    /// Line and real point of concentrated loads that act on a point.
    pub(super) splits: Vec<(usize, usize)>,
}
