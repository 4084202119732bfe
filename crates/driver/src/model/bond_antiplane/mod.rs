//! The model `bond_antiplane`: plates of bonds in antiplane shear.

mod keys;
mod material;
mod resolve;
mod words;

pub use keys::Antiplane;

use super::entry::plain;
use super::{Entry, Growth, Place, Refusal, Start};
use peristat_assembly::model::bond_antiplane::{AntiplaneError, AntiplaneParameters};

/// Name in case files.
const NAME: &str = "bond_antiplane";

/// Bonds that resist shear across the plane, and the keys that they come from.
#[derive(Clone, Debug)]
struct ShearBonds {
    keys: Antiplane,
    parameters: AntiplaneParameters,
}

impl From<AntiplaneError> for Refusal {
    fn from(error: AntiplaneError) -> Self {
        let AntiplaneError::NoNeighbours { .. } = error;
        Self::new(&error, Place::Horizon)
    }
}

/// What can be chosen.
const OPTIONS: [(&str, &str); 2] = [
    (
        "edges border",
        "bonds end on the border: uniform shear is exact at free, held and loaded edges (default)",
    ),
    ("edges overlay", "triangles replace missing bonds"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "plate of bonds in antiplane shear: points move across the plane by w; cracks of mode III; influences and edges as bond_plane: rectangle, outline",
    bodies: &[("antiplane shear of a plate, K_III of given cracks", "bond_antiplane")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a sheared plate with a hole", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
