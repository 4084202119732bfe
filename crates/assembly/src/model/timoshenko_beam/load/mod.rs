//! Loads of a beam.
//!
//! Bond-consistent loads give every bond its share α of the load inside its span and hand it to its two points with
//! the fixed-end forces of the exact Timoshenko element; the shares sum to the load because the weights of the bonds
//! that cross a cell sum to one.

mod nodal;
mod quadrature;
mod span;

use super::TimoshenkoBeam;
use quadrature::GAUSS;
pub(super) use span::{EndForces, Span};
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
    /// `amplitude · sin(half_waves π (x − from)/(to − from))`.
    Sine {
        /// Largest value.
        amplitude: f64,
        /// Number of half waves.
        half_waves: u32,
    },
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
    /// Force per length q, N/m, or moment per length c, N m/m.
    pub intensity: Intensity,
    /// Whether it is a moment c.
    pub is_moment: bool,
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
            Intensity::Sine { amplitude, half_waves } => amplitude * (f64::from(half_waves) * PI * z).sin(),
        }
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
            Intensity::Linear { .. } => 1,
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
        Self { from, to, ..*self }.integrate(0.0, span.length, |s| {
            let z = s / span.length;
            if self.is_moment { span.of_moment(z) } else { span.of_force(z) }
        })
    }

    /// `(∫ q, ∫ (b − x) q − ∫ c)` over `[a, b]`.
    fn resultant(&self, a: f64, b: f64) -> [f64; 2] {
        self.integrate(a, b, |x| if self.is_moment { [0.0, -1.0] } else { [1.0, b - x] })
    }

    fn is_linear_over(&self, a: f64, b: f64) -> Option<[f64; 2]> {
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
                Intensity::Sine { amplitude, .. } => *amplitude *= factor,
            }
        }
        for action in &mut loads.point {
            action.force *= factor;
            action.moment *= factor;
        }
        loads
    }

    /// Adds other loads to these.
    pub fn extend(&mut self, other: Self) {
        self.distributed.extend(other.distributed);
        self.point.extend(other.point);
    }

    /// Distributed loads that bonds carry.
    fn shared(&self) -> impl Iterator<Item = &Distributed> {
        self.distributed.iter().filter(|_| !self.lumped)
    }

    /// Whether bonds of a line carry loads.
    pub(super) fn loads_bonds(&self, chain: usize) -> bool {
        self.shared().any(|l| l.chain == chain) || self.point.iter().any(|p| p.spread && p.chain == chain)
    }

    /// End forces of all loads inside one bond, weight not included.
    pub(super) fn on(&self, chain: usize, span: &Span) -> EndForces {
        let mut sum = [0.0; 4];
        for load in self.shared().filter(|l| l.chain == chain) {
            let part = load.on(span);
            (0..4).for_each(|k| sum[k] += part[k]);
        }
        for a in self.point.iter().filter(|a| a.spread && a.chain == chain) {
            if let Some(z) = span.inside(a.x) {
                let (f, c) = (span.of_force(z), span.of_moment(z));
                (0..4).for_each(|k| sum[k] += a.force * f[k] + a.moment * c[k]);
            }
        }
        sum
    }

    /// `(∫ q, ∫ (b − x) q − ∫ c)` of all loads inside `[a, b]` that bonds carry; a concentrated one at `b` only if
    /// `with_end`.
    pub(super) fn resultant(&self, chain: usize, a: f64, b: f64, with_end: bool) -> [f64; 2] {
        let mut sum = [0.0; 2];
        for load in self.shared().filter(|l| l.chain == chain) {
            let part = load.resultant(a, b);
            (0..2).for_each(|k| sum[k] += part[k]);
        }
        let slack = 1e-9 * (b - a);
        for p in self.point.iter().filter(|p| p.spread && p.chain == chain) {
            if p.x > a + slack && p.x < if with_end { b + slack } else { b - slack } {
                sum[0] += p.force;
                sum[1] += p.force * (b - p.x) - p.moment;
            }
        }
        sum
    }
}
