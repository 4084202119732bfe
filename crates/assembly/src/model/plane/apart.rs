//! Bonds that never were, because nothing of the body lies between their points.

use super::near::near_points;
use super::neighbourhood::Neighbourhood;
use super::{Edges, Mirrors};
use crate::body::{Cell, Chains, SquareLattice, minus, parted_bonds, plus};
use crate::stiffness::Exception;
use std::collections::{BTreeMap, HashSet};

/// What parts the points of a lattice: bonds by index of their offset and lower point.
pub(super) struct Parted {
    /// Bonds that never were, sorted.
    pub(super) apart: Vec<(usize, usize)>,
    /// Bonds that cracks cut, and those across slots that a border does not part by itself.
    pub(super) cuts: HashSet<(usize, usize)>,
    /// All of them.
    pub(super) all: HashSet<(usize, usize)>,
}

impl Parted {
    /// That of a lattice with some edges, and bonds that cracks cut.
    pub(super) fn new<const M: usize>(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        neighbourhood: &Neighbourhood<M>,
        edges: Edges,
        cuts: &[(usize, usize)],
    ) -> Self {
        let offsets = &neighbourhood.offsets;
        let apart = apart_bonds(lattice, mirrors, offsets);
        let mut cuts: HashSet<(usize, usize)> = cuts.iter().copied().collect();
        // On whole cells bonds end where they leave them.
        let is_whole = lattice.blocks().is_empty() && lattice.slots().is_empty();
        if edges == Edges::Border && !is_whole {
            cuts.extend(across_slots(lattice, mirrors, offsets, &apart));
        }
        let all = cuts.iter().chain(&apart).copied().collect();
        Self { apart, cuts, all }
    }

    /// Some points and those of the bonds that never were, in order.
    pub(super) fn with_ends<const M: usize>(
        &self,
        lattice: &SquareLattice,
        neighbourhood: &Neighbourhood<M>,
        mut points: Vec<usize>,
    ) -> Vec<usize> {
        if self.apart.is_empty() {
            return points;
        }
        for &(k, lower) in &self.apart {
            let upper = plus(lattice.cell(lower), neighbourhood.offsets[k]);
            points.extend([Some(lower), lattice.number(upper)].into_iter().flatten());
        }
        points.sort_unstable();
        points.dedup();
        points
    }

    /// Those that never were of the offsets that have bonds.
    pub(super) fn gaps<const M: usize>(
        &self,
        neighbourhood: &Neighbourhood<M>,
    ) -> impl Iterator<Item = Exception> {
        let bonded = self.apart.iter().filter(|bond| neighbourhood.has_bonds(bond.0));
        bonded.map(|&(offset, lower)| Exception { offset, lower, factor: 0.0 })
    }
}

/// The bonds of a lattice that its body parts, images among them, by index of their offset and lower point, sorted.
pub(in super::super) fn apart_bonds(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    offsets: &[Cell],
) -> Vec<(usize, usize)> {
    let [apart, _] = parted(lattice, mirrors, offsets);
    apart
}

/// Those of some parted bonds that belong to slots: so many of them beside each other that they reach along three times the
/// longest one, or some between next points that a slot thinner than a cell parts. A border that cuts cells parts the rest of them by itself, and is exact for corners
/// that are not as deep as that.
fn across_slots(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    offsets: &[Cell],
    apart: &[(usize, usize)],
) -> Vec<(usize, usize)> {
    let is_open = is_open(lattice, mirrors);
    let reach = offsets.iter().flat_map(|o| o.map(i32::abs)).max().unwrap_or(0);
    let mut by_cell: BTreeMap<Cell, Vec<(usize, usize)>> = BTreeMap::new();
    apart.iter().for_each(|&bond| by_cell.entry(lattice.cell(bond.1)).or_default().push(bond));
    let mut found = Vec::new();
    while let Some((first, bonds)) = by_cell.pop_first() {
        let (mut together, mut last, mut box_of) = (bonds, vec![first], [first; 2]);
        while let Some(cell) = last.pop() {
            box_of = [0, 1].map(|side| {
                [0, 1, 2]
                    .map(|k| if side == 0 { box_of[0][k].min(cell[k]) } else { box_of[1][k].max(cell[k]) })
            });
            let around = (-1..=1).flat_map(|j| (-1..=1).map(move |i| plus(cell, [i, j, 0])));
            for next in around {
                if let Some(bonds) = by_cell.remove(&next) {
                    together.extend(bonds);
                    last.push(next);
                }
            }
        }
        let is_deep = minus(box_of[1], box_of[0]).iter().any(|side| *side >= 3 * reach);
        let is_thin = |&(k, lower): &(usize, usize)| {
            let cell = lattice.cell(lower);
            !is_open(cell, plus(cell, offsets[k]))
        };
        if is_deep || together.iter().any(is_thin) {
            found.extend(together);
        }
    }
    found
}

