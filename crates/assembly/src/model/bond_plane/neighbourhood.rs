//! Neighbours of a point of a lattice and the bonds to them.

use super::calibration::{matched, published};
use super::{BondPlaneError, Calibration, Edges, PlaneParameters, VolumeFactor};
use crate::body::Cell;

/// Square of the length of offsets that always can be sides of triangles, spacings: two rows and columns.
const NEXT: i32 = 8;

/// One of each pair of opposite offsets to the neighbours of a point.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Neighbourhood {
    /// Upwards, or to the right in the same row; those of the next two rows and columns always belong to it.
    pub(super) offsets: Vec<Cell>,
    /// `a`, Pa, per offset: the stiffness of a bond is `a V/ξ²` with the volume V of a point. None is negative.
    pub(super) weights: Vec<f64>,
    /// Part of the neighbour's volume that counts.
    pub(super) parts: Vec<f64>,
}

impl Neighbourhood {
    /// # Errors
    /// All of [`BondPlaneError`] that do not speak of clouds.
    pub(super) fn new(parameters: &PlaneParameters) -> Result<Self, BondPlaneError> {
        let offsets = half_offsets(reach_of(parameters));
        let (weights, parts) = match parameters.calibration {
            Calibration::Matched => {
                let weights = matched::weights(parameters, &offsets)?;
                let parts = weights.iter().map(|&a| f64::from(a > 0.0)).collect();
                (weights, parts)
            }
            Calibration::Published if parameters.edges == Edges::Overlay => {
                return Err(BondPlaneError::OverlayNeedsMatched);
            }
            Calibration::Published => published::weights(parameters, &offsets),
        };
        if weights.iter().all(|&a| a <= 0.0) {
            return Err(BondPlaneError::NoNeighbours { horizon_ratio: parameters.horizon_ratio });
        }
        let mut all = Self { offsets, weights, parts };
        all.retain();
        Ok(all)
    }

    /// Drops offsets without bonds.
    fn retain(&mut self) {
        let kept: Vec<usize> =
            (0..self.offsets.len()).filter(|&k| self.weights[k] > 0.0 || is_next(self.offsets[k])).collect();
        self.offsets = kept.iter().map(|&k| self.offsets[k]).collect();
        self.weights = kept.iter().map(|&k| self.weights[k]).collect();
        self.parts = kept.iter().map(|&k| self.parts[k]).collect();
    }

    /// Indices of the offsets that have bonds.
    pub(super) fn bonded(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.offsets.len()).filter(|&k| self.weights[k] > 0.0)
    }

    /// Largest offset of a bond, rows or columns.
    pub(super) fn reach(&self) -> i32 {
        self.bonded().flat_map(|k| self.offsets[k].map(i32::abs)).max().unwrap_or(0)
    }

    /// Index of the offset between two neighbours and which of them is the lower one.
    pub(super) fn between(&self, from: Cell, to: Cell) -> Option<(usize, bool)> {
        let [a, b] = [to[0] - from[0], to[1] - from[1]];
        let up = b > 0 || (b == 0 && a > 0);
        let step = if up { [a, b] } else { [-a, -b] };
        Some((self.offsets.iter().position(|o| *o == step)?, up))
    }
}

/// Offsets of all bonds that can exist, spacings.
fn reach_of(parameters: &PlaneParameters) -> f64 {
    let m = parameters.horizon_ratio;
    let beyond = match (parameters.calibration, parameters.volume_factor) {
        (Calibration::Published, VolumeFactor::Ramp) => 0.5,
        // Half a diagonal of a cell.
        (Calibration::Published, VolumeFactor::Area) => 0.75,
        _ => 0.0,
    };
    m + beyond
}

/// One of each pair of opposite offsets of at most `reach` spacings and those of the next
/// two rows and columns, row by row.
fn half_offsets(reach: f64) -> Vec<Cell> {
    let most = reach.floor().max(2.0) as i32;
    let inside = |[a, b]: Cell| f64::from(a * a + b * b) <= reach * reach * (1.0 + 1e-9);
    let all = (0..=most).flat_map(|b| (-most..=most).map(move |a| [a, b]));
    all.filter(|&step| step[1] > 0 || step[0] > 0).filter(|&s| inside(s) || is_next(s)).collect()
}

fn is_next([a, b]: Cell) -> bool {
    a * a + b * b <= NEXT
}

/// Length of an offset, spacings.
pub(super) fn length([a, b]: Cell) -> f64 {
    f64::from(a * a + b * b).sqrt()
}

/// `N = (n_x², n_y², n_x n_y)` of the direction of an offset: the stretch of a bond is `N·[ε_xx, ε_yy, γ_xy]`.
pub(super) fn direction_product([a, b]: Cell) -> [f64; 3] {
    let squared = f64::from(a * a + b * b);
    [f64::from(a * a) / squared, f64::from(b * b) / squared, f64::from(a * b) / squared]
}
