//! The bonds of a lattice of several materials: their factors or weights, what their ends lack, and those whose ends have not half
//! of them each.

use super::Mirrors;
use super::edges::Path;
use super::mixture::{Mixture, Through};
use super::near::at;
use super::neighbourhood::Neighbourhood;
use crate::body::{SquareLattice, plus};
use crate::bonds::{BondModel, Mat};
use crate::stiffness::{Between, Exception, GridBonds};
use std::array::from_fn;
use std::collections::HashSet;

/// A bond whose ends have not half of it each.
#[derive(Clone, Copy, Debug)]
struct Uneven<const M: usize> {
    /// Index of its offset among those that have bonds.
    class: u32,
    points: [u32; 2],
    /// Parts of its moduli that the lower point has beyond half.
    beyond: [f64; M],
}

/// Bonds whose ends have not half of them each.
#[derive(Clone, Debug)]
pub(in super::super) struct UnevenBonds<const M: usize> {
    list: Vec<Uneven<M>>,
}

/// What the bonds of a mixture are beside those of the base material.
#[derive(Clone, Debug)]
pub(in super::super) struct MixedBonds<const M: usize> {
    /// Factors of bonds by offset and lower point.
    pub(in super::super) exceptions: Vec<Exception>,
    /// Bonds through several tables of weights.
    pub(in super::super) between: Vec<Between<M>>,
    pub(in super::super) uneven: UnevenBonds<M>,
    /// What real points lack: these, offsets, and weights.
    pub(in super::super) lacks: Vec<(usize, usize, [f64; M])>,
}

impl<const M: usize> MixedBonds<M> {
    /// Those of a lattice; `absent` are bonds that are not there, by offset and lower point.
    pub(in super::super) fn new(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        neighbourhood: &Neighbourhood<M>,
        mixture: &Mixture,
        absent: &HashSet<(usize, usize)>,
    ) -> Self {
        let mut found = Self {
            exceptions: Vec::new(),
            between: Vec::new(),
            uneven: UnevenBonds { list: Vec::new() },
            lacks: Vec::new(),
        };
        let body = (lattice, mirrors);
        for (class, offset) in neighbourhood.bonded().enumerate() {
            let step = neighbourhood.offsets[offset];
            let pieces: Vec<_> = Path::of(step).pieces().collect();
            for run in lattice.runs() {
                for column in run.columns.clone() {
                    let (cell, lower) = (run.cell(column), run.number(column));
                    let Some(upper) = lattice.number(at(cell, step, true)) else { continue };
                    let path = || pieces.iter().map(|&(piece, part)| (plus(cell, piece), part));
                    let through = match mixture.table_along(body, path()) {
                        Some(table) => {
                            let Through { weights: [factor], shares, lacks } = mixture.through(body, path());
                            if factor != 1.0 {
                                found.exceptions.push(Exception { offset, lower, factor });
                            }
                            if shares[0] == shares[1] && lacks == [[0.0]; 2] {
                                continue;
                            }
                            let weights = neighbourhood.weights_of(table, offset);
                            let times = |[factor]: [f64; 1]| weights.map(|weight| factor * weight);
                            Through {
                                weights: times([factor]),
                                shares: shares.map(times),
                                lacks: lacks.map(times),
                            }
                        }
                        None => {
                            let of = |table| neighbourhood.of_material(table, offset);
                            let through = mixture.weights_through(body, path(), of);
                            found.between.push(Between { offset, lower, weights: through.weights });
                            through
                        }
                    };
                    if absent.contains(&(offset, lower)) {
                        continue;
                    }
                    // Ends that lack nothing may share unevenly, too.
                    found.uneven.push(class, [lower, upper], through.shares);
                    // Bonds of cells that are not whole count by the smaller part.
                    let part = lattice.fraction(lower).min(lattice.fraction(upper));
                    let ends = [lower, upper].into_iter().zip(through.lacks);
                    let is_real = |point: usize| mirrors.is_none() || mirrors.is_real(lattice.cell(point));
                    let own = ends.filter(|&(point, lack)| lack != [0.0; M] && is_real(point));
                    found
                        .lacks
                        .extend(own.map(|(point, lack)| (point, offset, lack.map(|lack| part * lack))));
                }
            }
        }
        found
    }
}

impl<const M: usize> UnevenBonds<M> {
    fn push(&mut self, class: usize, points: [usize; 2], [a, b]: [[f64; M]; 2]) {
        if a != b {
            let part = |m: usize| if a[m] == b[m] { 0.0 } else { 0.5 * (a[m] - b[m]) / (a[m] + b[m]) };
            let beyond = from_fn(part);
            self.list.push(Uneven { class: class as u32, points: points.map(|p| p as u32), beyond });
        }
    }

    /// Index of the offset among those that have bonds, points, and parts that the lower one has beyond half.
    pub(super) fn all(&self) -> impl Iterator<Item = (usize, [usize; 2], &[f64; M])> + '_ {
        self.list.iter().map(|of| (of.class as usize, of.points.map(|p| p as usize), &of.beyond))
    }

    /// Adds to `Q` planes of sums over the bonds of points, and one of their energies, what these have beyond halves of them;
    /// `shares` are those of halves.
    pub(in super::super) fn add_to<const D: usize, const Q: usize, B: BondModel<D, M>>(
        &self,
        bonds: &GridBonds<D, M, B>,
        (u, shares, volume): (&[f64], &[Mat<Q, M>], f64),
        sums: &mut [f64],
    ) {
        let n = sums.len() / (Q + 1);
        for of in &self.list {
            let class = of.class as usize;
            let Some(bond) = bonds.bond(class, of.points[0] as usize) else { continue };
            let (s, sigma) = bond.response(n, u);
            let energy: f64 = (0..M).map(|m| 0.5 * of.beyond[m] * s[m] * sigma[m]).sum();
            for (point, sign) in of.points.into_iter().zip([1.0, -1.0]) {
                let point = point as usize;
                for q in 0..Q {
                    let own: f64 = (0..M).map(|m| of.beyond[m] * shares[class][q][m] * sigma[m]).sum();
                    sums[q * n + point] += 2.0 * sign * own;
                }
                sums[Q * n + point] += sign * energy / volume;
            }
        }
    }

    /// The adjoint for the sums: adds the forces that do their work in strains `t`, `Q` planes.
    pub(in super::super) fn add_work<const D: usize, const Q: usize, B: BondModel<D, M>>(
        &self,
        bonds: &GridBonds<D, M, B>,
        (t, shares): (&[f64], &[Mat<Q, M>]),
        force: &mut [f64],
    ) {
        let n = t.len() / Q;
        for of in &self.list {
            let (class, [i, j]) = (of.class as usize, of.points.map(|p| p as usize));
            let Some(bond) = bonds.bond(class, i) else { continue };
            let sigma: [f64; M] = from_fn(|m| {
                let own = |q: usize| shares[class][q][m] * (t[q * n + i] - t[q * n + j]);
                2.0 * of.beyond[m] * bond.moduli[m] * (0..Q).map(own).sum::<f64>()
            });
            bond.add_work(n, &sigma, force);
        }
    }
}
