//! Values of nodes, elongations of bonds and what they pull, for many at a time.

use super::NodedBonds;
use super::stretches::{Stretch, Walk};
use peristat_vector::vectorised;

/// Elements that are evaluated at once.
const TILE: usize = 64;

/// A number of each of them.
type Tile = [f64; TILE];

/// What one end of the bonds of a stretch hangs on, and the shares of nodes.
type Hung<'a> = (&'a [Walk], &'a [f64]);

/// Adds `share` times the entries of a walk, `from` its k-th on.
#[inline(always)]
fn add_entries(sum: &mut [f64], share: f64, plane: &[f64], walk: &Walk, from: usize) {
    if walk.step == 1 {
        let entries = &plane[walk.at(from)..][..sum.len()];
        sum.iter_mut().zip(entries).for_each(|(sum, entry)| *sum += share * *entry);
    } else {
        sum.iter_mut().enumerate().for_each(|(k, sum)| *sum += share * plane[walk.at(from + k)]);
    }
}

/// Adds `share` times some numbers to the entries of a walk, `from` its k-th on.
#[inline(always)]
fn add_to_entries(plane: &mut [f64], share: f64, numbers: &[f64], walk: &Walk, from: usize) {
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

impl<const D: usize, const M: usize> NodedBonds<D, M> {
    /// `Q` planes of the values of all nodes, of those of the points.
    pub(super) fn of_nodes<const Q: usize>(&self, u: &[f64]) -> Vec<f64> {
        let mut values = vec![0.0; Q * self.node_count];
        vectorised(
            #[inline(always)]
            || {
                for stretch in self.nodes.all() {
                    let shares = &self.node_shares[stretch.kind as usize];
                    let [own, points @ ..] = self.nodes.walks(stretch, shares.len() + 1) else { continue };
                    for (from, len) in tiles(stretch) {
                        for c in 0..Q {
                            let mut sum: Tile = [0.0; TILE];
                            let plane = &u[c * self.points..][..self.points];
                            for (walk, share) in points.iter().zip(shares) {
                                add_entries(&mut sum[..len], *share, plane, walk, from);
                            }
                            let values = &mut values[c * self.node_count..][..self.node_count];
                            add_to_entries(values, 1.0, &sum[..len], own, from);
                        }
                    }
                }
            },
        );
        values
    }

    /// Adds to the planes of the points what those of the nodes make of them: the transpose.
    #[inline(always)]
    fn add_from_nodes(&self, nodes: &[f64], out: &mut [f64]) {
        for stretch in self.nodes.all() {
            let shares = &self.node_shares[stretch.kind as usize];
            let [own, points @ ..] = self.nodes.walks(stretch, shares.len() + 1) else { continue };
            for (from, len) in tiles(stretch) {
                for c in 0..D {
                    let mut values: Tile = [0.0; TILE];
                    let plane = &nodes[c * self.node_count..][..self.node_count];
                    add_entries(&mut values[..len], 1.0, plane, own, from);
                    let out = &mut out[c * self.points..][..self.points];
                    for (walk, share) in points.iter().zip(shares) {
                        add_to_entries(out, *share, &values[..len], walk, from);
                    }
                }
            }
        }
    }

    /// Adds to the planes of the points the forces of all bonds. `stress` makes what is conjugate to the measures of some bonds of a
    /// kind of the sums of the values at their ends, times these signs.
    pub(super) fn add_all<const Q: usize>(
        &self,
        (u, signs): (&[f64], [f64; 2]),
        force: &mut [f64],
        stress: impl Fn(usize, usize, &[Tile; Q], &mut [Tile; M]),
    ) {
        let nodes = self.of_nodes::<Q>(u);
        let mut on_nodes = vec![0.0; D * self.node_count];
        vectorised(
            #[inline(always)]
            || {
                let (mut sums, mut sigma) = ([[0.0; TILE]; Q], [[0.0; TILE]; M]);
                let (mut before, has_broken) = (0, !self.factors.is_empty());
                for stretch in self.bonds.all() {
                    let hung = self.hung(stretch);
                    for (from, len) in tiles(stretch) {
                        self.sum(&hung, ([u, &nodes], signs), &mut sums, from, len);
                        stress(stretch.kind as usize, len, &sums, &mut sigma);
                        if has_broken {
                            self.leave_out_broken(&mut sigma, before + from, len);
                        }
                        let rows = &self.rows[stretch.kind as usize].0;
                        self.pull(&hung, (rows, &sigma), [force, &mut on_nodes], from, len);
                    }
                    before += stretch.count as usize;
                }
                self.add_from_nodes(&on_nodes, force);
            },
        );
    }

    /// Takes what broken bonds would bear from that of some bonds, the first of which has a number.
    #[inline(never)]
    fn leave_out_broken(&self, sigma: &mut [Tile; M], number: usize, len: usize) {
        let factors = &self.factors[number..number + len];
        let numbers = sigma.iter_mut().flat_map(|sigma| sigma.iter_mut().zip(factors));
        numbers.for_each(|(sigma, factor)| *sigma *= *factor);
    }

    /// Sums of the values at the ends of some bonds of a stretch.
    #[inline(always)]
    fn sum<const Q: usize>(
        &self,
        hung: &[Hung<'_>; 2],
        ([u, nodes], signs): ([&[f64]; 2], [f64; 2]),
        sums: &mut [Tile; Q],
        from: usize,
        len: usize,
    ) {
        for (c, sum) in sums.iter_mut().enumerate() {
            let sum = &mut sum[..len];
            sum.fill(0.0);
            for ((walks, shares), sign) in hung.iter().zip(signs) {
                if shares.is_empty() {
                    add_entries(sum, sign, &u[c * self.points..][..self.points], &walks[0], from);
                }
                for (walk, share) in walks.iter().zip(*shares) {
                    let plane = &nodes[c * self.node_count..][..self.node_count];
                    add_entries(sum, sign * *share, plane, walk, from);
                }
            }
        }
    }

    /// Adds what some bonds of a stretch pull to the planes of points and of nodes.
    #[inline(always)]
    fn pull(
        &self,
        hung: &[Hung<'_>; 2],
        (rows, sigma): (&[[f64; D]; M], &[Tile; M]),
        [force, on_nodes]: [&mut [f64]; 2],
        from: usize,
        len: usize,
    ) {
        let mut action: Tile = [0.0; TILE];
        let action = &mut action[..len];
        for c in 0..D {
            action.fill(0.0);
            for (row, sigma) in rows.iter().zip(sigma) {
                action.iter_mut().zip(sigma).for_each(|(action, sigma)| *action += row[c] * *sigma);
            }
            for ((walks, shares), sign) in hung.iter().zip([-1.0, 1.0]) {
                if shares.is_empty() {
                    let plane = &mut force[c * self.points..][..self.points];
                    add_to_entries(plane, sign, action, &walks[0], from);
                }
                for (walk, share) in walks.iter().zip(*shares) {
                    let plane = &mut on_nodes[c * self.node_count..][..self.node_count];
                    add_to_entries(plane, sign * *share, action, walk, from);
                }
            }
        }
    }

    /// What the ends of the bonds of a stretch hang on, with shares where these are nodes.
    #[inline(always)]
    pub(super) fn hung(&self, stretch: &Stretch) -> [Hung<'_>; 2] {
        let shares = &self.shares[stretch.kind as usize];
        let [first, second] = shares.each_ref().map(|shares| shares.len().max(1));
        let (of_first, of_second) = self.bonds.walks(stretch, first + second).split_at(first);
        [(of_first, &shares[0]), (of_second, &shares[1])]
    }

    /// Adds the internal forces of all bonds.
    pub fn add_forces(&self, u: &[f64], force: &mut [f64]) {
        self.add_all::<D>(
            (u, [-1.0, 1.0]),
            force,
            #[inline(always)]
            |kind, len, difference, sigma| {
                let (rows, moduli) = &self.rows[kind];
                for m in 0..M {
                    let sigma = &mut sigma[m][..len];
                    sigma.fill(0.0);
                    for (difference, row) in difference.iter().zip(rows[m]) {
                        sigma.iter_mut().zip(difference).for_each(|(s, d)| *s += row * *d);
                    }
                    sigma.iter_mut().for_each(|s| *s *= moduli[m]);
                }
            },
        );
    }
}
