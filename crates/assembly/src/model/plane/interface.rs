//! What bonds through several materials leave to their points, and what these get of them.

use super::Mirrors;
use super::bond::PlaneBond;
use super::edges::{Path, modulus, triangles_of};
use super::mixture::{Mixture, Through};
use super::near::at;
use super::neighbourhood::Neighbourhood;
use crate::body::{SquareLattice, plus};
use crate::bonds::{Mat, add};
use crate::stiffness::{Exception, Families, Family, GridBonds};
use std::array::from_fn;
use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

/// A bond whose ends have not half of it each.
#[derive(Clone, Copy, Debug)]
struct Uneven {
    /// Index of its offset among those that have bonds.
    class: u32,
    points: [u32; 2],
    /// Part of the bond that the lower point has beyond half.
    beyond: f64,
}

/// The bonds of a body of several materials, as far as they are not those of one.
#[derive(Clone, Debug)]
pub(in super::super) struct Interface<const D: usize, const S: usize> {
    pub(super) mixture: Arc<Mixture>,
    /// Factors of bonds by offset and lower point.
    pub(super) exceptions: Vec<Exception>,
    uneven: Vec<Uneven>,
    /// Triangles that give back what points lack: first of bonds between points, then of those that end on the border.
    pub(super) families: Arc<Families<D, S, 2>>,
    /// Number of the first ones, which tell stresses, too.
    told: usize,
    /// Points that no triangle gives what they lack.
    pub(super) lost: usize,
}

/// What points lack, by point.
type Lacks<const S: usize> = BTreeMap<usize, Mat<S, S>>;

impl<const D: usize, const S: usize> Interface<D, S> {
    /// That of a body; `absent` are bonds that are not there, by offset and lower point, and `beside` is what bonds that end on the
    /// border leave to points.
    pub(super) fn new<const M: usize, B: PlaneBond<D, M, S>>(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (neighbourhood, bond): (&Neighbourhood<M>, &B),
        mixture: Arc<Mixture>,
        (cuts, gaps): (&HashSet<(usize, usize)>, &[Exception]),
        beside: &[(usize, usize, f64)],
    ) -> Self {
        let gaps: HashSet<(usize, usize)> = gaps.iter().map(|gap| (gap.offset, gap.lower)).collect();
        let mut found = Self {
            mixture: mixture.clone(),
            exceptions: Vec::new(),
            uneven: Vec::new(),
            families: Arc::new(Families::new(0, Vec::new())),
            told: 0,
            lost: 0,
        };
        let whole: Vec<Mat<S, S>> =
            (0..neighbourhood.offsets.len()).map(|k| modulus(lattice, neighbourhood, bond, k)).collect();
        let is_real = |point: usize| mirrors.is_none() || mirrors.is_real(lattice.cell(point));
        let mut lacks: Lacks<S> = BTreeMap::new();
        let lack = |lacks: &mut Lacks<S>, point: usize, k: usize, part: f64| {
            let own = whole[k].map(|row| row.map(|v| part * v));
            add(lacks.entry(point).or_insert([[0.0; S]; S]), &own);
        };
        for (class, k) in neighbourhood.bonded().enumerate() {
            for_each_through((lattice, mirrors), neighbourhood, k, &mixture, &mut |points, through| {
                let [lower, upper] = points;
                if through.factor != 1.0 {
                    found.exceptions.push(Exception { offset: k, lower, factor: through.factor });
                }
                if through.lacks == [0.0; 2] || cuts.contains(&(k, lower)) || gaps.contains(&(k, lower)) {
                    return;
                }
                let [a, b] = through.shares;
                if a != b {
                    let beyond = 0.5 * (a - b) / (a + b);
                    found.uneven.push(Uneven {
                        class: class as u32,
                        points: points.map(|p| p as u32),
                        beyond,
                    });
                }
                // Bonds of cells that are not whole count by the smaller part.
                let part = lattice.fraction(lower).min(lattice.fraction(upper));
                for (point, own) in points.into_iter().zip(through.lacks) {
                    if own > 0.0 && is_real(point) {
                        lack(&mut lacks, point, k, part * own);
                    }
                }
            });
        }
        let mut beyond: Lacks<S> = BTreeMap::new();
        beside.iter().for_each(|&(point, k, part)| lack(&mut beyond, point, k, part));
        let mut families: Vec<Family<D, S, 2>> = Vec::new();
        for (of, tells) in [(lacks, true), (beyond, false)] {
            for (point, own) in of {
                let bonds = (neighbourhood, bond);
                let all = triangles_of(lattice, bonds, (point, &own), cuts, Some(&mixture));
                found.lost += usize::from(all.is_empty());
                families.extend(all);
            }
            found.told = if tells { families.len() } else { found.told };
        }
        found.families = Arc::new(Families::new(lattice.points(), families));
        found
    }

