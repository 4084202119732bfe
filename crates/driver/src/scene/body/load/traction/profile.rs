//! How tractions vary along their borders.

use crate::scene::body::site::boundary::{Sample, Stretch};
use peristat_assembly::quadrature::GAUSS;

/// How a traction varies along its border.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Profile {
    /// Straight between two values, at the start and at the end.
    Linear([[f64; 3]; 2]),
    /// This value in the middle.
    Parabolic([f64; 3]),
    /// Against the normal.
    Pressure(f64),
    /// Against the normal, `peak √(1 − (place − centre)²/radius²)` within the radius.
    Hertz { centre: f64, radius: f64, peak: f64 },
}

impl Profile {
    /// Traction at a place of 0 to 1 where the border has this normal, Pa.
    pub(crate) fn at(&self, place: f64, normal: [f64; 2]) -> [f64; 3] {
        let against = |pressure: f64| [-pressure * normal[0], -pressure * normal[1], 0.0];
        match *self {
            Self::Linear([from, to]) => [0, 1, 2].map(|k| from[k] + place * (to[k] - from[k])),
            Self::Parabolic(middle) => middle.map(|t| 4.0 * place * (1.0 - place) * t),
            Self::Pressure(pressure) => against(pressure),
            Self::Hertz { centre, radius, peak } => {
                let ratio = (place - centre) / radius;
                against(peak * (1.0 - ratio * ratio).max(0.0).sqrt())
            }
        }
    }

    /// Its derivative in the plane by the place.
    pub(crate) fn slope(&self, place: f64) -> [f64; 2] {
        match *self {
            Self::Linear([from, to]) => [to[0] - from[0], to[1] - from[1]],
            Self::Parabolic([x, y, _]) => [x, y].map(|t| 4.0 * (1.0 - 2.0 * place) * t),
            // Only what is along the edge is asked for.
            Self::Pressure(_) | Self::Hertz { .. } => [0.0; 2],
        }
    }

    /// Positions on a stretch, m, with the traction there times the length that they stand for, N/m: sums over them are
    /// integrals to rounding.
    pub(crate) fn on(&self, stretch: &Stretch) -> Vec<([f64; 2], [f64; 3])> {
        let Self::Hertz { centre, radius, peak } = *self else {
            let value = |s: Sample| (s.at, self.at(s.place, s.normal).map(|t| s.length * t));
            return stretch.samples().map(value).collect();
        };
        // Over the angle whose sine is the place in the contact, the root is smooth.
        let angle =
            |end: f64| ((stretch.place + end * stretch.half - centre) / radius).clamp(-1.0, 1.0).asin();
        let [start, end] = [-1.0, 1.0].map(angle);
        let value = |&(share, weight): &(f64, f64)| {
            let (sin, cos) = (start + share * (end - start)).sin_cos();
            let inside = (centre + radius * sin - stretch.place) / (2.0 * stretch.half) + 0.5;
            let length = weight * (end - start) * radius * cos / (2.0 * stretch.half) * stretch.length;
            let sample = stretch.sample(inside, length);
            let [x, y] = sample.normal.map(|n| -length * peak * cos * n);
            (sample.at, [x, y, 0.0])
        };
        GAUSS.iter().map(value).collect()
    }

    /// The value that it has everywhere on a border of this normal, if it is one.
    pub(crate) fn constant(&self, normal: [f64; 2]) -> Option<[f64; 3]> {
        match *self {
            Self::Linear([from, to]) if from == to => Some(from),
            Self::Pressure(_) => Some(self.at(0.0, normal)),
            _ => None,
        }
    }

    /// Whether it acts across the plane.
    pub(crate) fn acts_across(&self) -> bool {
        match self {
            Self::Linear([from, to]) => from[2] != 0.0 || to[2] != 0.0,
            Self::Parabolic(middle) => middle[2] != 0.0,
            Self::Pressure(_) | Self::Hertz { .. } => false,
        }
    }
}
