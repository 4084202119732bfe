//! The points of a state-based body with their families, on a lattice with ghosts and images.

use super::super::bond_plane::CentralBond;
use super::super::plane::{Apart, Mirrors};
use super::ghosts::{Fit, Separated, fits, outside, parted_ghosts};
use super::materials::{Mixture, StateMaterials};
use super::term::StateTerm;
use super::weights::{FamilyWeights, Set, offsets};
use super::{Axis, Dilatation, StateEdges, StateError, StateParameters};
use crate::body::{Cell, SquareLattice, plus};
use crate::stiffness::{GridBonds, GridFamilies, GridFamily, Offset};
use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::Arc;

/// Points, families and energy of a body.
#[derive(Clone, Debug)]
pub(super) struct StateBody {
    /// The cells of the body alone.
    pub(super) real: Arc<SquareLattice>,
    /// With ghosts and images.
    pub(super) lattice: Arc<SquareLattice>,
    pub(super) mirrors: Mirrors,
    /// Points that are ghosts or images, in order.
    pub(super) ghosts: Vec<u32>,
    /// Shares of real points in the ghosts that are no images.
    pub(super) fits: BTreeMap<Cell, Fit>,
    pub(super) families: FamilyWeights,
    /// Where there are several materials.
    pub(super) mixture: Option<Mixture>,
    pub(super) term: StateTerm,
    /// Bonds that are cut: offset of the half and lower point, sorted.
    pub(super) cuts: Vec<(usize, usize)>,
    /// Bonds that never were, because the body parts their points, sorted.
    pub(super) apart: Vec<(usize, usize)>,
}

/// Volume of a cell, m³: of a ring, that one spacing from the axis.
pub(super) fn cell_volume(parameters: &StateParameters, spacing: f64) -> f64 {
    use super::Geometry::{Axisymmetric, PlaneStrain, PlaneStress};
    match parameters.geometry {
        PlaneStress(thickness) | PlaneStrain(thickness) => spacing * spacing * thickness,
        Axisymmetric => TAU * spacing.powi(3),
    }
}

/// Lines of symmetry, with the axis of a body of revolution that touches it among them.
pub(super) fn with_axis(
    parameters: &StateParameters,
    real: &SquareLattice,
    mirrors: Mirrors,
) -> Result<(Mirrors, bool), StateError> {
    if !parameters.is_axisymmetric() {
        return Ok((mirrors, false));
    }
    let left = real.corner()[0] / real.spacing() + f64::from(real.columns().start);
    // A bore, however narrow, is none.
    if left > 1e-6 {
        return Ok((mirrors, false));
    }
    if left < -1e-6 {
        return Err(StateError::OffAxis);
    }
    let has_images = parameters.axis != Axis::Truncated;
    let line = has_images.then_some(real.columns().start);
    let mut mirrors = mirrors;
    mirrors.lines[0][0] = line;
    Ok((mirrors, has_images))
}

/// The lattice of a body with its ghosts and images, the lines of symmetry, and the fits of the ghosts.
pub(super) fn extended(
    parameters: &StateParameters,
    real: &SquareLattice,
    mirrors: Mirrors,
    (separated, foreign): (&Separated, &Separated),
) -> Result<(SquareLattice, Mirrors, BTreeMap<Cell, Fit>), StateError> {
    let (mirrors, _) = with_axis(parameters, real, mirrors)?;
    let half = offsets(parameters);
    let all: Vec<Cell> = half.iter().copied().chain(half.iter().map(|o| o.map(|k| -k))).collect();
    let reach = all.iter().flat_map(|o| o.map(i32::abs)).max().unwrap_or(0);
    if parameters.edges != StateEdges::Ghosts {
        return Ok((mirrors.extended(real, reach), mirrors, BTreeMap::new()));
    }
    // No ghosts stand behind an axis at which families end.
    let ends_at_axis = parameters.is_axisymmetric() && parameters.axis == Axis::Truncated;
    let is_behind = |cell: &Cell| real.corner()[0] / real.spacing() + f64::from(cell[0]) < -1e-6;
    let mut beyond = outside(real, &mirrors, &all);
    beyond.retain(|cell| !(ends_at_axis && is_behind(cell)));
    let fits = fits(real, &beyond, separated, foreign);
    let widened = |range: std::ops::Range<i32>| range.start - reach..range.end + reach;
    let inside = |cell: Cell| real.number(cell).is_some() || fits.contains_key(&cell);
    let ranges = [widened(real.columns()), widened(real.rows()), real.layers()];
    let filled = SquareLattice::new(real.spacing(), real.corner(), ranges, inside);
    let areas: Vec<(Cell, f64)> =
        real.cut_cells().iter().map(|&(p, area)| (real.cell(p as usize), area)).collect();
    Ok((mirrors.extended(&filled.with_areas(&areas), reach), mirrors, fits))
}

