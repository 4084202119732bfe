//! Beam with free ends on a Winkler foundation k, force F at mid-span: M. Hetényi's problem, with shear.
//!
//! Away from the force B w'''' - (k B / S) w'' + k w = 0, with the roots ±m₁ and ±m₂. All follows from s² =
//! (m₁ + m₂)² and d² = (m₁ - m₂)²; d² is negative where the roots are complex:
//!
//! ```text
//! r = m₁ m₂ = sqrt(k / B)      s² = k / S + 2 r      d² = k / S - 2 r
//! ```
//!
//! With a = L/2, and for x <= a with e = a + x, f = a - x, Cs(t) = cosh st, Ss(t) = sinh(st) / s, Cd and Sd
//! likewise, { s, d } the bracket as written plus the same with s and d exchanged:
//!
//! ```text
//! N = Ss(a) + Sd(a)      T = (sinh(m₁ f) / m₁ - sinh(m₂ f) / m₂) / (m₁² - m₂²)
//!
//! w = F { Cd(f/2) [Cs(e/2) + Cs(a/2) Cs(x/2) + d² Ss(a/2) Ss(x/2)]
//!         - Sd(f/2) [d² (Ss(e/2) + Ss(a/2) Cs(x/2)) + s² Cs(a/2) Ss(x/2)] } / 4 k N
//! phi = F (T + 2 { Sd(f/2) Ss(a/2) Ss(x/2) }) / B N
//! M = -F { Ss(x/2) [Cd(f/2) Ss(a/2) - Sd(f/2) Cs(a/2)] } / N
//! V = F { Cd(f/2) Ss(e/2) - Sd(f/2) [Cs(a/2) Cs(x/2) + d² Ss(a/2) Ss(x/2)] } / 2 N
//! ```
//!
//! Behind the middle w and M are even, phi and V odd about it. With c the smaller one of Re m₁ and Re m₂, the
//! bracket as written over N decays like exp(-c f), the exchanged one like exp(-c e), as if the end mirrored
//! the force; every function is evaluated without its growth, so that no beam is too long. T is also (Sd(f/2)
//! Cs(f/2) - Ss(f/2) Cd(f/2)) / r, and has a power series: between the three of them no digits are lost, in
//! a short stiff beam or at a double root (k B = 4 S²).

use super::{End, FOUNDATION_BEAM, Facts, Reference, Solution, State};

pub(super) const ENTRY: Reference = Reference {
    name: "free_free_foundation_mid_force",
    about: "beam with free ends on a Winkler foundation, force at mid-span",
    source: FOUNDATION_BEAM,
    build,
};

fn build(facts: &Facts) -> Result<Solution, String> {
    facts.ends_are(End::Free, End::Free)?;
    let (l, b, s) = facts.symbols();
    let (force, foundation) = facts.only_force_at_on_foundation(l / 2.0)?;
    let half = HalfBeam::new(l / 2.0, b, s, foundation);
    let at = move |x: f64| {
        let (y, side) = if x <= l / 2.0 { (x, force) } else { (l - x, -force) };
        let State { w, phi, moment, shear } = half.at(y);
        State { w: force * w, phi: side * phi, moment: force * moment, shear: side * shear }
    };
    Ok(Solution::local(force * at(l / 2.0).w / 2.0, at))
}

/// cosh pt and sinh(pt) / p, or the cosine and sine of an imaginary p, over exp(growth t).
#[derive(Clone, Copy)]
struct Wave {
    /// p².
    square: f64,
    /// |p|.
    size: f64,
    /// p, or zero if p is imaginary.
    growth: f64,
}

impl Wave {
    fn new(square: f64) -> Self {
        let size = square.abs().sqrt();
        Self { square, size, growth: if square > 0.0 { size } else { 0.0 } }
    }

    fn even(&self, t: f64) -> f64 {
        if self.square > 0.0 { 0.5 + 0.5 * (-2.0 * self.size * t).exp() } else { (self.size * t).cos() }
    }

    fn odd(&self, t: f64) -> f64 {
        if self.size == 0.0 {
            t
        } else if self.square > 0.0 {
            -(-2.0 * self.size * t).exp_m1() / (2.0 * self.size)
        } else {
            (self.size * t).sin() / self.size
        }
    }
}

