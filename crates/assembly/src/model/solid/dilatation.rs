//! Families that feel changes of volume, `ϑ_k = Σ (3w/q) |ξ| e`, with what tetrahedra, or bonds on the
//! border, measure in place of missing bonds.
//!
//! Of several materials a point takes of every bond the part that it owns of half a bond of its own material, and the rest from the
//! tetrahedra that give it back: then ϑ is exact in every uniform strain, and by the inequality of Cauchy and Schwarz it never takes
//! more energy than what it is made of has, whatever Poisson's ratio.

use super::super::plane::is_up;
use super::body::Reach;
use super::border::Border;
use super::corners::Overlay;
use super::interface::Interface;
use super::{SolidLaw, TENSOR};
use crate::body::{Cell, SquareLattice, minus, plus};
use crate::stiffness::{Exception, Family, FamilyRows, GridFamilies, GridFamily};
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::sync::Arc;

/// The families of the real points of a lattice; none of a law without dilatation. Points that lack nothing share their rows.
pub(super) fn families(
    (lattice, law, reach): (&Arc<SquareLattice>, &SolidLaw, &Reach),
    (overlay, border, interface): (&Overlay, Option<&Border>, Option<&Interface>),
    (near, ghosts): (&[usize], &[u32]),
    (cuts, gaps): (&[(usize, usize)], &[Exception]),
) -> Option<GridFamilies<3>> {
    let dilatation = law.dilatation.as_ref()?;
    let spacing = lattice.spacing();
    let steps = Steps::new(reach, border);
    // (3w/q) |ξ| n, lengths in spacings but for the last: per m.
    let mut plain: FamilyRows<3> = vec![[0.0; 3]; steps.all.len()];
    for (k, step) in reach.steps.iter().enumerate() {
        let share = dilatation.shares[reach.offset_of(k)] / spacing;
        plain[steps.of[step]] = step.map(|x| share * f64::from(x));
    }
    let mut sets = vec![plain];
    let mut known: HashMap<Vec<[u64; 3]>, u32> = HashMap::new();
    let mut set_of = vec![Some(0); lattice.points()];
    let mut lacking = without(lattice, law, reach, near, (cuts, gaps));
    let own = |point: usize| interface.map_or(1.0, |interface| interface.mixture.of(point));
    let given = interface.map(Interface::by_points).unwrap_or_default();
    for point in given.keys() {
        lacking.entry(*point).or_insert_with(|| vec![false; reach.steps.len()]);
    }
    for (point, gone) in lacking {
        let mut rows = sets[0].clone();
        let lost = gone.iter().zip(&reach.steps).filter(|(gone, _)| **gone);
        lost.for_each(|(_, step)| rows[steps.of[step]] = [0.0; 3]);
        if let Some(interface) = interface {
            let seen = |step: &Cell| interface.seen(lattice, point, *step);
            let kept = gone.iter().zip(&reach.steps).filter(|(gone, _)| !**gone);
            kept.for_each(|(_, step)| rows[steps.of[step]].iter_mut().for_each(|r| *r *= seen(step)));
        }
        match border {
            Some(border) => add_border(&mut rows, &steps, border.rows.get(&point)),
            None => add_tetrahedra(&mut rows, &steps, overlay, point),
        }
        for family in given.get(&point).into_iter().flatten() {
            add_given(&mut rows, &steps, (lattice, law.material.shear_modulus() * own(point)), family);
        }
        let bits = rows.iter().map(|row| row.map(f64::to_bits)).collect();
        set_of[point] = Some(*known.entry(bits).or_insert_with(|| {
            sets.push(rows);
            sets.len() as u32 - 1
        }));
    }
    ghosts.iter().for_each(|&ghost| set_of[ghost as usize] = None);
    let volume = |point: usize| spacing.powi(3) * lattice.fraction(point) * own(point);
    let family = GridFamily {
        steps: steps.all,
        sets,
        set_of,
        volume: (0..lattice.points()).map(volume).collect(),
        own: Vec::new(),
        modulus: [[dilatation.modulus, 0.0], [0.0; 2]],
        mean_modulus: 0.0,
    };
    Some(GridFamilies::new(lattice.clone(), family))
}

