//! How the faces of a crack in a solid part behind a place of its front, from which the modes there follow.
//!
//! At a distance r behind the front they open by `8 K_I/E' √(r/2π)`, slide across it by `8 K_II/E' √(r/2π)` and along it by `4 K_III/G √(r/2π)`.
//! Each K is what its square tends to at the front, on a line through five distances.

use crate::scene::body::site::interpolate::{Interpolation, Weights};
use crate::scene::body::site::symmetry::Symmetry;
use peristat_assembly::body::{CRACK_SLACK, CrackSurface, FrontPlace, Fronts};
use std::f64::consts::TAU;

/// Distances behind the front, spacings: nearer to it bonds reach around it. They are for a horizon of three spacings or less.
const BEHIND: [f64; 5] = [2.0, 2.5, 3.0, 3.5, 4.0];
const HORIZON: f64 = 3.0;

/// How far a position may lie from the front, spacings.
const NEAR: f64 = 1.0;

/// How far behind a place of a front another one may be, over the farthest distance: corners of a front of straight pieces are nearer.
const OTHER: f64 = 0.8;

/// How far a normal may be off an axis.
const ALONG: f64 = 1e-6;

/// How far faces may lie off the plane of a place, spacings.
const FLAT: f64 = 0.1;

/// Why a stress intensity cannot be found at a position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum FrontFault {
    /// It has no place of the front in the body beside it.
    Far,
    /// The crack is bent or ends behind it, has another front or crack beside it there, or is outside of the body.
    Short {
        /// How far it must be straight and in the body, spacings.
        spacings: f64,
    },
}

/// How faces part behind a place of a front.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct FrontJump {
    /// Distances behind the front, m, and points of the model with their shares of what one face moves from the other.
    jumps: Vec<(f64, Weights)>,
    /// Across the faces, ahead, and along the front.
    axes: [[f64; 3]; 3],
    /// Whether the crack lies in a mirror: its faces do not slide.
    is_mirrored: bool,
}

/// What places are looked at in.
pub(crate) struct Beside<'a> {
    /// Horizon, m.
    pub(crate) horizon: f64,
    /// Mirrors.
    pub(crate) symmetry: &'a Symmetry,
    /// Values between points.
    pub(crate) on: &'a Interpolation<'a>,
    /// Number of the point next to a position in the body.
    pub(crate) inside: &'a dyn Fn([f64; 3]) -> Option<u32>,
}

impl FrontJump {
    /// That of the place of a front nearest to a position, m.
    ///
    /// # Errors
    /// [`FrontFault`].
    pub(crate) fn at(
        (surface, fronts): (&CrackSurface, &Fronts),
        position: [f64; 3],
        beside: &Beside,
    ) -> Result<Self, FrontFault> {
        let h = beside.on.body.spacing();
        let place = fronts.near(position).ok_or(FrontFault::Far)?;
        if distance(place.at, position) > NEAR * h {
            return Err(FrontFault::Far);
        }
        let widened = (beside.horizon / (HORIZON * h)).max(1.0);
        let short = FrontFault::Short { spacings: widened * BEHIND[BEHIND.len() - 1] };
        let mirror = mirror(&place, beside.symmetry, h);
        let jumps = BEHIND.map(|r| {
            let r = r * widened * h;
            let behind = [0, 1, 2].map(|k| place.at[k] - r * place.ahead[k]);
            let nearest = fronts.near(behind).map_or(0.0, |other| distance(other.at, behind));
            let is_on = surface.cuts(behind, behind, FLAT * h) && nearest > OTHER * r;
            let weights = is_on.then(|| jump(behind, place.normal, mirror, beside)).flatten();
            weights.map(|weights| (r, weights)).ok_or(short)
        });
        let FrontPlace { ahead: a, normal: n, .. } = place;
        let along = [a[1] * n[2] - a[2] * n[1], a[2] * n[0] - a[0] * n[2], a[0] * n[1] - a[1] * n[0]];
        Ok(Self {
            jumps: jumps.into_iter().collect::<Result<_, _>>()?,
            axes: [n, a, along],
            is_mirrored: mirror.is_some(),
        })
    }

