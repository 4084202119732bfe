//! The bonds on a border as rows of a matrix, `f_r = Σ_c B_rc v_c` with blocks `B = Σ k c_r c_c n nᵀ` of points and nodes.
//!
//! A bond on the border pulls at five points and nodes, and many bonds pull at the same ones: rows have an eighth of the work of
//! bonds one by one. Rows that follow each other along a flat face are alike, each a step on from the one before; they are stored
//! once and evaluated many at a time.

use super::kernel::load;
use crate::bonds::Mat;
use crate::stiffness::NodedBonds;
use pulp::{Arch, Simd, WithSimd, bytemuck};
use std::collections::HashMap;

/// Entries behind the last of a plane that vectors of any processor may read.
pub(super) const SLACK: usize = 16;
/// Runs of rows below which threads cost more than they bring.
const FEW: usize = 512;

/// The six numbers of a symmetric block: xx, yy, zz, xy, xz, yz.
type Block = [f32; 6];

/// Rows that follow each other, whose columns are each one on from those of the row before.
#[derive(Clone, Copy, Debug)]
struct Run {
    first: u32,
    count: u32,
    /// Number of columns, and where those of the first row and their blocks begin.
    width: u32,
    columns: u32,
    blocks: u32,
}

/// The rows.
#[derive(Clone, Debug)]
pub(super) struct BorderRows {
    /// Ascending.
    runs: Vec<Run>,
    columns: Vec<u32>,
    blocks: Vec<Block>,
}

/// A kind of bonds: what they have of their ends, end by end, and `k n nᵀ`.
struct Kind {
    /// Whether each end hangs on nodes, and not on a point.
    on_nodes: [bool; 2],
    shares: Vec<f64>,
    block: [f64; 6],
}

impl BorderRows {
    /// Those of bonds, whose stiffnesses are divided by `unit`, N/m; `number` tells the row of a point, or of a node, below `len`.
    pub(super) fn new(
        bonds: &NodedBonds<3, 1>,
        unit: f64,
        (len, number): (usize, impl Fn(u32, bool) -> u32),
    ) -> Self {
        let kinds: Vec<Kind> =
            bonds.kinds().map(|kind| Kind::new(kind.shares, kind.rows, kind.moduli, unit)).collect();
        let mut rows = Vec::new();
        let mut for_each = |visit: &mut dyn FnMut(usize, &[u32])| {
            bonds.for_each(|kind, ends| {
                rows.clear();
                for (ids, is_node) in ends.into_iter().zip(kinds[kind].on_nodes) {
                    rows.extend(ids.iter().map(|id| number(*id, is_node)));
                }
                visit(kind, &rows);
            });
        };
        let mut marks = vec![0; len];
        for_each(&mut |kind, rows| {
            rows.iter().enumerate().for_each(|(role, &row)| {
                let mark = &mut marks[row as usize];
                *mark = mark_of(kind, role, rows).wrapping_add(*mark);
            });
        });
        let starts = |row: &usize| marks[*row] != 0 && (*row == 0 || marks[*row] != marks[*row - 1]);
        let firsts: Vec<u32> = (0..len).filter(starts).map(|row| row as u32).collect();
        let mut of = vec![u32::MAX; len];
        firsts.iter().enumerate().for_each(|(k, row)| of[*row as usize] = k as u32);
        let mut sums: Vec<Vec<(u32, Block)>> = vec![Vec::new(); firsts.len()];
        for_each(&mut |kind, rows| {
            for (role, &row) in rows.iter().enumerate().filter(|(_, row)| of[**row as usize] != u32::MAX) {
                kinds[kind].add(role, rows, &mut sums[of[row as usize] as usize]);
            }
        });
        let ends = firsts.iter().map(|&first| {
            let alike = marks[first as usize..].iter().take_while(|mark| **mark == marks[first as usize]);
            [first, alike.count() as u32]
        });
        Self::compressed(ends.zip(sums))
    }

