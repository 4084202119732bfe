//! Sizes of a scene.

/// Sizes of a scene, known before it is solved.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize)]
pub struct Sizes {
    /// Points, ghosts included.
    pub points: usize,
    /// Bonds and springs.
    pub bonds: usize,
    /// Independent unknowns.
    pub unknowns: usize,
    /// Memory that solving will take, estimated, bytes.
    pub estimated_bytes: u64,
}
