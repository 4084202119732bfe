//! Loads of a beam and the nodal forces they become.
//!
//! Bond-consistent loads give every bond its share α of the load inside its span and hand it to its two points with
//! the fixed-end forces of the exact Timoshenko element; the shares sum to the load because the weights of the bonds
//! that cross a cell sum to one.

use super::{Chain, Grid, TimoshenkoBeam};
use crate::model::Model;
use std::array::from_fn;
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

/// Gauss-Legendre rule with 8 points on (0, 1), exact to degree 15: `(position, weight)`.
const GAUSS: [(f64, f64); 8] = {
    const X: [f64; 4] =
        [0.183_434_642_495_649_8, 0.525_532_409_916_329, 0.796_666_477_413_626_7, 0.960_289_856_497_536_3];
    const W: [f64; 4] =
        [0.362_683_783_378_362, 0.313_706_645_877_887_27, 0.222_381_034_453_374_48, 0.101_228_536_290_376_26];
    let mut rule = [(0.0, 0.0); 8];
    let mut k = 0;
    while k < 4 {
        rule[2 * k] = (0.5 - 0.5 * X[k], 0.5 * W[k]);
        rule[2 * k + 1] = (0.5 + 0.5 * X[k], 0.5 * W[k]);
        k += 1;
    }
    rule
};

/// Forces on `(w_i, φ_i, w_j, φ_j)`.
pub(super) type EndForces = [f64; 4];

/// A bond as its loads see it: `[x, x + length]` with `phi = 12 EI/(S ξ²)`.
#[derive(Clone, Copy)]
pub(super) struct Span {
    pub(super) x: f64,
    pub(super) length: f64,
    pub(super) phi: f64,
}

impl Span {
    /// End forces of a unit transverse force at `z = s/ξ`: the exact Timoshenko shape functions.
    fn of_force(&self, z: f64) -> EndForces {
        let (p, l) = (self.phi, self.length);
        let bend = z * (z * (2.0 * z - 3.0) - p);
        [
            (bend + 1.0 + p) / (1.0 + p),
            l * z * (z * (z - (2.0 + p / 2.0)) + 1.0 + p / 2.0) / (1.0 + p),
            -bend / (1.0 + p),
            l * z * (z * (z - (1.0 - p / 2.0)) - p / 2.0) / (1.0 + p),
        ]
    }

    /// End forces of a unit moment at `z`: rotations of the same shape functions.
    fn of_moment(&self, z: f64) -> EndForces {
        let (p, l) = (self.phi, self.length);
        let lift = 6.0 * z * (z - 1.0) / (l * (1.0 + p));
        [
            lift,
            (z * (3.0 * z - (4.0 + p)) + 1.0 + p) / (1.0 + p),
            -lift,
            z * (3.0 * z - (2.0 - p)) / (1.0 + p),
        ]
    }
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

