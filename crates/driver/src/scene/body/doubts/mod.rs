//! Doubts about bodies that can be solved.

pub(crate) mod bridges;
pub(crate) mod clamped;
pub(crate) mod held_corner;
pub(crate) mod loose;
mod scattered;
mod stairs;
pub(crate) mod warnings;
