//! Vectors of an implicit solver: what they are made of, and the loops over them.
//!
//! * [`Real`] is a number of 64 bits, or of 32 where a few digits do;
//! * [`vectorised`] runs a loop with the widest vectors that the processor has;
//! * [`dot`] sums products with an error that does not grow with their number;
//! * [`add`], [`subtract`], [`subtract_from`], [`extrapolate`] and [`advance`] change vectors, long ones by several threads.
//!
//! All results are the same on every machine and any number of threads: sums have a fixed order, and no multiplication is
//! fused with an addition.

mod lanes;
mod loops;
mod real;
mod sums;
mod vectorised;

pub use lanes::Lanes;
pub use loops::{add, advance, extrapolate, subtract, subtract_from};
pub use real::Real;
pub use sums::dot;
pub use vectorised::vectorised;
