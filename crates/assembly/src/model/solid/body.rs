//! Bonds, tetrahedra and families of a solid on a lattice.
//!
//! A point of a cell that a face cuts has the part `a_k` of a cell for its volume, and so has all of its energy: a bond has the
//! mean of the parts of its two ends.

use super::super::plane::{
    FARTHEST, FindCuts, Mirrors, Mixture, Neighbourhood, apart_bonds, at, can_end, grid, halved, near_points,
};
use super::bond::SolidBond;
use super::border::Border;
use super::corners::Overlay;
use super::dilatation::families;
use super::interface::Interface;
use super::{SolidEdges, SolidError, SolidLaw};
use crate::body::{Cell, SquareLattice, plus};
use crate::stiffness::{BondPoints, Exception, GridBonds, GridFamilies, Term};
use std::collections::HashSet;
use std::sync::Arc;

/// The bonds of a solid.
pub(super) type Bonds = Arc<GridBonds<3, 1, SolidBond>>;

/// From a point to all of its neighbours.
#[derive(Clone, Debug)]
pub(super) struct Reach {
    /// Offsets of the neighbourhood, then their opposites in the same order.
    pub(super) steps: Vec<Cell>,
    bonded: Vec<bool>,
}

impl Reach {
    fn new(neighbourhood: &Neighbourhood<1>) -> Self {
        let half = &neighbourhood.offsets;
        Self {
            steps: half.iter().copied().chain(half.iter().map(|o| o.map(|k| -k))).collect(),
            bonded: (0..2 * half.len()).map(|k| neighbourhood.has_bonds(k % half.len())).collect(),
        }
    }

    /// Index of the offset of a step, or of its opposite.
    pub(super) fn offset_of(&self, step: usize) -> usize {
        step % (self.steps.len() / 2)
    }

    /// Which bonds of a cell have no point at their other end.
    pub(super) fn missing(&self, lattice: &SquareLattice, cell: Cell) -> Vec<bool> {
        let missing = |(step, bonded): (&Cell, &bool)| *bonded && lattice.number(plus(cell, *step)).is_none();
        self.steps.iter().zip(&self.bonded).map(missing).collect()
    }

    /// Step of the bond of an offset from its lower or its upper end.
    pub(super) fn step_of(&self, offset: usize, is_lower: bool) -> usize {
        offset + if is_lower { 0 } else { self.steps.len() / 2 }
    }
}

/// A lattice with its bonds and what completes them.
#[derive(Clone, Debug)]
pub(super) struct SolidBody {
    pub(super) lattice: Arc<SquareLattice>,
    pub(super) mirrors: Mirrors,
    /// Images of real points.
    pub(super) ghosts: Vec<u32>,
    pub(super) law: SolidLaw,
    /// Bonds as their energy counts: half across a plane of symmetry, not beyond it, and by the parts of cells.
    pub(super) bonds: Bonds,
    /// Bonds as whole real points feel them, where that is different.
    pub(super) felt: Option<Bonds>,
    /// Bonds that end on the border.
    pub(super) border: Option<Border>,
    /// What moves these, of a body that breaks.
    pub(super) on_border: Option<Arc<BondPoints>>,
    /// What tetrahedra have of the energy, or beside a border that is completed tell of stresses alone.
    pub(super) overlay: Overlay,
    /// What does work with changes of volume.
    pub(super) families: Option<Arc<GridFamilies<3>>>,
    /// What it has beside that where it is of several materials.
    pub(super) interface: Option<Box<Interface>>,
    /// Bonds that are cut: indices of offsets of the neighbourhood and lower points, sorted by these.
    pub(super) cuts: Vec<(usize, usize)>,
    /// Bonds that never were, because the body parts their points, sorted.
    pub(super) apart: Vec<(usize, usize)>,
}

