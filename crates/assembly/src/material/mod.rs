//! Materials and cross-sections: what turns engineering data into stiffnesses.

mod profile;
mod rolled;
mod section;
mod stiffness;

pub use profile::Profile;
pub use rolled::Rolled;
pub use section::{Section, SectionError, SectionProperties, ShearCorrection};
pub use stiffness::{Compliance, SectionStiffness};
