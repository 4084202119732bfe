//! What holds a body.

pub(crate) mod bearing_keys;
pub(crate) mod conditions;
mod corners;
pub(crate) mod held_body;
pub(crate) mod held_border;
pub(crate) mod held_edge;
pub(crate) mod held_points;
pub(crate) mod rigid;
pub(crate) mod rigid_keys;
pub(crate) mod rigid_mirror;
pub(crate) mod support_keys;
mod support_parts;
pub(crate) mod supported;
pub(crate) mod supports;
