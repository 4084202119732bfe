//! Values of nodes, elongations of bonds and what they pull, for many at a time.

use super::NodedBonds;
use super::number::Number;
use super::stretches::{Stretch, Walk};
use std::array::from_fn;

/// Elements that are evaluated at once.
const TILE: usize = 64;

/// A number of each of them.
type Tile<T> = [T; TILE];

/// Adds `share` times the entries of a walk, `from` its k-th on.
#[inline(always)]
fn add_entries<T: Number>(sum: &mut [T], share: T, plane: &[T], walk: &Walk, from: usize) {
    if walk.step == 1 {
        let entries = &plane[walk.at(from)..][..sum.len()];
        sum.iter_mut().zip(entries).for_each(|(sum, entry)| *sum += share * *entry);
    } else {
        sum.iter_mut().enumerate().for_each(|(k, sum)| *sum += share * plane[walk.at(from + k)]);
    }
}

/// Adds `share` times some numbers to the entries of a walk, `from` its k-th on.
#[inline(always)]
fn add_to_entries<T: Number>(plane: &mut [T], share: T, numbers: &[T], walk: &Walk, from: usize) {
    if walk.step == 1 {
        let entries = &mut plane[walk.at(from)..][..numbers.len()];
        entries.iter_mut().zip(numbers).for_each(|(entry, number)| *entry += share * *number);
    } else {
        numbers.iter().enumerate().for_each(|(k, number)| plane[walk.at(from + k)] += share * *number);
    }
}

/// The elements of a stretch, some at a time: the number of the first, and how many.
fn tiles(stretch: &Stretch) -> impl Iterator<Item = (usize, usize)> + use<> {
    let count = stretch.count as usize;
    (0..count).step_by(TILE).map(move |from| (from, TILE.min(count - from)))
}

