//! Levels of a multigrid cycle that are coarser along one direction only, found from the matrix itself.
//!
//! A membrane stretches far less than it moves where its strains cancel each other: patterns that are fine across a
//! direction and smooth along it have next to no energy, and a lattice that is coarser in both directions does not know
//! them. Levels that keep all lines along that direction, and every second station on each, know them all:
//!
//! * the lines are interpolated linearly, each by itself, which gives `P`, and the next matrix is `Pᵀ A P`;
//! * unknowns of one station, across all lines, are smoothed together, by a factor of their own part of the matrix:
//!   across the direction their couplings are the stronger the coarser a level is.
//!
//! This is semicoarsening with line relaxation (Trottenberg, Oosterlee and Schüller, Multigrid, section 5.1).

mod interpolation;
mod matrix;
mod stations;

use crate::{FactorError, Hierarchy, Ordering, SparseCholesky};
use interpolation::interpolation;
use matrix::Matrix;
use sprs::CsMat;
use stations::StationFactors;

/// Where an unknown lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct LinePlace {
    /// Its place along the direction that is made coarser.
    pub station: u32,
    /// The line on which unknowns are interpolated from each other.
    pub line: u32,
}

/// The levels below a finest one, which is the business of the caller: level 0 of these is the next coarser. The last of them has a factor
/// alone.
pub struct Semicoarsening {
    /// Interpolation to every level that has a coarser one, the finest of all first.
    transfers: Vec<Matrix>,
    /// Their transposes.
    restrictions: Vec<Matrix>,
    /// All levels but the finest and the coarsest.
    levels: Vec<Level>,
    coarsest: usize,
}

/// A level between the finest and the coarsest.
struct Level {
    matrix: Matrix,
    stations: StationFactors,
}

impl Semicoarsening {
    /// Levels below the matrix whose lower triangle is given, and the factor of the coarsest: the first of these with at most `stations`.
    /// Unknowns without a place rest.
    ///
    /// # Errors
    /// [`FactorError`] if the part of a station or the coarsest matrix is not positive definite, or there is no memory.
    ///
    /// # Panics
    /// If `places` and the matrix differ in length.
    pub fn new(
        lower: CsMat<f64>,
        places: &[Option<LinePlace>],
        stations: u32,
    ) -> Result<(Self, SparseCholesky), FactorError> {
        assert_eq!(lower.rows(), places.len(), "a place for every unknown");
        let mut below = Self { transfers: vec![], restrictions: vec![], levels: vec![], coarsest: 0 };
        let (mut matrix, mut places) = (Matrix::symmetric(&lower), places.to_vec());
        // The matrices of the finest level are the largest: none is kept longer than needed.
        drop(lower);
        loop {
            let (transfer, coarse) = interpolation(&places);
            let restriction = transfer.transposed();
            let next = transfer.product_around(&restriction, &matrix);
            below.transfers.push(transfer);
            below.restrictions.push(restriction);
            if below.transfers.len() > 1 {
                let stations = StationFactors::new(&matrix, &places)?;
                below.levels.push(Level { matrix, stations });
            }
            (matrix, places) = (next, coarse.into_iter().map(Some).collect());
            let last = places.iter().flatten().map(|place| place.station).max().unwrap_or(0);
            let first = places.iter().flatten().map(|place| place.station).min().unwrap_or(0);
            if last - first < stations {
                break;
            }
        }
        below.coarsest = places.len();
        let lower = matrix.lower();
        let mut factor = SparseCholesky::analyse(&lower, Ordering::MinimumDegree)?;
        factor.refactor(&lower)?;
        Ok((below, factor))
    }

    /// Stored entries of all matrices and factors, without that of the coarsest.
    pub fn entries(&self) -> usize {
        let levels = self.levels.iter().map(|level| level.matrix.entries() + level.stations.entries());
        let transfers = self.transfers.iter().map(|transfer| 2 * transfer.entries());
        levels.chain(transfers).sum()
    }

    /// Writes over `coarse`, of level 0, what `fine` of the finest is there.
    pub fn restrict_finest(&self, fine: &[f64], coarse: &mut [f64]) {
        self.restrictions[0].multiply(fine, coarse);
    }

    /// Adds to `fine`, of the finest level, the interpolation of `coarse` of level 0.
    pub fn prolong_add_finest(&self, coarse: &[f64], fine: &mut [f64]) {
        self.transfers[0].multiply_add(coarse, fine);
    }
}

/// Products and smoothing are those of all levels but the last.
impl Hierarchy for Semicoarsening {
    type Real = f64;

    fn depth(&self) -> usize {
        self.transfers.len()
    }

    fn size(&self, level: usize) -> usize {
        self.levels.get(level).map_or(self.coarsest, |level| level.matrix.rows())
    }

    fn apply(&self, level: usize, x: &[f64], y: &mut [f64]) {
        self.levels[level].matrix.multiply(x, y);
    }

    fn smooth(&self, level: usize, scale: f64, r: &[f64], x: &mut [f64]) {
        self.levels[level].stations.add(scale, r, x);
    }

    fn restrict(&self, level: usize, fine: &[f64], coarse: &mut [f64]) {
        self.restrictions[level + 1].multiply(fine, coarse);
    }

    fn prolong_add(&self, level: usize, coarse: &[f64], fine: &mut [f64]) {
        self.transfers[level + 1].multiply_add(coarse, fine);
    }
}

#[cfg(test)]
mod tests;
