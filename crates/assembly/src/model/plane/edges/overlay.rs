//! The deficit overlay: triangles with the stiffness of missing bonds.
//!
//! A bond with the moduli c and the measures `U E` in a uniform state E has the energy `½ Eᵀ Uᵀ c U E`, half of it for
//! either end. A point whose bonds are missing lacks `D = ½ Σ_missing Uᵀ c U >= 0`, and one with a part `a_i` of a cell and
//! reduced bonds `D = ½ Σ (a_i − f_ij) Uᵀ c U` over all bonds that an inner point has. It gets it back as the energy
//! `½ Eᵀ D E/n` of each of the n <= 4 triangles that it makes with two next neighbours, E their state: so every point has
//! exactly the stiffness of the material in every uniform state, and nothing becomes indefinite.

use super::super::bond::PlaneBond;
use super::super::geometry;
use super::super::mixture::Mixture;
use super::super::near::at;
use super::super::neighbourhood::Neighbourhood;
use super::cut::modulus;
use super::deficit::Shares;
use crate::body::{Cell, SquareLattice, minus, plus};
use crate::bonds::{Mat, add};
use crate::stiffness::{Exception, Family};
use std::collections::{HashMap, HashSet};

/// Triangles and the number of points that lack bonds but have no triangle.
#[derive(Clone, Debug)]
pub(in super::super) struct Overlay<const D: usize, const S: usize> {
    pub(in super::super) triangles: Vec<Family<D, S, 2>>,
    pub(in super::super) uncorrected: usize,
}

/// Two other corners of a triangle.
type Corners = [Cell; 2];

/// Builds the triangles of some points, but those with a cut side. Bonds of `gaps` are missing, too, although both of their
/// points are there. Points of a mixture lack what they would have of their own material.
pub(in super::super) fn overlay<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    lattice: &SquareLattice,
    (neighbourhood, bond): (&Neighbourhood<M>, &B),
    points: impl Iterator<Item = usize>,
    (cuts, mixture): (&HashSet<(usize, usize)>, Option<&Mixture>),
    gaps: &[Exception],
) -> Overlay<D, S> {
    let of_table = |table: usize| {
        Shares::new(neighbourhood, |k| {
            let half = neighbourhood.weights_of(table, k).map(|weight| 0.5 * weight);
            modulus(lattice, bond, neighbourhood.offsets[k], &half)
        })
    };
    let shares: Vec<Shares<S>> = (0..=neighbourhood.others.len()).map(of_table).collect();
    let mut overlay = Overlay { triangles: Vec::new(), uncorrected: 0 };
    let mut across: HashMap<usize, Vec<(usize, f64)>> = HashMap::new();
    for gap in gaps {
        let upper = lattice.number(at(lattice.cell(gap.lower), neighbourhood.offsets[gap.offset], true));
        let ends = [Some(gap.lower), upper].into_iter().flatten();
        let part = ends.clone().map(|point| lattice.fraction(point)).fold(f64::INFINITY, f64::min);
        ends.for_each(|point| across.entry(point).or_default().push((gap.offset, part)));
    }
    for point in points {
        let cell = lattice.cell(point);
        let shares = &shares[mixture.map_or(0, |mixture| mixture.table(point))];
        let Some(mut deficit) = shares.deficit(lattice, cell) else { continue };
        let own = across.get(&point).into_iter().flatten();
        own.for_each(|&(offset, part)| {
            add(&mut deficit, &scaled(shares.of_offset(neighbourhood.offsets[offset]), part));
        });
        if let Some(mixture) = mixture {
            deficit = scaled(&deficit, mixture.of(point));
        }
        let own = triangles_of(lattice, (neighbourhood, bond), (point, &deficit), cuts, mixture);
        overlay.uncorrected += usize::from(own.is_empty());
        overlay.triangles.extend(own);
    }
    overlay
}

/// A matrix times a factor.
fn scaled<const S: usize>(matrix: &Mat<S, S>, factor: f64) -> Mat<S, S> {
    matrix.map(|row| row.map(|v| factor * v))
}

/// The triangles that give a point what it lacks, equal parts of it each: but those with a cut side, and in a mixture those with
/// points whose strains are others, if some are left.
pub(in super::super) fn triangles_of<
    const D: usize,
    const M: usize,
    const S: usize,
    B: PlaneBond<D, M, S>,
