//! The model `axisymmetric`: isotropic bodies of revolution of state-based families.

mod keys;
mod resolve;

pub use keys::Axisymmetric;

use super::entry::plain;
use super::{Entry, Growth, Start};

/// Name in case files.
pub(super) const NAME: &str = "axisymmetric";

/// What can be chosen.
const OPTIONS: [(&str, &str); 7] = [
    ("edges ghosts", "points outside, moved by fits of those inside, complete every family (default)"),
    ("edges border", "bonds end on the border, and on the axis; for spheres and cones"),
    ("measure section", "neighbours count by their areas in the section (default)"),
    ("measure published", "neighbours count by the volumes of their rings"),
    ("axis table", "weights and radii that hold uniform stresses in equilibrium at the axis (default)"),
    ("axis images", "images across the axis alone: hoop strains beside it are up to 70 % wrong"),
    ("axis truncated", "families end at the axis: hoop strains beside it are about 17 % wrong"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "isotropic body of revolution of state-based families, any Poisson's ratio below 1/2: x is the radius, y the axis; volumes and forces are those of the whole ring: rectangle, outline; influences and dilatation as state_plane",
    bodies: &[("cylinder, sphere, shaft, Hertz pressure on a half space", "axisymmetric")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a bottle under pressure", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
