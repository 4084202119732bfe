//! Bonds of a body that is a square lattice.
//!
//! With the overlay, a point i of a cell that the border cuts has the volume `a_i V`. A bond counts by the smaller part of
//! its two ends, `f_ij = min(a_i, a_j)`, so that what a point lacks, `a_i C − ½ Σ_j f_ij a N Nᵀ`, is never negative; the
//! overlay gives it back. Other treatments of edges have whole cells.

use super::super::plane::{Mirrors, at, near_points};
use super::edges::{EdgeFactors, Overlay, edge_factors, overlay};
use super::neighbourhood::Neighbourhood;
use super::{CentralBond, Edges, FindCuts, PlaneParameters};
use crate::body::SquareLattice;
use crate::stiffness::{Exception, Families, GridBonds, Offset};
use std::collections::HashSet;
use std::sync::Arc;

/// Bonds by offset.
pub(super) type Grid = GridBonds<2, 1, CentralBond>;

/// A lattice with its bonds.
#[derive(Clone, Debug)]
pub(super) struct LatticeBody {
    pub(super) lattice: Arc<SquareLattice>,
    pub(super) mirrors: Mirrors,
    /// Images of real points.
    pub(super) ghosts: Vec<u32>,
    pub(super) hood: Neighbourhood,
    /// Bonds as their energy counts: half across a line of symmetry, not beyond it.
    pub(super) bonds: Arc<Grid>,
    /// Bonds as real points feel them.
    pub(super) whole: Arc<Grid>,
    pub(super) triangles: Arc<Families<2, 3, 2>>,
    pub(super) uncorrected: usize,
    /// Points with cut bonds and the cut share of their family volumes.
    pub(super) damage: Vec<(usize, f64)>,
}

impl LatticeBody {
    /// `cuts` are indices of offsets of the neighbourhood and lower points.
    pub(super) fn new(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        hood: Neighbourhood,
        parameters: &PlaneParameters,
        cuts: &[(usize, usize)],
    ) -> Self {
        let lattice = match parameters.edges {
            Edges::Overlay => lattice,
            _ if lattice.cut_cells().is_empty() => lattice,
            _ => Arc::new(SquareLattice::clone(&lattice).with_whole_cells()),
        };
        let near = match parameters.edges {
            Edges::None => Vec::new(),
            _ => near_points(&lattice, hood.reach()),
        };
        let cuts: HashSet<(usize, usize)> = cuts.iter().copied().collect();
        let volume = lattice.spacing().powi(2) * parameters.material.thickness;
        let mut factors = EdgeFactors { base: vec![1.0; hood.offsets.len()], exceptions: Vec::new() };
        let mut triangles = Overlay::default();
        match parameters.edges {
            Edges::None => {}
            Edges::Volume | Edges::Energy => {
                factors = edge_factors(&lattice, &mirrors, &hood, parameters, &near);
            }
            Edges::Overlay => {
                factors.exceptions = reduced(&lattice, &hood);
                let near = with_neighbours(&lattice, &hood, near);
                let real =
                    near.iter().copied().filter(|&p| mirrors.is_none() || mirrors.is_real(lattice.cell(p)));
                triangles = overlay(&lattice, &hood, real, volume, &cuts);
            }
        }
        let mut exceptions = factors.exceptions;
        let mut ordered: Vec<(usize, usize)> = cuts.into_iter().collect();
        ordered.sort_unstable_by_key(|&(offset, lower)| (lower, offset));
        exceptions.extend(ordered.iter().map(|&(offset, lower)| Exception { offset, lower, factor: 0.0 }));
        let grid = |exceptions: &[Exception]| {
            Arc::new(grid(&lattice, &hood, &factors.base, CentralBond { volume }, exceptions))
        };
        let ghosts = mirrors.ghosts(&lattice);
        let whole = grid(&exceptions);
        let bonds = if ghosts.is_empty() {
            whole.clone()
        } else {
            exceptions.extend(halved(&lattice, &mirrors, &hood, &ghosts));
            grid(&exceptions)
        };
        let damage = damage(&lattice, &mirrors, &hood, &ordered);
        let uncorrected = triangles.uncorrected;
        let triangles = Arc::new(Families::new(lattice.points(), triangles.triangles));
        Self { lattice, mirrors, ghosts, hood, bonds, whole, triangles, uncorrected, damage }
    }

    /// Volume of a real point with a whole cell, m³.
    pub(super) fn volume(&self, thickness: f64) -> f64 {
        self.lattice.spacing().powi(2) * thickness
    }

