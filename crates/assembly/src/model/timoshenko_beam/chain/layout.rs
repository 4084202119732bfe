//! Which bonds a chain has, with which weight: ends, splits, ghosts and what covers make up for.

use super::super::end_treatment::EndKind;
use super::{ChainError, Grid, Line};
use crate::stiffness::{Override, Weights};
use std::collections::BTreeMap;

/// A line whose ends are decided, before it has bonds.
pub(super) struct Layout<'a> {
    pub(super) line: &'a Line,
    pub(super) points: usize,
    pub(super) ghosts: [usize; 2],
    pub(super) kinds: [EndKind; 2],
    pub(super) splits: bool,
}

impl Layout<'_> {
    /// Weights of all classes with their exceptions. `all` are those of an unbounded chain.
    pub(super) fn weights(&self, all: &[f64]) -> Result<Weights, ChainError> {
        let mut weights = all[..all.len().min(self.points - 1)].to_vec();
        let sum: f64 = all.iter().enumerate().map(|(k, a)| (k + 1) as f64 * a).sum();
        // What an interior cell lacks, for ratios that are not whole and for full volumes.
        let lack = if self.splits && (1.0 - sum).abs() > 1e-14 { 1.0 - sum } else { 0.0 };
        let base = weights[0] + lack;
        let lost = self.lost(all);
        let mut overrides = Vec::new();
        for lower in self.exceptional(weights.len()) {
            for step in 1..=weights.len() {
                let factor = self.factor(lower, step);
                let own = weights[step - 1];
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
                    overrides.push(Override { class: step - 1, lower, factor });
                }
            }
        }
        if base <= 0.0 {
            return Err(ChainError::NegativeWeight { weight: base });
        }
        weights[0] = base;
        let classes = weights.into_iter().enumerate().map(|(k, weight)| (k + 1, weight)).collect();
        let count = self.ghosts[0] + self.points + self.ghosts[1];
        Ok(Weights::new(count, classes, &overrides))
    }

    /// Lower points whose bonds may meet an end or a split, in order.
    fn exceptional(&self, reach: usize) -> Vec<usize> {
        let last = self.ghosts[0] + self.points + self.ghosts[1] - 1;
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