    /// Whether the crack is slanted to the layers of points, so that values beside its faces are interpolated.
    pub(crate) fn is_slanted(&self) -> bool {
        self.axes[0].iter().all(|n| n.abs() < 1.0 - ALONG)
    }

    /// K_I, K_II and K_III from the displacements of every point, with E' and the shear modulus.
    pub(crate) fn modes(&self, stiffness: [f64; 2], displacement: impl Fn(u32) -> [f64; 3]) -> [f64; 3] {
        let factors = [stiffness[0] / 8.0, stiffness[0] / 8.0, stiffness[1] / 4.0];
        let middle = self.jumps.iter().map(|jump| jump.0).sum::<f64>() / self.jumps.len() as f64;
        let spread: f64 = self.jumps.iter().map(|jump| (jump.0 - middle).powi(2)).sum();
        let mut squares = [0.0; 3];
        for (r, weights) in &self.jumps {
            let mut moved = [0.0; 3];
            for &(point, share) in weights {
                let u = displacement(point);
                (0..3).for_each(|k| moved[k] += share * u[k]);
            }
            // Share of this distance in the value at the front of a straight line through all.
            let at_front = 1.0 / self.jumps.len() as f64 - middle * (r - middle) / spread;
            for mode in 0..3 {
                let part: f64 = (0..3).map(|k| self.axes[mode][k] * moved[k]).sum();
                let root = factors[mode] * part * (TAU / r).sqrt();
                squares[mode] += at_front * root * root.abs();
            }
        }
        let modes = squares.map(|square| square.signum() * square.abs().sqrt());
        if self.is_mirrored { [modes[0], 0.0, 0.0] } else { modes }
    }
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>().sqrt()
}

/// Which side of a crack the body has where the crack lies in a mirror: 1 if it is that of the normal, else -1.
fn mirror(place: &FrontPlace, symmetry: &Symmetry, h: f64) -> Option<f64> {
    symmetry.at.iter().enumerate().find_map(|(side, plane)| {
        let (axis, inwards) = (side / 2, if side % 2 == 0 { 1.0 } else { -1.0 });
        let is_on =
            (place.at[axis] - (*plane)?).abs() <= CRACK_SLACK * h && place.normal[axis].abs() > 1.0 - 1e-9;
        is_on.then(|| inwards * place.normal[axis].signum())
    })
}

