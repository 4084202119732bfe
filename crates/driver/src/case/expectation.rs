//! Probes and checks of a case.

use super::{At, FieldName};
use crate::reference::Field;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A value to report.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Name, unique.
    pub name: String,
    /// Where: a position on a beam, for reactions a point of its grid; a joint, a place in the plane or a region. M, V and N are those to its right, at the right
    /// end those to its left; of a region it is the mean of its points, of an edge of those half a spacing inside it, with `edge` on it; of reactions
    /// the sum. With `of` a region or a member, or left out for the whole body.
    #[serde(default, skip_serializing_if = "At::is_nowhere")]
    pub at: At,
    /// What.
    pub field: FieldName,
    /// What is made of the values at all points of a region, a member or the whole body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub of: Option<Reduction>,
}

/// What is made of the values of a field at many points. An extreme is that of the points, or of both ends of the cells of a
/// beam: nothing is extrapolated to an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Reduction {
    /// The largest value, and where it is.
    Largest,
    /// The smallest value, and where it is.
    Smallest,
    /// The largest magnitude, without its sign, and where it is.
    LargestMagnitude,
    /// The mean over the volume, along beams over the length.
    Mean,
    /// The integral over the volume, in the unit of the field times that of a volume; along beams over the length.
    Integral,
}

impl Reduction {
    /// Whether it finds a value at a place.
    pub fn is_extreme(self) -> bool {
        matches!(self, Self::Largest | Self::Smallest | Self::LargestMagnitude)
    }

    /// What it makes of a field in words, such as `largest ux`.
    pub fn words(self, field: &str) -> String {
        let before = match self {
            Self::Largest => "largest",
            Self::Smallest => "smallest",
            Self::LargestMagnitude => "largest magnitude of",
            Self::Mean => "mean",
            Self::Integral => "integral of",
        };
        format!("{before} {field}")
    }
}

/// What a result must be. A check is made on the last load step, on `load_case` if that is given.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Check {
    /// Agreement with a closed form at all points.
    ClosedForm(ClosedForm),
    /// Agreement of a probe with a number.
    Value(Value),
    /// A bound on a probe.
    Limit(Limit),
    /// Agreement of all points with a stored file.
    Baseline(Baseline),
    /// Agreement of all points of a body in the plane with an expression in their coordinates.
    Formula(Formula),
}

/// Agreement with a closed form.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ClosedForm {
    /// Name of the reference; `peristat list` has them all.
    pub name: String,
    /// Field that is compared.
    pub field: Field,
    /// Largest difference at any point, relative to the largest value of the reference.
    pub tolerance: f64,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// Agreement with a number.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Value {
    /// Name of the probe.
    pub probe: String,
    /// Expected value.
    pub expected: f64,
    /// Largest difference relative to the expected value; absolute if that is zero.
    pub tolerance: f64,
    /// Where the number comes from.
    pub source: String,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// A bound on a probe, on both sides of it where the field jumps: one of `at_most` and `at_least`.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Limit {
    /// Name of the probe.
    pub probe: String,
    /// Largest magnitude allowed, whatever the sign: 5 forbids -6, too.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_most: Option<f64>,
    /// Smallest value allowed, with its sign: -0.013 forbids -0.02 and allows 1.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub at_least: Option<f64>,
    /// Why, such as `L/250`.
    pub why: String,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// Agreement with a stored file.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Baseline {
    /// CSV file with columns `x` (`s` for a frame, `x` and `y` in the plane) and the field, relative to the case, in its folder or below: a file of the folder `fields` of an earlier run will do.
    pub file: String,
    /// Field that is compared.
    pub field: FieldName,
    /// Largest difference at any point, relative to the largest stored value.
    pub tolerance: f64,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}

/// Agreement with an expression in x and y, at all points of a body in the plane.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Formula {
    /// Field that is compared.
    pub field: FieldName,
    /// The exact value at (x, y), such as `1e-3*x - 2*y^2`: + - * / ^, parentheses, pi, e, sqrt, exp, log, log10, sin, cos,
    /// tan, asin, acos, atan, atan2(y, x), sinh, cosh, tanh, abs, min, max. `-x^2` is −(x²); powers of powers need parentheses.
    pub is: String,
    /// Largest difference at any point, relative to the largest value of the formula.
    pub tolerance: f64,
    /// Where the formula comes from.
    pub source: String,
    /// Load case or combination; the last step if not given.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub load_case: Option<String>,
}
