//! What bonds through several materials leave to the points of a solid, and what these get of them.

use super::super::plane::{LatticeBond, Mirrors, MixedBonds, Mixture, Path, UnevenBonds};
use super::bond::SolidBond;
use super::tetrahedra::{Corners, rows_of_cells, tetrahedra};
use super::{SolidLaw, TENSOR};
use crate::body::{Cell, SquareLattice, plus};
use crate::bonds::{BondGeometry, BondModel, Mat, add, block};
use crate::stiffness::{Exception, Families, Family};
use std::collections::{BTreeMap, HashSet};
use std::sync::Arc;

/// The bonds of a solid of several materials, as far as they are not those of one.
#[derive(Clone, Debug)]
pub(super) struct Interface {
    pub(super) mixture: Arc<Mixture>,
    /// Factors of bonds by offset and lower point.
    pub(super) exceptions: Vec<Exception>,
    pub(super) uneven: UnevenBonds<1>,
    /// Tetrahedra that give back what points lack: first of bonds between points, then of those that end on the border.
    pub(super) families: Arc<Families<3, TENSOR, 3>>,
    /// Number of the first ones, which tell stresses, too.
    stress_count: usize,
    mirrors: Mirrors,
    /// Points that no tetrahedron gives what they lack.
    pub(super) lost: usize,
}

impl Interface {
    /// That of a solid; `gaps` are bonds that give way to what completes the border, and `beside` is what bonds that end there
    /// leave to points.
    pub(super) fn new(
        (lattice, mirrors): (&SquareLattice, &Mirrors),
        (law, bond): (&SolidLaw, SolidBond),
        mixture: Arc<Mixture>,
        (cuts, gaps): (&HashSet<(usize, usize)>, &[Exception]),
        beside: &[(usize, usize, [f64; 1])],
    ) -> Self {
        let neighbourhood = &law.neighbourhood;
        let absent = cuts.iter().copied().chain(gaps.iter().map(|gap| (gap.offset, gap.lower))).collect();
        let bonds = MixedBonds::new((lattice, mirrors), neighbourhood, &mixture, &absent);
        let unit = |k: usize| -> Mat<TENSOR, TENSOR> {
            let geometry = BondGeometry { xi: lattice.vector(neighbourhood.offsets[k]) };
            let (uniform, [unit]) = (bond.in_uniform_state(&geometry), bond.moduli(&geometry));
            block(&uniform, &[unit], &uniform)
        };
        let unit: Vec<Mat<TENSOR, TENSOR>> = (0..neighbourhood.offsets.len()).map(unit).collect();
        let (mut families, mut stress_count, mut lost) = (Vec::new(), 0, 0);
        for (lacks, tells) in [(&bonds.lacks[..], true), (beside, false)] {
            let mut by_point: BTreeMap<usize, Mat<TENSOR, TENSOR>> = BTreeMap::new();
            for &(point, k, [weight]) in lacks {
                let own = unit[k].map(|row| row.map(|v| weight * v));
                add(by_point.entry(point).or_insert([[0.0; TENSOR]; TENSOR]), &own);
            }
            for (point, own) in by_point {
                let corners = alike(
                    lattice,
                    &mixture,
                    point,
                    tetrahedra(lattice, neighbourhood, cuts, lattice.cell(point)),
                );
                lost += usize::from(corners.is_empty());
                let modulus = own.map(|row| row.map(|v| v / corners.len().max(1) as f64));
                families
                    .extend(corners.iter().filter_map(|&corners| family(lattice, point, corners, modulus)));
            }
            stress_count = if tells { families.len() } else { stress_count };
        }
        let families = Arc::new(Families::new(lattice.points(), families));
        let MixedBonds { exceptions, uneven, .. } = bonds;
        Self { mixture, exceptions, uneven, families, stress_count, mirrors: *mirrors, lost }
    }