impl StateBody {
    /// The body of the cells of a lattice; `cut` tells which bonds of the extended lattice something cuts, by offset of the
    /// half and lower point; `separated` whether something stands between two cells.
    pub(super) fn new(
        parameters: &StateParameters,
        real: Arc<SquareLattice>,
        mirrors: Mirrors,
        separated: &Separated,
        cut: &dyn Fn(&SquareLattice) -> Vec<(usize, usize)>,
        materials: Option<&Arc<StateMaterials>>,
    ) -> Result<Self, StateError> {
        let half = offsets(parameters);
        let (with_axis, has_axis) = with_axis(parameters, &real, mirrors)?;
        let reach = half.iter().flat_map(|o| o.map(i32::abs)).max().unwrap_or(0);
        let images = with_axis.extended(&real, reach);
        let (parts, parted) = Apart::new(&images, &with_axis, &half);
        let from_crack = separated;
        let separated = &|a: Cell, b: Cell| from_crack(a, b) || parts.parts(a, b);
        let number = |cell: Cell| materials.map(|of| Some(of.number(real.number(cell)?)));
        let foreign = &|a: Cell, b: Cell| number(a) != number(b);
        let (lattice, mirrors, fits) = extended(parameters, &real, mirrors, (separated, foreign))?;
        let lattice = Arc::new(lattice);
        let is_real: Vec<bool> = (0..lattice.points())
            .map(|p| {
                let cell = lattice.cell(p);
                mirrors.is_real(cell) && real.number(cell).is_some()
            })
            .collect();
        let ghosts = (0..lattice.points()).filter(|&p| !is_real[p]).map(|p| p as u32).collect();
        let ghost_bonds =
            |separated: &Separated| parted_ghosts((&real, &lattice, &mirrors), &fits, &half, separated);
        let bond = |[from, to]: [Cell; 2]| {
            let offset = half.iter().position(|o| plus(from, *o) == to)?;
            Some((offset, lattice.number(from)?))
        };
        let mut apart: Vec<(usize, usize)> = parted.into_iter().filter_map(bond).collect();
        if !apart.is_empty() {
            apart.extend(ghost_bonds(&|a, b| parts.parts(a, b)));
        }
        apart.sort_unstable();
        apart.dedup();
        let mixture = materials.map(|of| Mixture::new(of, &real, (&lattice, &mirrors), &fits));
        let families =
            FamilyWeights::new(parameters, (&lattice, &apart), &is_real, has_axis, mixture.as_ref())?;
        let mut cuts = cut(&lattice);
        cuts.extend(ghost_bonds(&|a, b| real.number(b).is_some() && from_crack(a, b)));
        let mut body = Self {
            term: StateTerm::empty(),
            real,
            lattice,
            mirrors,
            ghosts,
            fits,
            families,
            mixture,
            cuts: Vec::new(),
            apart,
        };
        body.remove(&cuts);
        body.term = body.energy(parameters);
        Ok(body)
    }

