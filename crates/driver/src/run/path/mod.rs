//! Running bodies of bonds that soften: equilibrium paths beyond the peak.
//!
//! A path is followed by a control, one file each: steps of the load factor, from event to event, or steps of dissipated
//! energy. All solve with the same body and commit through the same course, which keeps the energies.

mod auto;
mod body;
mod classes;
mod control;
mod course;
mod displacement;
mod dissipation;
mod ending;
mod event;
mod facts;
mod kept;
mod newton;
mod point;
mod problem;
mod report;
mod steps;
mod tangent;
#[cfg(test)]
mod tests;

pub use kept::PathRestart;
pub use point::PathPoint;
pub use report::PathReport;

pub(super) use body::SofteningBonds;
pub(super) use problem::SofteningBody;
pub(super) use steps::run;
