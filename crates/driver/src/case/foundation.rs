//! Winkler foundations of a case.

use super::Sign;
use peristat_assembly::material::Profile;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A Winkler foundation: it pushes back with `stiffness` times the deflection per length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Foundation {
    /// Member of a frame that it is under.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub member: Option<String>,
    /// Start; the left end of the body, or the joint `from` of the member, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub from: Option<f64>,
    /// End; the right end of the body, or the joint `to` of the member, if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub to: Option<f64>,
    /// Force per length and deflection, >= 0, by the distance s from the start of the foundation.
    pub stiffness: Profile,
    /// The only sign of the force with which it pushes: `positive` along w, as ground beneath a beam that is loaded downwards does.
    /// The beam lifts off it elsewhere.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub only: Option<Sign>,
}
