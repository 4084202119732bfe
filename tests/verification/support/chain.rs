//! Beam bonds on a bare lattice, with relations of the test's own.

use peristat_assembly::bonds::{BondGeometry, Point};
use peristat_assembly::condition::Equation;
use peristat_assembly::model::timoshenko_beam::{
    UniformBending, UniformSection, VolumeFactor, bond_law, bond_weights,
};
use peristat_assembly::model::{Component, Model, Points, RigidMotion};
use peristat_assembly::stiffness::{Lattice, LatticeBonds, Override, Term, Weights};

/// Weights and stiffnesses of a lattice of beam bonds.
pub(crate) struct Calibration {
    pub(crate) bending: f64,
    pub(crate) shear: f64,
    pub(crate) spacing: f64,
    pub(crate) law: &'static str,
    /// Weight of the bonds over 1, 2, … spacings.
    pub(crate) weights: Vec<f64>,
}

impl Calibration {
    /// Half-edge weights of a whole horizon ratio.
    pub(crate) fn half_edge(law: &'static str, m: u32, spacing: f64, [bending, shear]: [f64; 2]) -> Self {
        Self { bending, shear, spacing, law, weights: bond_weights(f64::from(m), VolumeFactor::HalfEdge) }
    }

    /// Shear stiffness of the bond over `n` spacings, written from the definition of the laws.
    pub(crate) fn shear_of(&self, n: usize) -> f64 {
        let power = |p: i32| -> f64 { self.numbered().map(|(n, a)| a * n.powi(p)).sum() };
        let square = match self.law {
            "published" => return self.shear,
            "corrected" => power(3) / power(1) * self.spacing.powi(2),
            _ => (n as f64 * self.spacing).powi(2),
        };
        1.0 / (1.0 / self.shear + square / (12.0 * self.bending))
    }

    /// Number of spacings and weight of every class.
    pub(crate) fn numbered(&self) -> impl Iterator<Item = (f64, f64)> + '_ {
        (1_u32..).map(f64::from).zip(self.weights.iter().copied())
    }

    /// The bonds on `points` points.
    pub(crate) fn bonds(&self, points: usize, overrides: &[Override]) -> LatticeBonds<2, 2, UniformBending> {
        let power = |p: i32| -> f64 { self.numbered().map(|(n, a)| a * n.powi(p)).sum() };
        let section = UniformSection {
            bending_stiffness: self.bending,
            shear_stiffness: self.shear,
            axial_stiffness: 1.0,
            law: bond_law::find(self.law).expect("the law exists"),
        };
        let mean_square_length = self.spacing.powi(2) * power(3) / power(1);
        let geometry = |k: usize| BondGeometry { xi: [k as f64 * self.spacing, 0.0, 0.0] };
        let geometries: Vec<_> = (1..=self.weights.len()).map(geometry).collect();
        let classes = self.weights.iter().enumerate().map(|(k, &weight)| (k + 1, weight)).collect();
        let lattice = Lattice { points, first: 0, count: points };
        let weights = Weights::new(points, classes, overrides);
        LatticeBonds::new(lattice, &UniformBending { section, mean_square_length }, &geometries, weights)
    }
}

/// A body of lattice bonds.
pub(crate) struct Body {
    pub(crate) points: usize,
    pub(crate) bonds: LatticeBonds<2, 2, UniformBending>,
    pub(crate) spacing: f64,
    pub(crate) relations: Vec<Equation>,
}

impl Points for Body {
    fn points(&self) -> usize {
        self.points
    }

    fn position(&self, point: usize) -> Point {
        [point as f64 * self.spacing, 0.0, 0.0]
    }

    fn components(&self) -> &[Component] {
        const { &[Component::displacement("w", 1), Component::rotation("phi", 1.0)] }
    }
}

impl Model<2> for Body {
    fn rigid_motions(&self) -> &'static [RigidMotion] {
        const { &[RigidMotion::translation("translation along w", ""), RigidMotion::rotation("rotation", "")] }
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        vec![Box::new(self.bonds.clone())]
    }

    fn relations(&self) -> Vec<Equation> {
        self.relations.clone()
    }

    fn rigid_motion(&self, kind: usize, point: usize, centre: Point) -> [f64; 2] {
        [[1.0, 0.0], [self.position(point)[0] - centre[0], 1.0]][kind]
    }
}
