//! Sections of a beam given by what they do instead of by their shape.

use peristat_assembly::material::Profile;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Stiffness of the sections of a line, by the distance s from its start.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Stiffness {
    /// Bending stiffness EI about the axis of the line (D₁₁ of a laminate), > 0.
    pub bending: Profile,
    /// Shear stiffness κGA, > 0.
    pub shear: Profile,
    /// Axial stiffness EA (A₁₁ of a laminate), > 0; needed in frames and with `coupling`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub axial: Option<Profile>,
    /// Coupling B₁₁ = −∫ E z dA of axial force and bending, z towards +w; zero about the neutral axis.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coupling: Option<Profile>,
    /// Area, if energy densities are wanted.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub area: Option<f64>,
    /// Height, if bending stresses are wanted: of a section of one material with the modulus `axial` / `area`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
}

/// A rectangle whose Young's modulus varies over its height as `E = E_bottom + (E_top − E_bottom)(z/h + 1/2)^p`, z from
/// mid-height towards +w; Poisson's ratio is the same everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PowerLaw {
    /// Width b, > 0.
    pub width: f64,
    /// Height h, > 0.
    pub height: f64,
    /// Young's modulus on the side of −w, > 0.
    pub bottom_modulus: f64,
    /// Young's modulus on the side of +w, > 0.
    pub top_modulus: f64,
    /// Exponent p, >= 0.
    pub exponent: f64,
}
