//! The numbers of a vector: of 64 bits, or of 32 where a few digits do.

use crate::sums;
use std::fmt::Debug;
use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A number of 32 or 64 bits.
pub trait Real:
    Copy
    + Debug
    + Default
    + PartialEq
    + Send
    + Sync
    + Into<f64>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + 'static
{
    /// The nearest one to a number.
    fn of(number: f64) -> Self;

    /// `x . y`, summed in 64 bits.
    fn dot(x: &[Self], y: &[Self]) -> f64;
}

impl Real for f64 {
    #[inline]
    fn of(number: f64) -> Self {
        number
    }

    fn dot(x: &[Self], y: &[Self]) -> f64 {
        sums::dot(x, y)
    }
}

impl Real for f32 {
    #[inline]
    fn of(number: f64) -> Self {
        number as f32
    }

    fn dot(x: &[Self], y: &[Self]) -> f64 {
        x.iter().zip(y).map(|(x, y)| f64::from(*x) * f64::from(*y)).sum()
    }
}
