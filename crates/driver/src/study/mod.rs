//! Convergence studies: many discretisations of one case, the orders at which their errors fall, and where their values go.
//!
//! A [`Study`] is what a file says; a [`Plan`] has its tasks, each a case with overrides; a [`Record`] is what a task finds
//! and the [`Store`] keeps it, so that a finished task is never solved again; [`Findings`] are what all records say
//! together. Nothing here prints.

mod check;
mod estimate;
mod expect;
mod faults;
mod file;
mod findings;
mod grid_error;
mod judge;
pub mod order;
mod plan;
mod record;
mod refined;
mod report;
mod settings;
mod solving;
mod store;
pub mod words;
mod write;

pub use estimate::EstimateEffort;
pub use faults::TaskFaults;
pub use file::{DeltaConvergence, Exact, Expect, JointConvergence, MConvergence, Refine, Study, Values};
pub use findings::{Findings, Level, Outcome, Quantity, Series};
pub use plan::{Plan, Task};
pub use record::{Measured, Record};
pub use solving::Solving;
pub use store::{Claimed, Store};
pub use write::write;
