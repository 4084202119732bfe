//! The bonds of one point.

use crate::body::Cell;
use crate::bonds::Mat;

/// Offsets of half of the bonds of a point with their stiffnesses, N/m.
#[derive(Clone, Debug)]
pub struct Stencil {
    /// Offsets, cells.
    pub(super) steps: Vec<Cell>,
    /// `k n nᵀ`, N/m.
    pub(super) blocks: Vec<Mat<3, 3>>,
    /// `√k n`.
    pub(super) rows: Vec<[f64; 3]>,
    /// Stiffness times squared length, which counts where points lack bonds.
    pub(super) shares: Vec<f64>,
}

impl Stencil {
    /// Central bonds of these stiffnesses, N/m, at these offsets; one of every two opposite ones.
    pub fn new(bonds: impl IntoIterator<Item = (Cell, f64)>) -> Self {
        let mut stencil =
            Self { steps: Vec::new(), blocks: Vec::new(), rows: Vec::new(), shares: Vec::new() };
        for (step, stiffness) in bonds.into_iter().filter(|bond| bond.1 > 0.0) {
            let squared: f64 = step.iter().map(|k| f64::from(*k).powi(2)).sum();
            let row = step.map(|k| f64::from(k) * (stiffness / squared).sqrt());
            stencil.steps.push(step);
            stencil.blocks.push(row.map(|a| row.map(|b| a * b)));
            stencil.rows.push(row);
            stencil.shares.push(stiffness * squared);
        }
        stencil
    }

    /// Cells that bonds reach along an axis.
    pub(super) fn reach(&self) -> usize {
        self.steps.iter().flatten().map(|k| k.unsigned_abs() as usize).max().unwrap_or(0)
    }

    /// How much a point resists a displacement if all others rest, N/m.
    pub fn stiffness(&self) -> f64 {
        self.whole()[0][0]
    }

    /// The block of a point that has all bonds, N/m.
    pub(super) fn whole(&self) -> Mat<3, 3> {
        let mut sum = [[0.0; 3]; 3];
        for block in &self.blocks {
            (0..9).for_each(|k| sum[k / 3][k % 3] += 2.0 * block[k / 3][k % 3]);
        }
        sum
    }

    /// The same with all stiffnesses times a factor.
    pub(super) fn scaled(&self, factor: f64) -> Self {
        let bonds = self.steps.iter().zip(&self.shares).map(|(step, share)| {
            let squared: f64 = step.iter().map(|k| f64::from(*k).powi(2)).sum();
            (*step, factor * share / squared)
        });
        Self::new(bonds)
    }
}