impl SolidBody {
    /// One of several materials, if there is a mixture.
    ///
    /// # Errors
    /// [`SolidError::TooThin`], [`SolidError::MaterialsNeedBorder`].
    pub(super) fn new(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        mut law: SolidLaw,
        cuts: &[(usize, usize)],
        mixture: Option<Arc<Mixture>>,
    ) -> Result<Self, SolidError> {
        let sides = [lattice.columns(), lattice.rows(), lattice.layers()];
        if sides.iter().any(|side| side.len() < 2) {
            return Err(SolidError::TooThin);
        }
        if law.edges == SolidEdges::Border && !has_border(&lattice, &mirrors, &law) {
            law.edges = SolidEdges::Overlay;
        }
        if mixture.is_some() && law.edges != SolidEdges::Border {
            return Err(SolidError::MaterialsNeedBorder);
        }
        let known: HashSet<(usize, usize)> = cuts.iter().copied().collect();
        let mut cuts: Vec<(usize, usize)> = known.iter().copied().collect();
        cuts.sort_unstable_by_key(|&(offset, lower)| (lower, offset));
        let (neighbourhood, reach) = (&law.neighbourhood, Reach::new(&law.neighbourhood));
        let mut near = near_points(&lattice, neighbourhood.reach());
        let bond = SolidBond { volume: lattice.spacing().powi(3) };
        let has_border = law.edges == SolidEdges::Border;
        let of_points = mixture.as_deref();
        let border =
            has_border.then(|| Border::new((&lattice, &mirrors), (&law, bond), &near, (&known, of_points)));
        let apart = apart_bonds(&lattice, &mirrors, &neighbourhood.offsets);
        let gap = |&(offset, lower): &(usize, usize)| Exception { offset, lower, factor: 0.0 };
        let parted: Vec<Exception> =
            apart.iter().filter(|bond| neighbourhood.has_bonds(bond.0)).map(gap).collect();
        let gaps: &[Exception] = border.as_ref().map_or(&parted, |border| &border.gaps);
        near.retain(|&point| mirrors.is_real(lattice.cell(point)));
        let completed = if law.edges.is_exact() { &near[..] } else { &[] };
        let mut overlay = Overlay::new(&lattice, &law, &reach, completed, &known, gaps);
        overlay.uncorrected = border.as_ref().map_or(overlay.uncorrected, |border| border.lost);
        let mut interface = mixture.map(|mixture| {
            let beside: &[(usize, usize, [f64; 1])] = border.as_ref().map_or(&[], |border| &border.lacks);
            Box::new(Interface::new((&lattice, &mirrors), (&law, bond), mixture, (&known, gaps), beside))
        });
        overlay.uncorrected += interface.as_ref().map_or(0, |interface| interface.lost);
        let base = vec![1.0; neighbourhood.offsets.len()];
        let grid = |exceptions: &[Exception]| {
            Arc::new(grid(&lattice, neighbourhood, &base, &bond, exceptions, (None, &[])))
        };
        let mut exceptions: Vec<Exception> = cuts.iter().map(gap).chain(gaps.iter().copied()).collect();
        exceptions.extend(interface.iter_mut().flat_map(|own| std::mem::take(&mut own.exceptions)));
        let ghosts = mirrors.ghosts(&lattice);
        let mut bonds = grid(&exceptions);
        let mut felt = None;
        if !ghosts.is_empty() || !lattice.cut_cells().is_empty() {
            exceptions.extend(reduced(&lattice, neighbourhood));
            exceptions.extend(halved(&lattice, &mirrors, neighbourhood, &ghosts));
            felt = Some(std::mem::replace(&mut bonds, grid(&exceptions)));
        }
        let complete = (&overlay, border.as_ref(), interface.as_deref());
        let families =
            families((&lattice, &law, &reach), complete, (&near, &ghosts), (&cuts, gaps)).map(Arc::new);
        Ok(Self {
            lattice,
            mirrors,
            ghosts,
            law,
            bonds,
            felt,
            border,
            on_border: None,
            overlay,
            families,
            interface,
            cuts,
            apart,
        })
    }

