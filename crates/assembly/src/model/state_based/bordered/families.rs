//! Dilatations of all points: of those that have all bonds by offset, of the others with what completes the border.
//!
//! With `c = a/(8μ)` of a bond of weight a and stretch s a whole family has `ϑ = Σ c s`, which is the trace of any uniform strain.
//! A point without some bonds takes parts of its bonds and of what completes the border
//! ([`Transport`](super::transport::Transport)), which have the tensor `V_k 1` together: then `ϑ_k = Σ parts/V_k` is exact, too.
//! All parts are taken: `Σ V_k ϑ_k` is the change of volume of the body as its border has it, and a uniform stress is in equilibrium. No
//! part is negative, and so by the inequality of Cauchy and Schwarz the families never take more energy than bonds have.

use super::super::{Dilatation, StateParameters};
use super::border::add_border;
use super::hoops::{Hoop, hoops};
use super::own_bonds::PointBonds;
use super::reach::{Lacking, Need, transport};
use super::rings::weight;
use super::sources::{Bonded, Source, Sources, add};
use super::transport::Transport;
use crate::body::{Cell, SquareLattice};
use crate::bonds::Mat;
use crate::stiffness::{GridFamilies, GridFamily, WideFamilies, WideMember};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Degrees of the splines with which points reach for places: as far as it takes.
const DEGREES: [i32; 3] = [3, 5, 9];
/// How much of being without a deviator points of a body of revolution give up where they cannot all be. Bonds count by the radius of their middle, and
/// families by that of their point: along a border with bonds of more than one row a deviator of about a tenth of a cell per
/// spacing, per radius in spacings, is left that belongs to no point.
const SLACK: f64 = 1e-2;
/// Largest deviator of a point that counts as none: cells. Rounding leaves 1e-14.
pub(super) const NONE: f64 = 1e-12;
/// The same of what bodies of revolution give up anyway, and of the volumes of hoop strains, per that of a cell at the largest
/// radius.
const NONE_OF_RINGS: f64 = 1e-4;

/// Dilatations as energies.
#[derive(Clone, Debug)]
pub(in super::super) struct Dilatations {
    /// Of points that have all bonds.
    pub(in super::super) grid: Arc<GridFamilies>,
    /// Of the others.
    pub(in super::super) own: Arc<WideFamilies<2, 2>>,
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

/// Dilatations of some points as rows, of bodies of revolution hoop strains, and their volumes, cells.
struct Measured {
    rows: Vec<Rows>,
    hoops: Vec<Hoop>,
    volumes: Vec<f64>,
    /// Largest deviator that is left.
    left: f64,
}

impl Measured {
    /// Those of points that take all parts of some sources.
    fn new(plate: &Bonded, points: &[Lacking], sources: &[Source]) -> Self {
        // The largest volume of a cell is one.
        let scale = 1.0 / points.iter().fold(1.0, |most: f64, point| most.max(point.weight));
        let (transport, left) = solved(plate, points, sources, scale);
        let mut found = Self { rows: Vec::new(), hoops: Vec::new(), volumes: Vec::new(), left };
        let mut from = 0;
        for &end in &transport.ends {
            let (mut rows, mut volume) = (Rows::new(), 0.0);
            for edge in &transport.edges[from..end] {
                let source = &sources[edge.place as usize];
                let part = edge.volume / (scale * source.volume());
                source.rows.iter().for_each(|(point, row)| add(&mut rows, *point, row.map(|r| part * r)));
                volume += edge.volume / scale;
            }
            // What has nothing measures nothing.
            let volume_or_one = if volume > 0.0 { volume } else { 1.0 };
            rows.values_mut().flatten().for_each(|r| *r /= volume_or_one);
            found.rows.push(rows);
            found.volumes.push(volume);
            from = end;
        }
        if plate.mirrors.revolved {
            let (hoops, left) = hoops(plate, points, &found.volumes, scale);
            (found.hoops, found.left) = (hoops, if left < NONE_OF_RINGS { found.left } else { left });
        }
        found
    }

