//! One straight chain of points: which bonds it has, with which weight.

mod relations;

use super::end_treatment::{EndKind, EndSupport, EndTreatment};
use super::weights::{VolumeFactor, bond_weights};
use crate::stiffness::Override;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use thiserror::Error;

/// Where the points of a line lie.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Grid {
    /// `cells + 1` points with one on each end.
    #[default]
    Nodes,
    /// One point in the middle of each cell.
    Cells,
}

/// A straight line along x, as given.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Position of its left end, m.
    pub from: f64,
    /// Length, m.
    pub length: f64,
    /// Number of cells.
    pub cells: usize,
    /// Where the points lie.
    pub grid: Grid,
    /// Horizon over spacing, δ/h, >= 1.
    pub horizon_ratio: f64,
    /// Points, counted from the left, that no bond may span.
    pub splits: Vec<usize>,
    /// What holds the two ends.
    pub supports: [EndSupport; 2],
}

/// A chain that cannot be built.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum ChainError {
    /// The correction would need a bond with a negative weight.
    #[error(
        "the bonds between neighbours would need the weight {weight:.4}, and a stiffness must not be negative"
    )]
    NegativeWeight {
        /// The weight.
        weight: f64,
    },
}

/// A line with its bonds: classes, exceptions and ghost points.
#[derive(Clone, Debug)]
pub struct Chain {
    /// Real points.
    pub points: usize,
    /// Ghost points beyond the left and the right end.
    pub ghosts: [usize; 2],
    /// Position of the first real point, m.
    pub origin: f64,
    /// Distance of neighbours, m.
    pub spacing: f64,
    /// Weight α of the bonds over 1, 2, … spacings.
    pub weights: Vec<f64>,
    /// Bonds with another weight; lower points are counted from the first ghost.
    pub overrides: Vec<Override>,
    line: Line,
    kinds: [EndKind; 2],
    splits: bool,
}

impl Line {
    /// Number of points.
    pub fn points(&self) -> usize {
        match self.grid {
            Grid::Nodes => self.cells + 1,
            Grid::Cells => self.cells,
        }
    }

    /// Distance of neighbours, m.
    pub fn spacing(&self) -> f64 {
        self.length / self.cells as f64
    }

    /// Position of the first point, m.
    pub fn origin(&self) -> f64 {
        match self.grid {
            Grid::Nodes => self.from,
            Grid::Cells => self.from + 0.5 * self.spacing(),
        }
    }
}

impl Chain {
    /// Bonds of a line.
    ///
    /// # Errors
    /// [`ChainError`] where a weight would be negative.
    pub fn new(line: Line, factor: VolumeFactor, treatment: &EndTreatment) -> Result<Self, ChainError> {
        let points = line.points();
        let all = bond_weights(line.horizon_ratio, factor);
        let weights = all[..all.len().min(points - 1)].to_vec();
        let reach = weights.len();
        let kinds = [0, 1].map(|side| (treatment.end)(&line.supports[side]));
        let ghosts = kinds.map(|kind| match (kind, line.grid) {
            (EndKind::Covered | EndKind::Truncated, _) => 0,
            (_, Grid::Nodes) => reach - 1,
            (_, Grid::Cells) => reach,
        });
        let mut chain = Self {
            points,
            ghosts,
            origin: line.origin(),
            spacing: line.spacing(),
            weights,
            overrides: Vec::new(),
            kinds,
            splits: treatment.splits,
            line,
        };
        chain.correct(&all)?;
        Ok(chain)
    }

    /// How the two ends are treated.
    pub fn ends(&self) -> [EndKind; 2] {
        self.kinds
    }

    /// Points with ghosts.
    pub fn extended(&self) -> usize {
        self.ghosts[0] + self.points + self.ghosts[1]
    }

    /// Position of an extended point, m.
    pub fn position(&self, point: usize) -> f64 {
        self.origin + (point as f64 - self.ghosts[0] as f64) * self.spacing
    }

    /// The line as given.
    pub fn line(&self) -> &Line {
        &self.line
    }

