//! Strengths of the material, as cases write them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Stresses at which the material fails, for fields such as `utilisation`: those along and across fibres, or the `yield_stress` of a
/// material without. Nothing fails by them: they judge the stresses of an elastic body.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Strengths {
    /// Yield stress of a material without fibres, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub yield_stress: Option<f64>,
    /// Tensile strength along the fibres X_t, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_tension: Option<f64>,
    /// Compressive strength along the fibres X_c, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_compression: Option<f64>,
    /// Tensile strength across the fibres Y_t, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matrix_tension: Option<f64>,
    /// Compressive strength across the fibres Y_c, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matrix_compression: Option<f64>,
    /// Shear strength along and across the fibres S, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear: Option<f64>,
}

impl Strengths {
    /// X_t, X_c, Y_t, Y_c and S by their keys.
    pub fn of_fibres(&self) -> [(&'static str, Option<f64>); 5] {
        [
            ("fibre_tension", self.fibre_tension),
            ("fibre_compression", self.fibre_compression),
            ("matrix_tension", self.matrix_tension),
            ("matrix_compression", self.matrix_compression),
            ("shear", self.shear),
        ]
    }
}