    /// Measures of a point as members of a family, and what a common motion makes of them.
    fn family(&self, k: usize) -> (Vec<WideMember<2, 2>>, Mat<2, 2>) {
        let none = Hoop::new();
        let hoop = self.hoops.get(k).unwrap_or(&none);
        let all: BTreeSet<u32> = self.rows[k].keys().chain(hoop.keys()).copied().collect();
        let share = 1.0 / all.len() as f64;
        let member = |&point: &u32| {
            let row = self.rows[k].get(&point).copied().unwrap_or_default();
            WideMember { point, share, rows: [row, [hoop.get(&point).copied().unwrap_or_default(), 0.0]] }
        };
        (all.iter().map(member).collect(), [[0.0; 2], [hoop.values().sum(), 0.0]])
    }
}

/// The transport from sources to points, and the largest deviator that it leaves. Points reach as far as it takes.
fn solved(plate: &Bonded, points: &[Lacking], sources: &[Source], scale: f64) -> (Transport, f64) {
    let solved = |degree: i32, slack: f64| {
        let need = (Need::Directions(degree), scale);
        let mut transport = transport(sources, points, &plate.mirrors, need, slack);
        let left = transport.solve();
        (transport, left)
    };
    let mut found = solved(DEGREES[0], 0.0);
    if plate.mirrors.revolved && found.1 >= NONE {
        let (transport, left) = solved(DEGREES[0], SLACK);
        return (transport, if left < NONE_OF_RINGS { 0.0 } else { left });
    }
    for &degree in &DEGREES[1..] {
        if found.1 < NONE {
            break;
        }
        found = solved(degree, 0.0);
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
        let measured = Measured::new(plate, &points, &sources);
        let cell = plate.kind.bond.volume;
        let modulus = parameters.family_modulus();
        let mut own = WideFamilies::new(plate.lattice.points());
        for (k, volume) in measured.volumes.iter().enumerate() {
            let (members, common) = measured.family(k);
            own.push(&members, common, modulus.map(|row| row.map(|c| cell * volume * c)));
        }
        let numbers: Vec<u32> = points.iter().map(|p| p.point as u32).collect();
        let mean_modulus = if by_blocks { parameters.bulk_modulus() } else { 0.0 };
        let means = by_blocks.then(|| Arc::new(means(plate, &points, &measured, cell * mean_modulus)));
        let is_real = |p: usize| plate.mirrors.is_none() || plate.mirrors.is_real(plate.lattice.cell(p));
        let has_all = |p: usize| is_real(p) && numbers.binary_search(&(p as u32)).is_err();
        let all = || 0..plate.lattice.points();
        let weights: Vec<f64> = all().map(|p| weight(plate, p)).collect();
        let hoop = |w: &f64| 1.0 / (w * plate.lattice.spacing());
        let family = GridFamily {
            steps: bonds.steps,
            sets: vec![bonds.rows],
            set_of: all().map(|p| has_all(p).then_some(0)).collect(),
            own: match plate.mirrors.revolved {
                true => {
                    weights.iter().zip(all()).map(|(w, p)| if has_all(p) { hoop(w) } else { 0.0 }).collect()
                }
                false => Vec::new(),
            },
            volume: weights.into_iter().map(|w| cell * w).collect(),
            modulus,
            mean_modulus,
        };
        let grid = Arc::new(GridFamilies::new(plate.lattice.clone(), family));
        let Measured { volumes, left, .. } = measured;
        Self { grid, own: Arc::new(own), means, points: numbers, volumes, left }
    }
}

/// Means of dilatations, hoop strains among them, over blocks of two by two cells.
fn means(plate: &Bonded, points: &[Lacking], measured: &Measured, modulus: f64) -> WideFamilies<2, 1> {
    let mut blocks: BTreeMap<Cell, (Rows, f64)> = BTreeMap::new();
    for (k, lacking) in points.iter().enumerate() {
        let (sum, whole) = blocks.entry(SquareLattice::parent(lacking.cell)).or_default();
        let volume = measured.volumes[k];
        measured.rows[k].iter().for_each(|(&point, row)| add(sum, point, row.map(|r| volume * r)));
        let hoop = measured.hoops.get(k).into_iter().flatten();
        hoop.for_each(|(&point, row)| add(sum, point, [volume * row, 0.0]));
        *whole += volume;
    }
    let mut means = WideFamilies::new(plate.lattice.points());
    for (mut rows, whole) in blocks.into_values() {
        rows.values_mut().flatten().for_each(|r| *r /= whole);
        let share = 1.0 / rows.len() as f64;
        let members: Vec<WideMember<2, 1>> =
            rows.iter().map(|(&point, &row)| WideMember { point, share, rows: [row] }).collect();
        // Dilatations of a common motion are zero but for the hoop.
        let common = rows.values().map(|row| row[0]).sum::<f64>();
        let common = if plate.mirrors.revolved { [[common, 0.0]] } else { [[0.0; 2]] };
        means.push(&members, common, [[modulus * whole]]);
    }
    means
}
