//! Doubts about bodies that can be solved.

pub(crate) mod clamped;
pub(crate) mod gaps;
pub(crate) mod held_corner;
pub(crate) mod loose;
pub(crate) mod warnings;
