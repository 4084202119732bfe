//! How tractions vary along their borders.

use crate::scene::body::site::boundary::{Sample, Stretch};
use crate::scene::prescribed::{Along, Prescribed};
use peristat_assembly::body::in_space;
use peristat_assembly::quadrature::GAUSS;
use std::sync::Arc;

/// Part of its value by which a formula may vary where it says the same everywhere.
const ROUNDING: f64 = 1e-14;

/// How a traction varies along its border.
#[derive(Clone, Debug)]
pub(crate) enum Profile {
    /// Straight between two values, at the start and at the end.
    Linear([[f64; 3]; 2]),
    /// This value in the middle.
    Parabolic([f64; 3]),
    /// Against the normal.
    Pressure(f64),
    /// Against the normal, `peak √(1 − (place − centre)²/radius²)` within the radius.
    Hertz { centre: f64, radius: f64, peak: f64 },
    /// By formulas of the position.
    Formula(Arc<Along>),
    /// Against the normal, by one.
    PressureFormula(Arc<Prescribed>),
}

impl Profile {
    /// Traction at a place of 0 to 1, a position, where the border has this normal, Pa; not a number where a formula has no value.
    pub(crate) fn at(&self, place: f64, at: [f64; 2], normal: [f64; 2]) -> [f64; 3] {
        let against = |pressure: f64| [-pressure * normal[0], -pressure * normal[1], 0.0];
        let value = |given: &Prescribed| given.at(in_space(at)).unwrap_or(f64::NAN);
        match *self {
            Self::Formula(ref given) => [0, 1, 2].map(|k| value(&given[k])),
            Self::PressureFormula(ref given) => against(value(given)),
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
            // Only what is along the edge is asked for; formulas do not fade.
            Self::Pressure(_) | Self::Hertz { .. } | Self::Formula(_) | Self::PressureFormula(_) => [0.0; 2],
        }
    }

    /// Positions on a stretch, m, with the traction there times the length that they stand for, N/m: sums over them are
    /// integrals to rounding.
    pub(crate) fn on(&self, stretch: &Stretch) -> Vec<([f64; 2], [f64; 3])> {
        let Self::Hertz { centre, radius, peak } = *self else {
            let value = |s: Sample| (s.at, self.at(s.place, s.at, s.normal).map(|t| s.length * t));
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
            Self::Pressure(_) => Some(self.at(0.0, [0.0; 2], normal)),
            _ => None,
        }
    }

    /// By numbers, where formulas have one value on all of some stretches; else as it is.
    pub(crate) fn plain(&self, stretches: &[Stretch]) -> Self {
        // Against this normal a pressure is along x.
        let value = |s: Sample| self.at(s.place, s.at, [-1.0, 0.0]);
        let mut values = stretches.iter().flat_map(Stretch::samples).map(value);
        let Some(first) = values.next() else { return self.clone() };
        let slack = ROUNDING * first.iter().fold(0.0_f64, |most, t| most.max(t.abs()));
        let is_one = values.all(|other| (0..3).all(|k| (other[k] - first[k]).abs() <= slack));
        match self {
            Self::Formula(_) if is_one => Self::Linear([first; 2]),
            Self::PressureFormula(_) if is_one => Self::Pressure(first[0]),
            _ => self.clone(),
        }
    }

    /// Whether formulas give it.
    pub(crate) fn is_formula(&self) -> bool {
        matches!(self, Self::Formula(_) | Self::PressureFormula(_))
    }

    /// Whether it acts across the plane.
    pub(crate) fn acts_across(&self) -> bool {
        match self {
            Self::Linear([from, to]) => from[2] != 0.0 || to[2] != 0.0,
            Self::Parabolic(middle) => middle[2] != 0.0,
            Self::Formula(given) => !given[2].is_zero(),
            Self::Pressure(_) | Self::Hertz { .. } | Self::PressureFormula(_) => false,
        }
    }
}
