//! What loads ask for, from geometry alone: tractions by quadrature of their courses over the true edge.

use std::f64::consts::TAU;
use std::iter::Sum;

/// Force and moment about the origin, and the sum of the magnitudes of their parts.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Asked {
    pub(super) force: [f64; 2],
    pub(super) moment: f64,
    pub(super) size: f64,
}

impl Asked {
    /// Adds a force at a place.
    pub(super) fn add(&mut self, force: [f64; 2], at: [f64; 2]) {
        (0..2).for_each(|k| self.force[k] += force[k]);
        self.moment += at[0] * force[1] - at[1] * force[0];
        self.size += force[0].hypot(force[1]);
    }
}

impl Sum for Asked {
    fn sum<I: Iterator<Item = Self>>(all: I) -> Self {
        all.fold(Self::default(), |sum, part| Self {
            force: [0, 1].map(|k| sum.force[k] + part.force[k]),
            moment: sum.moment + part.moment,
            size: sum.size + part.size,
        })
    }
}

/// What a section in the plane stands for: a thickness, or a whole ring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Across {
    Thickness(f64),
    Ring,
}

impl Across {
    /// Length across the plane at x.
    pub(super) fn at(self, x: f64) -> f64 {
        match self {
            Self::Thickness(t) => t,
            Self::Ring => TAU * x,
        }
    }
}

/// A straight edge; its normal points out of the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) name: &'static str,
    pub(super) from: [f64; 2],
    pub(super) to: [f64; 2],
    pub(super) normal: [f64; 2],
    /// Places along it between which a notch takes it away.
    pub(super) gap: Option<[f64; 2]>,
}

impl Edge {
    pub(super) fn length(&self) -> f64 {
        (self.to[0] - self.from[0]).hypot(self.to[1] - self.from[1])
    }

    /// A position on it, 0 at its start and 1 at its end.
    pub(super) fn at(&self, place: f64) -> [f64; 2] {
        [0, 1].map(|k| self.from[k] + place * (self.to[k] - self.from[k]))
    }

    /// Unit vector from start to end.
    pub(super) fn tangent(&self) -> [f64; 2] {
        [0, 1].map(|k| (self.to[k] - self.from[k]) / self.length())
    }

    /// Places between which there is a body behind it.
    fn parts(&self) -> Vec<[f64; 2]> {
        match self.gap {
            Some([from, to]) => vec![[0.0, from], [to, 1.0]],
            None => vec![[0.0, 1.0]],
        }
    }

    /// Area of it.
    pub(super) fn area(&self, across: Across) -> f64 {
        self.integral(|_| [1.0, 0.0], across).size
    }

    /// Force and moment of a traction by the place along it.
    pub(super) fn integral(&self, traction: impl Fn(f64) -> [f64; 2], across: Across) -> Asked {
        let mut asked = Asked::default();
        for (q, weight) in self.parts().into_iter().flat_map(quadrature) {
            let at = self.at(q);
            let part = weight * self.length() * across.at(at[0]);
            asked.add(traction(q).map(|t| part * t), at);
        }
        asked
    }

    /// That of the pressure `peak √(1 − (s − middle)²/radius²)`, s the distance from its start. With `s = middle + radius sin θ`
    /// it is smooth in θ.
    pub(super) fn contact(&self, middle: f64, radius: f64, peak: f64, across: Across) -> Asked {
        let angle = |s: f64| ((s - middle) / radius).clamp(-1.0, 1.0).asin();
        let range = |part: [f64; 2]| part.map(|q| angle(q * self.length()));
        let mut asked = Asked::default();
        for (theta, weight) in self.parts().into_iter().map(range).flat_map(quadrature) {
            let at = self.at((middle + radius * theta.sin()) / self.length());
            let part = weight * radius * theta.cos().powi(2) * across.at(at[0]);
            asked.add(self.normal.map(|n| -part * peak * n), at);
        }
        asked
    }
}

/// Places and weights of Gauss' rule of five places on twenty parts of a range.
fn quadrature([from, to]: [f64; 2]) -> impl Iterator<Item = (f64, f64)> {
    const PARTS: usize = 20;
    let roots = [
        0.0,
        (5.0 - 2.0 * (10.0_f64 / 7.0).sqrt()).sqrt() / 3.0,
        (5.0 + 2.0 * (10.0_f64 / 7.0).sqrt()).sqrt() / 3.0,
    ];
    let weights =
        [128.0 / 225.0, (322.0 + 13.0 * 70.0_f64.sqrt()) / 900.0, (322.0 - 13.0 * 70.0_f64.sqrt()) / 900.0];
    let half = 0.5 * (to - from) / PARTS as f64;
    (0..PARTS).flat_map(move |k| {
        let middle = from + (2 * k + 1) as f64 * half;
        [(-2_i32), -1, 0, 1, 2].map(|j| {
            let i = j.unsigned_abs() as usize;
            (middle + half * f64::from(j.signum()) * roots[i], half * weights[i])
        })
    })
}
