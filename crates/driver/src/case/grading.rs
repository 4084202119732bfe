//! Grids of cells of different lengths.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the cells of a line differ in length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", deny_unknown_fields)]
pub enum Grading {
    /// Every cell is longer than the one before it by the same factor.
    Geometric {
        /// Length of the last cell over that of the first, 1e-6 to 1e6.
        ratio: f64,
    },
    /// Cells grow by the same factor from both ends to the middle.
    BothEnds {
        /// Length of the middle cell over that of the end cells, 1e-6 to 1e6.
        ratio: f64,
    },
    /// The positions of all points, `cells` + 1 of them, from the left end to the right one.
    Positions(Vec<f64>),
}
