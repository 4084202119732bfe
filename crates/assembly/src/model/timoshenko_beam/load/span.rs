//! A bond as its loads see it: an exact Timoshenko element.

use super::Along;
use crate::model::timoshenko_beam::Chain;

/// Forces on `(w_i, φ_i, w_j, φ_j, u_i, u_j)`.
pub(in super::super) type EndForces = [f64; 6];

/// A bond as its loads see it: `[x, x + length]`, and `Φ = 12 EI/(S ξ²)`.
#[derive(Clone, Copy)]
pub(in super::super) struct Span {
    pub(in super::super) x: f64,
    pub(in super::super) length: f64,
    pub(in super::super) shear_ratio: f64,
}

impl Span {
    /// End forces of a unit transverse force at `z = s/ξ`: the exact Timoshenko shape functions.
    fn of_force(&self, z: f64) -> EndForces {
        let (p, l) = (self.shear_ratio, self.length);
        let bend = z * (z * (2.0 * z - 3.0) - p);
        [
            (bend + 1.0 + p) / (1.0 + p),
            l * z * (z * (z - (2.0 + p / 2.0)) + 1.0 + p / 2.0) / (1.0 + p),
            -bend / (1.0 + p),
            l * z * (z * (z - (1.0 - p / 2.0)) - p / 2.0) / (1.0 + p),
            0.0,
            0.0,
        ]
    }

    /// End forces of a unit moment at `z`: rotations of the same shape functions.
    fn of_moment(&self, z: f64) -> EndForces {
        let (p, l) = (self.shear_ratio, self.length);
        let lift = 6.0 * z * (z - 1.0) / (l * (1.0 + p));
        [
            lift,
            (z * (3.0 * z - (4.0 + p)) + 1.0 + p) / (1.0 + p),
            -lift,
            z * (3.0 * z - (2.0 - p)) / (1.0 + p),
            0.0,
            0.0,
        ]
    }

    /// End forces of a unit axial force at `z`.
    fn of_axial(z: f64) -> EndForces {
        [0.0, 0.0, 0.0, 0.0, 1.0 - z, z]
    }

    /// End forces of a unit load at `z`.
    pub(super) fn of(&self, along: Along, z: f64) -> EndForces {
        match along {
            Along::Transverse => self.of_force(z),
            Along::Rotation => self.of_moment(z),
            Along::Axial => Self::of_axial(z),
        }
    }

    /// Position `z` of `x` inside the span, `None` at its ends and beyond.
    pub(super) fn inside(&self, x: f64) -> Option<f64> {
        let z = (x - self.x) / self.length;
        let slack = 1e-9;
        (z > slack && z < 1.0 - slack).then_some(z)
    }
}

impl Span {
    /// The bond of a class at a lower point of a line with sections that do not vary.
    pub(super) fn new(chain: &Chain, class: usize, lower: usize, bending: f64, shear: f64) -> Self {
        let length = chain.bonds.bond(class, lower).length;
        Self { x: chain.position(lower), length, shear_ratio: 12.0 * bending / (shear * length * length) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_carry_force_and_moment() {
        let span = Span { x: 0.0, length: 0.7, shear_ratio: 0.4 };
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
