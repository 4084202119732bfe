//! Bonds between points and nodes: places that many bonds share and that move as weighted means of points.
//!
//! A node is found once for all bonds that end near it, and what bonds have that differ by their place alone is stored once, as
//! their kind: a bond is the list of what it hangs on.

use super::{BlockMatrix, ConnectedParts, Place, PlacedBond, PlacedBonds, Survey, Term};
use crate::bonds::{Mat, Rows};
use rayon::prelude::*;
use std::array::from_fn;

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

/// Energy of bonds between points and nodes, `E = Σ ½ s·diag(moduli)·s`.
#[derive(Clone, Debug)]
pub struct NodedBonds<const D: usize, const M: usize> {
    points: usize,
    nodes: Vec<Place>,
    kinds: Vec<NodedKind<D, M>>,
    /// Per kind: what each of its bonds hangs on, end by end: a point, or nodes.
    hung: Vec<Vec<u32>>,
}

/// Bonds that one thread takes at a time, and that are written out at a time.
const PART: usize = 1024;

impl<const D: usize, const M: usize> NodedBonds<D, M> {
    /// No bonds yet, of a body of `points` points.
    pub fn new(points: usize) -> Self {
        Self { points, nodes: Vec::new(), kinds: Vec::new(), hung: Vec::new() }
    }

    /// Adds a node; returns its number.
    pub fn add_node(&mut self, place: Place) -> u32 {
        self.nodes.push(place);
        self.nodes.len() as u32 - 1
    }

    /// Adds a kind; returns its number.
    pub fn add_kind(&mut self, kind: NodedKind<D, M>) -> usize {
        self.kinds.push(kind);
        self.hung.push(Vec::new());
        self.kinds.len() - 1
    }

    /// Adds a bond of a kind: the points or nodes at its first end, then those at the other.
    pub fn push(&mut self, kind: usize, hung: impl IntoIterator<Item = u32>) {
        self.hung[kind].extend(hung);
    }

    /// Number of bonds.
    pub fn count(&self) -> usize {
        (0..self.kinds.len()).map(|kind| self.hung[kind].len() / self.stride(kind)).sum()
    }

    /// About the number of pairs of points that bonds couple, a point and itself among them.
    pub fn pairs(&self) -> usize {
        let widest = self.nodes.iter().map(Vec::len).max().unwrap_or(1);
        // Nodes of a face share most of their points.
        let members = |kind: &NodedKind<D, M>| -> usize {
            kind.shares
                .iter()
                .map(|shares| if shares.is_empty() { 1 } else { widest.max(2 * shares.len()) })
                .sum()
        };
        let pairs = |(kind, of): (usize, &NodedKind<D, M>)| {
            self.hung[kind].len() / self.stride(kind) * (members(of) * (members(of) + 1) / 2)
        };
        self.kinds.iter().enumerate().map(pairs).sum()
    }

    /// Adds the forces that do the work `Σ t·Q σ` of the bonds with the planes `t` of the points in the middle of their ends, σ
    /// being conjugate to `Qᵀ t`; `shares` are those of the kinds.
    pub fn add_work<const Q: usize>(&self, t: &[f64], shares: &[Mat<Q, M>], force: &mut [f64]) {
        let of_nodes = self.of_nodes::<Q>(t);
        self.add_all(force, |kind, hung| {
            let [first, second] = self.ends::<Q>(kind, hung, t, &of_nodes);
            from_fn(|m| {
                let s: f64 = (0..Q).map(|q| 0.5 * shares[kind][q][m] * (first[q] + second[q])).sum();
                self.kinds[kind].moduli[m] * s
            })
        });
    }

    /// Points or nodes of a bond.
    fn stride(&self, kind: usize) -> usize {
        self.kinds[kind].width(0) + self.kinds[kind].width(1)
    }

