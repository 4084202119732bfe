//! Conditions on the unknowns: one mechanism, `u = T q + g`, for everything that constrains.

mod constraints;

pub use constraints::{Constraints, Contradiction, Equation, Row, Unknown};
