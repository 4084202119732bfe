//! Dilatations of all points: of those that have all bonds by offset, of the others with what completes the border.
//!
//! With `c = a/(8μ)` of a bond of weight a and stretch s a whole family has `ϑ = Σ c s`, which is the trace of any uniform strain.
//! A point without some bonds takes parts of what completes the border ([`Transport`](super::transport::Transport)), so that
//! its bonds and these together have the tensor `V_k 1`: then `ϑ_k = (Σ c s + Σ parts)/V_k` is exact, too. All parts are
//! taken: `Σ V_k ϑ_k` is the change of volume of the body as its border has it, and a uniform stress is in equilibrium. No
//! part is negative, and so by the inequality of Cauchy and Schwarz the families never take more energy than bonds have.

use super::super::{Dilatation, StateParameters};
use super::reach::{Lacking, transport};
use super::sources::{Bonded, Source, sources};
use crate::body::{Cell, SquareLattice};
use crate::stiffness::{FamilyRows, GridFamilies, GridFamily, WideFamilies, WideMember};
use std::collections::{BTreeMap, BTreeSet, HashSet};
use std::sync::Arc;

/// Dilatations as energies.
#[derive(Clone, Debug)]
pub(in super::super) struct Dilatations {
    /// Of points that have all bonds.
    pub(in super::super) grid: Arc<GridFamilies>,
    /// Of the others.
    pub(in super::super) own: Arc<WideFamilies<2, 1>>,
    /// Means over blocks of these.
    pub(in super::super) means: Option<Arc<WideFamilies<2, 1>>>,
    /// The points that are not in the grid, ascending.
    pub(in super::super) points: Vec<u32>,
    /// Their volumes, cells.
    pub(in super::super) volumes: Vec<f64>,
    /// Largest error of what a uniform stress without a trace does to them.
    pub(in super::super) left: f64,
}

/// Steps from a point to its neighbours, and `c ξ/|ξ|²` of the bonds there.
pub(super) struct Steps {
    pub(super) steps: Vec<Cell>,
    pub(super) rows: FamilyRows,
}

impl Steps {
    pub(super) fn new(plate: &Bonded, shear_modulus: f64) -> Self {
        let (mut steps, mut rows) = (Vec::new(), Vec::new());
        for sign in [1, -1] {
            for k in plate.hood.bonded() {
                let step = plate.hood.offsets[k].map(|o| sign * o);
                let xi = plate.lattice.vector(step);
                let part = plate.hood.weights[k][0] / (8.0 * shear_modulus * (xi[0] * xi[0] + xi[1] * xi[1]));
                steps.push(step);
                rows.push(xi.map(|x| part * x));
            }
        }
        Self { steps, rows }
    }

    /// Neighbours of a point and the rows of the bonds to them, if these are there.
    fn present<'a>(
        &'a self,
        (plate, gaps): (&'a Bonded, &'a HashSet<[usize; 2]>),
        point: usize,
    ) -> impl Iterator<Item = (usize, Cell, [f64; 2])> + 'a {
        let cell = plate.lattice.cell(point);
        let follows = plate.border.ended().is_some() || plate.border.cut().is_some();
        self.steps.iter().zip(&self.rows).filter_map(move |(step, row)| {
            let other = plate.lattice.number([cell[0] + step[0], cell[1] + step[1]])?;
            let part = match follows {
                true => 1.0,
                false => plate.lattice.fraction(point).min(plate.lattice.fraction(other)),
            };
            let is_there = !gaps.contains(&[point.min(other), point.max(other)]);
            is_there.then(|| (other, *step, row.map(|r| part * r)))
        })
    }
}

/// The points that have not all bonds, with the rows of those that they have.
struct Lack {
    points: Vec<Lacking>,
    rows: Vec<BTreeMap<u32, [f64; 2]>>,
}

impl Lack {
    fn new(plate: &Bonded, steps: &Steps, by_blocks: bool) -> Self {
        let ends = |gap: &crate::stiffness::Exception| {
            let (cell, step) = (plate.lattice.cell(gap.lower), plate.hood.offsets[gap.offset]);
            Some([gap.lower, plate.lattice.number([cell[0] + step[0], cell[1] + step[1]])?])
        };
        let gaps: HashSet<[usize; 2]> =
            plate.border.gaps().iter().filter_map(ends).map(|[a, b]| [a.min(b), a.max(b)]).collect();
        let near = super::super::super::plane::near_points(&plate.lattice, plate.hood.reach() + 1);
        let candidates: BTreeSet<usize> = near.into_iter().chain(gaps.iter().flatten().copied()).collect();
        let is_real = |p: &usize| plate.mirrors.is_none() || plate.mirrors.is_real(plate.lattice.cell(*p));
        let of = |point: usize| {
            let mut tensor = [0.0; 3];
            let mut rows = BTreeMap::new();
            for (other, step, row) in steps.present((plate, &gaps), point) {
                let xi = plate.lattice.vector(step);
                let parts = [row[0] * xi[0], row[1] * xi[1], row[0] * xi[1]];
                (0..3).for_each(|q| tensor[q] += parts[q]);
                add(&mut rows, other as u32, row);
                add(&mut rows, point as u32, row.map(|r| -r));
            }
            let volume = plate.lattice.fraction(point);
            (Lacking { point, cell: plate.lattice.cell(point), tensor, volume }, rows)
        };
        let all: Vec<_> = candidates.into_iter().filter(is_real).map(of).collect();
        let is_whole = |lacking: &Lacking| 0.5 * (lacking.tensor[0] + lacking.tensor[1]) > 1.0 - 1e-9;
        let parent = |lacking: &Lacking| SquareLattice::parent(lacking.cell);
        let blocks: HashSet<Cell> = all.iter().filter(|l| !is_whole(&l.0)).map(|l| parent(&l.0)).collect();
        let kept = all.into_iter().filter(|(l, _)| !is_whole(l) || (by_blocks && blocks.contains(&parent(l))));
        let (points, rows) = kept.unzip();
        Self { points, rows }
    }
}