    /// All bonds, in parts: their kind and what they hang on.
    fn parts(&self) -> Vec<(usize, &[u32])> {
        let of = |(kind, hung): (usize, &'_ Vec<u32>)| (kind, hung.len());
        let all = self.hung.iter().enumerate().map(of);
        let cut = |(kind, length): (usize, usize)| {
            let most = PART * self.stride(kind);
            (0..length).step_by(most).map(move |from| (kind, from..length.min(from + most)))
        };
        all.flat_map(cut).map(|(kind, range)| (kind, &self.hung[kind][range])).collect()
    }

    /// Values of all nodes, node by node.
    fn of_nodes<const Q: usize>(&self, u: &[f64]) -> Vec<[f64; Q]> {
        let value = |place: &Place| -> [f64; Q] {
            from_fn(|c| place.iter().map(|(p, share)| share * u[c * self.points + *p as usize]).sum())
        };
        self.nodes.par_iter().with_min_len(PART).map(value).collect()
    }

    /// Values at both ends of a bond.
    #[inline(always)]
    fn ends<const Q: usize>(
        &self,
        kind: usize,
        hung: &[u32],
        u: &[f64],
        nodes: &[[f64; Q]],
    ) -> [[f64; Q]; 2] {
        let kind = &self.kinds[kind];
        let (first, second) = hung.split_at(kind.width(0));
        let end = |ids: &[u32], shares: &[f64]| -> [f64; Q] {
            if shares.is_empty() {
                return from_fn(|c| u[c * self.points + ids[0] as usize]);
            }
            let mut sum = [0.0; Q];
            for (id, share) in ids.iter().zip(shares) {
                (0..Q).for_each(|c| sum[c] += share * nodes[*id as usize][c]);
            }
            sum
        };
        [end(first, &kind.shares[0]), end(second, &kind.shares[1])]
    }

    fn measures(&self, kind: usize, hung: &[u32], u: &[f64], nodes: &[[f64; D]]) -> [f64; M] {
        let [first, second] = self.ends::<D>(kind, hung, u, nodes);
        let rows = &self.kinds[kind].rows;
        from_fn(|m| (0..D).map(|c| rows[m][c] * (second[c] - first[c])).sum())
    }

    /// Adds the forces of all bonds, given what is conjugate to their measures. Threads find that; one adds the forces up, so that
    /// sums do not depend on their number.
    fn add_all(&self, force: &mut [f64], stress: impl Fn(usize, &[u32]) -> [f64; M] + Sync) {
        let parts = self.parts();
        let of = |(kind, hung): &(usize, &[u32])| -> Vec<[f64; M]> {
            hung.chunks_exact(self.stride(*kind)).map(|hung| stress(*kind, hung)).collect()
        };
        let all: Vec<Vec<[f64; M]>> = parts.par_iter().map(of).collect();
        let mut on_nodes = vec![[0.0; D]; self.nodes.len()];
        for ((kind, hung), stresses) in parts.iter().zip(&all) {
            let of = &self.kinds[*kind];
            for (hung, sigma) in hung.chunks_exact(self.stride(*kind)).zip(stresses) {
                let action: [f64; D] = from_fn(|c| (0..M).map(|m| of.rows[m][c] * sigma[m]).sum());
                let ends = hung.split_at(of.width(0));
                for (ids, shares, sign) in [(ends.0, &of.shares[0], -1.0), (ends.1, &of.shares[1], 1.0)] {
                    match shares.is_empty() {
                        true => {
                            (0..D).for_each(|c| force[c * self.points + ids[0] as usize] += sign * action[c])
                        }
                        false => ids.iter().zip(shares).for_each(|(id, share)| {
                            (0..D).for_each(|c| on_nodes[*id as usize][c] += sign * share * action[c]);
                        }),
                    }
                }
            }
        }
        for (place, action) in self.nodes.iter().zip(&on_nodes) {
            for (point, share) in place {
                (0..D).for_each(|c| force[c * self.points + *point as usize] += share * action[c]);
            }
        }
    }

    /// Calls `visit` with all bonds, some at a time, their nodes written out as points.
    fn written_out(&self, mut visit: impl FnMut(&PlacedBonds<D, M>)) {
        for (kind, hung) in self.parts() {
            let of = &self.kinds[kind];
            let mut placed = PlacedBonds::new(self.points);
            for hung in hung.chunks_exact(self.stride(kind)) {
                let (first, second) = hung.split_at(of.width(0));
                let ends = [self.place(first, &of.shares[0]), self.place(second, &of.shares[1])];
                let rows = Rows { difference: of.rows, mean: [[0.0; D]; M] };
                placed.push(&PlacedBond { ends, mean: None, rows, moduli: of.moduli });
            }
            visit(&placed);
        }
    }

    fn place(&self, ids: &[u32], shares: &[f64]) -> Place {
        if shares.is_empty() {
            return vec![(ids[0], 1.0)];
        }
        let nodes = ids.iter().zip(shares);
        nodes
            .flat_map(|(id, share)| self.nodes[*id as usize].iter().map(move |(p, s)| (*p, share * s)))
            .collect()
    }
}

impl<const D: usize, const M: usize> Term<D> for NodedBonds<D, M> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.written_out(|bonds| bonds.couplings(visit));
    }

    fn reach(&self) -> usize {
        let span = |points: &mut dyn Iterator<Item = u32>| {
            points.fold([u32::MAX, 0], |[low, high], p| [low.min(p), high.max(p)])
        };
        let of_nodes: Vec<[u32; 2]> =
            self.nodes.iter().map(|place| span(&mut place.iter().map(|p| p.0))).collect();
        let mut reach = 0;
        for (kind, hung) in self.parts() {
            let of = &self.kinds[kind];
            let is_node = |k: usize| !of.shares[usize::from(k >= of.width(0))].is_empty();
            for hung in hung.chunks_exact(self.stride(kind)) {
                let ends =
                    |(k, id): (usize, &u32)| if is_node(k) { of_nodes[*id as usize] } else { [*id; 2] };
                let [low, high] = span(&mut hung.iter().enumerate().flat_map(ends));
                reach = reach.max((high - low) as usize);
            }
        }
        reach
    }

    fn join(&self, parts: &mut ConnectedParts) {
        for place in &self.nodes {
            place.windows(2).for_each(|pair| parts.join(pair[0].0 as usize, pair[1].0 as usize));
        }
        for (kind, hung) in self.parts() {
            let of = &self.kinds[kind];
            let points = |ids: &[u32], shares: &[f64]| -> Vec<usize> {
                match shares.is_empty() {
                    true => vec![ids[0] as usize],
                    false => ids.iter().map(|id| self.nodes[*id as usize][0].0 as usize).collect(),
                }
            };
            for hung in hung.chunks_exact(self.stride(kind)) {
                let (first, second) = hung.split_at(of.width(0));
                let all = [points(first, &of.shares[0]), points(second, &of.shares[1])].concat();
                all.windows(2).for_each(|pair| parts.join(pair[0], pair[1]));
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let nodes = self.of_nodes::<D>(u);
        self.add_all(force, |kind, hung| {
            let s = self.measures(kind, hung, u, &nodes);
            from_fn(|m| self.kinds[kind].moduli[m] * s[m])
        });
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let nodes = self.of_nodes::<D>(u);
        let of = |(kind, hung): (usize, &[u32])| {
            let bonds: Vec<&[u32]> = hung.chunks_exact(self.stride(kind)).collect();
            Survey::of_all(bonds.len(), |bond| {
                let s = self.measures(kind, bonds[bond], u, &nodes);
                let NodedKind { rows, moduli, .. } = &self.kinds[kind];
                let action = |c: usize| (0..M).map(|m| rows[m][c] * moduli[m] * s[m]).sum::<f64>().abs();
                let energy = (0..M).map(|m| 0.5 * moduli[m] * s[m] * s[m]).sum();
                Survey { energy, largest_action: from_fn(action) }
            })
        };
        self.parts().into_iter().map(of).fold(Survey::EMPTY, Survey::join)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.written_out(|bonds| bonds.add_tangent(tangent));
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        self.written_out(|bonds| bonds.add_diagonal(blocks));
    }

    fn elements(&self) -> usize {
        self.count()
    }

    fn joins_many(&self) -> bool {
        // A place on a face has four corners.
        self.kinds.iter().any(|kind| kind.shares.iter().any(|shares| shares.len() > 2))
    }

    fn stored_factors(&self) -> usize {
        let hung: usize = self.hung.iter().map(Vec::len).sum();
        let nodes: usize = self.nodes.iter().map(|place| 2 * place.len() + 3).sum();
        hung.div_ceil(2) + nodes
    }
}