    /// Stores the first row of each run, by its number and that of its rows; blocks that several have once.
    fn compressed(rows: impl Iterator<Item = ([u32; 2], Vec<(u32, Block)>)>) -> Self {
        let mut known: HashMap<Vec<[u32; 6]>, u32> = HashMap::new();
        let (mut runs, mut columns, mut blocks) = (Vec::new(), Vec::new(), Vec::new());
        for ([first, count], row) in rows {
            let bits = row.iter().map(|(_, block)| block.map(f32::to_bits)).collect();
            let begin = *known.entry(bits).or_insert_with(|| {
                blocks.extend(row.iter().map(|of| of.1));
                (blocks.len() - row.len()) as u32
            });
            let width = row.len() as u32;
            runs.push(Run { first, count, width, columns: columns.len() as u32, blocks: begin });
            columns.extend(row.iter().map(|of| of.0));
        }
        columns.shrink_to_fit();
        blocks.shrink_to_fit();
        Self { runs, columns, blocks }
    }

    /// Writes the forces on all rows over `out`, three planes of rows; those of `v` have [`SLACK`] more entries.
    pub(super) fn apply(&self, v: [&[f32]; 3], out: [&mut [f32]; 3]) {
        let mut out = out;
        out.iter_mut().for_each(|plane| plane.fill(0.0));
        self.apply_runs(&self.runs, v, (0, out));
    }

    /// Those of some runs; `out` are the planes from a row on.
    fn apply_runs(&self, runs: &[Run], v: [&[f32]; 3], (start, out): (usize, [&mut [f32]; 3])) {
        if runs.len() <= FEW {
            return Arch::new().dispatch(Sweep { rows: self, runs, v, start, out });
        }
        let (low, high) = runs.split_at(runs.len() / 2);
        let middle = high[0].first as usize;
        let [x, y, z] = out.map(|plane| plane.split_at_mut(middle - start));
        rayon::join(
            || self.apply_runs(low, v, (start, [x.0, y.0, z.0])),
            || self.apply_runs(high, v, (middle, [x.1, y.1, z.1])),
        );
    }
}

/// What tells rows apart: the sum of these over the bonds of a row, its kind, the part of the row in it, and how far the others
/// are. Of a million rows two have the same sum by chance once in 1e7 bodies; their forces would be wrong then, and slow the cycle down.
fn mark_of(kind: usize, role: usize, rows: &[u32]) -> u64 {
    const ODD: u64 = 0x9E37_79B9_7F4A_7C15;
    let mix = |mark: u64, x: u64| (mark ^ x).wrapping_mul(ODD).rotate_left(29);
    let start = mix(mix(ODD, kind as u64), role as u64);
    let away = |row: &u32| u64::from(row.wrapping_sub(rows[role]));
    rows.iter().fold(start, |mark, row| mix(mark, away(row))).wrapping_mul(ODD)
}

impl Kind {
    fn new(shares: [Vec<f64>; 2], [n]: Mat<1, 3>, [modulus]: [f64; 1], unit: f64) -> Self {
        let on_nodes = shares.each_ref().map(|shares| !shares.is_empty());
        let of = |(shares, sign): (Vec<f64>, f64)| -> Vec<f64> {
            let shares = if shares.is_empty() { vec![1.0] } else { shares };
            shares.into_iter().map(|share| sign * share).collect()
        };
        let shares = shares.into_iter().zip([-1.0, 1.0]).flat_map(of).collect();
        let pairs = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        Self { on_nodes, shares, block: pairs.map(|(a, b)| modulus / unit * n[a] * n[b]) }
    }

    /// Adds the blocks of one bond to the row of one of its members, by ascending columns.
    fn add(&self, role: usize, rows: &[u32], sums: &mut Vec<(u32, Block)>) {
        for (&column, share) in rows.iter().zip(&self.shares) {
            let at = sums.binary_search_by_key(&column, |of| of.0).unwrap_or_else(|at| {
                sums.insert(at, (column, [0.0; 6]));
                at
            });
            let factor = self.shares[role] * share;
            (0..6).for_each(|k| sums[at].1[k] += (factor * self.block[k]) as f32);
        }
    }
}

