//! Springs from a point to the ground.

use super::{BlockMatrix, Share, Survey, Term, Twofold};
use crate::bonds::{Mat, add};
use crate::sum::Sum;

/// A linear spring on one unknown of a point, or on a sum of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Point.
    pub point: usize,
    /// Components and their coefficients in the motion that the spring resists; the second is zero where one is all.
    pub shares: [(usize, f64); 2],
    /// Stiffness, force per displacement (N/m) or moment per rotation (N m/rad), > 0.
    pub stiffness: f64,
}

/// Springs to the ground, `E = Σ ½ k (a u_c + b u_d)²`.
#[derive(Clone, Debug)]
pub struct Springs {
    points: usize,
    springs: Vec<Spring>,
}

impl Spring {
    /// A spring on one unknown.
    pub fn on(component: usize, point: usize, stiffness: f64) -> Self {
        Self { point, shares: [(component, 1.0), (component, 0.0)], stiffness }
    }

    /// Component and stiffness of a spring on one unknown.
    pub fn single(&self) -> Option<(usize, f64)> {
        let [(component, share), (_, other)] = self.shares;
        (other == 0.0).then_some((component, share * share * self.stiffness))
    }

    /// The motion that the spring resists, in a body of `points` points.
    fn motion(&self, points: usize, u: &[f64]) -> f64 {
        self.shares.iter().map(|&(component, share)| share * u[component * points + self.point]).sum()
    }

    /// Its internal forces with the numbers of their unknowns, in a body of `points` points.
    pub fn forces(&self, points: usize, u: &[f64]) -> [(usize, f64); 2] {
        let action = self.stiffness * self.motion(points, u);
        self.shares.map(|(component, share)| (component * points + self.point, share * action))
    }

    /// Its stiffness.
    fn block<const D: usize>(&self) -> Mat<D, D> {
        let mut block = [[0.0; D]; D];
        for (a, share) in self.shares {
            self.shares.iter().for_each(|&(b, other)| block[a][b] += share * self.stiffness * other);
        }
        block
    }
}

impl Springs {
    /// The springs of a body of `points` points.
    pub fn new(points: usize, springs: Vec<Spring>) -> Self {
        Self { points, springs }
    }
}

impl<const D: usize> Term<D> for Springs {
    fn couplings(&self, _visit: &mut dyn FnMut(usize, usize)) {}

    fn ground_motions(&self, visit: &mut dyn FnMut(&[Share])) {
        for s in &self.springs {
            let shares = s.shares.map(|(component, share)| (component, s.point, share));
            visit(if s.single().is_some() { &shares[..1] } else { &shares });
        }
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        let forces = self.springs.iter().flat_map(|s| s.forces(self.points, u));
        forces.for_each(|(unknown, value)| force[unknown] += value);
    }

    fn add_force_twofold(&self, u: Twofold<'_>, force: &mut [Sum]) -> bool {
        for spring in &self.springs {
            let unknowns =
                spring.shares.map(|(component, share)| (component * self.points + spring.point, share));
            let mut motion = Sum::default();
            unknowns.iter().for_each(|&(unknown, share)| motion.add_multiple(share, u.at(unknown)));
            let action = spring.stiffness * motion.total();
            unknowns.iter().for_each(|&(unknown, share)| force[unknown].add_product(share, action));
        }
        true
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        self.springs.iter().fold(Survey::EMPTY, |survey, s| {
            let motion = s.motion(self.points, u);
            let mut largest_action = [0.0; D];
            s.shares.iter().for_each(|&(c, share)| largest_action[c] += (share * s.stiffness * motion).abs());
            survey.join(Survey { energy: 0.5 * s.stiffness * motion * motion, largest_action })
        })
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        self.springs.iter().for_each(|s| tangent.add(s.point, s.point, &s.block()));
    }

    fn add_diagonal(&self, blocks: &mut [Mat<D, D>]) {
        self.springs.iter().for_each(|s| add(&mut blocks[s.point], &s.block()));
    }

    fn elements(&self) -> usize {
        self.springs.len()
    }

    fn stored_factors(&self) -> usize {
        self.springs.len()
    }
}
