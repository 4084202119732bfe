//! Bonds between points and nodes: places that many bonds share and that move as weighted means of points.
//!
//! A node is found once for all bonds that end near it, and what bonds have that differ by their place alone is stored once, as
//! their kind. Along a flat border bonds of a kind follow each other, each a step on from the one before, and so do nodes: what is
//! stored grows with the rows of cells beside the border, and many of them are evaluated at once.

mod breaking;
mod build;
mod evaluate;
mod stretches;

pub use breaking::BondPoints;
pub use build::NodedBondsBuilder;

use super::{BlockMatrix, ConnectedParts, Place, PlacedBond, PlacedBonds, Survey, Term};
use crate::bonds::{Mat, Rows};
use std::array::from_fn;
use stretches::{Stretch, Stretches};

/// What bonds have that differ by their place alone. Measures are those of the relative displacement of the two ends.
#[derive(Clone, Debug, PartialEq)]
pub struct NodedKind<const D: usize, const M: usize> {
    /// Shares of the nodes in either end; one of a point has none.
    pub shares: [Vec<f64>; 2],
    /// Coefficients of the relative displacement, `[measure][component]`.
    pub rows: Mat<M, D>,
    /// Moduli conjugate to the measures, weight included, >= 0.
    pub moduli: [f64; M],
}

impl<const D: usize, const M: usize> NodedKind<D, M> {
    /// Number of points or nodes at an end.
    fn width(&self, end: usize) -> usize {
        self.shares[end].len().max(1)
    }
}

/// Coefficients of the relative displacement of the ends, and moduli.
type Law<const D: usize, const M: usize> = (Mat<M, D>, [f64; M]);

/// Energy of bonds between points and nodes, `E = Σ ½ s·diag(moduli)·s`.
#[derive(Clone, Debug)]
pub struct NodedBonds<const D: usize, const M: usize> {
    points: usize,
    /// Per kind of node: shares of its points.
    node_shares: Vec<Vec<f64>>,
    /// The nodes: their own numbers, then those of their points.
    nodes: Stretches,
    node_count: usize,
    /// Per kind of bond: shares of the nodes in either end.
    shares: Vec<[Vec<f64>; 2]>,
    rows: Vec<Law<D, M>>,
    bonds: Stretches,
    /// Per bond: one, or zero where it has broken; empty as long as none has.
    factors: Vec<f64>,
}

impl<const D: usize, const M: usize> NodedBonds<D, M> {
    fn new(
        points: usize,
        (node_shares, nodes): (Vec<Vec<f64>>, Stretches),
        (kinds, bonds): (Vec<NodedKind<D, M>>, Stretches),
        node_count: usize,
    ) -> Self {
        let (shares, rows) = kinds.into_iter().map(|kind| (kind.shares, (kind.rows, kind.moduli))).unzip();
        Self { points, node_shares, nodes, node_count, shares, rows, bonds, factors: Vec::new() }
    }

    /// Number of bonds, broken ones among them.
    pub fn count(&self) -> usize {
        self.bonds.all().iter().map(|stretch| stretch.count as usize).sum()
    }

    /// About the number of pairs of points that bonds couple, a point and itself among them.
    pub fn pairs(&self) -> usize {
        let widest = self.node_shares.iter().map(Vec::len).max().unwrap_or(1);
        // Nodes of a face share most of their points.
        let at = |shares: &Vec<f64>| if shares.is_empty() { 1 } else { widest.max(2 * shares.len()) };
        let pairs = |stretch: &Stretch| {
            let members: usize = self.shares[stretch.kind as usize].iter().map(at).sum();
            stretch.count as usize * (members * (members + 1) / 2)
        };
        self.bonds.all().iter().map(pairs).sum()
    }

    /// Adds the forces that do the work `Σ t·Q σ` of the bonds with the planes `t` of the points in the middle of their ends, σ
    /// being conjugate to `Qᵀ t`; `shares` are those of the kinds.
    pub fn add_work<const Q: usize>(&self, t: &[f64], shares: &[Mat<Q, M>], force: &mut [f64]) {
        self.add_all::<Q>((t, [0.5; 2]), force, |kind, len, middle, sigma| {
            for (m, modulus) in self.rows[kind].1.iter().enumerate() {
                sigma[m][..len].fill(0.0);
                for (q, middle) in middle.iter().enumerate() {
                    let share = modulus * shares[kind][q][m];
                    sigma[m][..len].iter_mut().zip(middle).for_each(|(s, t)| *s += share * t);
                }
            }
        });
    }

