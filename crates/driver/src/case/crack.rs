//! Cracks that are there from the start.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A crack that is there from the start: it cuts the bonds that it meets, but those next to its ends (`crack_fronts`). In the plane it is a `path`; in a solid it is a surface, a
/// `disc`, a `polygon` or that of a `file`.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GivenCrack {
    /// Name; a crack without one is called by its number, the first is 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Positions from end to end, in the plane. A crack that opens an edge starts outside the body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub path: Option<Vec<[f64; 2]>>,
    /// A disc or a ring, in a solid.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub disc: Option<CrackDisc>,
    /// Corners of a plane polygon, in a solid. A crack that opens a face reaches beyond the body there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub polygon: Option<Vec<[f64; 3]>>,
    /// STL file of a surface, binary or ASCII, relative to the case, in its folder or below; it need not be closed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
}

/// Which bonds cracks cut next to their tips, in a solid next to their fronts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CrackFronts {
    /// None that cross a crack within a tenth of the horizon of its end: it acts as long as it is.
    Effective,
    /// All that cross a crack, as published models do: it acts 0.4 to 0.5 spacings longer than it is, and more in shear.
    Crossed,
}

/// A round crack.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CrackDisc {
    /// Its centre.
    pub centre: [f64; 3],
    /// A direction across it, of any length.
    pub normal: [f64; 3],
    /// Its radius, > 0.
    pub radius: f64,
    /// Radius of what stays whole in its middle: a crack all around a bar has a `radius` beyond it; 0 if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub inner_radius: Option<f64>,
}
