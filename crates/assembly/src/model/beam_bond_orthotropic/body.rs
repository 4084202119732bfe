//! Bodies of beam bonds.

use super::super::plane::{
    BorderShares, BreakingModel, COMPONENTS, CriticalStretch, Edges, FindCuts, Kind, LatticeBody, Mirrors,
    Mixture, PlaneFields, PlaneModel, RIGID_MOTIONS, Solvable, add_stress_work, calibration_error, in_plane,
    rigid_motion,
};
use super::laminae::{Moduli, by_lamina};
use super::{BeamBond, BeamNeighbourhood, Laminae, OrthotropicError, OrthotropicParameters};
use crate::body::{Cell, SquareLattice};
use crate::bonds::{Mat, Point};
use crate::condition::Equation;
use crate::model::solid::TENSOR;
use crate::model::{BodyFields, BodyModel, Breakable, Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;
use std::sync::{Arc, OnceLock};

/// A plate of beam bonds: unknowns `u`, `v` and `hθ` with the spacing h of its lattice.
#[derive(Clone, Debug)]
pub struct BeamBondOrthotropic {
    parameters: OrthotropicParameters,
    /// Those of the parameters, and of other laminae.
    moduli: Vec<Moduli>,
    components: [Component; 3],
    body: LatticeBody<3, 3, 4, BeamBond>,
    /// The same of every lamina alone, where materials differ and a load asked for them.
    even: OnceLock<Vec<Self>>,
}

/// Strains of stresses, or stresses of strains.
fn times(matrix: &Mat<3, 3>, vector: [f64; 3]) -> [f64; 3] {
    matrix.map(|row| row.iter().zip(&vector).map(|(c, s)| c * s).sum())
}

/// The unknowns of a point: those of the plane and its scaled rotation.
fn components(bond: &BeamBond) -> [Component; 3] {
    let [x, y] = COMPONENTS;
    [x, y, Component::rotation("phi", bond.turning)]
}

impl BeamBondOrthotropic {
    /// One of each pair of opposite offsets to the neighbours of a point in a body with laminae at some other `angles`, rad: the
    /// first number of a cut is an index into them.
    ///
    /// # Errors
    /// As [`BeamNeighbourhood::new`].
    pub fn offsets(
        parameters: &OrthotropicParameters,
        angles: &[f64],
    ) -> Result<Vec<Cell>, OrthotropicError> {
        Ok(BeamNeighbourhood::of_laminae(parameters, angles)?.offsets)
    }

    /// Rows or columns of images that a lattice of such a body needs beyond a line of symmetry.
    ///
    /// # Errors
    /// As [`BeamNeighbourhood::new`].
    pub fn depth(parameters: &OrthotropicParameters, angles: &[f64]) -> Result<i32, OrthotropicError> {
        Ok(parameters.edges.depth(BeamNeighbourhood::of_laminae(parameters, angles)?.reach()))
    }

    /// A body on a lattice with the angle of the parameters, images in `mirrors` among its points
    /// ([`Mirrors::extended`]). A cut is an index into [`offsets`](Self::offsets) and the lower point of a bond.
    ///
    /// # Errors
    /// As [`BeamNeighbourhood::new`].
    ///
    /// # Panics
    /// A cut has no such offset or point.
    pub fn on_lattice(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: OrthotropicParameters,
        cuts: &[(usize, usize)],
    ) -> Result<Self, OrthotropicError> {
        Self::mixed(lattice, mirrors, parameters, cuts, (Vec::new(), Laminae::default()))
    }

    /// The same of points of several stiffnesses and fibres: `factors` are moduli of the points over those of the parameters, > 0,
    /// none where all are one; images have what their points have. Edges are completed. Bodies of several laminae do not break.
    ///
    /// # Errors
    /// As [`on_lattice`](Self::on_lattice).
    ///
    /// # Panics
    /// As [`on_lattice`](Self::on_lattice); there is not one factor or lamina for every point, a point is of a lamina that is not
    /// there, or there are more than [`Laminae::MOST`] other angles.
    pub fn mixed(
        lattice: Arc<SquareLattice>,
        mirrors: Mirrors,
        parameters: OrthotropicParameters,
        cuts: &[(usize, usize)],
        (factors, laminae): (Vec<f64>, Laminae),
    ) -> Result<Self, OrthotropicError> {
        assert!(factors.is_empty() || factors.len() == lattice.points(), "one factor per point");
        laminae.check(lattice.points());
        let neighbourhood = BeamNeighbourhood::of_laminae(&parameters, &laminae.angles)?;
        let (spacing, thickness) = (lattice.spacing(), parameters.material.thickness);
        let moduli = Moduli::of(&parameters, &laminae.angles);
        let stiffness = moduli[0].stiffness;
        let kind = Kind {
            bond: BeamBond { volume: spacing * spacing * thickness, turning: spacing },
            edges: parameters.edges,
            thickness,
            stretch_moduli: [stiffness[0][0], stiffness[1][1]],
        };
        let mixture = Mixture::of_tables(factors, laminae.of);
        let body = LatticeBody::mixed(lattice, mirrors, neighbourhood, kind, cuts, mixture);
        let components = components(&body.kind.bond);
        Ok(Self { parameters, moduli, components, body, even: OnceLock::new() })
    }

    /// The same with other bonds.
    fn with(&self, body: LatticeBody<3, 3, 4, BeamBond>) -> Self {
        let Self { parameters, components, .. } = *self;
        Self { parameters, moduli: self.moduli.clone(), components, body, even: OnceLock::new() }
    }

    /// The body that is all of a lamina.
    fn even(&self, lamina: usize) -> Self {
        Self { moduli: vec![self.moduli[lamina]], ..self.with(self.body.of_one_material(lamina)) }
    }

    /// Moduli of the lamina of a point, at the factor one.
    fn moduli(&self, point: usize) -> &Moduli {
        // Points of coarser lattices may be of several.
        self.moduli.get(self.body.table(point)).unwrap_or(&self.moduli[0])
    }

    /// The parameters.
    pub fn parameters(&self) -> &OrthotropicParameters {
        &self.parameters
    }
}

impl BodyModel for BeamBondOrthotropic {
    fn volume(&self, point: usize) -> f64 {
        self.body.volume(point)
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        Some((&self.body.lattice, &self.body.mirrors))
    }

    fn ghosts(&self) -> &[u32] {
        &self.body.ghosts
    }

    fn edges(&self) -> Option<Edges> {
        Some(self.body.kind.edges)
    }

    fn border_shares(&self) -> Option<BorderShares<'_>> {
        self.body.border_shares()
    }

    fn triangles(&self) -> usize {
        self.body.triangles.list().len()
    }

    fn completing(&self) -> usize {
        self.body.completing()
    }

    fn uncorrected(&self) -> usize {
        self.body.uncorrected
    }

    fn damage(&self) -> Vec<f64> {
        self.body.damage()
    }

    fn never_joined(&mut self, bonds: &[(usize, usize)]) {
        self.body.never_joined(bonds);
    }

    fn prepare_to_break(&mut self) {
        self.body.prepare_to_break();
    }

    fn strains_of(&self, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        in_plane(self, stress, across)
    }

    fn strains_at(&self, point: usize, [x, y, shear, ..]: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        let [x, y, shear] = self.strain_at(point, [x, y, shear], across);
        [x, y, shear, 0.0, 0.0, 0.0]
    }

    fn across_of(&self, [x, y, shear, ..]: [f64; TENSOR]) -> f64 {
        self.stress_across([x, y, shear])
    }

    fn recover(&self, u: &[f64]) -> BodyFields {
        self.fields(u).into()
    }

    fn as_plane(&self) -> Option<&dyn PlaneModel> {
        Some(self)
    }
}

