//! Running bodies that break: brittle bonds, in quasi-static load steps.

mod event;
mod islands;
mod ledger;
mod problem;
mod steps;
mod unit;

pub use event::{Event, Restart};
pub use problem::{FACTS, Facts};
pub use steps::FractureReport;

pub(super) use problem::BreakingBody;
pub(super) use steps::run;
