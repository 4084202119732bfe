//! Tractions on borders.

pub(crate) mod add;
mod contact;
pub(crate) mod fading;
pub(crate) mod lump;
pub(crate) mod on_border;
pub(crate) mod on_wall;
pub(crate) mod profile;
pub(crate) mod resolve;
pub(crate) mod round;
pub(crate) mod slanted;
pub(crate) mod through_border;
pub(crate) mod uniform_stress;
mod wall_value;
