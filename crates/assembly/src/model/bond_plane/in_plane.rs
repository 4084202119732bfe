//! A plate as a body in the plane.

use super::super::plane::{PlaneFields, PlaneModel};
use super::{Body, BondPlane, PlaneState};
use crate::bonds::Mat;

impl PlaneModel for BondPlane {
    fn thickness(&self) -> f64 {
        self.parameters.material.thickness
    }

    fn stiffness(&self) -> Mat<3, 3> {
        self.parameters.material.stiffness()
    }

    fn stiffness_at(&self, point: usize) -> Mat<3, 3> {
        let factor = self.factor(point);
        self.stiffness().map(|row| row.map(|c| factor * c))
    }

    fn strain_of(&self, stress: [f64; 3]) -> [f64; 3] {
        self.parameters.material.strain(stress)
    }

    fn strain_at(&self, point: usize, stress: [f64; 3], _across: f64) -> [f64; 3] {
        let factor = self.factor(point);
        self.strain_of(stress).map(|strain| strain / factor)
    }

    fn stress_across(&self, [x, y, _]: [f64; 3]) -> f64 {
        match self.parameters.material.state {
            PlaneState::Stress => 0.0,
            PlaneState::Strain => PlaneState::Strain.poisson_ratio() * (x + y),
        }
    }

    fn fields(&self, u: &[f64]) -> PlaneFields {
        match &self.body {
            Body::Lattice(body) => body.fields(u),
            Body::Cloud(body) => {
                let volume = |point: usize| body.sites.volume(point);
                PlaneFields::with_triangles(body.sums(u), body.overlay.list().iter(), volume, u)
            }
        }
    }

    fn add_free_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        match &self.body {
            Body::Lattice(body) => body.add_free_work(t, points, force),
            Body::Cloud(_) => self.add_strain_work(t, points, force),
        }
    }

    fn free_stress_beyond(&self, t: &[f64]) -> Option<[Vec<f64>; 3]> {
        match &self.body {
            Body::Lattice(body) => body.free_stress_beyond(t),
            Body::Cloud(_) => None,
        }
    }

    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        match &self.body {
            Body::Lattice(body) => body.add_strain_work(t, points, force),
            Body::Cloud(body) => body.add_strain_work(t, force),
        }
    }

    fn energy_at_rest(&self, t: &[f64]) -> Option<f64> {
        match &self.body {
            Body::Lattice(body) => Some(body.energy_at_rest(t)),
            Body::Cloud(_) => None,
        }
    }
}