    /// The body at twice the spacing.
    pub(super) fn coarser(&self, parameters: &PlaneParameters, cuts: &FindCuts) -> Self {
        let coarse = match self.mirrors.is_none() {
            true => self.lattice.coarser(),
            false => self.mirrors.real(&self.lattice).coarser(),
        };
        let mirrors = self.mirrors.coarser();
        let coarse = mirrors.extended(&coarse, self.hood.reach());
        let cuts = cuts(&coarse, &self.hood.offsets);
        Self::new(Arc::new(coarse), mirrors, self.hood.clone(), parameters, &cuts)
    }
}

/// The bonds of the offsets that have any, with exceptions whose offsets are those of the neighbourhood.
fn grid(
    lattice: &Arc<SquareLattice>,
    hood: &Neighbourhood,
    base: &[f64],
    model: CentralBond,
    exceptions: &[Exception],
) -> Grid {
    let bonded: Vec<usize> = hood.bonded().collect();
    let mut class = vec![None; hood.offsets.len()];
    bonded.iter().enumerate().for_each(|(index, &k)| class[k] = Some(index));
    let offset = |&k: &usize| Offset { step: hood.offsets[k], weight: base[k] * hood.weights[k] };
    let offsets: Vec<Offset> = bonded.iter().map(offset).collect();
    let known: Vec<Exception> =
        exceptions.iter().filter_map(|e| Some(Exception { offset: class[e.offset]?, ..*e })).collect();
    GridBonds::new(lattice.clone(), &model, &offsets, &known)
}

/// Factors of the bonds of cells that are not whole: the smaller part of both ends.
fn reduced(lattice: &SquareLattice, hood: &Neighbourhood) -> Vec<Exception> {
    let mut exceptions = Vec::new();
    for &(point, part) in lattice.cut_cells() {
        let (point, cell) = (point as usize, lattice.cell(point as usize));
        for k in hood.bonded() {
            for up in [true, false] {
                let Some(other) = lattice.number(at(cell, hood.offsets[k], up)) else { continue };
                let factor = part.min(lattice.fraction(other));
                // A bond between two such cells is met twice.
                if up || lattice.fraction(other) == 1.0 {
                    let lower = if up { point } else { other };
                    exceptions.push(Exception { offset: k, lower, factor });
                }
            }
        }
    }
    exceptions
}

/// Some points, and those that have a bond to a cell that is not whole, in order.
fn with_neighbours(lattice: &SquareLattice, hood: &Neighbourhood, mut points: Vec<usize>) -> Vec<usize> {
    if lattice.cut_cells().is_empty() {
        return points;
    }
    for &(point, _) in lattice.cut_cells() {
        let cell = lattice.cell(point as usize);
        let steps = hood.bonded().flat_map(|k| [true, false].map(|up| at(cell, hood.offsets[k], up)));
        points.push(point as usize);
        points.extend(steps.filter_map(|other| lattice.number(other)));
    }
    points.sort_unstable();
    points.dedup();
    points
}

/// Factors of bonds across lines of symmetry, ½, and beyond them, 0.
fn halved(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    hood: &Neighbourhood,
    ghosts: &[u32],
) -> Vec<Exception> {
    let mut exceptions = Vec::new();
    for &ghost in ghosts {
        let cell = lattice.cell(ghost as usize);
        for k in hood.bonded() {
            for up in [true, false] {
                let other = at(cell, hood.offsets[k], up);
                let Some(number) = lattice.number(other) else { continue };
                let is_real = mirrors.is_real(other);
                if is_real || up {
                    let lower = if up { ghost as usize } else { number };
                    exceptions.push(Exception { offset: k, lower, factor: if is_real { 0.5 } else { 0.0 } });
                }
            }
        }
    }
    exceptions
}

/// Cut shares of family volumes of real points.
fn damage(
    lattice: &SquareLattice,
    mirrors: &Mirrors,
    hood: &Neighbourhood,
    cuts: &[(usize, usize)],
) -> Vec<(usize, f64)> {
    let mut ends: Vec<(usize, f64)> = Vec::new();
    for &(offset, lower) in cuts.iter().filter(|c| hood.weights[c.0] > 0.0) {
        if let Some(upper) = lattice.number(at(lattice.cell(lower), hood.offsets[offset], true)) {
            ends.extend([lower, upper].map(|p| (p, hood.parts[offset])));
        }
    }
    ends.sort_by_key(|e| e.0);
    let family = |point: usize| -> f64 {
        let cell = lattice.cell(point);
        let sides = hood.bonded().flat_map(|k| [(k, true), (k, false)]);
        let present = sides.filter(|&(k, up)| lattice.number(at(cell, hood.offsets[k], up)).is_some());
        present.map(|(k, _)| hood.parts[k]).sum()
    };
    let of = |part: &[(usize, f64)]| {
        let point = part[0].0;
        let cut: f64 = part.iter().map(|e| e.1).sum();
        mirrors.is_real(lattice.cell(point)).then(|| (point, cut / family(point)))
    };
    ends.chunk_by(|a, b| a.0 == b.0).filter_map(of).collect()
}
