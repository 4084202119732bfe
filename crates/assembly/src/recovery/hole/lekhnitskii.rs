//! Fields in anisotropic materials: `u = 2 Re Σ_k (p_k, q_k) Φ_k(z_k)`, `σ = 2 Re Σ_k (μ_k², 1, −μ_k) Φ_k'(z_k)` with
//! `z_k = x + μ_k y` (Lekhnitskii 1968, section 8).
//!
//! On the hole ζ₁ = ζ₂, there of modulus one. No traction acts there if Φ₁ + Φ₂ and μ₁ Φ₁ + μ₂ Φ₂ have no real part there:
//! then the parts of ζ⁻ⁿ follow from those of ζⁿ.

use super::load::{HoleLoad, Outgoing};
use super::{C, Ellipse, Field, outside};
use nalgebra::{Matrix4, Vector4};

/// Roots closer than this are moved apart, for the two potentials would be one.
const EQUAL: f64 = 1e-3;
/// By how much then the compliance in shear changes: the roots move by its square root.
const CHANGE: f64 = 1e-5;
/// Steps in which roots are found: those of a double root come nearer by a half in each.
const STEPS: usize = 100;

/// Potentials of an anisotropic material around an ellipse.
#[derive(Clone, Debug)]
pub(super) struct Lekhnitskii {
    ellipse: Ellipse,
    /// μ₁, μ₂.
    roots: [C; 2],
    /// p and q of both.
    shares: [[C; 2]; 2],
}

impl Lekhnitskii {
    /// Of compliances 1/Pa; none if there are no two roots.
    pub(super) fn new(s: &[[f64; 3]; 3], ellipse: Ellipse) -> Option<Self> {
        let mut s = *s;
        let mut roots = roots(&s)?;
        if (roots[0] - roots[1]).norm() < EQUAL * roots[0].norm() {
            s[2][2] *= 1.0 + CHANGE;
            roots = self::roots(&s)?;
        }
        let shares = roots
            .map(|mu| [s[0][0] * mu * mu + s[0][1] - s[0][2] * mu, s[0][1] * mu + s[1][1] / mu - s[1][2]]);
        Some(Self { ellipse, roots, shares })
    }

    /// Adds four fields for every power up to `order`: those of ζ₁ⁿ and ζ₂ⁿ, times 1 and i, with what they need of ζ⁻ⁿ.
    pub(super) fn add(&self, position: [f64; 2], order: usize, fields: &mut Vec<Field>) {
        let mapped = self.mapped(position);
        let [first, second] = self.roots.map(|mu| mu.conj());
        for n in 1..=order as i32 {
            for unit in [C::new(1.0, 0.0), C::i()] {
                for own in [0, 1] {
                    let outer = if own == 0 { [unit, C::ZERO] } else { [C::ZERO, unit] };
                    let moment = self.roots[own] * unit;
                    let other = (first * unit - moment) / (second - first);
                    let inner = [(-unit - other).conj(), other.conj()];
                    fields.push(self.field(&mapped, n, outer, inner));
                }
            }
        }
    }

    /// The potentials whose tractions on the hole are those of a load, with its coefficients of `e^{inθ}`: along the hole
    /// `2 Re Σ Φ_k` is the integral of what acts along y, `2 Re Σ μ_k Φ_k` that of what acts against x.
    pub(super) fn outgoing(&self, load: &HoleLoad) -> Outgoing {
        let [x, y] = load.mean();
        let [first, second] = self.roots;
        let powers = load.powers().map(|(n, [x, y])| {
            let (sum, moment) = (C::i() * y.conj() / n, -C::i() * x.conj() / n);
            let other = (moment - first * sum) / (second - first);
            [sum - other, other]
        });
        // The displacement has no jump around the hole: Im Σ p_k A_k = Im Σ q_k A_k = 0.
        let [p, q] = [0, 1].map(|c| self.shares.map(|own| own[c]));
        let rows = [[C::new(1.0, 0.0); 2], self.roots, p, q];
        let sizes = rows.map(|row| row[0].norm());
        let matrix = Matrix4::from_fn(|r, c| {
            let share = rows[r][c / 2] / sizes[r];
            if c % 2 == 0 { share.im } else { share.re }
        });
        let known = Vector4::new(-0.5 * y, 0.5 * x / sizes[1], 0.0, 0.0);
        let found = matrix.lu().solve(&known).unwrap_or_default();
        let logarithms = [C::new(found[0], found[1]), C::new(found[2], found[3])];
        Outgoing { powers: powers.collect(), logarithms }
    }

