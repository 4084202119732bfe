//! Springs from a point to the ground in a direction between two unknowns.

use super::{BlockMatrix, Share, Survey, Term};

/// A linear spring on a sum of two unknowns of a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObliqueSpring {
    /// Point.
    pub point: usize,
    /// Components and their coefficients in the motion that the spring resists.
    pub shares: [(usize, f64); 2],
    /// Stiffness, > 0.
    pub stiffness: f64,
}

/// Oblique springs to the ground, `E = Σ ½ k (a u_c + b u_d)²`.
#[derive(Clone, Debug)]
pub struct ObliqueSprings {
    points: usize,
    springs: Vec<ObliqueSpring>,
}

impl ObliqueSprings {
    /// The springs of a body of `points` points.
    pub fn new(points: usize, springs: Vec<ObliqueSpring>) -> Self {
        Self { points, springs }
    }
}

impl ObliqueSpring {
    /// The motion that the spring resists, in a body of `points` points.
    pub fn motion(&self, points: usize, u: &[f64]) -> f64 {
        self.shares.iter().map(|&(component, share)| share * u[component * points + self.point]).sum()
    }
}

impl<const D: usize> Term<D> for ObliqueSprings {
    fn couplings(&self, _visit: &mut dyn FnMut(usize, usize)) {}

    fn grounded(&self, visit: &mut dyn FnMut(usize, usize)) {
        self.springs
            .iter()
            .flat_map(|s| s.shares.map(|share| (share.0, s.point)))
            .for_each(|(c, p)| visit(c, p));
    }

    fn ground_motions(&self, visit: &mut dyn FnMut(&[Share])) {
        self.springs
            .iter()
            .for_each(|s| visit(&s.shares.map(|(component, share)| (component, s.point, share))));
    }

    fn add_force(&self, u: &[f64], force: &mut [f64]) {
        for s in &self.springs {
            let action = s.stiffness * s.motion(self.points, u);
            s.shares.iter().for_each(|&(c, share)| force[c * self.points + s.point] += share * action);
        }
    }

    fn survey(&self, u: &[f64]) -> Survey<D> {
        self.springs.iter().fold(Survey::EMPTY, |survey, s| {
            let motion = s.motion(self.points, u);
            let mut largest_action = [0.0; D];
            s.shares.iter().for_each(|&(c, share)| largest_action[c] = (share * s.stiffness * motion).abs());
            survey.join(Survey { energy: 0.5 * s.stiffness * motion * motion, largest_action })
        })
    }

    fn add_tangent(&self, tangent: &mut BlockMatrix<D>) {
        for s in &self.springs {
            let mut block = [[0.0; D]; D];
            for (a, share) in s.shares {
                s.shares.iter().for_each(|&(b, other)| block[a][b] += share * s.stiffness * other);
            }
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
