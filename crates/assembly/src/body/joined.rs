//! Which bonds of a lattice lie in its body.
//!
//! A bond reaches across whatever is narrower than it, and so across slots of the body. One of an offset exists if its points
//! are joined by a chain of next cells inside the box of the offset widened by one cell, of at most `max(|a|, |b|, |c|) + 1`
//! steps; a diagonal step needs a cell beside it. So steps of a border and dimples one cell deep cost no bond, and round holes
//! keep all of theirs. Next neighbours are joined by their own step or not at all, but for those that a slot thinner than a cell
//! parts: they may have one step more, as others.
//!
//! Cells that belong to no block of four, in solids of eight, keep all of their bonds: single rows and the tips of wedges hang on
//! few others, and would fall off.

use super::lattice::{Cell, SquareLattice, plus};

/// Cells by which the box of an offset is widened, and steps that a chain may have more.
const SLACK: i32 = 1;

/// The cells of a body, and which next ones of them nothing parts.
pub(crate) struct Chains<'a> {
    /// Whether there is a cell, images among them.
    pub(crate) has: &'a dyn Fn(Cell) -> bool,
    /// Whether nothing thinner than a cell runs between two next cells that are there.
    pub(crate) is_open: &'a dyn Fn(Cell, Cell) -> bool,
}

/// The way of an offset along its axes, one cell after the other, and the box in which chains may go.
struct Ways {
    offset: Cell,
    /// Cells from the first point that are next to the line to the other, each beside the one before.
    stairs: Vec<Cell>,
    low: Cell,
    size: [usize; 3],
    /// Steps along its longest side, and those that a chain may have.
    far: i32,
    steps: i32,
}

impl Ways {
    /// Chains may leave the box by some cells, and have as many steps more than the bond.
    fn of(offset: Cell, axes: usize, slack: i32) -> Self {
        let far = offset.iter().map(|k| k.abs()).max().unwrap_or(0);
        let along = |k: usize| if k < axes { slack } else { 0 };
        let low = [0, 1, 2].map(|k| offset[k].min(0) - along(k));
        let size = [0, 1, 2].map(|k| (offset[k].max(0) + along(k) - low[k] + 1) as usize);
        Self { offset, stairs: stairs(offset), low, size, far, steps: far + slack }
    }

    fn index(&self, cell: Cell) -> Option<usize> {
        let at = [0, 1, 2].map(|k| (cell[k] - self.low[k]) as usize);
        let is_inside = (0..3).all(|k| cell[k] >= self.low[k] && at[k] < self.size[k]);
        is_inside.then(|| (at[2] * self.size[1] + at[1]) * self.size[0] + at[0])
    }
}

/// Cells beside each other from one to another one, as near to the line between them as they can be.
fn stairs(offset: Cell) -> Vec<Cell> {
    let (mut cell, mut all) = ([0; 3], Vec::new());
    while cell != offset {
        // The axis along which the least of the way is behind.
        let behind = |k: usize| (f64::from(cell[k].abs()) + 0.5) / f64::from(offset[k].abs());
        let axes = (0..3).filter(|&k| cell[k] != offset[k]);
        let Some(next) = axes.min_by(|&a, &b| behind(a).total_cmp(&behind(b))) else { break };
        cell[next] += offset[next].signum();
        all.push(cell);
    }
    all
}