impl PlaneModel for BeamBondOrthotropic {
    fn thickness(&self) -> f64 {
        self.parameters.material.thickness
    }

    fn stiffness(&self) -> Mat<3, 3> {
        self.moduli[0].stiffness
    }

    fn stiffness_at(&self, point: usize) -> Mat<3, 3> {
        let factor = self.body.factor(point);
        self.moduli(point).stiffness.map(|row| row.map(|c| factor * c))
    }

    fn strain_of(&self, stress: [f64; 3]) -> [f64; 3] {
        times(&self.moduli[0].compliance, stress)
    }

    fn strain_at(&self, point: usize, stress: [f64; 3], _across: f64) -> [f64; 3] {
        let factor = self.body.factor(point);
        times(&self.moduli(point).compliance, stress).map(|strain| strain / factor)
    }

    fn fields(&self, u: &[f64]) -> PlaneFields {
        self.body.fields(u)
    }

    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.body.add_strain_work(t, points, force);
    }

    fn add_free_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.body.add_free_work(t, points, force);
    }

    fn free_stress_beyond(&self, t: &[f64]) -> Option<[Vec<f64>; 3]> {
        self.body.free_stress_beyond(t)
    }

    /// The forces of one stress on a border, with the moments that go with them, whatever the materials inside are: points have those
    /// of a body that is all of their lamina.
    fn add_stress_load(
        &self,
        points: Option<&[usize]>,
        stress_at: &(dyn Fn(usize, [f64; 2]) -> [f64; 3] + Sync),
        force: &mut [f64],
    ) {
        if self.body.mixture().is_none() {
            return add_stress_work(self, points, stress_at, force);
        }
        let even = self.even.get_or_init(|| (0..self.moduli.len()).map(|lamina| self.even(lamina)).collect());
        let of = |model: &Self| {
            let mut own = vec![0.0; force.len()];
            add_stress_work(model, points, stress_at, &mut own);
            own
        };
        let mut all: Vec<Vec<f64>> = even.iter().map(of).collect();
        // The stretch of joined sides has a part in forces on images.
        let own = match self.body.mirrors.joined {
            [false, false, _] if all.len() > 1 => by_lamina(self, &|point| self.body.table(point), all),
            _ => all.swap_remove(0),
        };
        force.iter_mut().zip(own).for_each(|(force, own)| *force += own);
    }

    fn energy_at_rest(&self, t: &[f64]) -> Option<f64> {
        Some(self.body.energy_at_rest(t))
    }
}

