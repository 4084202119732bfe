//! Bonds of a body that is a square lattice.
//!
//! With the overlay, a point i of a cell that the border cuts has the volume `a_i V`. A bond counts by the smaller part of
//! its two ends, `f_ij = min(a_i, a_j)`, so that what a point lacks is never negative; the overlay gives it back. Other
//! treatments of edges have whole cells.

use super::apart::Parted;
use super::bond::PlaneBond;
use super::edges::{Completion, EdgeFactors, Overlay, edge_factors, has_border, overlay};
use super::exceptions::{grid, halved, reduced, with_neighbours};
use super::interface::Interface;
use super::mixture::Mixture;
use super::near::near_points;
use super::neighbourhood::Neighbourhood;
use super::{Edges, FindCuts, Mirrors};
use crate::body::SquareLattice;
use crate::stiffness::{Exception, Families, GridBonds};
use std::collections::HashSet;
use std::sync::Arc;

/// What the bonds of a lattice are, whatever its points.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Kind<B> {
    pub(in super::super) bond: B,
    /// Treatment of edges.
    pub(in super::super) edges: Edges,
    /// m.
    pub(in super::super) thickness: f64,
    /// C11 and C22 along x and y, Pa.
    pub(in super::super) stretch_moduli: [f64; 2],
}

/// A lattice with its bonds, of `M` measures each, and its overlay of triangles, of `S` measures each.
#[derive(Clone, Debug)]
pub(in super::super) struct LatticeBody<const D: usize, const M: usize, const S: usize, B> {
    pub(in super::super) lattice: Arc<SquareLattice>,
    pub(in super::super) mirrors: Mirrors,
    /// Images of real points.
    pub(in super::super) ghosts: Vec<u32>,
    pub(in super::super) neighbourhood: Neighbourhood<M>,
    pub(in super::super) kind: Kind<B>,
    /// Bonds as their energy counts: half across a line of symmetry or a joined side, not beyond it.
    pub(in super::super) bonds: Arc<GridBonds<D, M, B>>,
    /// Bonds as real points feel them, where there are images.
    pub(super) felt: Option<Arc<GridBonds<D, M, B>>>,
    /// What completes its border.
    pub(in super::super) border: Completion<D, M, S>,
    /// What points near edges lack. Beside a border that is completed they tell its stresses, and have no energy.
    pub(in super::super) triangles: Arc<Families<D, S, 2>>,
    /// What it has beside that where it is of several materials.
    pub(super) interface: Option<Box<Interface<D, M, S>>>,
    pub(in super::super) uncorrected: usize,
    /// Bonds that are cut: indices of offsets of the neighbourhood and lower points.
    pub(super) cuts: Vec<(usize, usize)>,
    /// Bonds that never were, sorted: those between points that the body parts, and cut ones that are no damage.
    pub(in super::super) apart: Vec<(usize, usize)>,
}

impl<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>> LatticeBody<D, M, S, B> {
    /// `cuts` are indices of offsets of the neighbourhood and lower points.
    pub(in super::super) fn new(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        neighbourhood: Neighbourhood<M>,
        kind: Kind<B>,
        cuts: &[(usize, usize)],
    ) -> Self {
        Self::mixed(lattice, mirrors, neighbourhood, kind, cuts, None)
    }

    /// The same of several materials.
    pub(in super::super) fn mixed(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        neighbourhood: Neighbourhood<M>,
        mut kind: Kind<B>,
        cuts: &[(usize, usize)],
        mixture: Option<Arc<Mixture>>,
    ) -> Self {
        if kind.edges == Edges::Border && !has_border(&lattice, &mirrors, neighbourhood.reach()) {
            kind.edges = Edges::Overlay;
        }
        let lattice = match kind.edges {
            Edges::Border | Edges::Overlay => lattice,
            _ if lattice.cut_cells().is_empty() => lattice,
            _ => Arc::new(SquareLattice::clone(&lattice).with_whole_cells()),
        };
        let parted = Parted::new((&lattice, &mirrors), &neighbourhood, kind.edges, cuts);
        let mut near = match kind.edges {
            Edges::None => Vec::new(),
            _ => parted.with_ends(&lattice, &neighbourhood, near_points(&lattice, neighbourhood.reach())),
        };
        let bonds = (&neighbourhood, &kind.bond);
        let of_points = mixture.as_deref();
        let mut border =
            Completion::new((&lattice, &mirrors), bonds, kind.edges, &near, (&parted.cuts, of_points));
        if kind.edges != Edges::Border {
            border.gaps.extend(parted.gaps(&neighbourhood));
        }
        let mut factors =
            EdgeFactors { base: vec![1.0; neighbourhood.offsets.len()], exceptions: Vec::new() };
        let mut triangles = Overlay { triangles: Vec::new(), uncorrected: 0 };
        match kind.edges {
            Edges::None => {}
            Edges::Volume | Edges::Energy => {
                factors = edge_factors((&lattice, &mirrors), &neighbourhood, &kind, &near, &parted.apart);
            }
            Edges::Border | Edges::Overlay => {
                if !border.is_cut() {
                    factors.exceptions = reduced(&lattice, &neighbourhood);
                    near = with_neighbours(&lattice, &neighbourhood, near);
                }
                near.retain(|&p| mirrors.is_none() || mirrors.is_real(lattice.cell(p)));
                triangles = completing(&lattice, bonds, &border, near, (&parted.all, of_points));
            }
        }
        let mut interface = mixture.map(|mixture| {
            let without = (&parted.all, &border.gaps[..]);
            Box::new(Interface::new((&lattice, &mirrors), bonds, mixture, without, &border.lacks))
        });
        let mut exceptions = factors.exceptions;
        exceptions
            .extend(interface.iter_mut().flat_map(|interface| std::mem::take(&mut interface.exceptions)));
        let mut cuts: Vec<(usize, usize)> = parted.cuts.into_iter().collect();
        cuts.sort_unstable_by_key(|&(offset, lower)| (lower, offset));
        exceptions.extend(cuts.iter().map(|&(offset, lower)| Exception { offset, lower, factor: 0.0 }));
        let mixed = interface.as_ref().map(|interface| (&*interface.mixture, &interface.between[..]));
        let mixed = mixed.map_or((None, &[][..]), |(mixture, between)| (Some(mixture), between));
        let grid = |exceptions: &[Exception]| {
            Arc::new(grid(&lattice, &neighbourhood, &factors.base, &kind.bond, exceptions, mixed))
        };
        exceptions.extend(&border.gaps);
        let ghosts = mirrors.ghosts(&lattice);
        let mut bonds = grid(&exceptions);
        let mut felt = None;
        if !ghosts.is_empty() {
            exceptions.extend(halved(&lattice, &mirrors, &neighbourhood, &ghosts));
            felt = Some(std::mem::replace(&mut bonds, grid(&exceptions)));
        }
        let mut uncorrected = if border.is_none() { triangles.uncorrected } else { border.lost };
        uncorrected += interface.as_ref().map_or(0, |interface| interface.lost);
        let triangles = Arc::new(Families::new(lattice.points(), triangles.triangles));
        Self {
            lattice,
            mirrors,
            ghosts,
            neighbourhood,
            kind,
            bonds,
            felt,
            border,
            triangles,
            interface,
            uncorrected,
            cuts,
            apart: parted.apart,
        }
    }

