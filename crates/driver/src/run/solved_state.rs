//! One solved right-hand side.

use super::certificate::Certificate;
use super::workspace::StateSolution;

/// One solved right-hand side.
pub(super) struct SolvedState<'a> {
    pub(super) state: usize,
    pub(super) load: &'a [f64],
    pub(super) solution: StateSolution,
    pub(super) certificate: Certificate,
}
