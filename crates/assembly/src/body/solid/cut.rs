//! Parts that are cut out of blocks.

use thiserror::Error;

/// A part that is cut out of a block, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cut {
    /// A block.
    Block {
        /// Its lowest corner.
        from: [f64; 3],
        /// Its highest corner.
        to: [f64; 3],
    },
    /// A ball.
    Ball {
        /// Its middle.
        centre: [f64; 3],
        /// Its radius.
        radius: f64,
        /// Whether all but the ball is cut out.
        outside: bool,
    },
    /// A straight bore along an axis, through all of the block.
    Bore {
        /// The axis: 0 for x, 1 for y, 2 for z.
        axis: usize,
        /// A position in its middle.
        centre: [f64; 3],
        /// Its radius.
        radius: f64,
        /// Whether all but the bore is cut out, so that a cylinder is left.
        outside: bool,
    },
}

/// Why a cut is none.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum CutError {
    /// A radius is not above zero.
    #[error("`radius` must be greater than zero, found {found}")]
    Radius {
        /// What was given.
        found: f64,
    },
    /// A side has no length.
    #[error("`size` must be greater than zero, found {found}")]
    Size {
        /// Along which axis.
        axis: usize,
        /// What was given.
        found: f64,
    },
    /// A position is not finite.
    #[error("positions must be finite")]
    NotFinite,
}

impl Cut {
    /// # Errors
    /// [`CutError`].
    pub fn check(&self) -> Result<(), CutError> {
        let (positions, radius) = match *self {
            Self::Block { from, to } => {
                if let Some(axis) = (0..3).find(|&k| to[k] <= from[k]) {
                    return Err(CutError::Size { axis, found: to[axis] - from[axis] });
                }
                (vec![from, to], 1.0)
            }
            Self::Ball { centre, radius, .. } | Self::Bore { centre, radius, .. } => (vec![centre], radius),
        };
        if !(radius > 0.0 && radius.is_finite()) {
            return Err(CutError::Radius { found: radius });
        }
        match positions.iter().flatten().all(|x| x.is_finite()) {
            true => Ok(()),
            false => Err(CutError::NotFinite),
        }
    }

    /// Whether it cuts out all but a round body.
    pub(super) fn is_outside(&self) -> bool {
        matches!(self, Self::Ball { outside: true, .. } | Self::Bore { outside: true, .. })
    }

    /// Whether a position is inside, farther than `slack` from its border.
    pub(super) fn contains(&self, at: [f64; 3], slack: f64) -> bool {
        match *self {
            Self::Block { from, to } => (0..3).all(|k| from[k] + slack < at[k] && at[k] < to[k] - slack),
            Self::Ball { centre, radius, outside } => {
                is_beyond(distance(at, centre, None) - radius, outside, slack)
            }
            Self::Bore { axis, centre, radius, outside } => {
                is_beyond(distance(at, centre, Some(axis)) - radius, outside, slack)
            }
        }
    }
}

/// Whether a height above a round border is on the side that is cut out, farther than `slack` from the border.
fn is_beyond(height: f64, outside: bool, slack: f64) -> bool {
    if outside { height > slack } else { height < -slack }
}

/// Distance of two positions, or of their shadows along an axis.
fn distance(a: [f64; 3], b: [f64; 3], along: Option<usize>) -> f64 {
    let across = (0..3).filter(|&k| Some(k) != along);
    across.map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}
