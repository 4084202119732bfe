//! What every model says of a shell membrane: terms, relations, rigid motions, stresses.

use super::super::plane::{
    BorderShares, CALIBRATION, FindCuts, Mirrors, PlaneFields, PlaneModel, Solvable, in_plane,
};
use super::{ShellKinematics, ShellMembrane, ends};
use crate::body::SquareLattice;
use crate::bonds::{Mat, Point};
use crate::condition::Equation;
use crate::model::solid::TENSOR;
use crate::model::{BodyFields, BodyModel, Component, Model, ModelSizes, Points, RigidMotion};
use crate::stiffness::Term;
use std::sync::Arc;

impl BodyModel for ShellMembrane {
    fn volume(&self, point: usize) -> f64 {
        if self.is_ghost(point) { 0.0 } else { self.cell_area() * self.parameters.thickness }
    }

    fn lattice(&self) -> Option<(&Arc<SquareLattice>, &Mirrors)> {
        Some((&self.lattice, &self.mirrors))
    }

    /// Inextensional motions: the higher their harmonic around, the less stretch along the axis they need.
    fn needs_all_rows(&self) -> bool {
        true
    }

    fn ghosts(&self) -> &[u32] {
        &self.ghosts
    }

    /// Of a membrane without free sides, whose uniform stress acts on its ends alone.
    fn border_shares(&self) -> Option<BorderShares<'_>> {
        (self.ends.is_some() && !self.has_free_sides()).then(|| ends::shares(&self.lattice))
    }

    fn triangles(&self) -> usize {
        0
    }

    fn completing(&self) -> usize {
        self.ends.as_ref().map_or(0, |ends| ends.bonds.count())
    }

    fn uncorrected(&self) -> usize {
        self.families.uncorrected
    }

    fn damage(&self) -> Vec<f64> {
        vec![0.0; self.lattice.points()]
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

impl PlaneModel for ShellMembrane {
    fn thickness(&self) -> f64 {
        self.parameters.thickness
    }

    /// That of plane stress with ν = 1/3.
    fn stiffness(&self) -> Mat<3, 3> {
        let (a, b) = (1.125 * self.parameters.youngs_modulus, 0.375 * self.parameters.youngs_modulus);
        [[a, b, 0.0], [b, a, 0.0], [0.0, 0.0, b]]
    }

    fn strain_of(&self, [x, y, shear]: [f64; 3]) -> [f64; 3] {
        let e = self.parameters.youngs_modulus;
        [(x - y / 3.0) / e, (y - x / 3.0) / e, 8.0 * shear / (3.0 * e)]
    }

    fn fields(&self, u: &[f64]) -> PlaneFields {
        self.recovered(u)
    }

    fn add_strain_work(&self, t: &mut [f64], points: Option<&[usize]>, force: &mut [f64]) {
        self.add_work(t, points, force);
    }
}

/// The unknowns of a point: along the axis, along the circumference, and outwards.
const COMPONENTS: [Component; 3] =
    [Component::displacement("ux", 0), Component::displacement("uy", 1), Component::displacement("w", 2)];

/// Motions of a body in space.
const RIGID_MOTIONS: [RigidMotion; 6] = [
    RigidMotion::translation("translation along x", "move along its axis"),
    RigidMotion::rotation("rotation about the axis", "turn about its axis"),
    RigidMotion::translation("translation at 0 degrees", "move across its axis"),
    RigidMotion::translation("translation at 90 degrees", "move across its axis"),
    RigidMotion::rotation("tilt at 0 degrees", "tilt its axis"),
    RigidMotion::rotation("tilt at 90 degrees", "tilt its axis"),
];

impl Points for ShellMembrane {
    fn points(&self) -> usize {
        self.lattice.points()
    }

    fn position(&self, point: usize) -> Point {
        let [x, s] = self.lattice.place(point);
        [x, s, 0.0]
    }

    fn components(&self) -> &[Component] {
        &COMPONENTS
    }
}

impl Model<3> for ShellMembrane {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        &RIGID_MOTIONS
    }

    fn calibration_error(&self) -> f64 {
        CALIBRATION
    }

    fn terms(&self) -> Vec<Box<dyn Term<3>>> {
        let mut terms: Vec<Box<dyn Term<3>>> = vec![Box::new(self.bonds.clone())];
        if let Some(ends) = &self.ends {
            terms.push(Box::new(ends.bonds.clone()));
        }
        if let Some(curvature) = &self.curvature {
            terms.push(Box::new(curvature.clone()));
        }
        terms
    }

    fn sizes(&self) -> ModelSizes {
        let bonds = ModelSizes {
            reach: self.bonds.reach(),
            elements: self.bonds.elements(),
            entries: 9 * self.bonds.elements(),
            bytes: size_of::<f64>() * self.bonds.stored_factors(),
        };
        let bonds = match &self.ends {
            Some(ends) => bonds.join(ModelSizes::of(&ends.bonds, ends.bonds.pairs())),
            None => bonds,
        };
        let Some(curvature) = &self.curvature else { return bonds };
        // A disc of twice the radius has four times the neighbours.
        let (rows, pairs) = (curvature.elements(), 4 * self.families.offsets.len());
        bonds.join(ModelSizes { reach: 2 * bonds.reach, elements: rows, entries: 9 * rows * pairs, bytes: 0 })
    }

    fn relations(&self) -> Vec<Equation> {
        self.mirrors.relations(&self.lattice, &self.ghosts, |[x, y, _]| [x, y, 1.0])
    }

    /// The published elongations resist all but the first two a little, so that these are none.
    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 3] {
        let [x, s] = self.place(point);
        let (x, r) = (x - centre[0], self.parameters.radius);
        if kind > 1 && self.parameters.kinematics == ShellKinematics::Published {
            return [0.0; 3];
        }
        let (sin, cos) = (s / r).sin_cos();
        match kind {
            0 => [1.0, 0.0, 0.0],
            1 => [0.0, 1.0, 0.0],
            2 => [0.0, -sin, cos],
            3 => [0.0, cos, sin],
            4 => [-r * cos, -x * sin, x * cos],
            _ => [-r * sin, x * cos, x * sin],
        }
    }
}

impl Solvable<3> for ShellMembrane {
    /// None: coarser levels of membranes keep all rows, and their cells are no squares.
    fn coarser(&self, _: &FindCuts) -> Option<Box<dyn Solvable<3>>> {
        None
    }
}
