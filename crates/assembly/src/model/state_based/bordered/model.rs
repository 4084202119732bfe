//! The plate as a model: two unknowns per point, the displacements along x and y.

use super::super::super::plane::{
    BorderShares, COMPONENTS, Edges, FindCuts, Mirrors, PlaneFields, PlaneModel, RIGID_MOTIONS, Solvable,
    calibration_error, in_plane, rigid_motion,
};
use super::BorderedState;
use super::rings::weight;
use crate::body::SquareLattice;
use crate::bonds::{Mat, Point};
use crate::condition::Equation;
use crate::model::solid::TENSOR;
use crate::model::{BodyFields, BodyModel, Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;
use std::f64::consts::TAU;
use std::sync::Arc;

impl Points for BorderedState {
    fn points(&self) -> usize {
        self.plate.lattice.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.plate.lattice.place(point);
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<2> for BorderedState {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        // A body of revolution moves along its axis alone.
        if self.parameters.is_axisymmetric() { &RIGID_MOTIONS[1..2] } else { &RIGID_MOTIONS }
    }

    fn calibration_error(&self) -> f64 {
        calibration_error(self, 2)
    }

    fn contrast(&self) -> f64 {
        self.parameters.contrast()
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        match &self.dilatations {
            None => self.plate.terms(),
            Some(_) => vec![Box::new(self.term.clone())],
        }
    }

    fn sizes(&self) -> ModelSizes {
        let bonds = self.plate.sizes();
        let Some(of) = &self.dilatations else { return bonds };
        // A family couples all of its points, most of which others couple, too.
        let neighbours = 2 * self.plate.neighbourhood.bonded().count();
        let own = ModelSizes::of(&of.own, of.own.pairs());
        let means = of.means.iter().map(|means| ModelSizes::of(means, means.pairs()));
        let grid = ModelSizes::of(&of.grid, 2 * neighbours * self.points());
        means.fold(bonds.join(grid).join(own), ModelSizes::join)
    }

    fn relations(&self) -> Vec<Equation> {
        self.plate.mirrors.relations(&self.plate.lattice, &self.plate.ghosts, |[x, y, _]| [x, y])
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        let kind = if self.parameters.is_axisymmetric() { 1 } else { kind };
        let [x, y, _] = rigid_motion(kind, self.position(point), centre);
        [x, y]
    }
}

impl Solvable<2> for BorderedState {
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<2>>> {
        Some(Box::new(match self.parameters.is_axisymmetric() {
            true => self.coarser_ring()?,
            false => Self::new(self.plate.coarser(cuts)?, self.parameters),
        }))
    }
}

impl BodyModel for BorderedState {
    fn volume(&self, point: usize) -> f64 {
        weight(&self.plate, point) * self.plate.volume(point)
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        Some((&self.plate.lattice, &self.plate.mirrors))
    }

    fn ghosts(&self) -> &[u32] {
        &self.plate.ghosts
    }

    fn edges(&self) -> Option<Edges> {
        Some(self.plate.kind.edges)
    }

    fn border_shares(&self) -> Option<BorderShares<'_>> {
        self.plate.border_shares()
    }

    fn triangles(&self) -> usize {
        self.plate.triangles.list().len()
    }

    fn completing(&self) -> usize {
        self.plate.completing()
    }

    fn uncorrected(&self) -> usize {
        self.plate.uncorrected
    }

    fn damage(&self) -> Vec<f64> {
        self.plate.damage()
    }

    fn hardly_compresses(&self) -> bool {
        self.parameters.hardly_compresses()
    }

    fn strains_of(&self, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        in_plane(self, stress, across)
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

impl PlaneModel for BorderedState {
    fn thickness(&self) -> f64 {
        if self.parameters.is_axisymmetric() { 1.0 } else { self.plate.kind.thickness }
    }

    fn length_across(&self, x: f64) -> f64 {
        if self.parameters.is_axisymmetric() { TAU * x } else { self.thickness() }
    }

    fn stiffness(&self) -> Mat<3, 3> {
        self.parameters.stiffness()
    }

    fn strain_of(&self, stress: [f64; 3]) -> [f64; 3] {
        self.parameters.strain(stress)
    }

    fn stress_across(&self, stress: [f64; 3]) -> f64 {
        self.parameters.stress_across(stress)
    }

    fn strain_with(&self, stress: [f64; 3], across: f64) -> [f64; 3] {
        self.parameters.strain_with(stress, across)
    }

    fn fields(&self, u: &[f64]) -> PlaneFields {
        self.fields_of(u)
    }

    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.add_work(t, points, force);
    }
}
