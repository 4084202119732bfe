//! Solids of listed points as models: three unknowns per point, its displacements.

use super::BondSolidCloud;
use crate::body::{Cell, SquareLattice};
use crate::bonds::{Mat, Point};
use crate::condition::Equation;
use crate::model::plane::{Edges, FindCuts, Mirrors, Solvable, calibration_error};
use crate::model::solid::{
    COMPONENTS, RIGID_MOTIONS, SolidEdges, SolidFields, SolidModel, TENSOR, TENSOR_COMPONENTS, rigid_motion,
};
use crate::model::{BodyFields, BodyModel, Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::{NodedBonds, Term};
use std::sync::Arc;

impl Points for BondSolidCloud {
    fn points(&self) -> usize {
        self.body.sites.positions.len()
    }

    fn position(&self, point: usize) -> Point {
        self.body.sites.positions[point]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<3> for BondSolidCloud {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        self.body.terms()
    }

    fn sizes(&self) -> ModelSizes {
        self.body.sizes()
    }

    fn relations(&self) -> Vec<Equation> {
        Vec::new()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        rigid_motion(kind, self.position(point), centre)
    }

    fn calibration_error(&self) -> f64 {
        calibration_error(self, 3)
    }

    fn contrast(&self) -> f64 {
        self.material.contrast()
    }
}

impl BodyModel for BondSolidCloud {
    fn volume(&self, point: usize) -> f64 {
        self.body.sites.volume(point)
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        None
    }

    fn ghosts(&self) -> &[u32] {
        &[]
    }

    fn tensor_components(&self) -> &'static [&'static str] {
        &TENSOR_COMPONENTS
    }

    fn edges(&self) -> Option<Edges> {
        Some(self.edges.into())
    }

    fn triangles(&self) -> usize {
        self.body.overlay.list().len()
    }

    fn uncorrected(&self) -> usize {
        self.body.uncorrected
    }

    fn damage(&self) -> Vec<f64> {
        self.body.damage()
    }

    fn strains_of(&self, stress: [f64; TENSOR], _across: f64) -> [f64; TENSOR] {
        self.strain_of(stress)
    }

    fn recover(&self, u: &[f64]) -> BodyFields {
        self.fields(u).into()
    }

    fn unbreakable(&self) -> Option<&'static str> {
        Some("listed points of solids do not break")
    }

    fn as_solid(&self) -> Option<&dyn SolidModel> {
        Some(self)
    }
}

impl SolidModel for BondSolidCloud {
    fn faces(&self) -> SolidEdges {
        self.edges
    }

    fn bonds_of_a_point(&self) -> Vec<(Cell, f64)> {
        Vec::new()
    }

    fn cut_bonds(&self) -> Vec<(Cell, usize)> {
        Vec::new()
    }

    fn bonds_on_border(&self) -> Option<&NodedBonds<3, 1>> {
        None
    }

    fn stiffness(&self) -> Mat<TENSOR, TENSOR> {
        self.material.stiffness()
    }

    fn strain_of(&self, stress: [f64; TENSOR]) -> [f64; TENSOR] {
        self.material.strain(stress)
    }

    fn fields(&self, u: &[f64]) -> SolidFields {
        let mut sums = self.body.sums(u);
        for family in self.body.overlay.list() {
            family.add_densities(TENSOR, self.volume(family.point as usize), u, &mut sums);
        }
        SolidFields::of(sums)
    }

    fn add_strain_work(&self, t: &mut [f64], force: &mut [f64]) {
        self.body.add_strain_work(t, force);
    }
}

impl Solvable<3> for BondSolidCloud {
    fn coarser(&self, _cuts: &FindCuts) -> Option<Box<dyn Solvable<3>>> {
        None
    }
}
