//! Running bodies that break: brittle bonds, in quasi-static load steps.

mod breaking;
mod choice;
mod ending;
mod event;
mod forecast;
mod free_load;
mod islands;
mod ledger;
mod lost;
mod problem;
mod report;
mod steps;
#[cfg(test)]
mod tests;
mod unit;

pub use event::{BreakRestart, Event};
pub use forecast::{Forecast, forecast};
pub use problem::Facts;
pub use report::FractureReport;

pub(super) use free_load::FreeLoad;
pub(super) use problem::BreakingBody;
pub(super) use steps::run;