impl Points for BeamBondOrthotropic {
    fn points(&self) -> usize {
        self.body.lattice.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.body.lattice.place(point);
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &self.components
    }
}

impl Model<3> for BeamBondOrthotropic {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn calibration_error(&self) -> f64 {
        // Shares of places on the border and of means round, too: measured 1.5 times as much on a strip of 2000 x 4 points.
        let parts = if self.body.border.bonds().is_some() { 2.0 } else { 1.0 };
        parts * calibration_error(self, 2)
    }

    fn contrast(&self) -> f64 {
        let diagonal = self.moduli.iter().flat_map(|of| [0, 1, 2].map(|k| of.stiffness[k][k]));
        let [least, most] = [f64::min, f64::max].map(|of| diagonal.clone().reduce(of).unwrap_or(1.0));
        self.contrast_of_points() * (most / least).sqrt()
    }

    fn contrast_of_points(&self) -> f64 {
        self.body.mixture().map_or(1.0, |mixture| mixture.contrast())
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        self.body.terms()
    }

    fn sizes(&self) -> ModelSizes {
        self.body.sizes()
    }

    fn relations(&self) -> Vec<Equation> {
        let signs = |[x, y, _]: [f64; 3]| [x, y, x * y];
        self.body.mirrors.relations(&self.body.lattice, &self.body.ghosts, signs)
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        let [x, y, turn] = rigid_motion(kind, self.position(point), centre);
        [x, y, turn * self.body.kind.bond.turning]
    }
}

impl Solvable<3> for BeamBondOrthotropic {
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<3>>> {
        Some(Box::new(self.with(self.body.coarser(cuts)?)))
    }

    fn breaking(&self) -> Option<Box<dyn BreakingModel<3>>> {
        Some(Box::new(self.clone()))
    }
}

impl Breakable<3> for BeamBondOrthotropic {
    type Critical = CriticalStretch;

    fn bond_numbers(&self) -> u64 {
        self.body.bond_numbers()
    }

    fn ends(&self, bond: u64) -> [usize; 2] {
        self.body.ends(bond)
    }

    fn offset(&self, bond: u64) -> usize {
        self.body.offset_of(bond)
    }

    fn for_each_ratio(&self, u: &[f64], critical: &CriticalStretch, visit: &mut dyn FnMut(u64, f64)) {
        self.body.for_each_ratio(u, critical, visit);
    }

    fn part(&self, bonds: &[u64]) -> Vec<Box<dyn Term<3>>> {
        self.body.part(bonds)
    }

    /// # Panics
    /// The body has images in lines of symmetry.
    fn break_bonds(&mut self, bonds: &[u64]) {
        self.body.break_bonds(bonds);
    }
}
