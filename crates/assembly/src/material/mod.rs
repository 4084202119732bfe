//! Materials and cross-sections: what turns engineering data into stiffnesses.

mod section;

pub use section::{Section, SectionError, SectionProperties, ShearCorrection};
