//! Numbers of 64 bits, and of 32 where a few digits do.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// What elements are evaluated in.
pub trait Number:
    Copy
    + Default
    + PartialEq
    + Send
    + Sync
    + std::fmt::Debug
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + 'static
{
    /// The nearest one.
    fn of(number: f64) -> Self;
}

impl Number for f64 {
    fn of(number: f64) -> Self {
        number
    }
}

impl Number for f32 {
    fn of(number: f64) -> Self {
        number as f32
    }
}
