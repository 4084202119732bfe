//! Fields in isotropic materials: `2G (u_x + i u_y) = κ φ − z conj(φ') − conj(ψ)`, `σ_xx + σ_yy = 4 Re φ'`,
//! `σ_yy − σ_xx + 2i σ_xy = 2 (conj(z) φ'' + ψ')`, derivatives by z (Muskhelishvili 1953).
//!
//! With `z = ω(ζ) = r (ζ + m/ζ)` no traction acts on |ζ| = 1, where conj(ζ) = 1/ζ, if
//! `ψ = −conj(φ)(1/ζ) − ω(1/ζ) φ'(ζ)/ω'(ζ)`, so that every power `φ = c ζⁿ` has its ψ.

use super::load::{HoleLoad, Outgoing};
use super::{C, Ellipse, Field, outside};

/// Potentials of an isotropic material around an ellipse.
#[derive(Clone, Debug)]
pub(super) struct Kolosov {
    ellipse: Ellipse,
    /// 2G, Pa.
    twice_shear: f64,
    /// κ.
    kappa: f64,
    /// r, m.
    radius: f64,
    /// m.
    flatness: f64,
}

/// What powers of ζ at a position are made of.
struct Place {
    z: C,
    zeta: C,
    /// ω', ω''.
    slope: C,
    curvature: C,
    /// `ω(1/ζ)/ω'(ζ)` and its derivative by ζ.
    ratio: C,
    ratio_slope: C,
}

impl Kolosov {
    /// Of compliances 1/Pa.
    pub(super) fn new(s: &[[f64; 3]; 3], ellipse: Ellipse) -> Self {
        let nu = -s[0][1] / s[0][0];
        let [a, b] = ellipse.half_axes;
        Self {
            ellipse,
            twice_shear: 2.0 / s[2][2],
            kappa: (3.0 - nu) / (1.0 + nu),
            radius: 0.5 * (a + b),
            flatness: (a - b) / (a + b),
        }
    }

    fn place(&self, position: [f64; 2]) -> Place {
        let z = self.ellipse.place_of(position);
        let [zeta, _] = outside(z, self.ellipse.half_axes, C::i());
        let (r, m) = (self.radius, self.flatness);
        let square = zeta * zeta;
        let below = square - m;
        let above = zeta + m * square * zeta;
        Place {
            z,
            zeta,
            slope: r * (1.0 - m / square),
            curvature: 2.0 * r * m / (square * zeta),
            ratio: above / below,
            ratio_slope: ((1.0 + 3.0 * m * square) * below - 2.0 * zeta * above) / (below * below),
        }
    }

    /// Adds four fields for every power up to `order`: those of ζⁿ and ζ⁻ⁿ, times 1 and i.
    pub(super) fn add(&self, position: [f64; 2], order: usize, fields: &mut Vec<Field>) {
        let place = self.place(position);
        for n in 1..=order as i32 {
            for power in [n, -n] {
                fields.extend([C::new(1.0, 0.0), C::i()].map(|c| self.field(&place, power, c)));
            }
        }
    }

    /// The potentials whose tractions on the hole are those of a load: with its coefficients g of `e^{ikθ}` the sum
    /// `φ + ω conj(φ'/ω') + conj(ψ)` there is −i ∫ g dθ.
    pub(super) fn outgoing(&self, load: &HoleLoad) -> Outgoing {
        let [x, y] = load.mean();
        let powers = load
            .powers()
            .map(|(n, [x, y])| [(x.conj() + C::i() * y.conj()) / n, -(x + C::i() * y).conj() / n]);
        let first = -C::new(x, y) / (1.0 + self.kappa);
        // The displacement has no jump around the hole.
        Outgoing { powers: powers.collect(), logarithms: [first, -self.kappa * first.conj()] }
    }

    /// Their field at a position.
    pub(super) fn field_of(&self, position: [f64; 2], outgoing: &Outgoing) -> Field {
        let place = self.place(position);
        let zeta = place.zeta;
        let [first, second] = outgoing.logarithms;
        let mut phi = [first * zeta.ln(), first / zeta, -first / (zeta * zeta)];
        let mut psi = [second * zeta.ln(), second / zeta];
        let mut power = C::new(1.0, 0.0);
        for (k, [own, other]) in outgoing.powers.iter().enumerate() {
            let n = (k + 1) as f64;
            power /= zeta;
            let slopes = [power, -n * power / zeta, n * (n + 1.0) * power / (zeta * zeta)];
            (0..3).for_each(|d| phi[d] += own * slopes[d]);
            (0..2).for_each(|d| psi[d] += other * slopes[d]);
        }
        self.sum(&place, phi, psi)
    }

    /// The field of `φ = c ζⁿ`.
    fn field(&self, place: &Place, n: i32, c: C) -> Field {
        let (zeta, n_) = (place.zeta, f64::from(n));
        let power = |k: i32| zeta.powi(k);
        let phi = [c * power(n), c * n_ * power(n - 1), c * n_ * (n_ - 1.0) * power(n - 2)];
        self.sum(place, phi, [-c.conj() * power(-n), c.conj() * n_ * power(-n - 1)])
    }

    /// The field of φ with two derivatives by ζ and of `ψ + ω(1/ζ) φ'/ω'` with one.
    fn sum(
        &self,
        place: &Place,
        [phi, by_zeta, twice_by_zeta]: [C; 3],
        [other, other_by_zeta]: [C; 2],
    ) -> Field {
        let &Place { z, slope, curvature, ratio, ratio_slope, .. } = place;
        let psi = other - ratio * by_zeta;
        let psi_by_zeta = other_by_zeta - ratio_slope * by_zeta - ratio * twice_by_zeta;
        let first = by_zeta / slope;
        let second = (twice_by_zeta - first * curvature) / (slope * slope);
        let u = (self.kappa * phi - z * first.conj() - psi.conj()) / self.twice_shear;
        let sum = 4.0 * first.re;
        let other = 2.0 * (z.conj() * second + psi_by_zeta / slope);
        Field {
            displacement: [u.re, u.im],
            // The imaginary part of the derivative of u_x + i u_y by z.
            rotation: (self.kappa + 1.0) * first.im / self.twice_shear,
            stress: [0.5 * (sum - other.re), 0.5 * (sum + other.re), 0.5 * other.im],
        }
    }
}
