//! What the bonds of a stencil pull at points one after the other, in vector registers.

use super::Planes;
use super::grid::Grid;
use super::stencil::Stencil;
use pulp::{Simd, WithSimd, bytemuck};

/// The most points that are taken at once.
pub(super) const TILE: usize = 32;
/// Vectors of a component that are summed at once: with those of three components and their terms registers are full.
const VECTORS: usize = 2;

/// A bond: how far its other end is in memory, and `√k n`.
#[derive(Clone, Copy, Debug)]
struct Bond {
    away: usize,
    row: [f32; 3],
}

/// The bonds by which components of their direction are not zero: bit c of the index for component c.
#[derive(Clone, Debug)]
pub(super) struct Bonds([Vec<Bond>; 8]);

impl Bonds {
    pub(super) fn new(stencil: &Stencil, grid: &Grid) -> Self {
        let mut groups: [Vec<Bond>; 8] = Default::default();
        for (step, row) in stencil.steps.iter().zip(&stencil.rows) {
            let away = grid.away(*step);
            // Both ends of a bond are read, so that either direction does.
            let bond = Bond { away: away.unsigned_abs(), row: row.map(|r| r as f32) };
            let group: usize = (0..3).map(|c| usize::from(step[c] != 0) << c).sum();
            groups[group].push(bond);
        }
        Self(groups)
    }
}

/// What is done with the pulls on a tile: the place of its first point, its width, and `Σ K_d (v_{p+d} + v_{p−d})` by component.
pub(super) trait Finish: Sync {
    /// Takes those of one tile; `out` are the planes of its points.
    fn finish(&self, at: usize, pulls: &[[f32; TILE]; 3], out: [&mut [f32]; 3]);
}

/// One layer of a product.
pub(super) struct LayerSweep<'a, F> {
    pub(super) bonds: &'a Bonds,
    pub(super) v: Planes<'a>,
    /// Places of the points.
    pub(super) places: std::ops::Range<usize>,
    pub(super) out: [&'a mut [f32]; 3],
    pub(super) finish: &'a F,
}

impl<F: Finish> WithSimd for LayerSweep<'_, F> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let Self { bonds, v, places, mut out, finish } = self;
        let width = (VECTORS * S::F32_LANES).min(TILE);
        let mut at = places.start;
        while at < places.end {
            let tile = width.min(places.end - at);
            let mut pulls = [[0.0; TILE]; 3];
            pull(simd, bonds, v, at, &mut pulls);
            let own = out.each_mut().map(|out| out.split_off_mut(..tile).unwrap_or_default());
            finish.finish(at, &pulls, own);
            at += tile;
        }
    }
}

/// The pulls on the points of a tile.
#[inline(always)]
fn pull<S: Simd>(simd: S, bonds: &Bonds, v: Planes<'_>, at: usize, pulls: &mut [[f32; TILE]; 3]) {
    let mut sums = [[simd.splat_f32s(0.0); VECTORS]; 3];
    let [_, x, y, xy, z, xz, yz, xyz] = &bonds.0;
    group::<S, true, false, false>(simd, x, v, at, &mut sums);
    group::<S, false, true, false>(simd, y, v, at, &mut sums);
    group::<S, true, true, false>(simd, xy, v, at, &mut sums);
    group::<S, false, false, true>(simd, z, v, at, &mut sums);
    group::<S, true, false, true>(simd, xz, v, at, &mut sums);
    group::<S, false, true, true>(simd, yz, v, at, &mut sums);
    group::<S, true, true, true>(simd, xyz, v, at, &mut sums);
    for (pulls, sums) in pulls.iter_mut().zip(&sums) {
        for (k, sum) in sums.iter().enumerate() {
            let lanes: &[f32] = bytemuck::cast_slice(std::slice::from_ref(sum));
            pulls[k * S::F32_LANES..][..S::F32_LANES].copy_from_slice(lanes);
        }
    }
}

/// Adds the pulls of bonds whose directions have these components.
#[inline(always)]
fn group<S: Simd, const X: bool, const Y: bool, const Z: bool>(
    simd: S,
    bonds: &[Bond],
    v: Planes<'_>,
    at: usize,
    sums: &mut [[S::f32s; VECTORS]; 3],
) {
    let has = [X, Y, Z];
    for bond in bonds {
        let row = bond.row.map(|r| simd.splat_f32s(r));
        for k in 0..VECTORS {
            let mut stretch = simd.splat_f32s(0.0);
            for c in 0..3 {
                if has[c] {
                    let place = at + k * S::F32_LANES;
                    let ends = simd
                        .add_f32s(load(simd, v[c], place + bond.away), load(simd, v[c], place - bond.away));
                    // Not fused, so that all processors get the same bits.
                    stretch = simd.add_f32s(simd.mul_f32s(row[c], ends), stretch);
                }
            }
            for c in 0..3 {
                if has[c] {
                    sums[c][k] = simd.add_f32s(simd.mul_f32s(row[c], stretch), sums[c][k]);
                }
            }
        }
    }
}

/// Neighbouring entries in a register.
#[inline(always)]
pub(super) fn load<S: Simd>(_: S, plane: &[f32], at: usize) -> S::f32s {
    bytemuck::pod_read_unaligned(bytemuck::cast_slice(&plane[at..at + S::F32_LANES]))
}
