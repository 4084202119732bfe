//! Bonds of a solid that end on its border, as in the plane: what leaves the body is cut off there.
//!
//! A place on the border of a cube moves with the corners beside it, four on a face, and these with the nearest whole blocks of
//! eight points, continued linearly. Corners are found once, and bonds of the same offset and run of cells share the rest.

use super::super::plane::{Cells, End, LatticeBond, Mirrors, Neighbourhood, Nodes, around, for_each_part};
use super::TENSOR;
use super::bond::SolidBond;
use crate::body::{Cell, SquareLattice};
use crate::bonds::{BondGeometry, BondModel, Mat};
use crate::stiffness::{Exception, NodedBonds, NodedKind};
use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::sync::Arc;

/// What completes the border of a solid.
#[derive(Clone, Debug)]
pub(super) struct Border {
    pub(super) bonds: Arc<NodedBonds<3, 1>>,
    /// Elongation of the bonds of every kind per unit of every uniform strain.
    pub(super) uniform: Vec<Mat<TENSOR, 1>>,
    /// Bonds between points that give way to it.
    pub(super) gaps: Vec<Exception>,
    /// Number of cells whose bonds are left out, because the body is too thin there to tell how they move.
    pub(super) lost: usize,
}

/// A corner and, where there are cracks, the cell from which a bond comes.
type Asked = (Cell, Option<Cell>);

impl Border {
    /// That of a body; `near` are the points within reach of its border.
    pub(super) fn new(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (hood, bond): (&Neighbourhood<1>, &SolidBond),
        near: &[usize],
        cuts: &HashSet<(usize, usize)>,
    ) -> Self {
        let nodes = Nodes::new(Cells { lattice, mirrors, hood, cuts: Cow::Borrowed(cuts) });
        let (mut bonds, mut uniform, mut lost) =
            (NodedBonds::new(lattice.points()), Vec::new(), HashSet::new());
        let mut corners: HashMap<Asked, Option<u32>> = HashMap::new();
        let mut kinds: HashMap<(usize, [usize; 2], u64), usize> = HashMap::new();
        let gaps = for_each_part(&nodes, near, &mut |offset, run, part| {
            let ends = [0, 1].map(|side| run.end(side, 3));
            let Some(hung) = ends
                .iter()
                .map(|end| hung(&nodes, &mut bonds, &mut corners, end))
                .collect::<Option<Vec<_>>>()
            else {
                lost.insert(run.first());
                return;
            };
            let kind = *kinds.entry((offset, run.pieces(), part.to_bits())).or_insert_with(|| {
                let whole = BondGeometry { xi: lattice.vector(hood.offsets[offset]) };
                let short = BondGeometry { xi: whole.xi.map(|x| run.share() * x) };
                let [modulus] = bond.part_moduli(&whole, run.share());
                let [elongation] = bond.in_uniform_state(&short);
                uniform.push(elongation.map(|e| [e]));
                bonds.add_kind(NodedKind {
                    shares: ends.map(|end| match end {
                        End::Point(_) => Vec::new(),
                        End::Border(at, _) => around(at).map(|(_, share)| share).collect(),
                    }),
                    rows: bond.rows(&short).difference,
                    moduli: [part * hood.weights[offset][0] * modulus],
                })
            });
            bonds.push(kind, hung.into_iter().flatten());
        });
        Self { bonds: Arc::new(bonds), uniform, gaps, lost: lost.len() }
    }
}

/// The point or the nodes that an end hangs on; none where the body is too thin to tell.
fn hung(
    nodes: &Nodes<1>,
    bonds: &mut NodedBonds<3, 1>,
    known: &mut HashMap<Asked, Option<u32>>,
    end: &End,
) -> Option<Vec<u32>> {
    let (at, from) = match *end {
        End::Point(cell) => return Some(vec![nodes.cells.number(cell)?]),
        End::Border(at, from) => (at, from),
    };
    let mut node = |corner: Cell| {
        let asked = (corner, (!nodes.cells.cuts.is_empty()).then_some(from));
        *known.entry(asked).or_insert_with(|| {
            let shares = nodes.corner(corner, from)?;
            let numbered = |(cell, share)| Some((nodes.cells.number(cell)?, share));
            Some(bonds.add_node(shares.into_iter().map(numbered).collect::<Option<_>>()?))
        })
    };
    around(at).map(|(corner, _)| node(corner)).collect()
}
