//! Scenes of plates in bending.

mod balance;
mod border;
mod clamped_stairs;
mod foreign;
mod foundation;
mod gravity;
mod heat;
mod held_line;
mod initial_curvature;
mod line_load;
mod line_probe;
mod loads;
mod materials;
mod motions;
mod plate_loads;
mod point_load;
mod pressure;
mod probes;
mod restraints;
mod scene;
mod site;
mod statics;
mod support_keys;
mod support_springs;
mod supports;
mod symmetry;
mod thickness;
mod warnings;

pub use held_line::HeldLine;
pub use line_probe::OnLine;
pub use materials::PlateMaterial;
pub use plate_loads::{Heat, PlateLoads};
pub use probes::{PlateProbe, PlateQuantity};
pub use restraints::PlateSupport;
pub use scene::PlateScene;
pub use thickness::Thickness;
