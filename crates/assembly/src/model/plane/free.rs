//! What strains that need no stress do to the elements of a lattice: the measures at which these are free of force.
//!
//! A bond between points of one material is free at the measures `s* = ½ U (t_i + t_j)` of the free strains t of its points. One
//! through several materials is so across their interface at the strains of the cells that it passes, each by its part of the length,
//! and along the interface at those of its ends by their parts of the bond: across it layers stretch one after the other, along it
//! they hold each other, each by its own stiffness. Where moduli vary smoothly, all of it is by those parts. What completes the
//! border is free at those of its places, a triangle at those of its point. The load of [`LatticeBody::add_free_work`] is that of
//! the forces `Bᵀ C s*`, so that the energy of a state is
//! `Σ ½ C (s − s*)² = ½ u·K u − f·u + Σ ½ C s*²`.

use super::body::LatticeBody;
use super::bond::PlaneBond;
use super::edges::{By, Path};
use crate::body::{Cell, plus};
use crate::bonds::Mat;
use crate::stiffness::Family;
use std::array::from_fn;
use std::collections::HashMap;

/// Cells around the middle of a bond, in every direction, that tell how an interface lies.
const AROUND: i32 = 2;

/// The measures at which bonds between points are free, of strains `t` of these, three planes.
pub(super) struct FreeBonds<'a, const M: usize> {
    t: &'a [f64],
    /// Halves of the measures in uniform strains, by offset that has bonds.
    halves: Vec<Mat<3, M>>,
    /// Strains of bonds through several materials, measure by measure, by offset and lower point.
    through: HashMap<(usize, usize), [[f64; 3]; M]>,
}

impl<const M: usize> FreeBonds<'_, M> {
    /// Those of a bond, by index of its offset among those that have bonds, and its points.
    pub(super) fn measures(&self, class: usize, [i, j]: [usize; 2]) -> [f64; M] {
        let n = self.t.len() / 3;
        let mean = || [from_fn(|q| 0.5 * (self.t[q * n + i] + self.t[q * n + j])); M];
        let strains: [[f64; 3]; M] = self.through.get(&(class, i)).copied().unwrap_or_else(mean);
        from_fn(|m| (0..3).map(|q| 2.0 * self.halves[class][q][m] * strains[m][q]).sum())
    }
}

/// A bond through several materials, and what it is free at.
struct FreeThrough<'a, const M: usize> {
    /// Index of its offset among those that have bonds, and its points.
    class: usize,
    points: [usize; 2],
    /// Parts of its moduli that the lower point has beyond half.
    beyond: &'a [f64; M],
    /// Strains of its points that need no stress.
    ends: [[f64; 3]; 2],
    /// Their mean along it; none where its materials vary so little that its ends tell enough.
    mean: Option<[f64; 3]>,
    /// Direction of the interface; none where nothing changes.
    line: Option<[f64; 2]>,
}