impl Chains<'_> {
    /// Whether a chain joins a cell of a lattice of some axes to the one at an offset.
    pub(crate) fn join(&self, start: Cell, offset: Cell, axes: usize) -> bool {
        self.joins(start, &Ways::of(offset, axes, SLACK))
    }

    /// The same, for next cells too, by chains that may go further around: they may leave the box of the offset by some cells, and have
    /// as many steps more.
    pub(crate) fn join_around(&self, start: Cell, offset: Cell, axes: usize, slack: i32) -> bool {
        self.search(start, &Ways::of(offset, axes, slack))
    }

    /// Whether a chain joins the points of a bond; `start` is the cell of the first one.
    fn joins(&self, start: Cell, ways: &Ways) -> bool {
        if ways.far == 1 {
            let end = plus(start, ways.offset);
            let is_next = (self.has)(end) && self.is_beside(start, end);
            return is_next && ((self.is_open)(start, end) || self.search(start, ways));
        }
        let mut last = start;
        let beside = ways.stairs.iter().all(|step| {
            let (from, to) = (last, plus(start, *step));
            last = to;
            (self.has)(to) && (self.is_open)(from, to)
        });
        // Two steps beside each other are one diagonal step.
        beside || self.search(start, ways)
    }

    /// Whether a cell belongs to no block of four cells, in solids of eight.
    pub(crate) fn is_thin(&self, cell: Cell, axes: usize) -> bool {
        let blocks = 1 << axes;
        let side = |corner: usize, k: usize| if corner >> k & 1 == 0 { -1 } else { 1 };
        let is_whole = |corner: usize| {
            (1..blocks).all(|part: usize| {
                let step = [0, 1, 2].map(|k| if part >> k & 1 == 0 { 0 } else { side(corner, k) });
                (self.has)(plus(cell, step))
            })
        };
        !(0..blocks).any(is_whole)
    }

    fn search(&self, start: Cell, ways: &Ways) -> bool {
        let mut seen = vec![false; ways.size.iter().product()];
        let mut last = vec![[0; 3]];
        for _ in 0..ways.steps {
            let mut next = Vec::new();
            for from in last {
                for to in NEXT.iter().map(|step| plus(from, *step)) {
                    let Some(index) = ways.index(to).filter(|&index| !seen[index]) else { continue };
                    if self.leads(plus(start, from), plus(start, to)) {
                        if to == ways.offset {
                            return true;
                        }
                        seen[index] = true;
                        next.push(to);
                    }
                }
            }
            last = next;
        }
        false
    }

    /// Whether a step leads from a cell to a next one.
    fn leads(&self, from: Cell, to: Cell) -> bool {
        (self.has)(to) && (self.is_open)(from, to) && self.is_beside(from, to)
    }

    /// Whether cells beside each other lead from a cell to a next one that is there.
    fn is_beside(&self, from: Cell, to: Cell) -> bool {
        let axes = (0..3).filter(|&k| from[k] != to[k]);
        if axes.clone().count() < 2 {
            return true;
        }
        axes.into_iter().any(|axis| {
            let mut beside = from;
            beside[axis] = to[axis];
            (self.has)(beside) && self.is_beside(beside, to)
        })
    }
}

/// Steps to next cells, those of a plane first.
const NEXT: [Cell; 26] = next();

const fn next() -> [Cell; 26] {
    let (mut steps, mut count) = ([[0; 3]; 26], 0);
    let layers = [0, -1, 1];
    let mut k = 0;
    while k < 27 {
        let step = [k % 3 - 1, k / 3 % 3 - 1, layers[(k / 9) as usize]];
        if step[0] != 0 || step[1] != 0 || step[2] != 0 {
            steps[count] = step;
            count += 1;
        }
        k += 1;
    }
    steps
}

/// The bonds of a lattice that no chain of cells joins: for each the index of its offset in `steps` and its point at the near
/// end, sorted. `near` are the points within reach of a border, in order: others lose none. Those that thin parts keep are not
/// among the first, but the others.
pub(crate) fn parted_bonds(
    lattice: &SquareLattice,
    chains: &Chains,
    steps: &[Cell],
    near: &[usize],
) -> [Vec<(usize, usize)>; 2] {
    let axes = if lattice.is_plane() { 2 } else { 3 };
    let ways: Vec<Ways> = steps.iter().map(|&step| Ways::of(step, axes, SLACK)).collect();
    let mut found = [Vec::new(), Vec::new()];
    for &point in near {
        let cell = lattice.cell(point);
        for (k, way) in ways.iter().enumerate() {
            let other = plus(cell, way.offset);
            if lattice.number(other).is_some() && (chains.has)(other) && !chains.joins(cell, way) {
                let is_kept = [cell, other].iter().any(|end| chains.is_thin(*end, axes));
                found[usize::from(is_kept)].push((k, point));
            }
        }
    }
    found.iter_mut().for_each(|bonds| bonds.sort_unstable());
    found
}

#[cfg(test)]
mod tests;
