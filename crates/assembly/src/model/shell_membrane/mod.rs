//! Membranes of cylindrical shells: bonds on a cylinder that is developed into the plane, static and linear.
//!
//! A point at `(x, s)`, x along the axis and s = Rθ along the circumference, has the displacements u along x, v along s and w
//! outwards. A bond resists its elongation ([`ShellBond`]), the energy of a point is `W_i = ½ 3E Σ_j r_ij e_ij²` with
//! weights r, 1/m², so that a uniform strain has the energy of a membrane in plane stress with ν = 1/3, the only Poisson
//! ratio that such bonds have.
//!
//! A membrane does not resist inextensional motions `u = U(s), v = V(s) − x U'(s), w = R (x U''(s) − V'(s))`: its ends have
//! to prevent them ([`Inextensional`]), or rows of bending have to resist them ([`Curvature`]).

mod bending;
mod body;
mod bond;
mod ends;
mod error;
mod family;
mod fields;
mod inextensional;
mod motion;
mod parameters;
#[cfg(test)]
mod tests;
mod weights;

pub use bending::Curvature;
pub use body::ShellMembrane;
pub use bond::ShellBond;
pub use error::ShellError;
pub use inextensional::{EndConditions, Inextensional};
pub use parameters::{ShellEnds, ShellKinematics, ShellParameters};
