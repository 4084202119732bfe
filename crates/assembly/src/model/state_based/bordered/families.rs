//! Dilatations of all points: of those that have all bonds by offset, of the others with what completes the border.
//!
//! With `c = a/(8μ)` of a bond of weight a and stretch s a whole family has `ϑ = Σ c s`, which is the trace of any uniform strain.
//! A point without some bonds takes parts of its bonds and of what completes the border
//! ([`Transport`](super::transport::Transport)), which have the tensor `V_k 1` together: then `ϑ_k = Σ parts/V_k` is exact, too.
//! All parts are taken: `Σ V_k ϑ_k` is the change of volume of the body as its border has it, and a uniform stress is in equilibrium. No
//! part is negative, and so by the inequality of Cauchy and Schwarz the families never take more energy than bonds have.

use super::super::{Dilatation, StateParameters};
use super::border::add_border;
use super::own_bonds::PointBonds;
use super::reach::{Lacking, transport};
use super::sources::{Bonded, Source, Sources, add};
use super::transport::Transport;
use crate::body::{Cell, SquareLattice};
use crate::stiffness::{GridFamilies, GridFamily, WideFamilies, WideMember};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Degrees of the splines with which points reach for places: as far as it takes.
const DEGREES: [i32; 3] = [3, 5, 9];
/// Largest deviator of a point that counts as none: cells. Rounding leaves 1e-14.
pub(super) const NONE: f64 = 1e-12;

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

/// Rows of points, by these.
type Rows = BTreeMap<u32, [f64; 2]>;

/// Dilatations of some points as rows, and their volumes, cells.
struct Measured {
    rows: Vec<Rows>,
    volumes: Vec<f64>,
    /// Largest deviator that is left.
    left: f64,
}

impl Measured {
    /// Those of points that take all parts of some sources.
    fn new(plate: &Bonded, points: &[Lacking], sources: &[Source]) -> Self {
        let (transport, left) = solved(plate, points, sources);
        let mut found = Self { rows: Vec::new(), volumes: Vec::new(), left };
        let mut from = 0;
        for &end in &transport.ends {
            let (mut rows, mut volume) = (Rows::new(), 0.0);
            for edge in &transport.edges[from..end] {
                let source = &sources[edge.place as usize];
                let part = edge.volume / source.volume();
                source.rows.iter().for_each(|(point, row)| add(&mut rows, *point, row.map(|r| part * r)));
                volume += edge.volume;
            }
            // What has nothing measures nothing.
            let volume_or_one = if volume > 0.0 { volume } else { 1.0 };
            rows.values_mut().flatten().for_each(|r| *r /= volume_or_one);
            found.rows.push(rows);
            found.volumes.push(volume);
            from = end;
        }
        found
    }
}

/// The transport from sources to points, and the largest deviator that it leaves. Points reach as far as it takes.
fn solved(plate: &Bonded, points: &[Lacking], sources: &[Source]) -> (Transport, f64) {
    let solved = |degree: i32| {
        let mut transport = transport(sources, points, &plate.mirrors, degree);
        let left = transport.solve();
        (transport, left)
    };
    let mut found = solved(DEGREES[0]);
    for &degree in &DEGREES[1..] {
        if found.1 < NONE {
            break;
        }
        found = solved(degree);
    }
    found
}

impl Dilatations {
    /// Those of a plate whose bonds have the shear modulus of some parameters.
    pub(super) fn new(plate: &Bonded, parameters: &StateParameters) -> Self {
        let by_blocks = parameters.dilatation == Dilatation::Blocks;
        let bonds = PointBonds::new(plate, parameters.shear_modulus());
        let points = bonds.lacking(by_blocks);
        let mut sources = Sources::default();
        bonds.add_sources(&points, &mut sources);
        add_border(plate, parameters.shear_modulus(), &mut sources);
        let sources = sources.list();
        let Measured { rows, volumes, left } = Measured::new(plate, &points, &sources);
        let cell = plate.kind.bond.volume;
        let modulus = parameters.family_modulus();
        let mut own = WideFamilies::new(plate.lattice.points());
        for (rows, volume) in rows.iter().zip(&volumes) {
            own.push(&members(rows), [[0.0; 2]], [[cell * volume * modulus[0][0]]]);
        }
        let numbers: Vec<u32> = points.iter().map(|p| p.point as u32).collect();
        let mean_modulus = if by_blocks { parameters.bulk_modulus() } else { 0.0 };
        let means =
            by_blocks.then(|| Arc::new(means(plate, &points, (&rows, &volumes), cell * mean_modulus)));
        let is_real = |p: usize| plate.mirrors.is_none() || plate.mirrors.is_real(plate.lattice.cell(p));
        let has_all = |p: usize| is_real(p) && numbers.binary_search(&(p as u32)).is_err();
        let family = GridFamily {
            steps: bonds.steps,
            sets: vec![bonds.rows],
            set_of: (0..plate.lattice.points()).map(|p| has_all(p).then_some(0)).collect(),
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
    (rows, volumes): (&[Rows], &[f64]),
    modulus: f64,
) -> WideFamilies<2, 1> {
    let mut blocks: BTreeMap<Cell, (Rows, f64)> = BTreeMap::new();
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
fn members(rows: &Rows) -> Vec<WideMember<2, 1>> {
    let share = 1.0 / rows.len() as f64;
    rows.iter().map(|(&point, &row)| WideMember { point, share, rows: [row] }).collect()
}
