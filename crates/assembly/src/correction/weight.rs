//! A force on every point that is the same per volume: one field is in balance with it, and polynomials with what is left.

use crate::recovery::hole::Field;

/// `σ_xx = −b_x x, σ_yy = −b_y y, σ_xy = 0` from some origin.
#[derive(Clone, Copy, Debug)]
pub(super) struct Weight {
    compliance: [[f64; 3]; 3],
    origin: [f64; 2],
}

impl Weight {
    /// Of a material of this stiffness, Pa. Lines of symmetry run through the origin, m.
    pub(super) fn new(stiffness: &[[f64; 3]; 3], origin: [f64; 2]) -> Option<Self> {
        let matrix = nalgebra::Matrix3::from_fn(|r, c| stiffness[r][c]);
        let inverse = matrix.try_inverse()?;
        let compliance = std::array::from_fn(|r| std::array::from_fn(|c| inverse[(r, c)]));
        Some(Self { compliance, origin })
    }

    /// The field of a force per volume, N/m³.
    pub(super) fn field(&self, force: [f64; 2], at: [f64; 2]) -> Field {
        let [x, y] = [0, 1].map(|k| at[k] - self.origin[k]);
        let ([a, b], s) = (force, &self.compliance);
        // Integrals of ε = S σ; the shear strain S_61 σ_xx + S_62 σ_yy goes to u along y and to v along x.
        let u = -0.5 * s[0][0] * a * x * x - s[0][1] * b * x * y + 0.5 * (s[0][1] * a - s[2][1] * b) * y * y;
        let v = -0.5 * s[1][1] * b * y * y - s[1][0] * a * x * y + 0.5 * (s[1][0] * b - s[2][0] * a) * x * x;
        let by_x = (s[1][0] * b - s[2][0] * a) * x - s[1][0] * a * y;
        let by_y = (s[0][1] * a - s[2][1] * b) * y - s[0][1] * b * x;
        Field { displacement: [u, v], rotation: 0.5 * (by_x - by_y), stress: [-a * x, -b * y, 0.0] }
    }
}
