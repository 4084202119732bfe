//! How the faces of a crack part behind its tip, from which its modes follow.
//!
//! At a distance r behind a tip the faces open by `8 K_I/E' √(r/2π)` and slide by `8 K_II/E' √(r/2π)`. In a body of bonds they do so as if
//! r began a little ahead of the tip, farther for sliding than for opening: the squares grow linearly all the same, and the modes are to
//! each other as the roots of what they grow by between two distances.

use crate::scene::body::site::interpolate::{Interpolation, Weights};
use peristat_assembly::body::in_space;

/// Spacings between the tip and the first of the two places, at least: nearer to it bonds reach around the tip.
const NEAREST: f64 = 2.0;

/// Displacement of one face of a crack from the other at two distances behind a tip.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Jump {
    /// Points of the model and their shares of it, which sum to zero, at the nearer and the farther place.
    pub(crate) weights: [Weights; 2],
    /// Unit vector along the crack towards its tip.
    pub(crate) tangent: [f64; 2],
}

impl Jump {
    /// That of a tip with the vertex of the crack before it; `None` where its last straight part is too short.
    ///
    /// `horizon` is in m, `inside` is the number of the point next to a position in the body.
    pub(crate) fn at(
        [tip, before]: [[f64; 2]; 2],
        horizon: f64,
        on: &Interpolation,
        inside: &dyn Fn([f64; 3]) -> Option<u32>,
    ) -> Option<Self> {
        let d = [tip[0] - before[0], tip[1] - before[1]];
        let length = d[0].hypot(d[1]);
        let h = on.body.spacing();
        let tangent = d.map(|d| d / length);
        let far = (2.0 * horizon).max(2.0 * NEAREST * h).min(0.5 * length);
        let near = 0.5 * far;
        if near < NEAREST * h * (1.0 - 1e-6) {
            return None;
        }
        let at = |r: f64| {
            let place = [0, 1].map(|k| tip[k] - r * tangent[k]);
            let normal = [-tangent[1], tangent[0]];
            let mut weights = Weights::new();
            for face in [1.0, -1.0] {
                // The face itself from one and two spacings beside it.
                for (off, beside) in [(h, 2.0), (2.0 * h, -1.0)] {
                    let at = in_space([0, 1].map(|k| place[k] + face * off * normal[k]));
                    let found = on.at(at, inside(at)?);
                    weights.extend(found.into_iter().map(|(point, w)| (point, face * beside * w)));
                }
            }
            Some(weights)
        };
        Some(Self { weights: [at(near)?, at(far)?], tangent })
    }

    /// What K_I and K_II are proportional to, from the displacements along x and y of every point. Sliding is that of the face on the
    /// left, seen towards the tip, in this direction.
    pub(crate) fn parts(&self, displacement: impl Fn(u32) -> [f64; 2]) -> [f64; 2] {
        let [a, b] = self.tangent;
        let [near, far] = [0, 1].map(|place: usize| {
            let mut jump = [0.0; 2];
            for &(point, share) in &self.weights[place] {
                let u = displacement(point);
                (0..2).for_each(|k| jump[k] += share * u[k]);
            }
            [a * jump[1] - b * jump[0], a * jump[0] + b * jump[1]]
        });
        [0, 1].map(|k| {
            let grown = far[k] * far[k].abs() - near[k] * near[k].abs();
            grown.signum() * grown.abs().sqrt()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use peristat_assembly::body::{Crack, PointBody, SquareLattice};

    #[test]
    fn faces_that_part_with_roots_of_the_distance_give_their_factors() {
        let lattice = SquareLattice::rectangle(0.5, [0.0; 2], [40, 40]);
        for (tip, before) in [([12.0, 10.0], [2.0, 10.0]), ([13.0, 12.1], [3.0, 5.1])] {
            let crack = [Crack::new(vec![before, tip]).unwrap()];
            let body = PointBody::Lattice(lattice.clone());
            let on = Interpolation { body: &body, cracks: &crack, reach: 3 };
            let inside = |at: [f64; 3]| lattice.number(lattice.cell_at([at[0], at[1]])).map(|p| p as u32);
            let jump = Jump::at([tip, before], 1.5, &on, &inside).unwrap();
            let [a, b] = jump.tangent;
            // Opening 3 √(r + 0.2), sliding −2 √(r + 0.7), beside a uniform strain and a rotation.
            let displacement = |p: u32| {
                let at = lattice.place(p as usize);
                let d = [at[0] - tip[0], at[1] - tip[1]];
                let (r, side) = ((-d[0] * a - d[1] * b).max(0.0), (d[1] * a - d[0] * b).signum());
                let (open, slide) = (1.5 * side * (r + 0.2).sqrt(), -side * (r + 0.7).sqrt());
                [slide * a - open * b + 3.0 * at[0] - at[1], slide * b + open * a + at[0] + 2.0 * at[1]]
            };
            let [opening, sliding] = jump.parts(displacement);
            // From 1.5 to 3 before the tip; roots are continued linearly between points.
            let ratio = sliding / opening;
            assert!(opening > 0.0 && (ratio + 2.0 / 3.0).abs() < 0.01, "{ratio}");
        }
        let body = PointBody::Lattice(lattice);
        let on = Interpolation { body: &body, cracks: &[], reach: 3 };
        assert_eq!(Jump::at([[12.0, 10.0], [8.1, 10.0]], 1.5, &on, &|_| Some(0)), None);
    }
}
