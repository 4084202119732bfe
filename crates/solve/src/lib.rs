//! Linear algebra of an implicit solver: direct factors of symmetric matrices, most
//! of them positive definite, and conjugate gradients preconditioned with them.
//!
//! Everything here is about vectors, symmetric matrices and linear maps; what the
//! numbers mean is the caller's business.
//!
//! * [`BandCholesky`] factors a band matrix in place, in time proportional to the
//!   order, for unknowns that form a chain;
//! * [`RepeatingCholesky`] does so for a band matrix of equal columns, in time and
//!   memory that do not depend on how often they repeat;
//! * [`SparseCholesky`] factors any other sparse matrix and keeps the symbolic
//!   analysis for the next matrix of the same pattern;
//! * [`SparseIndefinite`] factors one that need not be positive definite, in the same
//!   structure, and counts its negative eigenvalues;
//! * [`LowRank`] solves with a factored matrix that a few terms were added to or taken from;
//! * [`nested_dissection`] orders the unknowns of points in a plane so that it
//!   fills little, and [`DissectedCholesky`] factors the two halves of such an
//!   order side by side in two threads;
//! * [`choose`] says whether a band or a sparse factor suits a matrix, and why;
//! * [`Pcg`] finishes a direct solve whose matrix was rounded: the factor is the
//!   preconditioner and a [`LinearOperator`] that evaluates the products more
//!   accurately than the assembled matrix could is the truth;
//! * [`ReducedPcg`] solves with a matrix that differs from a factored one in a few unknowns, among which it iterates;
//! * [`Multigrid`] is a preconditioner for matrices too large to factor, given the levels of a [`Hierarchy`];
//! * [`Deflated`] adds to a preconditioner what it does not know of a few smooth vectors;
//! * [`Semicoarsening`] makes such levels from a matrix, coarser along one direction only;
//! * [`Ranks`] are processes that solve one problem together.
//!
//! All results are the same on every machine and any number of threads: sums have a
//! fixed order and no multiplication is fused with an addition. Long vectors are
//! dealt out to the threads of the current `rayon` pool.

mod band;
mod blocks;
mod choice;
mod deflated;
mod dissected;
mod dissection;
mod error;
mod hierarchy;
mod low_rank;
mod multigrid;
mod operator;
mod pcg;
#[cfg(test)]
mod plane;
mod ranks;
mod repeating;
mod semicoarsening;
mod sparse;

pub use band::{BandCholesky, BandMatrix};
pub use choice::{Method, Profile, choose};
pub use deflated::{Deflated, SmoothVectors};
pub use dissected::{DissectedCholesky, Reach};
pub use dissection::{Dissection, PointGraph, nested_dissection};
pub use error::FactorError;
pub use hierarchy::{Hierarchy, Relaxation};
pub use low_rank::LowRank;
pub use multigrid::{Multigrid, MultigridOptions};
pub use operator::{LinearOperator, Preconditioner};
pub use pcg::{Pcg, PcgOptions, PcgReport, PcgStatus, ReducedPcg};
pub use ranks::{Halo, Ranks};
pub use repeating::{Backward, Forward, RepeatingBand, RepeatingCholesky};
pub use semicoarsening::{LinePlace, Semicoarsening};
pub use sparse::{Ordering, SparseCholesky, SparseIndefinite};