    /// Adds the nodal forces to `force`, two planes of `beam.points()` entries.
    pub fn add_to(&self, beam: &TimoshenkoBeam, force: &mut [f64]) {
        for load in &self.distributed {
            if self.lumped {
                add_lumped(load, beam, force);
            } else {
                add_consistent(load, beam, force);
            }
        }
        for action in &self.point {
            add_point(action, beam, force);
        }
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
            if let Some(z) = strictly_inside(a.x, span) {
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

/// Position inside a span, `None` at its ends and beyond.
fn strictly_inside(x: f64, span: &Span) -> Option<f64> {
    let z = (x - span.x) / span.length;
    let slack = 1e-9;
    (z > slack && z < 1.0 - slack).then_some(z)
}

fn scatter(force: &mut [f64], n: usize, i: usize, j: usize, weight: f64, ends: &EndForces) {
    force[i] += weight * ends[0];
    force[n + i] += weight * ends[1];
    force[j] += weight * ends[2];
    force[n + j] += weight * ends[3];
}

impl TimoshenkoBeam {
    /// The bond of a class at a lower extended point of a chain.
    pub(super) fn span(&self, chain: usize, class: usize, lower: usize) -> Span {
        let length = self.bonds[chain].classes()[class].geometry.length();
        let p = &self.parameters;
        let phi = 12.0 * p.bending_stiffness / (p.shear_stiffness * length * length);
        Span { x: self.chains[chain].position(lower), length, phi }
    }
}

fn add_consistent(load: &Distributed, beam: &TimoshenkoBeam, force: &mut [f64]) {
    let (n, bonds) = (beam.points(), &beam.bonds()[load.chain]);
    let (chain, lattice) = (&beam.chains()[load.chain], bonds.lattice());
    for (class, c) in bonds.classes().iter().enumerate() {
        // A load that is straight over a bond is the sum of two unit loads, integrated once per class.
        let unit = |start: f64, end: f64| {
            let length = c.geometry.length();
            let intensity = Intensity::Linear { start, end };
            let load = Distributed { from: 0.0, to: length, intensity, ..*load };
            load.on(&Span { x: 0.0, ..beam.span(load.chain, class, 0) })
        };
        let (at_start, at_end) = (unit(1.0, 0.0), unit(0.0, 1.0));
        bonds.for_each(class, |lower, weight| {
            let (a, b) = (chain.position(lower), chain.position(lower + c.step));
            if b <= load.from || a >= load.to {
                return;
            }
            let ends = match load.is_linear_over(a, b) {
                Some([qa, qb]) => from_fn(|k| qa * at_start[k] + qb * at_end[k]),
                None => load.on(&beam.span(load.chain, class, lower)),
            };
            let i = lattice.first + lower;
            scatter(force, n, i, i + c.step, weight, &ends);
        });
    }
}

fn add_lumped(load: &Distributed, beam: &TimoshenkoBeam, force: &mut [f64]) {
    let chain = &beam.chains()[load.chain];
    let first = beam.first_real(load.chain);
    let plane = if load.is_moment { beam.points() } else { 0 };
    for k in 0..chain.points {
        let (a, b) = tributary(chain, k);
        let (a, b) = (a.max(load.from), b.min(load.to));
        if b > a {
            // The value at the point, as the literature does, where the load covers its whole share.
            let x = chain.position(chain.ghosts[0] + k);
            let at = if x >= a && x <= b { x } else { 0.5 * (a + b) };
            force[plane + first + k] += load.value(at) * (b - a);
        }
    }
}

/// The part of the line that belongs to a real point.
fn tributary(chain: &Chain, k: usize) -> (f64, f64) {
    let (x, half) = (chain.position(chain.ghosts[0] + k), 0.5 * chain.spacing);
    match chain.line().grid {
        Grid::Cells => (x - half, x + half),
        Grid::Nodes => {
            let a = if k == 0 { x } else { x - half };
            (a, if k + 1 == chain.points { x } else { x + half })
        }
    }
}

fn add_point(action: &PointAction, beam: &TimoshenkoBeam, force: &mut [f64]) {
    let n = beam.points();
    let (chain, bonds) = (&beam.chains()[action.chain], &beam.bonds()[action.chain]);
    let nearest = ((action.x - chain.origin) / chain.spacing).round().max(0.0) as usize;
    let nearest = nearest.min(chain.points - 1);
    let mut rest = 1.0;
    if action.spread {
        let middle = chain.ghosts[0] + nearest;
        for (class, c) in bonds.classes().iter().enumerate() {
            for lower in middle.saturating_sub(c.step)..=middle {
                let weight = bonds.weight(class, lower);
                let span = beam.span(action.chain, class, lower);
                let Some(z) = strictly_inside(action.x, &span).filter(|_| weight != 0.0) else {
                    continue;
                };
                let (f, m) = (span.of_force(z), span.of_moment(z));
                let ends = from_fn(|k| action.force * f[k] + action.moment * m[k]);
                let i = bonds.lattice().first + lower;
                scatter(force, n, i, i + c.step, weight, &ends);
                rest -= weight;
            }
        }
    }
    // What no bond spans belongs to the point; inside a cell that is the rounding of zero.
    let on_point = (action.x - chain.position(chain.ghosts[0] + nearest)).abs() < 1e-6 * chain.spacing;
    if on_point || !action.spread {
        let point = beam.first_real(action.chain) + nearest;
        force[point] += rest * action.force;
        force[n + point] += rest * action.moment;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gauss_rule_is_exact_for_degree_fifteen() {
        for degree in 0..16 {
            let sum: f64 = GAUSS.iter().map(|(x, w)| w * x.powi(degree)).sum();
            let exact = 1.0 / f64::from(degree + 1);
            assert!((sum - exact).abs() < 4e-16, "degree {degree}: {sum}");
        }
    }

    #[test]
    fn shape_functions_carry_force_and_moment() {
        let span = Span { x: 0.0, length: 0.7, phi: 0.4 };
        for z in [0.0, 0.3, 0.8, 1.0] {
            let f = span.of_force(z);
            assert!((f[0] + f[2] - 1.0).abs() < 1e-15);
            // Moments about the left end: φ and ∫ x w balance, φ_i + φ_j + ξ w_j = ξ z.
            assert!((f[1] + f[3] + 0.7 * f[2] - 0.7 * z).abs() < 1e-15);
            let m = span.of_moment(z);
            assert!((m[0] + m[2]).abs() < 1e-15);
            assert!((m[1] + m[3] + 0.7 * m[2] - 1.0).abs() < 1e-15);
        }
    }
}
