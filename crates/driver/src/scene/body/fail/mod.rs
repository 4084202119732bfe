//! How bodies break and soften.

pub(crate) mod elastic;
pub(crate) mod fracture;
pub(crate) mod path;
mod toughness;