/// Steps from a point to all that its dilatation can depend on: a half, then their opposites.
struct Steps {
    all: Vec<Cell>,
    /// Index of a step.
    of: HashMap<Cell, usize>,
}

impl Steps {
    fn new(reach: &Reach, border: Option<&Border>) -> Self {
        let upwards = |step: &Cell| if is_up(*step) { *step } else { step.map(|k| -k) };
        let mut half: Vec<Cell> = reach.steps[..reach.steps.len() / 2].to_vec();
        let beyond =
            border.iter().flat_map(|border| border.rows.values().flat_map(|rows| rows.keys().map(upwards)));
        let known: HashSet<Cell> = half.iter().copied().collect();
        let new: BTreeSet<Cell> = beyond.filter(|step| !known.contains(step)).collect();
        half.extend(new);
        let all: Vec<Cell> = half.iter().copied().chain(half.iter().map(|step| step.map(|k| -k))).collect();
        let of = all.iter().enumerate().map(|(k, step)| (*step, k)).collect();
        Self { all, of }
    }
}

/// Points that lack bonds, and which by their steps: there is no point, the border parts them, or they are cut.
fn without(
    lattice: &SquareLattice,
    law: &SolidLaw,
    reach: &Reach,
    near: &[usize],
    (cuts, gaps): (&[(usize, usize)], &[Exception]),
) -> BTreeMap<usize, Vec<bool>> {
    let missing = |&point: &usize| (point, reach.missing(lattice, lattice.cell(point)));
    let mut gone: BTreeMap<usize, Vec<bool>> = near.iter().map(missing).collect();
    let gaps = gaps.iter().map(|gap| (gap.offset, gap.lower));
    for (offset, lower) in cuts.iter().copied().chain(gaps) {
        let upper = lattice.number(plus(lattice.cell(lower), law.neighbourhood.offsets[offset]));
        for (point, is_lower) in [(Some(lower), true), (upper, false)] {
            let Some(point) = point else { continue };
            let own = gone.entry(point).or_insert_with(|| vec![false; reach.steps.len()]);
            own[reach.step_of(offset, is_lower)] = true;
        }
    }
    gone
}

/// Adds the rows that bonds on the border bring to a point.
fn add_border(rows: &mut FamilyRows<3>, steps: &Steps, of: Option<&BTreeMap<Cell, [f64; 3]>>) {
    for (step, part) in of.into_iter().flatten() {
        let row = &mut rows[steps.of[step]];
        (0..3).for_each(|c| row[c] += part[c]);
    }
}

/// Adds what the tetrahedra of a point measure in place of missing bonds.
fn add_tetrahedra(rows: &mut FamilyRows<3>, steps: &Steps, overlay: &Overlay, point: usize) {
    let Some(kind) = overlay.of_point.get(&point).map(|&kind| &overlay.kinds[kind]) else { return };
    for (other, strain) in kind.others.iter().zip(kind.strain.chunks_exact(3)) {
        let row = &mut rows[steps.of[other]];
        (0..3).for_each(|c| row[c] += (0..TENSOR).map(|q| kind.dilatation[q] * strain[c][q]).sum::<f64>());
    }
}

/// Adds what a tetrahedron of a point with the shear modulus G measures in place of what bonds through softer materials leave: with
/// the stiffness `D` of that it is `D 1 : E/(5 G V)`, as a bond of the weight a has `(3w/q) ξ² = a/(10 G)`.
fn add_given(
    rows: &mut FamilyRows<3>,
    steps: &Steps,
    (lattice, shear): (&SquareLattice, f64),
    family: &Family<3, TENSOR, 3>,
) {
    let scale = 1.0 / (5.0 * shear * lattice.spacing().powi(3));
    let trace = family.modulus.map(|row| scale * (row[0] + row[1] + row[2]));
    let cell = lattice.cell(family.point as usize);
    for (&other, strain) in family.others.iter().zip(&family.rows) {
        let row = &mut rows[steps.of[&minus(lattice.cell(other as usize), cell)]];
        (0..3).for_each(|c| row[c] += (0..TENSOR).map(|q| trace[q] * strain[q][c]).sum::<f64>());
    }
}
