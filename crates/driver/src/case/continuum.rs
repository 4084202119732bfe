//! Whose solution the results are.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Whose solution the results are.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Continuum {
    /// That of the bonds, with their horizon.
    Nonlocal,
    /// That of local elasticity, which horizons that go to zero lead to: residuals of stresses of the fourth order correct that of
    /// the bonds.
    Local,
}