/// The points of parts one cell wide that keep bonds across what is beside them.
pub fn thin_points(lattice: &SquareLattice, mirrors: &Mirrors, offsets: &[Cell]) -> Vec<usize> {
    let [_, kept] = parted(lattice, mirrors, offsets);
    let has = has(lattice, mirrors);
    let chains = Chains { has: &has, is_open: &|_, _| true };
    let axes = if lattice.is_plane() { 2 } else { 3 };
    let ends = kept.iter().flat_map(|&(k, lower)| {
        let cell = lattice.cell(lower);
        [cell, plus(cell, offsets[k])]
    });
    let thin = ends.filter(|&cell| mirrors.is_real(cell) && chains.is_thin(cell, axes));
    let mut points: Vec<usize> = thin.filter_map(|cell| lattice.number(cell)).collect();
    points.sort_unstable();
    points.dedup();
    points
}

/// The bonds that a body parts, and those of them that thin parts keep.
fn parted(lattice: &SquareLattice, mirrors: &Mirrors, offsets: &[Cell]) -> [Vec<(usize, usize)>; 2] {
    if is_box(lattice) && lattice.slots().is_empty() {
        return [Vec::new(), Vec::new()];
    }
    let reach = offsets.iter().flat_map(|o| o.map(i32::abs)).max().unwrap_or(0);
    let (has, is_open) = (has(lattice, mirrors), is_open(lattice, mirrors));
    let chains = Chains { has: &has, is_open: &is_open };
    let mut near = near_points(lattice, reach);
    if !lattice.slots().is_empty() {
        near.extend(beside_slots(lattice, mirrors, reach + 1));
        near.sort_unstable();
        near.dedup();
    }
    parted_bonds(lattice, &chains, offsets, &near)
}

/// Points within some rows and columns of slots thinner than a cell, and of their images.
fn beside_slots(lattice: &SquareLattice, mirrors: &Mirrors, reach: i32) -> Vec<usize> {
    let around = || (-reach..=reach).flat_map(|j| (-reach..=reach).map(move |i| [i, j, 0]));
    let cells: HashSet<Cell> =
        lattice.slots().iter().flat_map(|slot| around().map(|step| plus(slot.0, step))).collect();
    let is_near = |cell: Cell| cells.contains(&cell) || cells.contains(&mirrors.image(cell).0);
    (0..lattice.points()).filter(|&point| is_near(lattice.cell(point))).collect()
}

/// Whether a lattice has a cell, stored or an image.
fn has<'a>(lattice: &'a SquareLattice, mirrors: &'a Mirrors) -> impl Fn(Cell) -> bool + 'a {
    move |cell| lattice.number(if mirrors.is_none() { cell } else { mirrors.image(cell).0 }).is_some()
}

/// Whether no slot parts two next cells; images are parted as their cells are, and a diagonal step over joined sides, of which no slot
/// is known, as the ways around its corners.
fn is_open<'a>(lattice: &'a SquareLattice, mirrors: &'a Mirrors) -> impl Fn(Cell, Cell) -> bool + 'a {
    let of_images = |from: Cell, to: Cell| lattice.is_open(mirrors.image(from).0, mirrors.image(to).0);
    move |from, to| {
        let [a, b] = [from, to].map(|cell| mirrors.image(cell).0);
        let goes_over = (0..2).any(|k| (a[k] - b[k]).abs() > 1);
        if !goes_over || from[0] == to[0] || from[1] == to[1] {
            return lattice.is_open(a, b);
        }
        let corners = [[to[0], from[1], from[2]], [from[0], to[1], from[2]]];
        corners.into_iter().any(|corner| of_images(from, corner) && of_images(corner, to))
    }
}

/// Pairs of cells that the body parts, beside bonds that it parts.
pub(in super::super) struct Apart<'a> {
    lattice: &'a SquareLattice,
    mirrors: &'a Mirrors,
    /// Cells of these bonds.
    ends: HashSet<Cell>,
}

impl<'a> Apart<'a> {
    /// Those beside the bonds of some offsets. The lattice has its images.
    pub(in super::super) fn new(
        lattice: &'a SquareLattice,
        mirrors: &'a Mirrors,
        offsets: &[Cell],
    ) -> (Self, Vec<[Cell; 2]>) {
        let ends = |(k, lower): (usize, usize)| {
            let cell = lattice.cell(lower);
            [cell, plus(cell, offsets[k])]
        };
        let bonds: Vec<[Cell; 2]> = apart_bonds(lattice, mirrors, offsets).into_iter().map(ends).collect();
        (Self { lattice, mirrors, ends: bonds.iter().flatten().copied().collect() }, bonds)
    }

    /// Whether the body parts two cells, of which one has lost a bond.
    pub(in super::super) fn parts(&self, from: Cell, to: Cell) -> bool {
        if !self.ends.contains(&from) && !self.ends.contains(&to) {
            return false;
        }
        let (has, is_open) = (has(self.lattice, self.mirrors), is_open(self.lattice, self.mirrors));
        let chains = Chains { has: &has, is_open: &is_open };
        from != to && !chains.join(from, minus(to, from), 2)
    }
}

/// Whether cells fill a box: then a bond lies in the body.
fn is_box(lattice: &SquareLattice) -> bool {
    let sides = [lattice.columns(), lattice.rows(), lattice.layers()];
    sides.iter().map(|side| side.len()).product::<usize>() == lattice.points()
}