/// Shares of points in what the face on the side of the normal moves from the other one at a place.
fn jump(place: [f64; 3], normal: [f64; 3], mirror: Option<f64>, beside: &Beside) -> Option<Weights> {
    let h = beside.on.body.spacing();
    let faces = match mirror {
        Some(side) => vec![(side, 2.0)],
        None => vec![(1.0, 1.0), (-1.0, 1.0)],
    };
    let mut weights = Weights::new();
    for (side, times) in faces {
        let beside_it = |off: f64| [0, 1, 2].map(|k| place[k] + side * off * h * normal[k]);
        // No other crack between the faces and the points beside them.
        let [near, far] = [0.2, 1.5].map(beside_it);
        if beside.on.cracks.iter().any(|crack| crack.cuts(near, far, CRACK_SLACK * h)) {
            return None;
        }
        // The face itself from the two layers beside it.
        for (off, share) in [(0.5, 1.5), (1.5, -0.5)] {
            let at = beside_it(off);
            let found = beside.on.at(at, (beside.inside)(at)?);
            weights.extend(found.into_iter().map(|(point, w)| (point, side * times * share * w)));
        }
    }
    Some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::body::site::fronts::Around;
    use peristat_assembly::body::{Crack, PointBody, SquareLattice};

    #[test]
    fn faces_that_part_with_roots_of_the_distance_have_their_factors() {
        let solid = SquareLattice::cuboid(0.5, [0.0; 3], [24; 3]);
        let body = PointBody::Solid(solid.clone());
        let surface = CrackSurface::polygon(&[
            [-1.0, -1.0, 6.0],
            [6.0, -1.0, 6.0],
            [6.0, 13.0, 6.0],
            [-1.0, 13.0, 6.0],
        ])
        .unwrap();
        let cracks = [Crack::from(surface.clone())];
        let on = Interpolation { body: &body, cracks: &cracks, reach: 2 };
        let inside = |at: [f64; 3]| solid.number(solid.cell_around(at)).map(|p| p as u32);
        let symmetry = Symmetry::default();
        let beside = Beside { horizon: 1.0, symmetry: &symmetry, on: &on, inside: &inside };
        let find = |surface: &CrackSurface, position: [f64; 3]| {
            let around = Around { body: &body, symmetry: &symmetry, horizon: 1.0 };
            let fronts =
                around.with_recess(0, &[Crack::from(surface.clone())], |recess| surface.fronts(recess));
            FrontJump::at((surface, &fronts), position, &beside)
        };
        let front = find(&surface, [6.2, 5.0, 6.0]).unwrap();
        // Faces part by 2 (K/M) sqrt(r/2 pi) each way, beside a uniform strain; E' and the shear modulus are 8 and 4.
        let asked = [3.0, -2.0, 1.5];
        let displacement = |p: u32| {
            let at = body.position(p as usize);
            let (r, side) = ((6.0 - at[0]).max(0.0), (at[2] - 6.0).signum());
            let [first, second, third] = asked.map(|k| 0.5 * side * k * (r / TAU).sqrt());
            let (n, t) = (front.axes[0], front.axes[2]);
            let strain = 0.3 * at[0] - 0.2 * at[2];
            [0, 1, 2].map(|k| {
                first * n[k] * n[2].signum() + second * front.axes[1][k] * n[2] + third * t[k] * n[2] + strain
            })
        };
        let found = front.modes([8.0, 4.0], displacement);
        for (found, asked) in found.into_iter().zip(asked) {
            // Roots are continued linearly between points.
            assert!((found / asked - 1.0).abs() < 0.01, "{found} {asked}");
        }
        assert_eq!(find(&surface, [3.0, 5.0, 6.0]), Err(FrontFault::Far));
        assert_eq!(find(&surface, [3.0, 13.0, 6.0]), Err(FrontFault::Far));
        let narrow = CrackSurface::disc([6.0, 6.0, 6.0], [0.0, 0.0, 1.0], [0.0, 1.5]).unwrap();
        assert_eq!(find(&narrow, [7.5, 6.0, 6.0]), Err(FrontFault::Short { spacings: 4.0 }));
    }

    #[test]
    fn seams_whose_corners_do_not_match_are_no_fronts() {
        let body = PointBody::Solid(SquareLattice::cuboid(0.5, [0.0; 3], [24; 3]));
        let symmetry = Symmetry::default();
        let at = |x: f64, y: f64| [x, y, 6.0];
        // One triangle on the left of a diagonal, two on its right.
        let surface = CrackSurface::triangles([
            [at(2.0, 2.0), at(8.0, 8.0), at(2.0, 8.0)],
            [at(2.0, 2.0), at(8.0, 2.0), at(5.0, 5.0)],
            [at(8.0, 2.0), at(8.0, 8.0), at(5.0, 5.0)],
        ])
        .unwrap();
        let around = Around { body: &body, symmetry: &symmetry, horizon: 1.0 };
        let fronts = around.with_recess(0, &[Crack::from(surface.clone())], |recess| surface.fronts(recess));
        let place = fronts.near([5.2, 4.8, 6.0]).unwrap();
        assert!((distance(place.at, [5.2, 4.8, 6.0]) - 2.8).abs() < 0.01, "{place:?}");
    }
}
