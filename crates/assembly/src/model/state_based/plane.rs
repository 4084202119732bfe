//! State-based bodies as bodies in the plane: stresses, loads, coarser lattices.

use super::super::plane::{Mirrors, PlaneFields, PlaneModel, in_plane};
use super::body::cell_volume;
use super::{Geometry, StateBased, StateParameters};
use crate::body::{Cell, SquareLattice};
use crate::bonds::Mat;
use crate::model::solid::TENSOR;
use crate::model::{BodyFields, BodyModel, Points};
use std::f64::consts::TAU;
use std::sync::Arc;

impl BodyModel for StateBased {
    fn volume(&self, point: usize) -> f64 {
        self.true_volume(point)
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        Some((&self.body.lattice, &self.body.mirrors))
    }

    fn ghosts(&self) -> &[u32] {
        &self.body.ghosts
    }

    fn triangles(&self) -> usize {
        0
    }

    fn uncorrected(&self) -> usize {
        0
    }

    fn damage(&self) -> Vec<f64> {
        let families = &self.body.families;
        let mut gone = vec![0.0; self.points()];
        let is_apart = |cut: &&(usize, usize)| self.body.apart.binary_search(cut).is_ok();
        for &(offset, lower) in self.body.cuts.iter().filter(|cut| !is_apart(cut)) {
            let ends = [
                (lower, offset),
                (self.body.upper(offset, lower).unwrap_or(lower), families.opposite(offset)),
            ];
            for (point, offset) in ends {
                let plain = &families.sets[0];
                let of = |w: f64, [a, b, _]: Cell| w * f64::from(a * a + b * b) / plain.q;
                if families.set_of[point].is_some() {
                    gone[point] += of(plain.weights[offset], families.offsets[offset]);
                }
            }
        }
        gone
    }

    fn hardly_compresses(&self) -> bool {
        self.materials().iter().any(StateParameters::hardly_compresses)
    }

    fn fold(&self, force: &mut [f64]) {
        self.body.fold(force);
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

    fn across_at(&self, point: usize, [x, y, shear, ..]: [f64; TENSOR]) -> f64 {
        self.material(point).stress_across([x, y, shear])
    }

    fn recover(&self, u: &[f64]) -> BodyFields {
        self.fields(u).into()
    }

    fn as_plane(&self) -> Option<&dyn PlaneModel> {
        Some(self)
    }
}

impl PlaneModel for StateBased {
    fn thickness(&self) -> f64 {
        match self.parameters.geometry {
            Geometry::PlaneStress(thickness) | Geometry::PlaneStrain(thickness) => thickness,
            Geometry::Axisymmetric => 1.0,
        }
    }

    fn length_across(&self, x: f64) -> f64 {
        if self.parameters.is_axisymmetric() { TAU * x } else { self.thickness() }
    }

    fn stiffness(&self) -> Mat<3, 3> {
        self.parameters.stiffness()
    }

    fn stiffness_at(&self, point: usize) -> Mat<3, 3> {
        self.material(point).stiffness()
    }

    fn strain_of(&self, stress: [f64; 3]) -> [f64; 3] {
        self.parameters.strain(stress)
    }

    fn strain_with(&self, stress: [f64; 3], across: f64) -> [f64; 3] {
        self.parameters.strain_with(stress, across)
    }

    fn strain_at(&self, point: usize, stress: [f64; 3], across: f64) -> [f64; 3] {
        self.material(point).strain_with(stress, across)
    }

    fn stress_across(&self, stress: [f64; 3]) -> f64 {
        self.parameters.stress_across(stress)
    }

    fn fields(&self, u: &[f64]) -> PlaneFields {
        self.body.fields(&self.parameters, u)
    }

    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.body.add_stretch_work(&self.parameters, points, t, force);
    }

    fn add_stress_load(
        &self,
        points: Option<&[usize]>,
        stress_at: &(dyn Fn(usize, [f64; 2]) -> [f64; 3] + Sync),
        force: &mut [f64],
    ) {
        let stress = |p: usize| stress_at(p, self.place(p));
        self.body.add_stress_work(&self.parameters, points, &stress, force);
        if !self.parameters.is_axisymmetric() {
            return;
        }
        // The stress across is that along x, with the volumes of the energies.
        let n = self.points();
        let cell = cell_volume(&self.parameters, self.body.lattice.spacing());
        let families = &self.body.families;
        let mut add = |p: usize| {
            if families.set_of[p].is_some() {
                force[p] += cell * families.energy[p] * stress(p)[0] / self.place(p)[0];
            }
        };
        match points {
            Some(points) => points.iter().for_each(|&p| add(p)),
            None => (0..n).for_each(add),
        }
    }
}