/// The beam from a free end to the force, for F = 1.
#[derive(Clone, Copy)]
struct HalfBeam {
    /// a.
    length: f64,
    bending: f64,
    foundation: f64,
    /// s, and d.
    sum: Wave,
    difference: Wave,
    /// r = m₁ m₂.
    product: f64,
    /// c, the smaller one of Re m₁ and Re m₂.
    decay: f64,
}

impl HalfBeam {
    fn new(length: f64, bending: f64, shear: f64, foundation: f64) -> Self {
        let product = (foundation / bending).sqrt();
        let sum = Wave::new(foundation / shear + 2.0 * product);
        let difference = Wave::new(foundation / shear - 2.0 * product);
        let fast = (sum.size + difference.growth) / 2.0;
        let decay = if difference.growth > 0.0 { product / fast } else { fast };
        Self { length, bending, foundation, sum, difference, product, decay }
    }

    /// State at x from the free end.
    fn at(&self, x: f64) -> State {
        let Self { length: a, sum, difference, .. } = *self;
        let [near, far] = [a - x, a + x].map(|t| (-self.decay * t).exp());
        let (direct, mirrored) = (self.bracket(sum, difference, x), self.bracket(difference, sum, x));
        let both = |field: fn(&State) -> f64| near * field(&direct) + far * field(&mirrored);
        let spread = far * (-difference.growth * x).exp() * self.spread(a - x);
        let n = sum.odd(a) + (-2.0 * self.decay * a).exp() * difference.odd(a);
        State {
            w: both(|state| state.w) / (4.0 * self.foundation * n),
            phi: (spread + both(|state| state.phi)) / (self.bending * n),
            moment: -both(|state| state.moment) / n,
            shear: both(|state| state.shear) / (2.0 * n),
        }
    }

    /// The brackets { s, d } of the module's head as written there, with p for s and q for d.
    fn bracket(&self, p: Wave, q: Wave, x: f64) -> State {
        let [e, f, a, x] = [self.length + x, self.length - x, self.length, x].map(|t| t / 2.0);
        let (even, odd) = (q.even(f), q.odd(f));
        let (evens, odds) = (p.even(a) * p.even(x), p.odd(a) * p.odd(x));
        let slopes = q.square * (p.odd(e) + p.odd(a) * p.even(x)) + p.square * p.even(a) * p.odd(x);
        State {
            w: even * (p.even(e) + evens + q.square * odds) - odd * slopes,
            phi: 2.0 * odd * odds,
            moment: p.odd(x) * (even * p.odd(a) - odd * p.even(a)),
            shear: even * p.odd(e) - odd * (evens + q.square * odds),
        }
    }

    /// T over exp(f (s + growth of d) / 2): by its series, from roots far apart, or from s and d.
    fn spread(&self, f: f64) -> f64 {
        let Self { sum, difference, product, .. } = *self;
        if sum.size * f < 3.0 {
            let growth = (sum.size + difference.growth) / 2.0;
            return (-growth * f).exp() * self.series(f);
        }
        if difference.square > sum.square / 4.0 {
            let [fast, slow] = [(sum.size + difference.size) / 2.0, self.decay].map(|m| Wave::new(m * m));
            let slow = (-difference.size * f).exp() * slow.odd(f);
            return (fast.odd(f) - slow) / (sum.size * difference.size);
        }
        let t = f / 2.0;
        (difference.odd(t) * sum.even(t) - sum.odd(t) * difference.even(t)) / product
    }

