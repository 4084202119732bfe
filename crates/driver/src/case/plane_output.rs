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

/// The energy release rate G at tips of a crack, from the energies of the crack made longer and shorter by one spacing, or a stress
/// intensity that follows from it; at a place of a front in a solid from how the faces part. Faces that overlap are warned of: G has no meaning for them. It is reported as a probe of this name.
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
    /// In a solid, the place of the front nearest to this position: of any crack, from how its faces part there.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at: Option<[f64; 3]>,
    /// What it is.
    #[serde(default)]
    pub quantity: TipQuantity,
}

/// What loads the tip of a crack.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum TipQuantity {
    /// The magnitude `√(E' G)`: K_I where loads open the crack symmetrically, `√(K_I² + K_II²)` where its faces slide, too, which is
    /// warned of; in antiplane shear K_III.
    #[default]
    K,
    /// K_I, of the opening at a place of a front in a solid, or of one tip in the plane: `√(E' G)` times the share of the opening in what the faces part by.
    #[serde(rename = "k_i")]
    KI,
    /// K_II, of their sliding. It is positive where the face on the left of the crack, seen towards the tip, slides towards the tip.
    #[serde(rename = "k_ii")]
    KII,
    /// K_III, of their sliding along the front, at a place of the front of a crack in a solid.
    #[serde(rename = "k_iii")]
    KIII,
    /// G, which is the J-integral of an elastic body.
    EnergyReleaseRate,
}

impl TipQuantity {
    /// Its name in case files; that of `√(E' G)` is the key.
    pub fn name(self) -> &'static str {
        match self {
            Self::K => "stress_intensity",
            Self::KI => "k_i",
            Self::KII => "k_ii",
            Self::KIII => "k_iii",
            Self::EnergyReleaseRate => "energy_release_rate",
        }
    }
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