    /// The triangles that tell stresses.
    pub(super) fn told(&self) -> &[Family<D, S, 2>] {
        &self.families.list()[..self.told]
    }

    /// Adds to three planes of sums over the bonds of points, and one of their energies, what these have beyond halves of them;
    /// `shares` are those of halves.
    pub(super) fn add_uneven<const M: usize, B: PlaneBond<D, M, S>>(
        &self,
        bonds: &GridBonds<D, M, B>,
        (u, shares, volume): (&[f64], &[Mat<3, M>], f64),
        sums: &mut [f64],
    ) {
        let n = sums.len() / 4;
        for of in &self.uneven {
            let class = of.class as usize;
            let Some(bond) = bonds.bond(class, of.points[0] as usize) else { continue };
            let (s, sigma) = bond.response(n, u);
            let energy: f64 = (0..M).map(|m| 0.5 * s[m] * sigma[m]).sum();
            for (point, sign) in of.points.into_iter().zip([1.0, -1.0]) {
                let (point, part) = (point as usize, sign * of.beyond);
                for q in 0..3 {
                    let own: f64 = (0..M).map(|m| shares[class][q][m] * sigma[m]).sum();
                    sums[q * n + point] += 2.0 * part * own;
                }
                sums[3 * n + point] += part * energy / volume;
            }
        }
    }

    /// The adjoint for the stresses: adds the forces that do their work in strains `t`, three planes.
    pub(super) fn add_work<const M: usize, B: PlaneBond<D, M, S>>(
        &self,
        bonds: &GridBonds<D, M, B>,
        (t, shares): (&[f64], &[Mat<3, M>]),
        force: &mut [f64],
    ) {
        let n = t.len() / 3;
        for of in &self.uneven {
            let (class, [i, j]) = (of.class as usize, of.points.map(|p| p as usize));
            let Some(bond) = bonds.bond(class, i) else { continue };
            let sigma: [f64; M] = from_fn(|m| {
                let own = |q: usize| shares[class][q][m] * (t[q * n + i] - t[q * n + j]);
                2.0 * of.beyond * bond.moduli[m] * (0..3).map(own).sum::<f64>()
            });
            let (first, second) = (bond.rows.first(), bond.rows.second());
            for c in 0..D {
                force[c * n + i] += (0..M).map(|m| first[m][c] * sigma[m]).sum::<f64>();
                force[c * n + j] += (0..M).map(|m| second[m][c] * sigma[m]).sum::<f64>();
            }
        }
    }
}

/// Calls `visit` with the points of every bond of an offset, the lower one first, and what it has.
fn for_each_through<const M: usize>(
    body: (&SquareLattice, &Mirrors),
    neighbourhood: &Neighbourhood<M>,
    k: usize,
    mixture: &Mixture,
    visit: &mut dyn FnMut([usize; 2], Through),
) {
    let (lattice, step) = (body.0, neighbourhood.offsets[k]);
    let pieces: Vec<_> = Path::of(step).pieces().collect();
    for run in lattice.runs() {
        for column in run.columns.clone() {
            let cell = run.cell(column);
            let Some(upper) = lattice.number(at(cell, step, true)) else { continue };
            let path = pieces.iter().map(|&(piece, part)| (plus(cell, piece), part));
            visit([run.number(column), upper], mixture.through(body, path));
        }
    }
}
