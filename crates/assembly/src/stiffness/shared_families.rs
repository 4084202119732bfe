//! Families that share their moduli: points and some others about them, many of which lie alike.
//!
//! The measures of a family are the displacements of the others relative to the point, `s_e = u_e − u_point`, all their
//! components. A modulus is stored once for all families that lie alike, as a root R, `C = Rᵀ R`: a rotation, whose measures are
//! not small, has `R s` of the size of rounding and an energy of its square.

use super::{BlockMatrix, Survey, Term};
use crate::bonds::{Mat, add};
use nalgebra::DMatrix;
use rayon::prelude::*;
use std::array::from_fn;
use std::collections::HashSet;

/// What families have that lie alike.
#[derive(Clone, Debug, PartialEq)]
pub struct SharedKind {
    /// Number of other points.
    others: usize,
    /// Rows of the root R, √(N/m), of as many numbers as there are measures: the components of a point next to each other.
    root: Vec<f64>,
}

/// Rows below this part of the largest one are what rounding leaves of zero.
const RANK: f64 = 1e-15;

impl SharedKind {
    /// Families of a number of other points with the modulus `C = AᵀA`; A has any number of rows.
    pub fn new(others: usize, a: DMatrix<f64>) -> Self {
        let root = a.qr().unpack_r();
        let least = RANK * root.amax();
        let kept = root.row_iter().filter(|row| row.amax() > least);
        Self { others, root: kept.flat_map(|row| row.iter().copied().collect::<Vec<_>>()).collect() }
    }
}

/// A family: its point, its kind, what multiplies the modulus, and where its others are listed.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Entry {
    point: u32,
    kind: u32,
    first: u32,
    factor: f64,
}

/// Energy of families that share moduli, `E = Σ ½ f sᵀ C s`.
#[derive(Clone, Debug)]
pub struct SharedFamilies<const D: usize> {
    points: usize,
    kinds: Vec<SharedKind>,
    entries: Vec<Entry>,
    others: Vec<u32>,
}

/// Families that one thread takes at a time.
const PART: usize = 256;

impl<const D: usize> SharedFamilies<D> {
    /// No families yet, of a body of `points` points.
    pub fn new(points: usize) -> Self {
        Self { points, kinds: Vec::new(), entries: Vec::new(), others: Vec::new() }
    }

    /// Adds a kind; returns its number.
    pub fn add_kind(&mut self, kind: SharedKind) -> usize {
        self.kinds.push(kind);
        self.kinds.len() - 1
    }

    /// Adds a family of a kind with as many others as that has.
    pub fn push(&mut self, point: usize, kind: usize, factor: f64, others: impl Iterator<Item = usize>) {
        let first = self.others.len() as u32;
        self.entries.push(Entry { point: point as u32, kind: kind as u32, first, factor });
        self.others.extend(others.map(|other| other as u32));
    }

    /// Number of families.
    pub fn count(&self) -> usize {
        self.entries.len()
    }

    /// The families that have both points of one of some pairs, the lower one first.
    pub fn spanning(&self, pairs: &HashSet<[u32; 2]>) -> Vec<usize> {
        let ends: HashSet<u32> = pairs.iter().flatten().copied().collect();
        let spans = |family: &usize| {
            let entry = &self.entries[*family];
            let all = self.others(entry).iter().chain([&entry.point]);
            let met: Vec<u32> = all.filter(|point| ends.contains(point)).copied().collect();
            (1..met.len()).any(|k| met[..k].iter().any(|&p| pairs.contains(&[p.min(met[k]), p.max(met[k])])))
        };
        if pairs.is_empty() { Vec::new() } else { (0..self.count()).filter(spans).collect() }
    }

    /// Some of the families.
    pub fn part(&self, families: &[usize]) -> Self {
        Self { entries: families.iter().map(|&family| self.entries[family]).collect(), ..self.clone() }
    }

    /// Removes families, ascending numbers.
    pub fn remove(&mut self, families: &[usize]) {
        let mut number = 0..;
        self.entries.retain(|_| number.next().is_none_or(|number| families.binary_search(&number).is_err()));
    }

    /// Point, kind, factor and measures of a family.
    pub fn family(&self, family: usize, u: &[f64]) -> (usize, usize, f64, Vec<f64>) {
        let entry = &self.entries[family];
        (entry.point as usize, entry.kind as usize, entry.factor, self.measures(entry, u))
    }

    /// Point and kind of a family.
    pub fn point_and_kind(&self, family: usize) -> (usize, usize) {
        let entry = &self.entries[family];
        (entry.point as usize, entry.kind as usize)
    }

    /// Energy of a family with some measures, J.
    pub fn energy(&self, family: usize, measures: &[f64]) -> f64 {
        self.stress(&self.entries[family], measures).1
    }

