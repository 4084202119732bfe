//! What acts one way: supports and foundations that push and do not pull, or the reverse; members that bear tension alone, or
//! compression.
//!
//! Such a part exerts a force of one sign on a motion s of the body, or none: with the sign σ, the value v that an equation prescribes
//! and the gap g it holds `s = v − σg` by a force p with `σp ≥ 0`, or `σ(s − v) + g ≥ 0` and `p = 0`.

use serde::{Deserialize, Serialize};

/// Something that acts one way.
#[derive(Clone, Copy, Debug)]
pub struct OneWay {
    /// What it is while it acts.
    pub part: Part,
    /// Sign of its force, 1 or −1.
    pub sign: f64,
    /// How far the motion may be passed before it acts; none of springs.
    pub gap: f64,
    /// What the case calls it.
    pub origin: Origin,
}

/// What acts one way, by its number in the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// An equation.
    Equation(usize),
    /// A spring to the ground.
    Spring(usize),
}

/// Where something that acts one way comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A held point, by its number in the scene.
    Support(usize),
    /// A foundation of the case.
    Foundation(usize),
    /// A member of a frame.
    Member(usize),
}

/// Kinds of what acts one way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum OneWayKind {
    /// Supports.
    Supports,
    /// Points above foundations.
    Foundation,
    /// Members of a frame.
    Members,
}

impl OneWayKind {
    /// All kinds.
    pub const ALL: [Self; 3] = [Self::Supports, Self::Foundation, Self::Members];

    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Self::Supports => "supports",
            Self::Foundation => "points on foundations",
            Self::Members => "members",
        }
    }
}

impl Origin {
    /// The kind.
    pub fn kind(self) -> OneWayKind {
        match self {
            Self::Support(_) => OneWayKind::Supports,
            Self::Foundation(_) => OneWayKind::Foundation,
            Self::Member(_) => OneWayKind::Members,
        }
    }
}
