//! Tractions on a hole, and the one field that has them there and no others: it fades away from the hole, or grows with the logarithm
//! of the distance where they have a resultant.

use super::{C, Ellipse};
use std::f64::consts::TAU;

/// Places on a hole at which its tractions are taken.
const PLACES: usize = 128;
/// Highest power of the field.
const HIGHEST: usize = 32;

/// Tractions on a hole times the length of a step of the parametric angle θ, as Fourier coefficients of `e^{ikθ}`, N: along both
/// axes of the hole, k from zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct HoleLoad {
    coefficients: Vec<[C; 2]>,
}

/// Powers ζ⁻ⁿ of two potentials, n from one, and the logarithms of ζ in them.
#[derive(Clone, Debug, Default)]
pub(super) struct Outgoing {
    pub(super) powers: Vec<[C; 2]>,
    pub(super) logarithms: [C; 2],
}

impl HoleLoad {
    /// Of the traction at a position with its normal, which points into the hole, Pa.
    pub fn new(ellipse: &Ellipse, traction: impl Fn([f64; 2], [f64; 2]) -> [f64; 2]) -> Self {
        let [a, b] = ellipse.half_axes;
        let angle = |k: usize| TAU * k as f64 / PLACES as f64;
        let at = |(k, at): (usize, &[f64; 2])| {
            let (sine, cosine) = angle(k).sin_cos();
            let length = (a * sine).hypot(b * cosine) / PLACES as f64;
            ellipse.seen(traction(*at, ellipse.normal(*at).map(|n| -n))).map(|t| t * length)
        };
        let pulls: Vec<[f64; 2]> = ellipse.places(PLACES).iter().enumerate().map(at).collect();
        if pulls.iter().flatten().all(|pull| *pull == 0.0) {
            return Self::default();
        }
        let coefficient = |k: usize, c: usize| {
            let part = |(j, pull): (usize, &[f64; 2])| pull[c] * C::new(0.0, -angle(k * j % PLACES)).exp();
            pulls.iter().enumerate().map(part).sum::<C>()
        };
        Self { coefficients: (0..=HIGHEST).map(|k| [0, 1].map(|c| coefficient(k, c))).collect() }
    }

    /// Whether nothing acts.
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// Adds a multiple of another one.
    pub fn add_multiple(&mut self, factor: f64, other: &Self) {
        if self.is_zero() {
            self.coefficients = vec![[C::ZERO; 2]; other.coefficients.len()];
        }
        for (own, more) in self.coefficients.iter_mut().zip(&other.coefficients) {
            (0..2).for_each(|c| own[c] += factor * more[c]);
        }
    }

    /// The resultant over 2π, N.
    pub(super) fn mean(&self) -> [f64; 2] {
        self.coefficients.first().map_or([0.0; 2], |first| first.map(|c| c.re))
    }

    /// The coefficients of `e^{inθ}` with their n, from one.
    pub(super) fn powers(&self) -> impl Iterator<Item = (f64, [C; 2])> + '_ {
        self.coefficients.iter().enumerate().skip(1).map(|(n, own)| (n as f64, *own))
    }
}
