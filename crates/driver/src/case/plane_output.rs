//! What is reported of bodies in the plane, beside probes.

use super::{CrackName, Vector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// All fields along a straight line.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineOutput {
    /// Name, unique; part of the name of its file.
    pub name: String,
    /// First end.
    pub from: Vector,
    /// Second end.
    pub to: Vector,
    /// Number of positions, ends included, >= 2.
    pub points: usize,
}

/// The energy release rate G at tips of a crack as a stress intensity `√(E' G)`, from the energies of the crack made longer
/// and shorter by one spacing. It is a magnitude: K_I where loads open the crack symmetrically, `√(K_I² + K_II²)` where its
/// faces also slide; for faces that overlap it has no meaning. The last two are warned of. It is reported as a probe of
/// this name.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StressIntensity {
    /// Name, unique among probes.
    pub name: String,
    /// Name of the crack, or its number, the first is 1.
    pub crack: CrackName,
    /// Which of its tips are in the body; of cracks in the plane. In a solid it is the mean along the front of a `disc`: its rim, or the
    /// inner one of a ring.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tips: Option<Tips>,
}

/// Tips of a crack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Tips {
    /// The first position of its path.
    Start,
    /// The last position of its path.
    End,
    /// Both, moved together.
    Both,
}
