//! Materials of regions and of members of frames, as cases write them.

use super::{Expansion, Modulus, Names, Strengths};
use crate::model::Critical;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A material of some regions, or of some members of a frame. What it does not give is that of `model`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RegionMaterial {
    /// Name of a region whose points are of it, or of a member of a frame, or a list of several. Without `at` it is the material of
    /// all points of a body that no other one claims.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<Names>,
    /// Name of a material of the `library`: its moduli, `thermal_expansion` and, where a body has a weight, `density`, where none are
    /// given here.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub material: Option<String>,
    /// Young's modulus E, > 0. In a body it may vary: by a formula of x, y and z, or as a table.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub youngs_modulus: Option<Modulus>,
    /// Poisson's ratio ν of families, between −1 and 1/2.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub poisson_ratio: Option<f64>,
    /// Shear modulus G of a body in antiplane shear, which may vary as E does, or of members, > 0; without it that of members follows
    /// from E and the `poisson_ratio` of the model.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_modulus: Option<Modulus>,
    /// All moduli of a body with fibres over those of `model`, > 0, which may vary as E does.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stiffness_factor: Option<Modulus>,
    /// Angle of the fibres of a region of a body with fibres from x, counter-clockwise, degrees, from −360 to 360.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_angle: Option<f64>,
    /// Thickness of a region of a plate in bending, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thickness: Option<f64>,
    /// At which strains its bonds break, in bodies with `fracture`; default: as those of `model`, at the energy release rate or the
    /// stretch of `fracture.critical`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub critical: Option<Critical>,
    /// At which strains the bonds between it and other materials break; default: at the energy of the weaker of both. Of two
    /// materials that give one for their interface the weaker one counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub interface: Option<Critical>,
    /// Mass per volume of a region of a body, > 0, for `gravity` and `spin`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub density: Option<f64>,
    /// Stresses at which a region of a body fails, where they are other than the `strengths` beside `model`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub strengths: Option<Strengths>,
    /// Strain per kelvin, for `temperature`; of fibres `[along, across]` them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub thermal_expansion: Option<Expansion>,
}