    /// T as the sum of f^(2n + 1) h_n / (2n + 1)!, h_n = (m₁^2n - m₂^2n) / (m₁² - m₂²).
    fn series(&self, f: f64) -> f64 {
        let squares = (self.sum.square + self.difference.square) / 2.0; // m₁² + m₂²
        let (mut h, mut previous) = (1.0, 0.0);
        let (mut power, mut n, mut total) = (f * f * f / 6.0, 3.0, 0.0);
        while n < 40.0 {
            total += h * power;
            (h, previous) = (squares * h - self.product * self.product * previous, h);
            power *= f * f / ((n + 1.0) * (n + 2.0));
            n += 2.0;
        }
        total
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// x and w, phi, M, V.
    type At = (f64, [f64; 4]);

    /// k, L, S for B = F = 1, and the state at two places: the decaying exponentials of the four roots, their
    /// constants from the conditions at the end and the middle, with 120 digits (mpmath). The roots are
    /// complex, double, nearly double and real; then a short beam, complex and real, and a long one.
    #[rustfmt::skip]
    const STATES: [(f64, f64, f64, [At; 2]); 7] = [
        (40.0, 2.0, 8.0, [
            (0.25, [0.003350685626737444, 0.025467602448030865, 0.0009978963310733184, 0.0023251167679452472]),
            (0.75, [0.020830273185329398, 0.019910462124014976, -0.04148058216621545, 0.22519311800097025]),
        ]),
        (36.0, 2.0, 3.0, [
            (0.25, [0.0024069311881764676, 0.019886725650858562, 0.0008023513389775049, 0.0005226762812879273]),
            (0.75, [0.02249315921241604, 0.016047514671442976, -0.030713145740461852, 0.1833060755595378]),
        ]),
        (36.0, 2.0, 3.000_000_000_1, [
            (0.25, [0.002406931188240523, 0.019886725651160946, 0.0008023513389716758, 0.0005226762814654611]),
            (0.75, [0.02249315921245613, 0.01604751467164536, -0.030713145741032635, 0.18330607556164635]),
        ]),
        (40.0, 2.0, 0.5, [
            (0.25, [7.325690423895248e-05, 0.005257236182453733, 0.00033950342816987, -0.0017461408218961722]),
            (0.75, [0.012049461236732934, 0.0051155372031396, -0.0043176895380951956, 0.051245862442495765]),
        ]),
        (1e-8, 2.0, 5.0, [
            (0.25, [49999999.96971028, 0.0820312499530526, -0.01562499998540412, 0.12499999989318848]),
            (0.75, [50000000.02986654, 0.04817708331037354, -0.14062499991819763, 0.3749999998885498]),
        ]),
        (1e-8, 2.0, 1e-6, [
            (0.25, [49932363.57091767, 0.0819362571450043, -0.015599801137997514, 0.12480490896205775]),
            (0.75, [50057220.52357223, 0.048128616411684234, -0.14045671867525764, 0.3747268043129089]),
        ]),
        (4e4, 200.0, 150.0, [
            (99.75, [-1.7002633012002877e-06, 0.00013193549738834713, 0.0016056910948419121, -0.015071666318839104]),
            (99.96875, [0.00013982114936310328, 0.0004020656475461222, -0.007535545496756762, 0.274980077599406]),
        ]),
    ];

    #[test]
    fn every_kind_of_roots_gives_the_state() {
        for (foundation, length, shear, states) in STATES {
            let half = HalfBeam::new(length / 2.0, 1.0, shear, foundation);
            let found = states.map(|(x, _)| half.at(x)).map(|s| [s.w, s.phi, s.moment, s.shear]);
            for i in 0..4 {
                let largest = states.iter().map(|(_, state)| state[i].abs()).fold(0.0, f64::max);
                for (found, (x, expected)) in found.iter().zip(states) {
                    let error = (found[i] - expected[i]).abs() / largest;
                    // Measured at most 9.6e-16.
                    assert!(error < 3e-15, "k = {foundation}, S = {shear}, x = {x}: {error:e}");
                }
            }
        }
    }

    /// Hetényi's own beam: w = (F λ / 2 k) (cosh λL + cos λL + 2) / (sinh λL + sin λL), λ⁴ = k / 4B.
    #[test]
    fn a_beam_rigid_in_shear_is_that_of_hetenyi() {
        let (bending, foundation): (f64, f64) = (3.1, 8.9);
        let lambda = (foundation / (4.0 * bending)).powf(0.25);
        for (length, infinite) in [(0.7, false), (2.9, false), (12.0, false), (60.0, true), (1e6, true)] {
            let z: f64 = lambda * length;
            let ratio = if infinite { 1.0 } else { (z.cosh() + z.cos() + 2.0) / (z.sinh() + z.sin()) };
            let half = HalfBeam::new(length / 2.0, bending, 1e18, foundation);
            let error = half.at(length / 2.0).w / (lambda / (2.0 * foundation) * ratio) - 1.0;
            // Measured 4.5e-16.
            assert!(error.abs() < 2e-15, "L = {length}: {error:e}");
        }
    }
}
