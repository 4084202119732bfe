//! Bonds of a solid that end on its border, as in the plane: what leaves the body is cut off there.
//!
//! A place on the border of a cube moves with the corners beside it, four on a face, and these with the nearest whole blocks of
//! eight points, continued linearly. Corners are found once, and bonds of the same offset and run of cells share the rest.
//!
//! Where points feel changes of volume, a point needs the elongations of all of its bonds. One that leaves the body has that of
//! its run from the point, `e ξ/|run|`, and half of the energy of a whole bond; runs without a point have none.

use super::super::plane::{Cells, End, LatticeBond, Mirrors, Mixture, Nodes, Run, around, for_each_part};
use super::bond::SolidBond;
use super::{SolidLaw, TENSOR};
use crate::body::{Cell, SquareLattice, minus};
use crate::bonds::{BondGeometry, BondModel, Mat};
use crate::stiffness::{Exception, NodedBonds, NodedBondsBuilder, NodedKind};
use std::borrow::Cow;
use std::collections::{BTreeMap, HashMap, HashSet};
use std::sync::Arc;

/// What completes the border of a solid.
#[derive(Clone, Debug)]
pub(super) struct Border {
    pub(super) bonds: Arc<NodedBonds<3, 1>>,
    /// Elongation of the bonds of every kind per unit of every uniform strain.
    pub(super) uniform: Vec<Mat<TENSOR, 1>>,
    /// Per kind of bonds.
    pub(super) wholes: Vec<Whole>,
    /// Bonds between points that give way to it.
    pub(super) gaps: Vec<Exception>,
    /// Rows of the dilatation of points that bonds on the border bring, by steps from them, per m.
    pub(super) rows: HashMap<usize, BTreeMap<Cell, [f64; 3]>>,
    /// What bonds of several materials leave to points: these, offsets, and weights.
    pub(super) lacks: Vec<(usize, usize, [f64; 1])>,
    /// Number of cells whose bonds are left out, because the body is too thin there to tell how they move.
    pub(super) lost: usize,
}

/// The whole bond that one which ends on the border is a part of.
#[derive(Clone, Copy, Debug)]
pub(super) struct Whole {
    /// Index of its offset.
    pub(super) offset: usize,
    /// Length of the part over its own.
    pub(super) share: f64,
    /// Modulus of the part over that of the base material.
    pub(super) factor: f64,
    /// Places of its cells on the path of the whole bond: of the first one, and behind the last.
    pub(super) pieces: [u8; 2],
}

/// What a point has of a bond that ends on the border.
#[derive(Clone, Copy)]
struct Part {
    /// The modulus of the point over that of the base material.
    own: f64,
    /// What the bond has of that.
    seen: f64,
}

impl Part {
    /// That of a point with a modulus and a bond with another.
    fn new(own: f64, of_bond: f64) -> Self {
        Self { own, seen: (of_bond / own).min(1.0) }
    }
}

/// A corner and, where there are cracks, the cell from which a bond comes.
type Asked = (Cell, Option<Cell>);

/// Builds them.
struct Builder<'a> {
    nodes: Nodes<'a, 1>,
    law: &'a SolidLaw,
    bond: SolidBond,
    bonds: NodedBondsBuilder<3, 1>,
    uniform: Vec<Mat<TENSOR, 1>>,
    wholes: Vec<Whole>,
    rows: HashMap<usize, BTreeMap<Cell, [f64; 3]>>,
    corners: HashMap<Asked, Option<u32>>,
    /// By offset, run, part of the energy and modulus.
    kinds: HashMap<(usize, [usize; 2], [u64; 2]), usize>,
    /// What a bond hangs on.
    hung: Vec<u32>,
}

impl Border {
    /// That of a body; `near` are the points within reach of its border.
    pub(super) fn new(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (law, bond): (&SolidLaw, SolidBond),
        near: &[usize],
        (cuts, mixture): (&HashSet<(usize, usize)>, Option<&Mixture>),
    ) -> Self {
        let cells =
            || Cells { lattice, mirrors, neighbourhood: &law.neighbourhood, cuts: Cow::Borrowed(cuts) };
        let mut builder = Builder {
            nodes: Nodes::new(cells()),
            law,
            bond,
            bonds: NodedBondsBuilder::new(lattice.points()),
            uniform: Vec::new(),
            wholes: Vec::new(),
            rows: HashMap::new(),
            corners: HashMap::new(),
            kinds: HashMap::new(),
            hung: Vec::new(),
        };
        let (mut lost, mut lacks) = (HashSet::new(), Vec::new());
        let gaps = for_each_part(&Nodes::new(cells()), near, &mut |offset, run, part| {
            let through = mixture.map(|mixture| mixture.through((lattice, mirrors), run.cells()));
            let added = match &law.dilatation {
                None => {
                    if let Some(through) = through {
                        let own = run.ends_of(mirrors).into_iter().zip(through.lacks);
                        let own = own.filter_map(|(cell, lack)| Some((lattice.number(cell?)?, lack)));
                        let own = own.filter(|own| own.1 != [0.0]);
                        let [weight] = law.neighbourhood.weights[offset];
                        let part = run.share() * weight;
                        lacks.extend(own.map(|(point, [lack])| (point, offset, [part * lack])));
                    }
                    let factor = through.map_or(1.0, |through| through.weights[0]);
                    builder.add(offset, run, (part * run.share(), factor))
                }
                Some(dilatation) => {
                    let whole = |own: u32| match (mixture, through) {
                        (Some(mixture), Some(through)) => {
                            Part::new(mixture.of(own as usize), through.weights[0])
                        }
                        _ => Part { own: 1.0, seen: 1.0 },
                    };
                    builder.add_sides(offset, run, (dilatation.shares[offset], &whole), &mut lacks)
                }
            };
            if added.is_none() {
                lost.insert(run.first());
            }
        });
        let Builder { bonds, uniform, wholes, rows, .. } = builder;
        let bonds = Arc::new(bonds.build());
        Self { bonds, uniform, wholes, gaps, rows, lacks, lost: lost.len() }
    }
}

