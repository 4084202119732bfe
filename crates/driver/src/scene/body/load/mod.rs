//! What loads a body.

pub(crate) mod asked;
pub(crate) mod body_force;
pub(crate) mod context;
pub(crate) mod eigenstrain;
mod initial_strain;
pub(crate) mod joined_sides;
pub(crate) mod load_cases;
mod mass;
pub(crate) mod point_load;
pub(crate) mod pressure;
pub(crate) mod rigid_moment;
pub(crate) mod stress_field;
pub(crate) mod sums;
pub(crate) mod temperature;
pub(crate) mod traction;