    /// Adds the forces that do work with the measures of a family as `sigma` does.
    pub fn add_work(&self, family: usize, sigma: &[f64], force: &mut [f64]) {
        let (entry, n) = (&self.entries[family], self.points);
        for (other, action) in self.others(entry).iter().zip(sigma.chunks_exact(D)) {
            for c in 0..D {
                force[c * n + *other as usize] += action[c];
                force[c * n + entry.point as usize] -= action[c];
            }
        }
    }

    /// Number of pairs of points that families couple, a point and itself among them.
    pub fn pairs(&self) -> usize {
        let members = |entry: &Entry| self.kinds[entry.kind as usize].others + 1;
        self.entries.iter().map(|entry| members(entry) * (members(entry) + 1) / 2).sum()
    }

    fn others(&self, entry: &Entry) -> &[u32] {
        &self.others[entry.first as usize..][..self.kinds[entry.kind as usize].others]
    }

    fn measures(&self, entry: &Entry, u: &[f64]) -> Vec<f64> {
        let at = |c: usize, point: u32| u[c * self.points + point as usize];
        let relative = |&other: &u32| from_fn::<f64, D, _>(|c| at(c, other) - at(c, entry.point));
        self.others(entry).iter().flat_map(relative).collect()
    }

    /// `f C s`, conjugate to the measures, and the energy.
    fn stress(&self, entry: &Entry, s: &[f64]) -> (Vec<f64>, f64) {
        let (mut sigma, mut twice) = (vec![0.0; s.len()], 0.0);
        for row in self.kinds[entry.kind as usize].root.chunks_exact(s.len()) {
            let along: f64 = row.iter().zip(s).map(|(r, s)| r * s).sum();
            let stress = entry.factor * along;
            twice += along * stress;
            sigma.iter_mut().zip(row).for_each(|(sigma, r)| *sigma += r * stress);
        }
        (sigma, 0.5 * twice)
    }

    /// The block of two members, the point itself being none.
    fn block(&self, entry: &Entry, members: [Option<usize>; 2]) -> Mat<D, D> {
        let kind = &self.kinds[entry.kind as usize];
        let of = |member: Option<usize>| member.map_or(0..kind.others, |k| k..k + 1);
        let sign: f64 = members.iter().map(|member| if member.is_none() { -1.0 } else { 1.0 }).product();
        let mut block = [[0.0; D]; D];
        for row in kind.root.chunks_exact(D * kind.others) {
            let [a, b]: [[f64; D]; 2] =
                members.map(|member| from_fn(|c| of(member).map(|k| row[D * k + c]).sum()));
            (0..D).for_each(|r| (0..D).for_each(|c| block[r][c] += sign * entry.factor * a[r] * b[c]));
        }
        block
    }

    /// Points of a family with their indices among the others.
    fn members(&self, entry: &Entry) -> Vec<(usize, Option<usize>)> {
        let others = self.others(entry).iter().enumerate().map(|(k, &p)| (p as usize, Some(k)));
        std::iter::once((entry.point as usize, None)).chain(others).collect()
    }
}

impl<const D: usize> Term<D> for SharedFamilies<D> {
    fn couplings(&self, visit: &mut dyn FnMut(usize, usize)) {
        for entry in &self.entries {
            let members = self.members(entry);
            for (k, (i, _)) in members.iter().enumerate() {
                members[k + 1..].iter().for_each(|(j, _)| visit(*i, *j));
            }
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        // Threads find the stresses; one adds them up, so that sums do not depend on their number.
        let stress = |entry: &Entry| self.stress(entry, &self.measures(entry, u)).0;
        let all: Vec<Vec<f64>> = self.entries.par_iter().with_min_len(PART).map(stress).collect();
        all.iter().enumerate().for_each(|(family, sigma)| self.add_work(family, sigma, force));
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        let of = |family: usize| {
            let entry = &self.entries[family];
            let s = self.measures(entry, u);
            let (sigma, energy) = self.stress(entry, &s);
            let largest = |c: usize| sigma.iter().skip(c).step_by(D).fold(0.0, |m: f64, f| m.max(f.abs()));
            Survey { energy, largest_action: from_fn(largest) }
        };
        Survey::of_all(self.entries.len(), of)
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for entry in &self.entries {
            let members = self.members(entry);
            for &(i, a) in &members {
                for &(j, b) in members.iter().filter(|(j, _)| *j >= i) {
                    tangent.add(i, j, &self.block(entry, [a, b]));
                }
            }
        }
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        for entry in &self.entries {
            for (i, a) in self.members(entry) {
                add(&mut blocks[i], &self.block(entry, [a, a]));
            }
        }
    }

    fn elements(&self) -> usize {
        self.entries.len()
    }

    fn joins_many(&self) -> bool {
        true
    }

    fn stored_factors(&self) -> usize {
        let roots: usize = self.kinds.iter().map(|kind| kind.root.len()).sum();
        roots + 3 * self.entries.len() + self.others.len().div_ceil(2)
    }
}