    /// Offsets of the half that have bonds.
    pub(super) fn bonded(&self) -> impl Iterator<Item = usize> + '_ {
        let half = self.families.offsets.len() / 2;
        (0..half).filter(|&k| self.families.sets[0].weights[k] > 0.0)
    }

    /// Upper end of the bond at an offset of the half.
    pub(super) fn upper(&self, offset: usize, lower: usize) -> Option<usize> {
        self.lattice.number(plus(self.lattice.cell(lower), self.families.offsets[offset]))
    }

    /// Removes bonds from the families of their points; the term is to be made again.
    pub(super) fn remove(&mut self, bonds: &[(usize, usize)]) {
        let ends = |&(offset, lower): &(usize, usize)| Some((offset, [lower, self.upper(offset, lower)?]));
        let ends: Vec<(usize, [usize; 2])> = bonds.iter().filter_map(ends).collect();
        self.families.remove(&ends);
        self.cuts.extend(bonds);
        self.cuts.sort_unstable();
        self.cuts.dedup();
    }

    /// Bonds, and families of the materials where they have energy of their own.
    pub(super) fn energy(&self, parameters: &StateParameters) -> StateTerm {
        let (families, spacing) = (&self.families, self.lattice.spacing());
        let volume = cell_volume(parameters, spacing);
        let plain = &families.sets[0];
        let bonded: Vec<usize> = self.bonded().collect();
        let steps: Vec<Offset<1>> = bonded
            .iter()
            .map(|&k| {
                let [a, b, _] = families.offsets[k];
                // 8 μ (V + V) w/q = a V/ξ².
                let square = f64::from(a * a + b * b);
                let weight = 16.0 * parameters.shear_modulus() * plain.weights[k] * square / plain.q;
                Offset { step: families.offsets[k], weights: [weight] }
            })
            .collect();
        let factor = |k: usize, [lower, upper]: [usize; 2]| families.bond_factor(bonded[k], lower, upper);
        let bonds = GridBonds::with_factors(self.lattice.clone(), &CentralBond { volume }, &steps, factor);
        let own = self.mixture.as_ref().map_or(std::slice::from_ref(parameters), |m| &m.materials.of);
        let all = own.iter().enumerate().filter(|(_, material)| material.has_families());
        StateTerm::new(bonds, all.filter_map(|(k, material)| self.families_of(k, material)).collect())
    }

    /// What the families of a material have beside bonds; none where no point is of it.
    fn families_of(&self, number: usize, material: &StateParameters) -> Option<GridFamilies> {
        let (families, volume) = (&self.families, cell_volume(material, self.lattice.spacing()));
        let part = |p: usize| self.mixture.as_ref().map_or(1.0, |mixture| mixture.part(number, p));
        let parts: Vec<f64> = (0..self.lattice.points()).map(part).collect();
        let set = |(set, part): (&Option<u32>, &f64)| set.filter(|_| *part > 0.0);
        let family = GridFamily {
            steps: families.offsets.clone(),
            sets: families.sets.iter().map(|set| self.dilatation_rows(set)).collect(),
            set_of: families.set_of.iter().zip(&parts).map(set).collect(),
            // Of a point that is stiffer by a factor its volume counts as often.
            volume: families.energy.iter().zip(&parts).map(|(v, part)| part * v * volume).collect(),
            own: if material.is_axisymmetric() { self.hoop_rows() } else { Vec::new() },
            modulus: material.family_modulus(),
            mean_modulus: match material.dilatation {
                Dilatation::Blocks => material.bulk_modulus(),
                Dilatation::Points => 0.0,
            },
        };
        let has_any = family.set_of.iter().any(Option::is_some);
        has_any.then(|| GridFamilies::new(self.lattice.clone(), family))
    }

    /// `(2/q) w |ξ| n` per offset, 1/m, of what a point sees of elongations.
    pub(super) fn dilatation_rows(&self, set: &Set) -> Vec<[f64; 2]> {
        let scale = 2.0 / (set.q * self.lattice.spacing());
        let rows = self.families.offsets.iter().zip(&set.weights).enumerate();
        rows.map(|(k, (o, w))| [0, 1].map(|c| scale * w * set.own(k) * f64::from(o[c]))).collect()
    }

    /// `1/x` of the points that have a family.
    fn hoop_rows(&self) -> Vec<f64> {
        let of = |p: usize| match self.families.set_of[p] {
            Some(_) => 1.0 / self.lattice.place(p)[0],
            None => 0.0,
        };
        (0..self.lattice.points()).map(of).collect()
    }
}
