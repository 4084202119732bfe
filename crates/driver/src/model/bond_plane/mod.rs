//! The model `bond_plane`: isotropic plates and slices of central bonds.

mod bond_law;
mod critical;
mod keys;
mod material;
mod resolve;
mod soften;
mod words;

pub use bond_law::{BilinearLaw, PlaneBondLaw};
pub use keys::Plane;

use super::entry::plain;
use super::{Entry, Growth, Place, Refusal, Start};
use peristat_assembly::model::bond_plane::{BondPlaneError, PlaneParameters};

/// Central bonds and the keys that they come from.
#[derive(Clone, Debug)]
struct Central {
    keys: Plane,
    parameters: PlaneParameters,
    usual_horizon_ratio: f64,
}

impl From<BondPlaneError> for Refusal {
    fn from(error: BondPlaneError) -> Self {
        let at = match error {
            BondPlaneError::NotRepresentable { .. } | BondPlaneError::NoNeighbours { .. } => Place::Horizon,
            BondPlaneError::OverlayNeedsMatched => Place::Key("edges"),
            BondPlaneError::AreaNeedsCells => Place::Key("volume_factor"),
            BondPlaneError::Coincident { .. } => Place::Body,
        };
        Self::new(&error, at)
    }
}

/// What can be chosen.
const OPTIONS: [(&str, &str); 11] = [
    (
        "calibration matched",
        "bonds with which a lattice has the moduli of the material to rounding (default)",
    ),
    (
        "calibration published",
        "the constants of the continuum; moduli of a lattice are off by percents; with volume_factor full, clip, ramp, area",
    ),
    (
        "weights isotropic",
        "exact bonds without a direction in the sixth moment: errors inside are of the fourth order where no body force acts",
    ),
    ("influence constant", "ω = 1, how the stiffness of bonds depends on their length (default)"),
    ("influence inverse", "ω = δ/ξ"),
    ("influence linear", "ω = 1 − ξ/δ"),
    (
        "edges border",
        "bonds end on the border, or leave what they have to triangles that it cuts: uniform stresses and held edges are exact (default of matched)",
    ),
    ("edges overlay", "triangles replace missing bonds: exact for every uniform strain at every point"),
    ("edges none", "bonds beyond an edge are missing (default of published)"),
    ("edges volume", "bonds are stiffened by the volumes of the families of their ends"),
    ("edges energy", "bonds are stiffened by the energies of their ends in stretches along x and y"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: "bond_plane",
    about: "isotropic plate of central bonds, plane stress (ν = 1/3) or plane strain (ν = 1/4): rectangle, outline, points, mesh, and the specimens compact_tension, single_edge_bend, centre_cracked_panel",
    bodies: &[("plane stress or strain, ν = 1/3 or 1/4: holes, cracks, ductile bonds", "bond_plane")],
    options: || plain(&OPTIONS),
    starts: &[Start {
        name: "bond_plane",
        about: "a pulled plate with a hole",
        case: include_str!("start.json"),
    }],
    growth: Growth::Plane,
};