/// Some runs of a product.
struct Sweep<'a> {
    rows: &'a BorderRows,
    runs: &'a [Run],
    v: [&'a [f32]; 3],
    /// The first row of `out`.
    start: usize,
    out: [&'a mut [f32]; 3],
}

impl WithSimd for Sweep<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { rows, runs, v, start, out } = self;
        for run in runs {
            let columns = &rows.columns[run.columns as usize..][..run.width as usize];
            let blocks = &rows.blocks[run.blocks as usize..][..run.width as usize];
            let mut done = 0;
            while done < run.count as usize {
                let sums = sum(simd, (columns, blocks), v, done);
                let tile = S::F32_LANES.min(run.count as usize - done);
                let at = run.first as usize - start + done;
                for c in 0..3 {
                    let lanes: &[f32] = bytemuck::cast_slice(std::slice::from_ref(&sums[c]));
                    out[c][at..at + tile].copy_from_slice(&lanes[..tile]);
                }
                done += tile;
            }
        }
    }
}

/// The forces on neighbouring rows of a run, from one of them on.
#[inline(always)]
fn sum<S: Simd>(simd: S, (columns, blocks): (&[u32], &[Block]), v: [&[f32]; 3], from: usize) -> [S::f32s; 3] {
    let mut sums = [simd.splat_f32s(0.0); 3];
    for (column, block) in columns.iter().zip(blocks) {
        let at = *column as usize + from;
        let [x, y, z] = [load(simd, v[0], at), load(simd, v[1], at), load(simd, v[2], at)];
        let [xx, yy, zz, xy, xz, yz] = block.map(|b| simd.splat_f32s(b));
        // Not fused, so that all processors get the same bits.
        let row = |a, b, c| {
            let (first, second) = (simd.mul_f32s(a, x), simd.mul_f32s(b, y));
            simd.add_f32s(simd.add_f32s(first, second), simd.mul_f32s(c, z))
        };
        let forces = [row(xx, xy, xz), row(xy, yy, yz), row(xz, yz, zz)];
        for c in 0..3 {
            sums[c] = simd.add_f32s(sums[c], forces[c]);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stiffness::{NodedBondsBuilder, NodedKind, Term};

    /// Bonds of points and of nodes, each of which is one point, in a row and here and there.
    fn bonds(points: usize) -> NodedBonds<3, 1> {
        let mut builder = NodedBondsBuilder::new(points);
        let nodes: Vec<u32> = (0..60).map(|k| builder.add_node(vec![(100 + k, 1.0)])).collect();
        let kind = |shares, row, modulus| NodedKind { shares, rows: [row], moduli: [modulus] };
        let along = builder.add_kind(kind([vec![], vec![0.25, 0.75]], [0.6, 0.8, 0.0], 3.0));
        let across = builder.add_kind(kind([vec![0.5, 0.5], vec![]], [0.0, 0.6, -0.8], 2.0));
        let between = builder.add_kind(kind([vec![1.0], vec![1.0]], [0.36, 0.48, 0.8], 0.5));
        for k in 1..59 {
            builder.push(along, [k as u32, nodes[k], nodes[k + 1]]);
            if k % 13 != 0 {
                builder.push(across, [nodes[k - 1], nodes[k], 40 + k as u32]);
            }
        }
        (0..4).for_each(|k| builder.push(between, [nodes[7 * k], nodes[31 - 5 * k]]));
        // Both ends of one bond on one node.
        builder.push(between, [nodes[50]; 2]);
        builder.build()
    }

    #[test]
    fn forces_are_those_of_the_bonds_in_few_runs() {
        let points = 160;
        let (bonds, places) = (bonds(points), bonds(points).places());
        let u: Vec<f64> = (0..3 * points).map(|i| ((i * 7919) % 1013) as f64 / 1013.0 - 0.5).collect();
        let mut expected = vec![0.0; 3 * points];
        bonds.add_force(&u, &mut expected);
        let row = |id: u32, is_node: bool| if is_node { places[id as usize][0].0 } else { id };
        let rows = BorderRows::new(&bonds, 0.5, (points, row));
        // 160 rows of which most are alike.
        assert!(rows.runs.len() < 80, "{}", rows.runs.len());
        let short: Vec<f32> = u.iter().map(|x| *x as f32).chain([0.0; SLACK]).collect();
        let v = [0, 1, 2].map(|c| &short[c * points..][..points + SLACK]);
        let mut out = vec![f32::NAN; 3 * points];
        let mut planes = out.chunks_exact_mut(points);
        rows.apply(v, [0; 3].map(|_| planes.next().expect("a plane")));
        for (found, expected) in out.iter().zip(&expected) {
            assert!((f64::from(*found) - 2.0 * expected).abs() < 2e-6, "{found} {expected}");
        }
    }
}
