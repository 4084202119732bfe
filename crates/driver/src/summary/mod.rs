//! The record of a run: what `summary.json` holds and `--json` prints.

mod beam;
mod body;
mod collector;
mod doubts;
mod estimate;
mod extremes;
mod model;
mod plate;
mod plate_forces;
mod state;
mod whole;
pub mod words;

pub use crate::model::MaterialSummary;
pub use beam::{BeamForces, BeamSummary};
pub use body::{BodyForces, BodySummary, RegionSummary, ValueSummary};
pub use collector::Collector;
pub use estimate::{Estimate, Estimates, Grids};
pub use extremes::{Extremes, Located};
pub use model::ModelSummary;
pub use plate::{PlateRegion, PlateSummary};
pub use plate_forces::{CornerForce, LineForces, PlateForces};
pub use state::{Forces, StateSummary};
pub use whole::{Status, Summary};