    /// Sets class weights and overrides. `all` are the weights of an unbounded chain.
    fn correct(&mut self, all: &[f64]) -> Result<(), ChainError> {
        let sum: f64 = all.iter().enumerate().map(|(k, a)| (k + 1) as f64 * a).sum();
        // What an interior cell lacks, for ratios that are not whole and for full volumes.
        let lack = if self.splits && (1.0 - sum).abs() > 1e-14 { 1.0 - sum } else { 0.0 };
        let base = self.weights[0] + lack;
        let lost = self.lost(all);
        for lower in self.exceptional() {
            for step in 1..=self.weights.len() {
                let factor = self.factor(lower, step);
                let own = self.weights[step - 1];
                let (weight, usual) = if step == 1 && factor != 0.0 && self.is_real(lower, 1) {
                    let lost = lost.get(&(lower as isize)).copied().unwrap_or(0.0);
                    (own * factor + lack + lost, base)
                } else {
                    (own * factor, if step == 1 { base } else { own })
                };
                if weight < 0.0 {
                    return Err(ChainError::NegativeWeight { weight });
                }
                if weight != usual {
                    let factor = weight / usual;
                    self.overrides.push(Override { class: step - 1, lower, factor });
                }
            }
        }
        if base <= 0.0 {
            return Err(ChainError::NegativeWeight { weight: base });
        }
        self.weights[0] = base;
        Ok(())
    }

    /// Lower points whose bonds may meet an end or a split, in order.
    fn exceptional(&self) -> Vec<usize> {
        let reach = self.weights.len();
        let last = self.extended() - 1;
        let ends = [self.ghosts[0], self.ghosts[0] + self.points - 1];
        let splits = self.line.splits.iter().filter(|_| self.splits).map(|s| s + self.ghosts[0]);
        let around = |b: usize| b.saturating_sub(reach)..=(b + reach).min(last);
        let mut all: Vec<usize> = ends.into_iter().chain(splits).flat_map(around).collect();
        all.sort_unstable();
        all.dedup();
        all
    }

    fn is_real(&self, lower: usize, step: usize) -> bool {
        lower >= self.ghosts[0] && lower + step < self.ghosts[0] + self.points
    }

    fn spans_split(&self, i: isize, j: isize) -> bool {
        // Splits are sorted, so a long beam with many of them stays cheap.
        let splits = &self.line.splits;
        let next = splits.partition_point(|&s| s as isize <= i);
        self.splits && splits.get(next).is_some_and(|&s| (s as isize) < j)
    }

    /// Factor of a bond from the treatment of the ends, without top-up.
    fn factor(&self, lower: usize, step: usize) -> f64 {
        let n = self.points as isize;
        let i = lower as isize - self.ghosts[0] as isize;
        let j = i + step as isize;
        if self.is_real(lower, step) {
            if self.spans_split(i, j) {
                return 0.0;
            }
            let half = |side: usize, touches: bool| {
                let on_end = touches && self.line.grid == Grid::Nodes;
                if on_end && self.kinds[side] == EndKind::Truncated { 0.5 } else { 1.0 }
            };
            return half(0, i == 0) * half(1, j == n - 1);
        }
        // A bond crosses an end if exactly one point is a ghost; bonds that touch a point on the end are ordinary.
        let side = match (i < 0, j >= n) {
            (true, false) if j > 0 || (j == 0 && self.line.grid == Grid::Cells) => 0,
            (false, true) if i < n - 1 || (i == n - 1 && self.line.grid == Grid::Cells) => 1,
            _ => return 0.0,
        };
        match self.kinds[side] {
            EndKind::Mirrored => 0.5,
            EndKind::Continued => 1.0,
            EndKind::Covered | EndKind::Truncated => 0.0,
        }
    }

    /// Weight that cells lack because bonds stop at a covered end or a split, by the extended point below the cell.
    fn lost(&self, all: &[f64]) -> BTreeMap<isize, f64> {
        let n = self.points as isize;
        let reach = all.len() as isize;
        let splits = self.line.splits.iter().filter(|_| self.splits).map(|&s| s as isize);
        // Bonds that an unbounded chain would have and this one has not, by difference at the cells they cross.
        let mut difference: BTreeMap<isize, f64> = BTreeMap::new();
        let mut lowers: Vec<isize> =
            [0, n - 1].into_iter().chain(splits).flat_map(|b| b - reach..=b).collect();
        lowers.sort_unstable();
        lowers.dedup();
        for i in lowers {
            for (k, weight) in all.iter().enumerate() {
                let j = i + k as isize + 1;
                let gone = (i < 0 && self.kinds[0] == EndKind::Covered)
                    || (j >= n && self.kinds[1] == EndKind::Covered)
                    || self.spans_split(i, j);
                if gone {
                    *difference.entry(i).or_default() += weight;
                    *difference.entry(j).or_default() -= weight;
                }
            }
        }
        let mut lost = 0.0;
        let mut cells = BTreeMap::new();
        let mut previous = None;
        for (cell, change) in difference {
            if let Some(previous) = previous {
                (previous..cell).for_each(|c| _ = cells.insert(c + self.ghosts[0] as isize, lost));
            }
            lost += change;
            // What is left of a cancelled sum is no loss.
            if lost.abs() < 1e-14 {
                lost = 0.0;
            }
            previous = Some(cell).filter(|_| lost != 0.0);
        }
        cells
    }
}
