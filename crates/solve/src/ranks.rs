//! Processes that solve one problem together.
//!
//! Each of them holds a part of every vector. What they do together is behind a trait, so that neither this crate nor the
//! mechanics knows how processes talk to each other.

use crate::{LinearOperator, PcgOptions, PcgReport, Preconditioner};

/// Processes that solve one problem together, of which this is one. The vectors of all, one behind the other in the order of
/// their numbers, are one long vector.
///
/// Every method but [`number`](Self::number) and [`count`](Self::count) is called by all of them, in the same order; a process
/// that cannot go on ends all.
pub trait Ranks: Sync {
    /// The number of this one, from 0 on.
    fn number(&self) -> usize;

    /// How many they are.
    fn count(&self) -> usize;

    /// Overwrites numbers with those of the first process.
    fn broadcast(&self, values: &mut [f64]);

    /// Overwrites numbers with their sums over all processes, which are the same on all.
    fn sum(&self, values: &mut [f64]);

    /// Overwrites `all` of the first process with the long vector of the `own` parts; of others it may be empty.
    fn gather(&self, own: &[f64], all: &mut [f64]);

    /// The reverse of [`gather`](Self::gather).
    fn deal(&self, all: &[f64], own: &mut [f64]);

    /// What fetches entries of the long vector, by their places in it, of which `own` are kept here.
    fn halo(&self, own: usize, wanted: &[usize]) -> Box<dyn Halo + '_>;

    /// Solves `A x = b` by conjugate gradients from zero until the 2-norm of the residual has fallen as `options` ask; operator and
    /// preconditioner map the own parts of long vectors.
    fn conjugate_gradients(
        &self,
        operator: &dyn LinearOperator,
        preconditioner: &mut dyn Preconditioner,
        b: &[f64],
        x: &mut [f64],
        options: &PcgOptions,
    ) -> PcgReport;
}

/// What fetches entries of a long vector that other processes keep.
pub trait Halo: Sync {
    /// Overwrites `wanted` with the entries; `own` is the part of this process.
    fn fetch(&self, own: &[f64], wanted: &mut [f64]);
}
