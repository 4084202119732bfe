//! Loads of a beam.
//!
//! Bond-consistent loads give every bond its share α of the load inside its span and hand it to its two points with
//! the fixed-end forces of the exact Timoshenko element; the shares sum to the load because the weights of the bonds
//! that cross a cell sum to one.

mod carried;
mod fixed_end;
mod inside;
mod nodal;
mod span;
mod stored;

pub(super) use fixed_end::FixedEnd;
pub use inside::{Element, Inside};
pub use nodal::ChainLoads;

use super::{PHI, U, W};
use crate::quadrature::GAUSS;
use carried::Carried;
use span::{EndForces, Span};
use std::f64::consts::PI;

/// Value of a distributed load along the line it acts on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Intensity {
    /// Straight from the value at the start of the load to the value at its end.
    Linear {
        /// Value at the start.
        start: f64,
        /// Value at the end.
        end: f64,
    },
    /// The parabola through the values at the start, the middle and the end of the load.
    Parabola {
        /// Value at the start.
        start: f64,
        /// Value in the middle.
        middle: f64,
        /// Value at the end.
        end: f64,
    },
    /// `amplitude · sin(half_waves π (x − from)/(to − from))`.
    Sine {
        /// Largest value.
        amplitude: f64,
        /// Number of half waves.
        half_waves: u32,
    },
}

/// The displacement that a load works on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Along {
    /// Deflection w: a force.
    Transverse,
    /// Rotation φ: a moment.
    Rotation,
    /// Axial displacement u: a force.
    Axial,
}

impl Along {
    /// Component of the unknowns.
    pub fn component(self) -> usize {
        match self {
            Self::Transverse => W,
            Self::Rotation => PHI,
            Self::Axial => U,
        }
    }
}

/// A load spread over `from ..= to`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distributed {
    /// Line that it acts on.
    pub chain: usize,
    /// Start, m.
    pub from: f64,
    /// End, m.
    pub to: f64,
    /// Force per length q or p, N/m, or moment per length c, N m/m.
    pub intensity: Intensity,
    /// What it works on.
    pub along: Along,
}

/// A concentrated force and moment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PointAction {
    /// Line that it acts on.
    pub chain: usize,
    /// Position, m.
    pub x: f64,
    /// Force along w, N.
    pub force: f64,
    /// Moment along φ, N m.
    pub moment: f64,
    /// Force along u, N.
    pub axial: f64,
    /// Shared by the bonds that span it; otherwise it acts on the point at `x`, where a chain is split or ends.
    pub spread: bool,
}

/// All loads of one load case.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BeamLoads {
    /// Distributed loads.
    pub distributed: Vec<Distributed>,
    /// Concentrated loads.
    pub point: Vec<PointAction>,
    /// Nodal value times tributary length instead of bond-consistent forces.
    pub lumped: bool,
}

impl Distributed {
    fn value(&self, x: f64) -> f64 {
        let z = (x - self.from) / (self.to - self.from);
        match self.intensity {
            Intensity::Linear { start, end } if start == end => start,
            Intensity::Linear { start, end } => start + (end - start) * z,
            Intensity::Parabola { start, middle, end } => {
                start * (1.0 - z) * (1.0 - 2.0 * z) + middle * 4.0 * z * (1.0 - z) + end * z * (2.0 * z - 1.0)
            }
            Intensity::Sine { amplitude, half_waves } => amplitude * (f64::from(half_waves) * PI * z).sin(),
        }
    }

    /// Where a sine of several half-waves changes its sign, m.
    fn zeros_of_waves(&self) -> impl Iterator<Item = f64> + use<> {
        let half_waves = match self.intensity {
            Intensity::Sine { half_waves, .. } => half_waves,
            _ => 1,
        };
        let (from, length) = (self.from, self.to - self.from);
        (1..half_waves).map(move |k| from + length * f64::from(k) / f64::from(half_waves))
    }

    /// The value, where it is the same everywhere.
    fn constant(&self) -> Option<f64> {
        match self.intensity {
            Intensity::Linear { start, end } if start == end => Some(start),
            _ => None,
        }
    }

