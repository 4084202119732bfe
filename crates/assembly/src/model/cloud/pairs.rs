//! Points, and those of them that are neighbours.

use super::super::bond_plane::{Influence, VolumeFactor, radial_part};
use super::super::plane::Calibration;
use super::Place;
use crate::body::Neighbours;
use std::array::from_fn;

/// Where the points of a cloud are, and how large.
#[derive(Clone, Debug)]
pub(in super::super) struct Sites<const D: usize> {
    /// m.
    pub(in super::super) positions: Vec<[f64; D]>,
    /// Areas, m², in the plane; volumes, m³, in space.
    pub(in super::super) sizes: Vec<f64>,
    /// Volume per size: the thickness in the plane, m; one in space.
    pub(in super::super) thickness: f64,
}

/// How far points see each other, and how much of each other.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Horizon {
    /// δ, m.
    radius: f64,
    influence: Influence,
    volume_factor: VolumeFactor,
}

/// Two neighbours and the bond between them.
#[derive(Clone, Copy, Debug)]
pub(in super::super) struct Pair<const D: usize> {
    /// The lower number first.
    pub(in super::super) points: [u32; 2],
    /// Unit vector from the first to the second.
    pub(in super::super) direction: [f64; D],
    /// Distance, m.
    pub(in super::super) length: f64,
    /// Part of their volumes that counts.
    pub(in super::super) part: f64,
    /// N/m.
    pub(in super::super) stiffness: f64,
}

impl<const D: usize> Pair<D> {
    pub(in super::super) fn ends(&self) -> [usize; 2] {
        self.points.map(|p| p as usize)
    }
}

impl Horizon {
    /// That of a calibration: bonds that are not as published need no volume factors.
    pub(in super::super) fn new(
        radius: f64,
        influence: Influence,
        calibration: Calibration,
        volume_factor: VolumeFactor,
    ) -> Self {
        let volume_factor = match calibration {
            Calibration::Published => volume_factor,
            Calibration::Matched => VolumeFactor::Full,
        };
        Self { radius, influence, volume_factor }
    }

    /// Part of their volumes that counts in the bond of two points of some widths, m.
    pub(super) fn part(&self, length: f64, widths: [f64; 2]) -> f64 {
        let [a, b] = widths.map(|width| radial_part(self.volume_factor, length, self.radius, width));
        0.5 * (a + b)
    }
}

impl<const D: usize> Sites<D> {
    /// Volume of a point, m³.
    pub(in super::super) fn volume(&self, point: usize) -> f64 {
        self.sizes[point] * self.thickness
    }

    /// From the first to the second of two points, m.
    pub(super) fn between(&self, [i, j]: [usize; 2]) -> [f64; D] {
        from_fn(|k| self.positions[j][k] - self.positions[i][k])
    }

    /// Distance of two points, m.
    pub(super) fn distance(&self, points: [usize; 2]) -> f64 {
        self.between(points).into_iter().fold(0.0, f64::hypot)
    }

    /// Side of the square or the cube of a point, m.
    pub(super) fn width<const S: usize>(&self, point: usize) -> f64
    where
        [f64; D]: Place<D, S>,
    {
        <[f64; D]>::width(self.sizes[point])
    }

    /// Neighbours with `k = c ω β V_i V_j/ξ`, c the micromodulus, N/m⁶, in ascending order; or two points at one position.
    pub(in super::super) fn pairs<const S: usize>(
        &self,
        horizon: &Horizon,
        micromodulus: f64,
    ) -> Result<Vec<Pair<D>>, [usize; 2]>
    where
        [f64; D]: Place<D, S>,
    {
        let widths: Vec<f64> = (0..self.positions.len()).map(|p| self.width(p)).collect();
        let beyond = match horizon.volume_factor {
            VolumeFactor::Ramp => 0.5 * widths.iter().copied().fold(0.0, f64::max),
            _ => 0.0,
        };
        let in_space = |at: &[f64; D]| from_fn(|k| at.get(k).copied().unwrap_or(0.0));
        let in_space: Vec<[f64; 3]> = self.positions.iter().map(in_space).collect();
        let near = Neighbours::within(&in_space, (horizon.radius + beyond) * (1.0 + 1e-9));
        let mut pairs = Vec::new();
        for points in near.pairs() {
            let ends = points.map(|p| p as usize);
            let (vector, length) = (self.between(ends), self.distance(ends));
            if length == 0.0 {
                return Err(ends);
            }
            let part = horizon.part(length, ends.map(|p| widths[p]));
            let influence = horizon.influence.at((length / horizon.radius).min(1.0));
            let [first, second] = ends.map(|p| self.volume(p));
            let stiffness = micromodulus * influence * part * first * second / length;
            if stiffness > 0.0 {
                let direction = vector.map(|x| x / length);
                pairs.push(Pair { points, direction, length, part, stiffness });
            }
        }
        Ok(pairs)
    }
}
