//! Why a state-based body cannot be made.

use thiserror::Error;

/// Why a state-based body cannot be made. Hints stand behind a semicolon.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum StateError {
    /// Rows of points do not hold each other.
    #[error(
        "a horizon of {0} spacings leaves rows of points free to move against each other; use 2 or more, such as 3"
    )]
    NoNeighbours(f64),
    /// A weight would be negative.
    #[error(
        "the edges `moment` need negative weights at {0} points, such as those of corners, and their stiffness is none; use `ghosts` or `moment_plus`"
    )]
    NegativeWeights(usize),
    /// What completes a border does not complete families.
    #[error("the border of this body does not complete families; use the edges `ghosts`")]
    NoBorder,
    /// The table of the axis would have negative weights.
    #[error(
        "next to the axis this horizon and this influence need negative weights; use the influence `linear`, or a horizon of 2 to 4 spacings"
    )]
    NegativeAxis,
    /// The table of the axis is that of full families.
    #[error(
        "the table of the axis needs full families at all edges, and those of this treatment are cut off; use the edges `ghosts`, or \"axis\": \"truncated\""
    )]
    AxisNeedsGhosts,
    /// The table of the axis is that of areas in the section.
    #[error(
        "the table of the axis is made for neighbours that count by their areas; use the measure `section`, or \"axis\": \"images\""
    )]
    AxisNeedsSection,
    /// Families beside what completes an edge would be of several materials.
    #[error("families of several materials are completed by ghosts of their own; use the edges `ghosts`")]
    MaterialsNeedGhosts,
    /// The lattice does not stand on the axis as it must.
    #[error(
        "the axis runs through cells; let the body begin at x = 0, or at a whole number of spacings from it"
    )]
    OffAxis,
}
