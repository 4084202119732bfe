//! The model `plate_bending`: plates of Mindlin and Reissner in bending.

mod keys;
mod resolve;

pub use keys::Bending;

use super::entry::plain;
use super::{Entry, Growth, Start};

/// Name in case files.
const NAME: &str = "plate_bending";

/// What can be chosen.
const OPTIONS: [(&str, &str); 2] = [
    ("shear_law corrected", "bonds share shear so that thin plates do not lock (default)"),
    ("shear_law published", "one shear modulus per bond: locks in thin plates; for comparison"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "plate in bending with shear, thin or thick, any Poisson's ratio: deflections and rotations; slabs on walls, columns and soil: rectangle, outline",
    bodies: &[("plate in bending: slab, panel, floor", "plate_bending")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a slab on four walls", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