    /// Their field at a position.
    pub(super) fn field_of(&self, position: [f64; 2], outgoing: &Outgoing) -> Field {
        let mapped = self.mapped(position);
        // Both logarithms turn together: one angle, and how far each is from it.
        let [around, _] = outside(self.ellipse.place_of(position), self.ellipse.half_axes, C::i());
        let mut field = Field::default();
        for k in 0..2 {
            let [zeta, slope] = mapped[k];
            let own = outgoing.logarithms[k];
            let (mut potential, mut by_zeta) = (own * (around.ln() + (zeta / around).ln()), own / zeta);
            let mut power = C::new(1.0, 0.0);
            for (j, shares) in outgoing.powers.iter().enumerate() {
                power /= zeta;
                potential += shares[k] * power;
                by_zeta -= (j + 1) as f64 * shares[k] * power / zeta;
            }
            self.add_potential(k, potential, by_zeta * slope, &mut field);
        }
        field
    }

    /// ζ_k of a position and their derivatives by z_k.
    fn mapped(&self, position: [f64; 2]) -> [[C; 2]; 2] {
        let at = self.ellipse.place_of(position);
        self.roots.map(|mu| outside(at.re + mu * at.im, self.ellipse.half_axes, mu))
    }

    /// The field of `Φ_k = outer_k ζ_kⁿ + inner_k ζ_k⁻ⁿ`; `mapped` are ζ_k and its derivative by z_k.
    fn field(&self, mapped: &[[C; 2]; 2], n: i32, outer: [C; 2], inner: [C; 2]) -> Field {
        let mut field = Field::default();
        let n_ = f64::from(n);
        for k in 0..2 {
            let [zeta, slope] = mapped[k];
            let (out, back) = (outer[k] * zeta.powi(n), inner[k] * zeta.powi(-n));
            self.add_potential(k, out + back, n_ * (out - back) / zeta * slope, &mut field);
        }
        field
    }

    /// Adds the field of a potential Φ_k with its derivative by z_k.
    fn add_potential(&self, k: usize, potential: C, by_z: C, field: &mut Field) {
        let mu = self.roots[k];
        (0..2).for_each(|c| field.displacement[c] += 2.0 * (self.shares[k][c] * potential).re);
        let [p, q] = self.shares[k];
        field.rotation += ((q - mu * p) * by_z).re;
        field.stress[0] += 2.0 * (mu * mu * by_z).re;
        field.stress[1] += 2.0 * by_z.re;
        field.stress[2] -= 2.0 * (mu * by_z).re;
    }
}

/// Roots above the real axis of `S₁₁ μ⁴ − 2 S₁₆ μ³ + (2 S₁₂ + S₆₆) μ² − 2 S₂₆ μ + S₂₂`, all four at once (Durand 1960, Kerner
/// 1966).
fn roots(s: &[[f64; 3]; 3]) -> Option<[C; 2]> {
    // Of modulus one, about, in these units.
    let unit = (s[1][1] / s[0][0]).powf(0.25);
    let monic = [-2.0 * s[0][2], 2.0 * s[0][1] + s[2][2], -2.0 * s[1][2], s[1][1]];
    let mut power = s[0][0];
    let polynomial = monic.map(|c| {
        power *= unit;
        c / power
    });
    let mut all = [1, 2, 3, 4].map(|k| C::new(0.4, 0.9).powi(k));
    for _ in 0..STEPS {
        for k in 0..4 {
            let value = polynomial.iter().fold(C::new(1.0, 0.0), |value, c| value * all[k] + *c);
            let apart: C = (0..4).filter(|j| *j != k).map(|j| all[k] - all[j]).product();
            all[k] -= value / apart;
        }
    }
    let above: Vec<C> = all.into_iter().filter(|mu| mu.im > 0.0).map(|mu| unit * mu).collect();
    <[C; 2]>::try_from(above).ok()
}
