//! How results are drawn.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How diagrams and maps of a run are drawn. Numbers in tables, probes and checks are as ever.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Drawing {
    /// Signs of M and V in the diagrams of beams and frames; default: `fields`.
    #[serde(default)]
    pub signs: Signs,
    /// How many isolines the maps of bodies in the plane have, about, >= 1, at most 50; they are at round values.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub isolines: Option<usize>,
    /// What arrows show on the maps of bodies in the plane.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arrows: Option<Arrows>,
    /// Formats in which every picture of `plots` is written beside its SVG.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub formats: Vec<PictureFormat>,
}

impl Drawing {
    /// Whether it asks for nothing.
    pub(super) fn is_usual(&self) -> bool {
        *self == Self::default()
    }
}

/// A format of pictures beside SVG.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PictureFormat {
    /// Pixels, two for each of the SVG's in both directions.
    Png,
    /// Lines, areas and text, sharp at every size.
    Pdf,
}

impl PictureFormat {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::Png, Self::Pdf];

    /// How the names of its files end.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Pdf => "pdf",
        }
    }
}

/// Signs of section forces in diagrams.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Signs {
    /// Those of the fields `M` and `V`.
    #[default]
    Fields,
    /// V > 0 where it turns a piece of the beam clockwise, as left of a load downwards. M > 0 upwards, where a beam sags.
    Structural,
    /// V as with `structural`; M of a line downwards, on the side in tension. Frames always have M there.
    TensionSide,
}

/// What arrows on a map show.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Arrows {
    /// Where points have moved, on the map of the displacement.
    Displacement,
    /// Principal stresses in the plane, on the map of the von Mises stress: outwards in tension, inwards in compression.
    PrincipalStress,
}

impl Signs {
    /// The factor of V in diagrams.
    pub fn of_shear(self) -> f64 {
        if self == Self::Fields { 1.0 } else { -1.0 }
    }

    /// What a diagram says of V.
    pub fn shear_note(self) -> &'static str {
        if self == Self::Fields { "" } else { ", clockwise positive" }
    }
}