impl Builder<'_> {
    /// Adds a run; `part` is its energy over that of its whole bond at the same stretch and modulus, `factor` its modulus over that of
    /// the base material. None where the body is too thin to tell how it moves.
    fn add(&mut self, offset: usize, run: &Run, (part, factor): (f64, f64)) -> Option<()> {
        let ends = [0, 1].map(|side| run.end(side, 3));
        self.hung.clear();
        ends.iter().try_for_each(|end| self.hang(end))?;
        let whole =
            BondGeometry { xi: self.nodes.cells.lattice.vector(self.law.neighbourhood.offsets[offset]) };
        let short = BondGeometry { xi: whole.xi.map(|x| run.share() * x) };
        let (bond, weight) = (self.bond, self.law.neighbourhood.weights[offset][0]);
        let (bonds, uniform, wholes) = (&mut self.bonds, &mut self.uniform, &mut self.wholes);
        let kind = *self
            .kinds
            .entry((offset, run.pieces(), [part, factor].map(f64::to_bits)))
            .or_insert_with(|| {
                let [elongation] = bond.in_uniform_state(&short);
                uniform.push(elongation.map(|e| [e]));
                wholes.push(Whole { offset, share: run.share(), factor, pieces: run.places() });
                let [modulus] = bond.moduli(&short);
                bonds.add_kind(NodedKind {
                    shares: ends.map(|end| match end {
                        End::Point(_) => Vec::new(),
                        End::Border(at, _) => around(at).map(|(_, share)| share).collect(),
                    }),
                    rows: bond.rows(&short).difference,
                    moduli: [part * factor * weight * modulus],
                })
            });
        self.bonds.push(kind, self.hung.iter().copied());
        Some(())
    }

    /// Adds a run as half of the whole bond of each real point that it begins or ends at, with its part of their dilatation; what
    /// it leaves of that through softer materials is what the point lacks.
    fn add_sides(
        &mut self,
        offset: usize,
        run: &Run,
        (share, part): (f64, &dyn Fn(u32) -> Part),
        lacks: &mut Vec<(usize, usize, [f64; 1])>,
    ) -> Option<()> {
        let cells = &self.nodes.cells;
        let spacing = cells.lattice.spacing();
        for side in [0, 1].into_iter().filter(|&side| run.has_points()[side]) {
            let (End::Point(own), End::Border(at, from)) = (run.end(side, 3), run.end(1 - side, 3)) else {
                continue;
            };
            let cells = &self.nodes.cells;
            let (true, Some(point)) = (cells.mirrors.is_real(own), cells.number(own)) else { continue };
            let Part { own: modulus, seen } = part(point);
            let away = if side == 0 { seen } else { -seen };
            let row = self.law.neighbourhood.offsets[offset]
                .map(|x| away * share / (spacing * run.share()) * f64::from(x));
            let shares = self.nodes.place(at, from)?;
            let rows = self.rows.entry(point as usize).or_default();
            for (cell, part) in shares.into_iter().filter(|of| of.0 != own) {
                let sum = rows.entry(minus(cell, own)).or_insert([0.0; 3]);
                (0..3).for_each(|c| sum[c] += part * row[c]);
            }
            self.add(offset, run, (0.5, modulus * seen))?;
            if seen < 1.0 {
                let [weight] = self.law.neighbourhood.weights[offset];
                lacks.push((point as usize, offset, [0.5 * modulus * (1.0 - seen) * weight]));
            }
        }
        Some(())
    }

    /// Adds the point or the nodes that an end hangs on to those of the bond; none where the body is too thin to tell.
    fn hang(&mut self, end: &End) -> Option<()> {
        let nodes = &self.nodes;
        let (at, from) = match *end {
            End::Point(cell) => {
                self.hung.push(nodes.cells.number(cell)?);
                return Some(());
            }
            End::Border(at, from) => (at, from),
        };
        for (corner, _) in around(at) {
            let asked = (corner, (!nodes.cells.cuts.is_empty()).then_some(from));
            let node = *self.corners.entry(asked).or_insert_with(|| {
                let shares = nodes.corner(corner, from)?;
                let numbered = |(cell, share)| Some((nodes.cells.number(cell)?, share));
                Some(self.bonds.add_node(shares.into_iter().map(numbered).collect::<Option<_>>()?))
            });
            self.hung.push(node?);
        }
        Some(())
    }
}