    /// Bonds as real points feel them.
    pub(super) fn whole(&self) -> &GridBonds<D, M, B> {
        self.felt.as_ref().unwrap_or(&self.bonds)
    }

    /// Moduli of the points over those of the base material, where some are others.
    pub(in super::super) fn mixture(&self) -> Option<&Arc<Mixture>> {
        self.interface.as_ref().map(|interface| &interface.mixture)
    }

    /// Modulus of a point over that of the base material.
    pub(in super::super) fn factor(&self, point: usize) -> f64 {
        self.mixture().map_or(1.0, |mixture| mixture.of(point))
    }

    /// Which table has the weights of the bonds of a point.
    pub(in super::super) fn table(&self, point: usize) -> usize {
        self.mixture().map_or(0, |mixture| mixture.table(point))
    }

    /// Volume of a real point with a whole cell, m³.
    pub(super) fn cell_volume(&self) -> f64 {
        self.lattice.spacing().powi(2) * self.kind.thickness
    }

    /// Volume of a point, m³; an image has that of its real point.
    pub(super) fn real_volume(&self, point: usize) -> f64 {
        self.cell_volume() * self.lattice.fraction(point)
    }

    /// Volume that a point stands for in stresses, m³: a whole cell beside a border that cuts cells and is completed.
    pub(in super::super) fn stress_volume(&self, point: usize) -> f64 {
        if self.border.is_cut() { self.cell_volume() } else { self.real_volume(point) }
    }

    /// Volume of a point, m³; an image has none.
    pub(in super::super) fn volume(&self, point: usize) -> f64 {
        if self.is_ghost(point) { 0.0 } else { self.real_volume(point) }
    }

    /// Whether a point is an image.
    pub(super) fn is_ghost(&self, point: usize) -> bool {
        self.ghosts.binary_search(&(point as u32)).is_ok()
    }

    /// The body of the material of a table alone.
    pub(in super::super) fn of_one_material(&self, table: usize) -> Self {
        Self::new(
            self.lattice.clone(),
            self.mirrors,
            self.neighbourhood.of_one(table),
            self.kind.clone(),
            &self.cuts,
        )
    }

    /// The body at twice the spacing; none where joined sides leave no lattice for it.
    pub(in super::super) fn coarser(&self, cuts: &FindCuts) -> Option<Self> {
        let mirrors = self.mirrors.coarser()?;
        let coarse = match self.mirrors.is_none() {
            true => self.lattice.coarser(),
            false => self.mirrors.real(&self.lattice).coarser(),
        };
        let coarse = mirrors.extended(&coarse, self.kind.edges.depth(self.neighbourhood.reach()));
        let cuts = cuts(&coarse, &self.neighbourhood.offsets);
        let kind = Kind { bond: self.kind.bond.coarser(), ..self.kind.clone() };
        let materials = self.neighbourhood.materials(self.mixture().map_or(0, |own| own.blends().len()));
        let coarse_body = (&coarse, &mirrors);
        let mixture = self.mixture().and_then(|own| own.coarser(&self.lattice, coarse_body, materials));
        let blends = mixture.as_ref().map_or(&[][..], |mixture| mixture.blends());
        let neighbourhood = self.neighbourhood.with_blends(materials, blends);
        Some(Self::mixed(Arc::new(coarse), mirrors, neighbourhood, kind, &cuts, mixture))
    }
}

/// The triangles of some real points. Where the border is completed they tell stresses alone, of points of which nothing else
/// does.
fn completing<const D: usize, const M: usize, const S: usize, B: PlaneBond<D, M, S>>(
    lattice: &SquareLattice,
    bonds: (&Neighbourhood<M>, &B),
    border: &Completion<D, M, S>,
    points: Vec<usize>,
    cuts: (&HashSet<(usize, usize)>, Option<&Mixture>),
) -> Overlay<D, S> {
    let Some(strains) = &border.strains else {
        return overlay(lattice, bonds, points.into_iter(), cuts, &border.gaps);
    };
    let untold = points.into_iter().filter(|&point| !strains.tells(point));
    overlay(&lattice.clone().with_whole_cells(), bonds, untold, cuts, &border.gaps)
}
