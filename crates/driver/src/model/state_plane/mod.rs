//! The model `state_plane`: isotropic plates and slices of state-based families.

mod keys;
mod resolve;

pub use keys::StatePlane;

use super::entry::plain;
use super::{Entry, Growth, Start};

/// Name in case files.
const NAME: &str = "state_plane";

/// What can be chosen.
const OPTIONS: [(&str, &str); 12] = [
    ("influence linear", "ω = 1 − ξ/δ, how the weight of neighbours depends on their distance (default)"),
    ("influence inverse", "ω = δ/ξ"),
    ("influence constant", "ω = 1"),
    (
        "edges ghosts",
        "points outside, moved by fits of those inside, complete every family (default on whole cells)",
    ),
    (
        "edges border",
        "bonds end on the border, or leave what they have to triangles that it cuts: uniform stresses and held edges are exact (default where a border cuts cells)",
    ),
    (
        "edges moment_plus",
        "weights exact for every uniform strain in what is left of a family; points that would need negative ones give their energy away",
    ),
    ("edges moment", "the same, refused where a weight would be negative, such as at corners"),
    ("edges calibrated", "families are weighed by the neighbours that are there: moduli percents off"),
    ("edges none", "families are weighed as if they were whole: moduli percents off"),
    ("dilatation points", "every point measures its change of volume (default for ν <= 0.45)"),
    (
        "dilatation blocks",
        "means over blocks of two by two points, so that nothing locks near ν = 1/2 (default in plane strain for ν > 0.45)",
    ),
    (
        "Poisson's ratio 1/3",
        "in plane stress needs bonds alone, as does 1/4 in plane strain: no families are made",
    ),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "isotropic plate of state-based families, plane stress or plane strain, any Poisson's ratio below 1/2: rectangle, outline",
    bodies: &[("plane stress or strain, any Poisson's ratio: holes, cracks", "state_plane")],
    options: || plain(&OPTIONS),
    starts: &[Start {
        name: NAME,
        about: "a pressed rubber block with a hole",
        case: include_str!("start.json"),
    }],
    growth: Growth::Families,
};
