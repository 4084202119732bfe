//! What a run is asked for.

/// What a run is asked for beyond the unknowns.
#[derive(Clone, Copy, Debug, Default)]
pub struct RunOptions {
    /// Recover section forces, stresses and energy densities of every state even if no check reads them.
    pub recover: bool,
    /// Memory that must not be exceeded, bytes.
    pub max_memory: Option<u64>,
    /// Solve a beam that is not exact on any grid once more as one that is, and say how far the two are apart.
    pub compare: bool,
}