    /// The kinds, by their numbers.
    pub fn kinds(&self) -> impl Iterator<Item = NodedKind<D, M>> {
        let kinds = self.shares.iter().zip(&self.rows);
        kinds.map(|(shares, (rows, moduli))| NodedKind {
            shares: shares.clone(),
            rows: *rows,
            moduli: *moduli,
        })
    }

    /// The points that bonds move with, ascending.
    pub fn members(&self) -> Vec<u32> {
        let mut members: Vec<u32> = self.places().iter().flatten().map(|of| of.0).collect();
        self.for_each(|kind, ends| {
            let points = ends.into_iter().zip(&self.shares[kind]).filter(|(_, shares)| shares.is_empty());
            members.extend(points.map(|(ids, _)| ids[0]));
        });
        members.sort_unstable();
        members.dedup();
        members
    }

    /// Points and shares of all nodes.
    pub fn places(&self) -> Vec<Place> {
        let mut places = vec![Place::new(); self.node_count];
        for stretch in self.nodes.all() {
            let shares = &self.node_shares[stretch.kind as usize];
            let [own, points @ ..] = self.nodes.walks(stretch, shares.len() + 1) else { continue };
            for k in 0..stretch.count as usize {
                let of = points.iter().zip(shares).map(|(walk, share)| (walk.at(k) as u32, *share));
                places[own.at(k)] = of.collect();
            }
        }
        places
    }

    /// Calls `visit` with every bond that there is: its kind and the points or nodes at its ends.
    pub fn for_each(&self, mut visit: impl FnMut(usize, [&[u32]; 2])) {
        self.for_each_numbered(|_, kind, ends| visit(kind, ends));
    }

    /// The same with the number of the bond first.
    fn for_each_numbered(&self, mut visit: impl FnMut(usize, usize, [&[u32]; 2])) {
        let (mut ids, mut number) = (Vec::new(), 0);
        for stretch in self.bonds.all() {
            let [(first, _), (second, _)] = self.hung(stretch);
            for k in 0..stretch.count as usize {
                if !self.is_broken(number) {
                    ids.clear();
                    ids.extend(first.iter().chain(second).map(|walk| walk.at(k) as u32));
                    let (first, second) = ids.split_at(first.len());
                    visit(number, stretch.kind as usize, [first, second]);
                }
                number += 1;
            }
        }
    }

    /// Calls `visit` with all bonds, some at a time, their nodes written out as points.
    fn written_out(&self, mut visit: impl FnMut(&PlacedBonds<D, M>)) {
        /// Bonds that are written out at a time.
        const PART: usize = 1024;
        let places = self.places();
        let mut placed = PlacedBonds::new(self.points);
        self.for_each(|kind, ends| {
            placed.push(&self.placed(&places, kind, ends));
            if placed.count() == PART {
                visit(&placed);
                placed = PlacedBonds::new(self.points);
            }
        });
        visit(&placed);
    }

    /// A bond of a kind by the points that it moves with; `places` are those of the nodes.
    fn placed(&self, places: &[Place], kind: usize, ends: [&[u32]; 2]) -> PlacedBond<D, M> {
        let end = |side: usize| -> Place {
            let (ids, shares) = (ends[side], &self.shares[kind][side]);
            if shares.is_empty() {
                return vec![(ids[0], 1.0)];
            }
            let nodes = ids.iter().zip(shares);
            nodes
                .flat_map(|(id, share)| places[*id as usize].iter().map(move |(p, s)| (*p, share * s)))
                .collect()
        };
        let (difference, moduli) = self.rows[kind];
        let rows = Rows { difference, mean: [[0.0; D]; M] };
        PlacedBond { ends: [end(0), end(1)], mean: None, rows, moduli }
    }

    /// Calls `visit` with every bond that there is, by its number, its kind and its measures in some displacements.
    pub fn for_each_measured(&self, u: &[f64], mut visit: impl FnMut(usize, usize, [f64; M])) {
        let nodes = self.of_nodes::<D>(u);
        self.for_each_numbered(|number, kind, ends| {
            let mut difference = [0.0; D];
            for ((ids, shares), sign) in ends.into_iter().zip(&self.shares[kind]).zip([-1.0, 1.0]) {
                for (c, difference) in difference.iter_mut().enumerate() {
                    *difference += match shares.is_empty() {
                        true => sign * u[c * self.points + ids[0] as usize],
                        false => {
                            let of = ids.iter().zip(shares);
                            of.map(|(id, share)| sign * share * nodes[c * self.node_count + *id as usize])
                                .sum()
                        }
                    };
                }
            }
            let rows = &self.rows[kind].0;
            visit(number, kind, from_fn(|m| (0..D).map(|c| rows[m][c] * difference[c]).sum()));
        });
    }
}