impl Dilatations {
    /// Those of a plate whose bonds have the shear modulus of some parameters.
    pub(super) fn new(plate: &Bonded, parameters: &StateParameters) -> Self {
        let by_blocks = parameters.dilatation == Dilatation::Blocks;
        let shear = parameters.shear_modulus();
        let steps = Steps::new(plate, shear);
        let Lack { points, mut rows } = Lack::new(plate, &steps, by_blocks);
        let sources = sources(plate, shear);
        let mut transport = transport(&sources, &points, &plate.mirrors, plate.hood.reach());
        let left = transport.solve();
        let mut volumes = Vec::with_capacity(points.len());
        let mut from = 0;
        for ((lacking, rows), &end) in points.iter().zip(&mut rows).zip(&transport.ends) {
            let mut volume = 0.5 * (lacking.tensor[0] + lacking.tensor[1]);
            for edge in &transport.edges[from..end] {
                volume += edge.volume;
                let source: &Source = &sources[edge.place as usize];
                let part = edge.volume / source.volume();
                source.rows.iter().for_each(|(point, row)| add(rows, *point, row.map(|r| part * r)));
            }
            rows.values_mut().flatten().for_each(|r| *r /= volume);
            volumes.push(volume);
            from = end;
        }
        let cell = plate.kind.bond.volume;
        let modulus = parameters.family_modulus();
        let mut own = WideFamilies::new(plate.lattice.points());
        for (rows, volume) in rows.iter().zip(&volumes) {
            own.push(&members(rows), [[0.0; 2]], [[cell * volume * modulus[0][0]]]);
        }
        let numbers: Vec<u32> = points.iter().map(|p| p.point as u32).collect();
        let mean_modulus = if by_blocks { parameters.bulk_modulus() } else { 0.0 };
        let means = by_blocks.then(|| Arc::new(means(plate, &points, (&rows, &volumes), cell * mean_modulus)));
        let is_own = |p: usize| {
            !(plate.mirrors.is_none() || plate.mirrors.is_real(plate.lattice.cell(p)))
                || numbers.binary_search(&(p as u32)).is_ok()
        };
        let family = GridFamily {
            steps: steps.steps,
            sets: vec![steps.rows],
            set_of: (0..plate.lattice.points()).map(|p| (!is_own(p)).then_some(0)).collect(),
            volume: vec![cell; plate.lattice.points()],
            own: Vec::new(),
            modulus,
            mean_modulus,
        };
        let grid = Arc::new(GridFamilies::new(plate.lattice.clone(), family));
        Self { grid, own: Arc::new(own), means, points: numbers, volumes, left }
    }
}

/// Means of dilatations over blocks of two by two cells.
fn means(
    plate: &Bonded,
    points: &[Lacking],
    (rows, volumes): (&[BTreeMap<u32, [f64; 2]>], &[f64]),
    modulus: f64,
) -> WideFamilies<2, 1> {
    let mut blocks: BTreeMap<Cell, (BTreeMap<u32, [f64; 2]>, f64)> = BTreeMap::new();
    for (k, lacking) in points.iter().enumerate() {
        let (sum, whole) = blocks.entry(SquareLattice::parent(lacking.cell)).or_default();
        rows[k].iter().for_each(|(&point, row)| add(sum, point, row.map(|r| volumes[k] * r)));
        *whole += volumes[k];
    }
    let mut means = WideFamilies::new(plate.lattice.points());
    for (mut rows, whole) in blocks.into_values() {
        rows.values_mut().flatten().for_each(|r| *r /= whole);
        means.push(&members(&rows), [[0.0; 2]], [[modulus * whole]]);
    }
    means
}

/// Rows as members of a family.
fn members(rows: &BTreeMap<u32, [f64; 2]>) -> Vec<WideMember<2, 1>> {
    let share = 1.0 / rows.len() as f64;
    rows.iter().map(|(&point, &row)| WideMember { point, share, rows: [row] }).collect()
}

fn add(rows: &mut BTreeMap<u32, [f64; 2]>, point: u32, row: [f64; 2]) {
    let own = rows.entry(point).or_default();
    (0..2).for_each(|c| own[c] += row[c]);
}
