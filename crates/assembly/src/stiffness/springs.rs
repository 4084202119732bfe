//! Springs from a point to the ground.

use super::{BlockMatrix, Survey, Term};

/// A linear spring on one unknown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spring {
    /// Component of the unknown.
    pub component: usize,
    /// Point of the unknown.
    pub point: usize,
    /// Stiffness, force per displacement (N/m) or moment per rotation (N m/rad), > 0.
    pub stiffness: f64,
}

/// Springs to the ground, `E = Σ ½ k u²`.
#[derive(Clone, Debug)]
pub struct Springs {
    points: usize,
    springs: Vec<Spring>,
}

impl Springs {
    /// The springs of a body of `points` points.
    pub fn new(points: usize, springs: Vec<Spring>) -> Self {
        Self { points, springs }
    }

    fn unknown(&self, spring: &Spring) -> usize {
        spring.component * self.points + spring.point
    }
}

impl<const D: usize> Term<D> for Springs {
    fn couplings(&self, _visit: &mut dyn FnMut(usize, usize)) {}

    fn grounded(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.springs.iter().for_each(|s| visit(s.component, s.point));
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        for s in &self.springs {
            force[self.unknown(s)] += s.stiffness * u[self.unknown(s)];
        }
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        self.springs.iter().fold(Survey::EMPTY, |survey, s| {
            let u = u[self.unknown(s)];
            let mut largest_action = [0.0; D];
            largest_action[s.component] = (s.stiffness * u).abs();
            survey.join(Survey { energy: 0.5 * s.stiffness * u * u, largest_action })
        })
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for s in &self.springs {
            let mut block = [[0.0; D]; D];
            block[s.component][s.component] = s.stiffness;
            tangent.add(s.point, s.point, &block);
        }
    }

    fn elements(&self) -> usize {
        self.springs.len()
    }

    fn stored_factors(&self) -> usize {
        self.springs.len()
    }
}
