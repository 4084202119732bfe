//! What models of bodies in the plane share: images in lines of symmetry, points near edges, the calibration of offsets.

mod mirrors;
mod near;
mod projection;

pub use mirrors::Mirrors;

pub(super) use near::{at, near_points};
pub(super) use projection::project;

/// Component of the displacement along x.
pub const UX: usize = 0;
/// Component of the displacement along y.
pub const UY: usize = 1;
