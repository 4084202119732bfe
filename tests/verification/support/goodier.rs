//! A round inclusion in a plate, as Goodier (1933) has it.

use nalgebra::{Complex, DMatrix, DVector};

type C = Complex<f64>;

/// A body in the plane for Goodier: its shear modulus, and `(3 − ν)/(1 + ν)` in plane stress, `3 − 4 ν` in plane strain.
#[derive(Clone, Copy)]
pub(crate) struct Elastic {
    pub(crate) shear: f64,
    pub(crate) kappa: f64,
}

/// The disc of radius 1 in a plate under the remote stress σ_xx = 1: potentials of Goodier's solution, of the plate `1/4 z + a/z` and
/// `−1/2 z + b/z + d/z³`, of the disc `p z` and `r z`.
pub(crate) struct Goodier {
    sides: [Elastic; 2],
    /// a, b, d, p, r.
    of: Vec<f64>,
}

impl Goodier {
    /// That of a plate and a disc.
    pub(crate) fn new(sides: [Elastic; 2]) -> Self {
        let real = |x: f64| C::new(x, 0.0);
        let mut rows: Vec<(Vec<f64>, f64)> = Vec::new();
        for k in 0..8 {
            let z = C::from_polar(1.0, 0.1 + 0.2 * f64::from(k));
            let zero = real(0.0);
            // Potentials with the derivative of the first one.
            let all: [[C; 3]; 6] = [
                [z.inv(), -z.powi(-2), zero],
                [zero, zero, z.inv()],
                [zero, zero, z.powi(-3)],
                [z, real(1.0), zero],
                [zero, zero, z],
                [0.25 * z, real(0.25), -0.5 * z],
            ];
            let moved = |[f, df, g]: [C; 3], of: Elastic| {
                (of.kappa * f - z * df.conj() - g.conj()) / (2.0 * of.shear)
            };
            let pulled = |[f, df, g]: [C; 3]| f + z * df.conj() + g.conj();
            let side = [0, 0, 0, 1, 1, 0];
            let both = |k: usize| [moved(all[k], sides[side[k]]), pulled(all[k])];
            for q in 0..2 {
                let sign = |k: usize| if side[k] == 1 { -1.0 } else { 1.0 };
                let value = |k: usize| sign(k) * both(k)[q];
                rows.push(((0..5).map(|k| value(k).re).collect(), -value(5).re));
                rows.push(((0..5).map(|k| value(k).im).collect(), -value(5).im));
            }
        }
        let a = DMatrix::from_fn(rows.len(), 5, |i, j| rows[i].0[j]);
        let b = DVector::from_iterator(rows.len(), rows.iter().map(|r| r.1));
        let found = a.clone().svd(true, true).solve(&b, 1e-14).expect("a least square");
        assert!((a * &found - b).amax() < 1e-10 * found.amax().max(1.0));
        Self { sides, of: found.iter().copied().collect() }
    }

    /// Displacements at a place.
    pub(crate) fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [plate, disc] = self.sides;
        let (z, [a, b, d, p, r]) = (C::new(x, y), [0, 1, 2, 3, 4].map(|k| self.of[k]));
        let moved = match z.norm() > 1.0 {
            true => {
                let (f, df) = (0.25 * z + a / z, C::new(0.25, 0.0) - a / z.powi(2));
                let g = -0.5 * z + b / z + d / z.powi(3);
                (plate.kappa * f - z * df.conj() - g.conj()) / (2.0 * plate.shear)
            }
            false => (disc.kappa * p * z - p * z - (r * z).conj()) / (2.0 * disc.shear),
        };
        [moved.re, moved.im]
    }

    /// Stresses of the disc along x and y.
    pub(crate) fn inside(&self) -> [f64; 2] {
        [2.0 * self.of[3] - self.of[4], 2.0 * self.of[3] + self.of[4]]
    }
}
