//! A plate in antiplane shear as a model with one unknown per point.

use super::super::plane::{
    BorderShares, Edges, FindCuts, Mirrors, PlaneFields, PlaneModel, Solvable, in_plane,
};
use super::BondAntiplane;
use crate::body::SquareLattice;
use crate::bonds::{Mat, Point};
use crate::condition::Equation;
use crate::model::solid::TENSOR;
use crate::model::{BodyFields, BodyModel, Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;
use std::sync::Arc;

const COMPONENTS: [Component; 1] = [Component::displacement("w", 2)];

const RIGID_MOTIONS: [RigidMotion; 1] =
    [RigidMotion::translation("translation along z", "move across the plane")];

impl Points for BondAntiplane {
    fn points(&self) -> usize {
        self.body.lattice.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, y] = self.body.lattice.place(point);
        [x, y, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<1> for BondAntiplane {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn terms(&self) -> Vec<Box<dyn Term<1>>> {
        self.body.terms()
    }

    fn contrast(&self) -> f64 {
        self.contrast_of_points()
    }

    fn contrast_of_points(&self) -> f64 {
        self.body.mixture().map_or(1.0, |mixture| mixture.contrast())
    }

    fn sizes(&self) -> ModelSizes {
        self.body.sizes()
    }

    fn relations(&self) -> Vec<Equation> {
        self.body.mirrors.relations(&self.body.lattice, &self.body.ghosts, |signs| [signs[2]])
    }

    fn rigid_motion(&self, _kind: usize, _point: usize, _centre: Point) -> [f64; 1] {
        [1.0]
    }
}

impl BodyModel for BondAntiplane {
    fn volume(&self, point: usize) -> f64 {
        self.body.volume(point)
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        Some((&self.body.lattice, &self.body.mirrors))
    }

    fn ghosts(&self) -> &[u32] {
        &self.body.ghosts
    }

    fn tensor_components(&self) -> &'static [&'static str] {
        &["xz", "yz"]
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

    fn strains_of(&self, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        in_plane(self, stress, across)
    }

    fn strains_at(&self, point: usize, stress: [f64; TENSOR], across: f64) -> [f64; TENSOR] {
        let factor = self.body.factor(point);
        self.strains_of(stress, across).map(|strain| strain / factor)
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

impl PlaneModel for BondAntiplane {
    fn thickness(&self) -> f64 {
        self.parameters.thickness
    }

    fn stiffness(&self) -> Mat<3, 3> {
        let g = self.parameters.shear_modulus;
        [[g, 0.0, 0.0], [0.0, g, 0.0], [0.0; 3]]
    }

    fn strain_of(&self, [xz, yz, _]: [f64; 3]) -> [f64; 3] {
        [xz, yz, 0.0].map(|stress| stress / self.parameters.shear_modulus)
    }

    fn strain_at(&self, point: usize, stress: [f64; 3], _across: f64) -> [f64; 3] {
        let factor = self.body.factor(point);
        self.strain_of(stress).map(|strain| strain / factor)
    }

    fn fields(&self, u: &[f64]) -> PlaneFields {
        self.body.fields(u)
    }

    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.body.add_strain_work(t, points, force);
    }
}

impl Solvable<1> for BondAntiplane {
    fn coarser(&self, cuts: &FindCuts) -> Option<Box<dyn Solvable<1>>> {
        Some(Box::new(Self { parameters: self.parameters, body: self.body.coarser(cuts)? }))
    }
}