impl<const M: usize> FreeThrough<'_, M> {
    /// The strain at which a measure is free.
    fn strain(&self, m: usize) -> [f64; 3] {
        let parts = [0.5 + self.beyond[m], 0.5 - self.beyond[m]];
        let held: [f64; 3] = from_fn(|q| parts[0] * self.ends[0][q] + parts[1] * self.ends[1][q]);
        match (self.mean, self.line) {
            (None, _) => held,
            (Some(mean), None) => mean,
            (Some(mean), Some(line)) => {
                let more = with_along(line, along(line, held) - along(line, mean));
                from_fn(|q| mean[q] + more[q])
            }
        }
    }

    /// What it has across the interface beyond the strain of an end.
    fn beyond_end(&self, end: usize) -> [f64; 3] {
        let Some(mean) = self.mean else { return [0.0; 3] };
        let more: [f64; 3] = from_fn(|q| mean[q] - self.ends[end][q]);
        let held = self.line.map_or([0.0; 3], |line| with_along(line, along(line, more)));
        from_fn(|q| more[q] - held[q])
    }
}

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// The measures at which bonds between points are free.
    pub(super) fn free_bonds<'a>(&self, t: &'a [f64]) -> FreeBonds<'a, M> {
        let mut through = HashMap::new();
        self.for_each_through(t, &mut |of| {
            through.insert((of.class, of.points[0]), from_fn(|m| of.strain(m)));
        });
        FreeBonds { t, halves: self.virial_shares(1.0), through }
    }

    /// Calls `visit` with every bond through several materials, of strains `t` that points have without stress.
    fn for_each_through(&self, t: &[f64], visit: &mut dyn FnMut(&FreeThrough<M>)) {
        let Some(interface) = &self.interface else { return };
        let (n, body) = (self.lattice.points(), (&*self.lattice, &self.mirrors));
        let at = |point: usize| -> [f64; 3] { from_fn(|q| t[q * n + point]) };
        let offsets: Vec<Cell> = self.neighbourhood.bonded().map(|k| self.neighbourhood.offsets[k]).collect();
        let paths: Vec<Vec<(Cell, f64)>> =
            offsets.iter().map(|step| Path::of(*step).pieces().collect()).collect();
        for (class, points, beyond) in interface.uneven.all() {
            let first = self.lattice.cell(points[0]);
            let (mut sum, mut length, mut is_apart) = ([0.0; 3], 0.0, false);
            for &(piece, part) in &paths[class] {
                if let Some(point) = interface.mixture.point(body, plus(first, piece)) {
                    length += part;
                    is_apart |= interface.mixture.strains_apart(point, points[0])
                        || interface.mixture.strains_apart(points[0], point);
                    sum.iter_mut().zip(at(point)).for_each(|(sum, own)| *sum += part * own);
                }
            }
            let ends = points.map(at);
            let mean = is_apart.then(|| sum.map(|sum| sum / length));
            let strain = |cell| Some(at(interface.mixture.point(body, cell)?));
            let line = mean.and_then(|_| self.interface_line(&strain, (first, offsets[class]), ends));
            visit(&FreeThrough { class, points, beyond, ends, mean, line });
        }
    }

    /// The direction along which strains of points change the least around the middle of a bond from a cell along an offset, with those
    /// of its ends; none where these are the same.
    fn interface_line(
        &self,
        strain: &dyn Fn(Cell) -> Option<[f64; 3]>,
        (first, step): (Cell, Cell),
        ends: [[f64; 3]; 2],
    ) -> Option<[f64; 2]> {
        let change: [f64; 3] = from_fn(|q| ends[1][q] - ends[0][q]);
        if change == [0.0; 3] {
            return None;
        }
        // As many cells on either side of the middle, which lies in a cell or between two.
        let around = |axis: usize| {
            let (middle, odd) = (first[axis] + step[axis].div_euclid(2), step[axis].rem_euclid(2));
            middle - AROUND..=middle + AROUND + odd
        };
        let cells = around(1).flat_map(|j| around(0).map(move |i| [i, j, first[2]]));
        let known = cells.filter_map(|cell| {
            let own = strain(cell)?;
            let value: f64 = (0..3).map(|q| (own[q] - ends[0][q]) * change[q]).sum();
            let [x, y] = self.lattice.place_of(cell);
            Some([x, y, value])
        });
        let places: Vec<[f64; 3]> = known.collect();
        let mean = |q: usize| places.iter().map(|of| of[q]).sum::<f64>() / places.len() as f64;
        let middle = [mean(0), mean(1), mean(2)];
        let rise = |axis: usize| -> f64 {
            places.iter().map(|of| (of[axis] - middle[axis]) * (of[2] - middle[2])).sum()
        };
        let [x, y] = [rise(0), rise(1)];
        let steep = x.hypot(y);
        (steep > 0.0).then(|| [-y / steep, x / steep])
    }

    /// Adds the forces that keep the body in strains `t` that its points have without stress, three planes: nowhere else than at
    /// interfaces they differ from those that do the work of the stresses of points.
    pub(in super::super) fn add_free_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.add_border_work(t, force);
        let (n, halves) = (self.lattice.points(), self.virial_shares(1.0));
        self.for_each_through(t, &mut |of| {
            let Some(bond) = self.whole().bond(of.class, of.points[0]) else { return };
            // What the bond lacks of it beside the halves of its real ends.
            let real = || (0..2).filter(|&end| !self.is_ghost(of.points[end]));
            let sigma = from_fn(|m| {
                let strain = of.strain(m);
                let more = |q: usize| real().map(|end| strain[q] - of.ends[end][q]).sum::<f64>();
                bond.moduli[m] * (0..3).map(|q| halves[of.class][q][m] * more(q)).sum::<f64>()
            });
            bond.add_work(n, &sigma, force);
        });
        self.add_work_of_halves(t, points, force);
    }

    /// What points have of the stresses of the strains `t`, three planes, beyond those of their own: bonds are free at others across
    /// an interface. Three planes; none where the body is of one material.
    pub(in super::super) fn free_stress_beyond(&self, t: &[f64]) -> Option<[Vec<f64>; 3]> {
        self.interface.as_ref()?;
        let (n, volume) = (self.lattice.points(), self.cell_volume());
        let halves = self.virial_shares(1.0);
        let mut beyond = [0, 1, 2].map(|_| vec![0.0; n]);
        self.for_each_through(t, &mut |of| {
            let Some(bond) = self.whole().bond(of.class, of.points[0]) else { return };
            let halves = &halves[of.class];
            for end in (0..2).filter(|&end| !self.is_ghost(of.points[end])) {
                let more = of.beyond_end(end);
                for m in 0..M {
                    let measure: f64 = (0..3).map(|q| 2.0 * halves[q][m] * more[q]).sum();
                    let part = 1.0 + [2.0, -2.0][end] * of.beyond[m];
                    let sigma = part * bond.moduli[m] * measure / volume;
                    (0..3).for_each(|q| beyond[q][of.points[end]] += halves[q][m] * sigma);
                }
            }
        });
        let told = self.border.strains.iter().flat_map(|strains| strains.points());
        told.for_each(|point| beyond.iter_mut().for_each(|plane| plane[point] = 0.0));
        let cut_cells = if self.border.is_cut() { &[] } else { self.lattice.cut_cells() };
        for &(point, part) in cut_cells {
            beyond.iter_mut().for_each(|plane| plane[point as usize] /= part);
        }
        Some(beyond)
    }

    /// Energy `Σ ½ C s*²` of the body where nothing moves, of free strains `t` of its points, three planes; it has no images.
    pub(in super::super) fn energy_at_rest(&self, t: &[f64]) -> f64 {
        let (free, mut energy) = (self.free_bonds(t), 0.0);
        let of = |moduli: &[f64; M], s: [f64; M]| (0..M).map(|m| 0.5 * moduli[m] * s[m] * s[m]).sum::<f64>();
        self.bonds.for_each_with_moduli(|class, ends, moduli| {
            energy += of(&moduli, free.measures(class, ends));
        });
        match &self.border.by {
            By::Points => energy += of_triangles(self.triangles.list(), t),
            By::Bonds(border) => {
                let body = (&*self.lattice, &self.neighbourhood, &self.kind.bond);
                let bonds = 0..border.kinds.len();
                energy += bonds.map(|k| of(border.bonds.moduli(k), border.free(body, t, k))).sum::<f64>();
            }
            // Bodies whose border is of these do not break.
            By::Triangles(_) => {}
        }
        energy + self.interface.as_ref().map_or(0.0, |interface| of_triangles(interface.families.list(), t))
    }
}

/// The strain along a direction.
fn along([x, y]: [f64; 2], [xx, yy, shear]: [f64; 3]) -> f64 {
    x * x * xx + y * y * yy + x * y * shear
}

/// A strain along a direction alone.
fn with_along([x, y]: [f64; 2], strain: f64) -> [f64; 3] {
    [x * x * strain, y * y * strain, 2.0 * x * y * strain]
}

/// The energy of triangles where nothing moves.
fn of_triangles<const D: usize, const S: usize>(triangles: &[Family<D, S, 2>], t: &[f64]) -> f64 {
    let n = t.len() / 3;
    let of = |triangle: &Family<D, S, 2>| {
        let own: [f64; S] = from_fn(|q| if q < 3 { t[q * n + triangle.point as usize] } else { 0.0 });
        own.iter().zip(triangle.stress(&own)).map(|(e, s)| 0.5 * e * s).sum::<f64>()
    };
    triangles.iter().map(of).sum()
}