    /// Integrates `weight(x)` times the load over its part of `[a, b]`.
    fn integrate<const N: usize>(&self, a: f64, b: f64, weight: impl Fn(f64) -> [f64; N]) -> [f64; N] {
        let (a, b) = (a.max(self.from), b.min(self.to));
        let mut sum = [0.0; N];
        if b <= a {
            return sum;
        }
        // A sixteenth of a wave per rule leaves an error below rounding.
        let pieces = match self.intensity {
            Intensity::Linear { .. } | Intensity::Parabola { .. } => 1,
            Intensity::Sine { half_waves, .. } => {
                (8.0 * f64::from(half_waves) * (b - a) / (self.to - self.from)).ceil() as usize
            }
        };
        let width = (b - a) / pieces as f64;
        for piece in 0..pieces {
            for (z, g) in GAUSS {
                let x = a + (piece as f64 + z) * width;
                let share = g * width * self.value(x);
                let weight = weight(x);
                (0..N).for_each(|k| sum[k] += share * weight[k]);
            }
        }
        sum
    }

    /// End forces of the part of the load inside a bond.
    fn on(&self, span: &Span) -> EndForces {
        // Counted from the bond: far from the origin, positions have lost digits of its length.
        let (from, to) = (self.from - span.x, self.to - span.x);
        Self { from, to, ..*self }.integrate(0.0, span.length, |s| span.of(self.along, s / span.length))
    }

    /// `(∫ q, ∫ (b − x) q − ∫ c, ∫ p)` over `[a, b]`.
    fn resultant(&self, a: f64, b: f64) -> [f64; 3] {
        let [sum, lever] = match self.intensity {
            Intensity::Linear { .. } => self.linear_resultant(a, b),
            Intensity::Parabola { .. } | Intensity::Sine { .. } => self.integrate(a, b, |x| [1.0, b - x]),
        };
        match self.along {
            Along::Transverse => [sum, lever, 0.0],
            Along::Rotation => [0.0, -sum, 0.0],
            Along::Axial => [0.0, 0.0, sum],
        }
    }

    /// `(∫ q, ∫ (b − x) q)` over `[a, b]` of a load that is straight where it acts.
    fn linear_resultant(&self, a: f64, b: f64) -> [f64; 2] {
        let (start, end) = (a.max(self.from), b.min(self.to));
        if end <= start {
            return [0.0; 2];
        }
        let (width, [q_start, q_end]) = (end - start, [start, end].map(|x| self.value(x)));
        let sum = 0.5 * width * (q_start + q_end);
        [sum, width * width * (2.0 * q_start + q_end) / 6.0 + (b - end) * sum]
    }

    fn is_linear_over(&self, [a, b]: [f64; 2]) -> Option<[f64; 2]> {
        // Ends of loads and points agree up to rounding.
        let slack = 1e-9 * (b - a);
        let inside = a >= self.from - slack && b <= self.to + slack;
        match self.intensity {
            Intensity::Linear { .. } if inside => Some([self.value(a), self.value(b)]),
            _ => None,
        }
    }
}

impl BeamLoads {
    /// The loads times a factor.
    pub fn scaled(&self, factor: f64) -> Self {
        let mut loads = self.clone();
        for load in &mut loads.distributed {
            match &mut load.intensity {
                Intensity::Linear { start, end } => (*start, *end) = (factor * *start, factor * *end),
                Intensity::Parabola { start, middle, end } => {
                    [start, middle, end].into_iter().for_each(|value| *value *= factor);
                }
                Intensity::Sine { amplitude, .. } => *amplitude *= factor,
            }
        }
        for action in &mut loads.point {
            action.force *= factor;
            action.moment *= factor;
            action.axial *= factor;
        }
        loads
    }

    /// Adds other loads to these.
    pub fn extend(&mut self, other: Self) {
        self.distributed.extend(other.distributed);
        self.point.extend(other.point);
    }
}

impl PointAction {
    /// Its components that are not zero.
    fn parts(&self) -> impl Iterator<Item = (Along, f64)> {
        let all =
            [(Along::Transverse, self.force), (Along::Rotation, self.moment), (Along::Axial, self.axial)];
        all.into_iter().filter(|(_, value)| *value != 0.0)
    }
}