>(
    lattice: &SquareLattice,
    (neighbourhood, bond): (&Neighbourhood<M>, &B),
    (point, lacks): (usize, &Mat<S, S>),
    cuts: &HashSet<(usize, usize)>,
    mixture: Option<&Mixture>,
) -> Vec<Family<D, S, 2>> {
    let cell = lattice.cell(point);
    let mut corners = quadrants(lattice, cell);
    if corners.is_empty() {
        corners = nearest(lattice, neighbourhood, cell);
    }
    corners.retain(|&[a, b]| {
        [(cell, a), (cell, b), (a, b)]
            .into_iter()
            .all(|(from, to)| !is_cut(lattice, neighbourhood, cuts, from, to))
    });
    if let Some(mixture) = mixture {
        let strains_apart =
            |cell: &Cell| lattice.number(*cell).is_some_and(|other| mixture.strains_apart(other, point));
        let alike: Vec<Corners> = corners.iter().copied().filter(|c| !c.iter().any(strains_apart)).collect();
        if !alike.is_empty() {
            corners = alike;
        }
    }
    let modulus = lacks.map(|row| row.map(|v| v / corners.len().max(1) as f64));
    let triangle = |&[a, b]: &Corners| {
        let from_point = |c: Cell| {
            let [x, y, _] = geometry(lattice, minus(c, cell)).xi;
            [x, y]
        };
        let (rows, own) = bond.triangle(from_point(a), from_point(b));
        let others = [lattice.number(a)? as u32, lattice.number(b)? as u32];
        Some(Family { point: point as u32, others, rows, own, modulus })
    };
    corners.iter().filter_map(triangle).collect()
}

/// The triangles with the next cells to the left or right and above or below.
fn quadrants(lattice: &SquareLattice, cell: Cell) -> Vec<Corners> {
    let exists = |c: &Cell| lattice.number(*c).is_some();
    let all =
        [1, -1].into_iter().flat_map(|x| [1, -1].map(|y| [plus(cell, [x, 0, 0]), plus(cell, [0, y, 0])]));
    all.filter(|corners| corners.iter().all(exists)).collect()
}

/// Triangles are as good as the best if they are so up to this factor.
const AS_GOOD: f64 = 4.0;

/// The nearest, best shaped triangles of neighbours within the horizon: all that are about equally good, so that images in
/// a mirror choose images, and that a point is not a hinge between the triangles on its sides.
fn nearest<const M: usize>(
    lattice: &SquareLattice,
    neighbourhood: &Neighbourhood<M>,
    cell: Cell,
) -> Vec<Corners> {
    let squared = |[x, y, _]: Cell| f64::from(x * x + y * y);
    let steps = neighbourhood.offsets.iter().flat_map(|&step| [step, step.map(|k| -k)]);
    let mut near: Vec<Cell> = steps.filter(|&s| lattice.number(at(cell, s, true)).is_some()).collect();
    near.sort_by(|&a, &b| squared(a).total_cmp(&squared(b)));
    let mut found: Vec<(f64, Corners)> = Vec::new();
    let mut least = f64::INFINITY;
    for (k, &b) in near.iter().enumerate() {
        // The badness of a triangle is at least the square of its longest side.
        if squared(b) > AS_GOOD * least {
            break;
        }
        for &a in &near[..k] {
            let twice_area = (a[0] * b[1] - a[1] * b[0]).abs();
            if twice_area != 0 && neighbourhood.between(a, b).is_some() {
                let sides = squared(a) + squared(b) + squared(minus(b, a));
                let badness = sides * sides / f64::from(twice_area);
                least = least.min(badness);
                found.push((badness, [at(cell, a, true), at(cell, b, true)]));
            }
        }
    }
    found.into_iter().filter(|f| f.0 <= AS_GOOD * least).map(|f| f.1).collect()
}

/// Whether the bond between two cells is cut.
pub(in super::super::super) fn is_cut<const M: usize>(
    lattice: &SquareLattice,
    neighbourhood: &Neighbourhood<M>,
    cuts: &HashSet<(usize, usize)>,
    from: Cell,
    to: Cell,
) -> bool {
    if cuts.is_empty() {
        return false;
    }
    let Some((offset, up)) = neighbourhood.between(from, to) else { return false };
    lattice.number(if up { from } else { to }).is_some_and(|lower| cuts.contains(&(offset, lower)))
}