    /// What a point owns of the bond at a step, of half a bond of its own material.
    pub(super) fn seen(&self, lattice: &SquareLattice, point: usize, step: Cell) -> f64 {
        let (cell, path) = (lattice.cell(point), Path::of(step));
        let pieces = path.pieces().map(|(piece, part)| (plus(cell, piece), part));
        let through = self.mixture.through((lattice, &self.mirrors), pieces);
        1.0 - 2.0 * through.lacks[0][0] / self.mixture.of(point)
    }

    /// The tetrahedra by their points.
    pub(super) fn by_points(&self) -> BTreeMap<usize, Vec<&Family<3, TENSOR, 3>>> {
        let mut by_points: BTreeMap<usize, Vec<_>> = BTreeMap::new();
        for family in self.families.list() {
            by_points.entry(family.point as usize).or_default().push(family);
        }
        by_points
    }

    /// The tetrahedra that have one of some pairs of points for an edge.
    pub(super) fn beside(&self, pairs: &HashSet<[u32; 2]>) -> Vec<Family<3, TENSOR, 3>> {
        self.families.list().iter().filter(|tetrahedron| spans(tetrahedron, pairs)).copied().collect()
    }

    /// Forgets the tetrahedra that have one of some pairs of points for an edge.
    pub(super) fn part(&mut self, pairs: &HashSet<[u32; 2]>) {
        let goes = |tetrahedron: &&Family<3, TENSOR, 3>| spans(tetrahedron, pairs);
        self.stress_count -= self.stress_families().iter().filter(goes).count();
        // A body that keeps all of them shares them with its copies.
        if self.families.list().iter().any(|tetrahedron| goes(&tetrahedron)) {
            Arc::make_mut(&mut self.families).retain(|tetrahedron| !goes(&tetrahedron));
        }
    }

    /// The tetrahedra that tell stresses.
    pub(super) fn stress_families(&self) -> &[Family<3, TENSOR, 3>] {
        &self.families.list()[..self.stress_count]
    }

    /// Adds the work of all tetrahedra in the strains `t` of their points, six planes.
    pub(super) fn add_work(&self, t: &[f64], force: &mut [f64]) {
        self.families.list().iter().for_each(|family| family.add_strain_work(TENSOR, t, force));
    }
}

/// Whether an edge of a tetrahedron is one of some pairs, the lower point first.
fn spans(tetrahedron: &Family<3, TENSOR, 3>, pairs: &HashSet<[u32; 2]>) -> bool {
    let ([a, b, c], p) = (tetrahedron.others, tetrahedron.point);
    let edges = [[p, a], [p, b], [p, c], [a, b], [a, c], [b, c]];
    edges.into_iter().any(|[i, j]| pairs.contains(&[i.min(j), i.max(j)]))
}

/// Those of some tetrahedra that have no points whose strains are others, if there are such.
fn alike(lattice: &SquareLattice, mixture: &Mixture, point: usize, all: Vec<Corners>) -> Vec<Corners> {
    let cell = lattice.cell(point);
    let strains_apart = |step: &[i32; 3]| {
        lattice.number(plus(cell, *step)).is_some_and(|other| mixture.strains_apart(other, point))
    };
    let alike: Vec<Corners> = all.iter().copied().filter(|c| !c.iter().any(strains_apart)).collect();
    if alike.is_empty() { all } else { alike }
}

/// A tetrahedron of a point.
fn family(
    lattice: &SquareLattice,
    point: usize,
    corners: Corners,
    modulus: Mat<TENSOR, TENSOR>,
) -> Option<Family<3, TENSOR, 3>> {
    let cell = lattice.cell(point);
    let mut others = [0; 3];
    for (other, step) in others.iter_mut().zip(corners) {
        *other = lattice.number(plus(cell, step))? as u32;
    }
    let rows = rows_of_cells(corners, lattice.spacing());
    Some(Family { point: point as u32, others, rows, own: [[0.0; 3]; TENSOR], modulus })
}
