//! Parts of the change of volume that belong to no family, or to one that is not whole.
//!
//! A bond with the weight a and the stretch s has the part `a s/(8μ)` of the dilatation of either of its points. What a border
//! has in place of missing bonds, runs of bonds or triangles, has the same per stretch for both, and belongs to no point yet.
//! What is close together and has about one direction is one source: points then can take of one direction more on their left
//! and of another more on their right, as the borders of bodies want it.

use super::super::super::bond_plane::CentralBond;
use super::super::super::plane::LatticeBody;
use crate::body::Cell;
use std::collections::BTreeMap;

/// The bonds of a state-based body with `λ = μ`.
pub(in super::super) type Bonded = LatticeBody<2, 1, 3, CentralBond>;

/// Parts of a change of volume, `Σ rows·u`, with the tensor t of them: in a strain E it is `t : E`. Volumes are in cells.
#[derive(Clone, Debug, Default)]
pub(super) struct Source {
    /// Where it is, in cells.
    pub(super) at: [f64; 2],
    /// `[t_xx, t_yy, t_xy]`; half of the trace is its volume.
    pub(super) tensor: [f64; 3],
    /// Points and the coefficients of their displacements, 1/m.
    pub(super) rows: BTreeMap<u32, [f64; 2]>,
}

impl Source {
    /// Its volume.
    pub(super) fn volume(&self) -> f64 {
        0.5 * (self.tensor[0] + self.tensor[1])
    }

    /// Adds the coefficients of a point.
    pub(super) fn add_row(&mut self, point: u32, row: [f64; 2]) {
        add(&mut self.rows, point, row);
    }

    /// Adds a part of another one.
    fn join(&mut self, part: f64, other: &Self) {
        let (own, theirs) = (self.volume(), part * other.volume());
        (0..2).for_each(|k| self.at[k] = (own * self.at[k] + theirs * other.at[k]) / (own + theirs));
        (0..3).for_each(|q| self.tensor[q] += part * other.tensor[q]);
        other.rows.iter().for_each(|(&point, row)| self.add_row(point, row.map(|r| part * r)));
    }
}

/// Adds the coefficients of a point to rows.
pub(super) fn add(rows: &mut BTreeMap<u32, [f64; 2]>, point: u32, row: [f64; 2]) {
    let own = rows.entry(point).or_default();
    (0..2).for_each(|c| own[c] += row[c]);
}

/// What sources have in common that are one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kind {
    /// Bonds between a point and others.
    Bonds,
    /// What completes the border, by the cell or the block where it begins.
    Border,
    /// Something by itself.
    Single(usize),
}

/// The direction of all that has many.
pub(super) const ANY: Cell = [1, 1, 0];

/// Sources by kind, cell and direction.
#[derive(Clone, Debug, Default)]
pub(super) struct Sources {
    found: BTreeMap<(Kind, Cell, usize), Source>,
}

impl Sources {
    /// Adds a source of a direction, in the axes of the lattice.
    pub(super) fn add(&mut self, kind: Kind, cell: Cell, direction: Cell, source: &Source) {
        for (sector, part) in sectors(direction) {
            self.found.entry((kind, cell, sector)).or_default().join(part, source);
        }
    }

    /// All of them.
    pub(super) fn list(self) -> Vec<Source> {
        self.found.into_values().collect()
    }
}

/// The quarters of all directions, nearer to the rows or to the columns and with or against the diagonal, that one belongs to, and
/// its parts in them.
fn sectors([a, b, _]: Cell) -> Vec<(usize, f64)> {
    let choice = |first: i32, second: i32| match first.cmp(&second) {
        std::cmp::Ordering::Greater => vec![(0, 1.0)],
        std::cmp::Ordering::Less => vec![(1, 1.0)],
        std::cmp::Ordering::Equal => vec![(0, 0.5), (1, 0.5)],
    };
    let (rows, rises) = (choice(a.abs(), b.abs()), choice(a * b, 0));
    let both = |&(row, part): &(usize, f64)| {
        rises.iter().map(move |&(rise, other)| (2 * row + rise, part * other)).collect::<Vec<_>>()
    };
    rows.iter().flat_map(both).collect()
}
