//! Scenes of bodies in the plane, in rooms: a room uses those before it.

pub(crate) mod site;

pub(crate) mod hold;

pub(crate) mod load;

pub(crate) mod read;

pub(crate) mod fail;

mod doubts;
mod hole_ring;
mod limit;
mod motions;
mod resolve;
mod scene;
mod statics;
#[cfg(test)]
mod tests;

pub use fail::fracture::BodyFracture;
pub use hold::conditions::Conditions;
pub use hold::held_edge::HeldEdge;
pub use hold::held_points::HeldPoints;
pub use hold::rigid::RigidPoints;
pub use hold::supported::BodySupport;
pub(crate) use hold::supported::CONTRADICTION;
pub use hole_ring::HoleRing;
pub(crate) use hole_ring::is_on;
pub(crate) use limit::LocalLimit;
pub use load::eigenstrain::{Eigenstrain, EigenstrainPart};
pub use load::sums::BodyLoads;
pub use read::checks::BodyComparison;
pub(in crate::scene) use read::checks::compare;
pub(crate) use read::fields::{Has, Says, of_points};
pub use read::intensities::Intensity;
pub(crate) use read::outputs::lines;
pub use read::outputs::{LinePoint, OutputLine};
pub use read::probes::{BodyProbe, Quantity};
pub use scene::{BodyScene, BodyState};
pub use site::cracks::NamedCrack;
pub use site::interpolate::Weights;