    /// Bonds as whole real points feel them.
    pub(super) fn whole(&self) -> &GridBonds<3, 1, SolidBond> {
        self.felt.as_ref().unwrap_or(&self.bonds)
    }

    /// Volume of a cell, m³.
    pub(super) fn cell_volume(&self) -> f64 {
        self.lattice.spacing().powi(3)
    }

    /// Volume of a point, m³; an image has none.
    pub(super) fn volume(&self, point: usize) -> f64 {
        match self.ghosts.binary_search(&(point as u32)) {
            Ok(_) => 0.0,
            Err(_) => self.cell_volume() * self.lattice.fraction(point),
        }
    }

    /// Terms of the energy.
    pub(super) fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        let mut terms: Vec<Box<dyn Term<3>>> = vec![Box::new(self.bonds.clone())];
        match &self.border {
            Some(border) => terms.push(Box::new(border.bonds.clone())),
            None if self.overlay.families.count() > 0 => terms.push(Box::new(self.overlay.families.clone())),
            None => {}
        }
        if let Some(families) = &self.families {
            terms.push(Box::new(families.clone()));
        }
        if let Some(interface) = self.interface.as_ref().filter(|i| !i.families.list().is_empty()) {
            terms.push(Box::new(interface.families.clone()));
        }
        terms
    }

    /// Moduli of the points over those of the base material, where some are others.
    pub(super) fn mixture(&self) -> Option<&Arc<Mixture>> {
        self.interface.as_ref().map(|interface| &interface.mixture)
    }

    /// Modulus of a point over that of the base material.
    pub(super) fn factor(&self, point: usize) -> f64 {
        self.mixture().map_or(1.0, |mixture| mixture.of(point))
    }

    /// The body at twice the spacing; none where joined sides or a single layer leave no lattice for it.
    pub(super) fn coarser(&self, cuts: &FindCuts) -> Option<Self> {
        let mirrors = self.mirrors.coarser()?;
        let coarse = match self.mirrors.is_none() {
            true => self.lattice.coarser(),
            false => self.mirrors.real(&self.lattice).coarser(),
        };
        let coarse = mirrors.extended(&coarse, self.law.edges.depth(self.law.neighbourhood.reach()));
        let cuts = cuts(&coarse, &self.law.neighbourhood.offsets);
        let mixture = self.mixture().and_then(|own| own.coarser(&self.lattice, (&coarse, &mirrors), 1));
        let coarse = Arc::new(coarse);
        let of = |mixture| Self::new(coarse.clone(), mirrors, self.law.clone(), &cuts, mixture).ok();
        // Where no bonds end on the border of the coarser lattice it is of one material.
        of(mixture).or_else(|| of(None))
    }
}

/// Whether bonds can end on the border: cells are whole and belong to blocks of eight.
fn has_border(lattice: &SquareLattice, mirrors: &Mirrors, law: &SolidLaw) -> bool {
    law.neighbourhood.reach() <= FARTHEST && lattice.cut_cells().is_empty() && can_end(lattice, mirrors)
}

/// Factors of the bonds of cells that are not whole: the mean of the parts of both ends.
fn reduced(lattice: &SquareLattice, neighbourhood: &Neighbourhood<1>) -> Vec<Exception> {
    let mut exceptions = Vec::new();
    for &(point, part) in lattice.cut_cells() {
        let (point, cell) = (point as usize, lattice.cell(point as usize));
        for offset in neighbourhood.bonded() {
            for up in [true, false] {
                let Some(other) = lattice.number(at(cell, neighbourhood.offsets[offset], up)) else {
                    continue;
                };
                let of_other = lattice.fraction(other);
                // A bond between two such cells is met twice.
                if up || of_other == 1.0 {
                    let lower = if up { point } else { other };
                    exceptions.push(Exception { offset, lower, factor: 0.5 * (part + of_other) });
                }
            }
        }
    }
    exceptions
}