impl<const D: usize, const M: usize, T: Number> NodedBonds<D, M, T> {
    /// `Q` planes of the values of all nodes, of those of the points.
    pub(super) fn of_nodes<const Q: usize>(&self, u: &[T]) -> Vec<T> {
        let mut values = vec![T::default(); Q * self.node_count];
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                for stretch in self.nodes.all() {
                    let shares = &self.node_shares[stretch.kind as usize];
                    let [own, points @ ..] = self.nodes.walks(stretch, shares.len() + 1) else { continue };
                    for (from, len) in tiles(stretch) {
                        for c in 0..Q {
                            let mut sum: Tile<T> = [T::default(); TILE];
                            let plane = &u[c * self.points..][..self.points];
                            for (walk, share) in points.iter().zip(shares) {
                                add_entries(&mut sum[..len], *share, plane, walk, from);
                            }
                            let values = &mut values[c * self.node_count..][..self.node_count];
                            add_to_entries(values, T::of(1.0), &sum[..len], own, from);
                        }
                    }
                }
            },
        );
        values
    }

    /// Adds to the planes of the points what those of the nodes make of them: the transpose.
    fn add_from_nodes(&self, nodes: &[T], out: &mut [T]) {
        for stretch in self.nodes.all() {
            let shares = &self.node_shares[stretch.kind as usize];
            let [own, points @ ..] = self.nodes.walks(stretch, shares.len() + 1) else { continue };
            for (from, len) in tiles(stretch) {
                for c in 0..D {
                    let mut values: Tile<T> = [T::default(); TILE];
                    let plane = &nodes[c * self.node_count..][..self.node_count];
                    add_entries(&mut values[..len], T::of(1.0), plane, own, from);
                    let out = &mut out[c * self.points..][..self.points];
                    for (walk, share) in points.iter().zip(shares) {
                        add_to_entries(out, *share, &values[..len], walk, from);
                    }
                }
            }
        }
    }

    /// Adds to the planes of the points the forces of all bonds; `stress` makes of the values at the ends of some bonds of a kind,
    /// `[end][component]`, what is conjugate to their measures.
    pub(super) fn add_all<const Q: usize>(
        &self,
        u: &[T],
        force: &mut [T],
        stress: impl Fn(usize, usize, &[[Tile<T>; Q]; 2]) -> [Tile<T>; M],
    ) {
        let nodes = self.of_nodes::<Q>(u);
        let mut on_nodes = vec![T::default(); D * self.node_count];
        pulp::Arch::new().dispatch(
            #[inline(always)]
            || {
                for stretch in self.bonds.all() {
                    let kind = stretch.kind as usize;
                    for (from, len) in tiles(stretch) {
                        let ends = self.ends::<Q>(stretch, [u, &nodes], from, len);
                        let sigma = stress(kind, len, &ends);
                        self.pull(stretch, &sigma, [force, &mut on_nodes], from, len);
                    }
                }
                self.add_from_nodes(&on_nodes, force);
            },
        );
    }

    /// Values at both ends of some bonds of a stretch.
    #[inline(always)]
    fn ends<const Q: usize>(
        &self,
        stretch: &Stretch,
        [u, nodes]: [&[T]; 2],
        from: usize,
        len: usize,
    ) -> [[Tile<T>; Q]; 2] {
        let mut ends = [[[T::default(); TILE]; Q]; 2];
        for (end, (walks, shares)) in ends.iter_mut().zip(self.hung(stretch)) {
            for (c, sum) in end.iter_mut().enumerate() {
                let sum = &mut sum[..len];
                if shares.is_empty() {
                    add_entries(sum, T::of(1.0), &u[c * self.points..][..self.points], &walks[0], from);
                }
                for (walk, share) in walks.iter().zip(shares) {
                    let plane = &nodes[c * self.node_count..][..self.node_count];
                    add_entries(sum, *share, plane, walk, from);
                }
            }
        }
        ends
    }

    /// Adds what some bonds of a stretch pull to the planes of points and of nodes.
    #[inline(always)]
    fn pull(
        &self,
        stretch: &Stretch,
        sigma: &[Tile<T>; M],
        [force, on_nodes]: [&mut [T]; 2],
        from: usize,
        len: usize,
    ) {
        let rows = &self.rows[stretch.kind as usize].0;
        for c in 0..D {
            let mut action: Tile<T> = [T::default(); TILE];
            for m in 0..M {
                for k in 0..len {
                    action[k] += rows[m][c] * sigma[m][k];
                }
            }
            for ((walks, shares), sign) in self.hung(stretch).into_iter().zip([-1.0, 1.0]) {
                let action = &action[..len];
                if shares.is_empty() {
                    let plane = &mut force[c * self.points..][..self.points];
                    add_to_entries(plane, T::of(sign), action, &walks[0], from);
                }
                for (walk, share) in walks.iter().zip(shares) {
                    let plane = &mut on_nodes[c * self.node_count..][..self.node_count];
                    add_to_entries(plane, T::of(sign) * *share, action, walk, from);
                }
            }
        }
    }

    /// What the ends of the bonds of a stretch hang on, with shares where these are nodes.
    pub(super) fn hung(&self, stretch: &Stretch) -> [(&[Walk], &[T]); 2] {
        let shares = &self.shares[stretch.kind as usize];
        let [first, second] = shares.each_ref().map(|shares| shares.len().max(1));
        let (of_first, of_second) = self.bonds.walks(stretch, first + second).split_at(first);
        [(of_first, &shares[0]), (of_second, &shares[1])]
    }

    /// Adds the internal forces of all bonds.
    pub fn add_forces(&self, u: &[T], force: &mut [T]) {
        self.add_all::<D>(u, force, |kind, len, [first, second]| {
            let (rows, moduli) = &self.rows[kind];
            from_fn(|m| {
                let mut sigma: Tile<T> = [T::default(); TILE];
                for c in 0..D {
                    for k in 0..len {
                        sigma[k] += rows[m][c] * (second[c][k] - first[c][k]);
                    }
                }
                sigma[..len].iter_mut().for_each(|s| *s = moduli[m] * *s);
                sigma
            })
        });
    }
}
