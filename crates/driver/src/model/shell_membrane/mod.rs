//! The model `shell_membrane`: membranes of cylindrical shells of central bonds.

mod bearable;
mod keys;
mod material;
mod pressure;
mod resolve;
mod warn;
mod words;

pub use keys::Shell;
pub use pressure::{HoopPressure, Pressure};

use super::entry::plain;
use super::{Entry, Growth, Place, Refusal, Start};
use peristat_assembly::model::shell_membrane::{ShellError, ShellParameters};

/// Name in case files.
const NAME: &str = "shell_membrane";

/// Bonds of a developed cylinder and the keys that they come from.
#[derive(Clone, Debug)]
struct ShellBonds {
    keys: Shell,
    parameters: ShellParameters,
}

impl From<ShellError> for Refusal {
    fn from(error: ShellError) -> Self {
        let at = match error {
            ShellError::ShortHorizon { .. } => Place::Horizon,
            ShellError::NotRepresentable { .. }
            | ShellError::Around { .. }
            | ShellError::OutOfRange { .. } => Place::Key("radius"),
        };
        Self::new(&error, at)
    }
}

/// What can be chosen.
const OPTIONS: [(&str, &str); 5] = [
    ("kinematics chord", "elongations of straight lines in space: rigid motions are free (default)"),
    ("kinematics published", "elongations in the developed plane"),
    ("ends border", "bonds end on the border, which is held and loaded: exact in one stress (default)"),
    ("ends weights", "points beside ends have weights of their own, and the outermost are held"),
    ("bending", "rows that resist changes of the curvature of the circumference, for ovalling"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "membrane of a cylindrical shell of central bonds, ν = 1/3: a rectangle of length and arc, joined by periodic; calibrations as bond_plane",
    bodies: &[("thin tube, cylindrical panel", "shell_membrane")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a tube under pressure", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
