//! Scenes of plates in bending.

mod balance;
mod border;
mod clamped_stairs;
mod foreign;
mod foundation;
mod line_load;
mod loads;
mod motions;
mod plate_loads;
mod point_load;
mod pressure;
mod probes;
mod scene;
mod site;
mod statics;
mod support_keys;
mod supports;
mod symmetry;
mod warnings;

pub use plate_loads::PlateLoads;
pub use probes::{PlateProbe, PlateQuantity};
pub use scene::PlateScene;
pub use supports::PlateSupport;