impl<const D: usize, const M: usize> Term<D> for NodedBonds<D, M> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.written_out(|bonds| bonds.couplings(visit));
    }

    fn reach(&self) -> usize {
        let span = |points: &mut dyn Iterator<Item = [u32; 2]>| {
            points.fold([u32::MAX, 0], |[low, high], [a, b]| [low.min(a), high.max(b)])
        };
        let of_node = |place: &Place| span(&mut place.iter().map(|of| [of.0; 2]));
        let of_nodes: Vec<[u32; 2]> = self.places().iter().map(of_node).collect();
        let mut reach = 0;
        self.for_each(|kind, ends| {
            let ids = ends.into_iter().zip(&self.shares[kind]);
            let mut all = ids.flat_map(|(ids, shares)| {
                ids.iter().map(|id| if shares.is_empty() { [*id; 2] } else { of_nodes[*id as usize] })
            });
            let [low, high] = span(&mut all);
            reach = reach.max((high - low) as usize);
        });
        reach
    }

    fn join(&self, parts: &mut ConnectedParts) {
        let places = self.places();
        let join_all = |place: &Place, parts: &mut ConnectedParts| {
            place.windows(2).for_each(|pair| parts.join(pair[0].0 as usize, pair[1].0 as usize));
        };
        let mut joined = vec![false; places.len()];
        self.for_each(|kind, ends| {
            let mut last = None;
            for (ids, shares) in ends.into_iter().zip(&self.shares[kind]) {
                for id in ids {
                    // A node that no bond hangs on any more joins nothing.
                    if !shares.is_empty() && !std::mem::replace(&mut joined[*id as usize], true) {
                        join_all(&places[*id as usize], parts);
                    }
                    let point = if shares.is_empty() { *id } else { places[*id as usize][0].0 } as usize;
                    last.into_iter().for_each(|last| parts.join(last, point));
                    last = Some(point);
                }
            }
        });
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        self.add_forces(u, force);
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let mut survey = Survey::EMPTY;
        self.for_each_measured(u, |_, kind, s| {
            let (rows, moduli) = &self.rows[kind];
            let action = |c: usize| (0..M).map(|m| rows[m][c] * moduli[m] * s[m]).sum::<f64>().abs();
            let energy = (0..M).map(|m| 0.5 * moduli[m] * s[m] * s[m]).sum();
            survey = survey.join(Survey { energy, largest_action: from_fn(action) });
        });
        survey
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.written_out(|bonds| bonds.add_tangent(tangent));
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        let places = self.places();
        let mut members: Place = Vec::new();
        self.for_each(|kind, ends| {
            members.clear();
            for ((ids, shares), sign) in ends.into_iter().zip(&self.shares[kind]).zip([-1.0, 1.0]) {
                if shares.is_empty() {
                    members.push((ids[0], sign));
                }
                for (id, share) in ids.iter().zip(shares) {
                    members
                        .extend(places[*id as usize].iter().map(|(point, of)| (*point, sign * share * of)));
                }
            }
            members.sort_unstable_by_key(|member| member.0);
            let (rows, moduli) = &self.rows[kind];
            for same in members.chunk_by(|a, b| a.0 == b.0) {
                let share: f64 = same.iter().map(|member| member.1).sum();
                let block = &mut blocks[same[0].0 as usize];
                for (row, modulus) in rows.iter().zip(moduli) {
                    (0..D * D).for_each(|k| {
                        block[k / D][k % D] += share * share * modulus * row[k / D] * row[k % D]
                    });
                }
            }
        });
    }

    fn elements(&self) -> usize {
        self.count()
    }

    fn joins_many(&self) -> bool {
        // A place on a face has four corners.
        self.shares.iter().any(|ends| ends.iter().any(|shares| shares.len() > 2))
    }

    fn stored_factors(&self) -> usize {
        (self.nodes.stored() + self.bonds.stored()).div_ceil(2)
    }
}

#[cfg(test)]
mod tests;
