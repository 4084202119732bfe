//! The strain form of a straight chain: unknowns without rigid motions.
//!
//! Unknowns of a cell c between the points c and c + 1, of length h and middle x_c:
//!
//! ```text
//! θ_c = φ_{c+1} − φ_c          g_c = w_{c+1} − w_c − h (φ_c + φ_{c+1})/2
//! ```
//!
//! A bond over several cells measures `Δφ = Σ θ_c` and `ξγ + e Δφ = Σ [ g_c + (x̄ − x_c + e) θ_c ]`, x̄ its middle. The
//! stiffness `K = Σ α (k_φ a aᵀ + k_γ b bᵀ)` of these measures has the half bandwidth 2m − 1 and, scaled by its diagonal,
//! a condition number of 2 to 4 whatever the number of cells and the slenderness: nothing in it can move rigidly. Its
//! right-hand side is statics: `K v = (M_c, Q_c)`, moment in the middle of the cell and shear force of the cantilever
//! that is clamped at the first point and carries all loads and reactions ([`FromRight`]). Displacements are sums
//! ([`FromLeft`]). Supports come in by the force method ([`ForceMethod`]).
//!
//! Cells are numbered from the left; the matrix begins at the right end, so that its elimination runs along with the
//! sums of the loads and the back substitution along with those of the displacements.

mod checks;
mod force_method;
mod from_left;
mod from_right;
mod stiffness;
mod sums;
#[cfg(test)]
mod tests;

pub use checks::StrainChecks;
pub use force_method::{ForceMethod, Redundants, StrainSupport};
pub use from_left::FromLeft;
pub use from_right::{FromRight, Resultant};
pub use stiffness::StrainBand;

use super::chain::BondTable;
use super::{Chain, ChainLoads, Grid, TimoshenkoBeam};
use crate::sum::Sum;
use stiffness::Block;
use thiserror::Error;

/// Cells that the sums take at once: what they need of a block stays in the first level of the cache.
pub const STRAIN_BLOCK: usize = 512;

/// Why a body has no strain form.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum NoStrainForm {
    /// Several lines.
    #[error("the body has {0} lines")]
    Lines(usize),
    /// Points of which none lies on an end.
    #[error("the points lie in the middle of the cells")]
    Cells,
    /// Ghost points.
    #[error("ghost points continue the beam beyond its ends")]
    Ghosts,
}

/// A force or moment on a point beside the loads: a reaction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrainAction {
    /// Point.
    pub point: usize,
    /// What it acts on, [`W`](super::W) or [`PHI`](super::PHI).
    pub component: usize,
    /// Value, N or N m; the rounding of a reaction alone bends a redundant beam by more than that of its displacements.
    pub value: Sum,
}

/// The strain form of a body of one line.
#[derive(Clone, Debug)]
pub struct StrainForm<'a> {
    chain: &'a Chain,
    /// Columns of a cell all of whose bonds are ordinary, where all such cells are alike.
    ordinary: Option<Vec<Block>>,
}

impl<'a> StrainForm<'a> {
    /// The strain form of a body.
    ///
    /// # Errors
    /// [`NoStrainForm`] with the reason.
    pub fn new(beam: &'a TimoshenkoBeam) -> Result<Self, NoStrainForm> {
        let [chain] = beam.chains() else { return Err(NoStrainForm::Lines(beam.chains().len())) };
        if chain.line().grid == Grid::Cells {
            return Err(NoStrainForm::Cells);
        }
        if chain.ghosts != [0; 2] {
            return Err(NoStrainForm::Ghosts);
        }
        let mut form = Self { chain, ordinary: None };
        if chain.is_uniform() {
            form.ordinary = Some(form.ordinary_columns());
        }
        Ok(form)
    }

    /// Number of cells N.
    pub fn cells(&self) -> usize {
        self.chain.points - 1
    }

    /// Cells or points that a sweep takes at most.
    fn block(&self) -> usize {
        STRAIN_BLOCK.min(self.chain.points)
    }

    /// The line.
    pub fn chain(&self) -> &'a Chain {
        self.chain
    }

    /// Largest number of cells under a bond, m.
    pub fn reach(&self) -> usize {
        self.chain.weights.reach()
    }

    /// Distance of a point from the first one, m.
    pub fn distance(&self, point: usize) -> f64 {
        match &self.chain.line().stations {
            Some(_) => self.chain.position(point) - self.chain.position(0),
            None => point as f64 * self.chain.spacing,
        }
    }

    /// Overwrites `planes` by the forces of the loads on the points from `first` on. Near ends and splits this is done in
    /// small pieces: most of them are ordinary all the same.
    fn forces(&self, loads: &ChainLoads, first: usize, planes: [&mut [f64]; 2]) {
        let [force, couple] = planes;
        force.fill(0.0);
        couple.fill(0.0);
        let mut start = 0;
        for count in self.pieces(first, force.len()) {
            let (force, couple) = (&mut force[start..start + count], &mut couple[start..start + count]);
            loads.add_block(first + start..first + start + count, &mut [force, couple]);
            start += count;
        }
    }

    /// Cuts a range of `count` cells or points into pieces that are ordinary or small.
    fn pieces(&self, first: usize, count: usize) -> impl Iterator<Item = usize> + use<> {
        const SMALL: usize = 32;
        let (back, ahead) = (first.saturating_sub(self.reach()), first + count + self.reach());
        let whole = ahead <= self.cells() && self.are_ordinary(back, ahead);
        let most = if whole { count } else { SMALL };
        (0..count).step_by(most.max(1)).map(move |start| most.min(count - start))
    }

    /// Lengths of the cells from `first` on, m.
    fn widths(&self, first: usize, widths: &mut [f64]) {
        match &self.chain.bonds {
            BondTable::Uniform { .. } => widths.fill(self.chain.spacing),
            BondTable::Each { .. } if self.chain.line().stations.is_none() => widths.fill(self.chain.spacing),
            BondTable::Each { .. } => {
                let width = |c: usize| self.chain.position(c + 1) - self.chain.position(c);
                widths.iter_mut().enumerate().for_each(|(k, h)| *h = width(first + k));
            }
        }
    }
}
