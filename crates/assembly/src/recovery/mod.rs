//! Recovery: what displacements of points tell of the fields between and beside them.

pub mod hole;
pub mod trefftz;
