//! What the bonds of a full family have together in a uniform strain.

use super::super::plane::direction_product;
use super::material::turned;
use crate::body::Cell;
use crate::bonds::Mat;
use std::array::from_fn;

/// Energy density `½ (εᵀ C ε + 2 r h·ε + H r²)` of a full family: strain `ε = [ε_xx, ε_yy, γ_xy]`, and r, by which the
/// body turns more than its points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moments {
    /// `C = Σ a N Nᵀ + b T Tᵀ`, Pa: the stiffness where points turn with the body.
    pub stiffness: Mat<3, 3>,
    /// `h = Σ b T`, Pa; its first two components are opposite.
    pub coupling: [f64; 3],
    /// `H = Σ b`, Pa: `4 (C66 − C12)` for every family.
    pub rotation: f64,
}

impl Moments {
    /// Moments of half offsets with weights `[a, b, q]`, Pa, in the axes of the lattice.
    pub fn new(offsets: &[Cell], weights: &[[f64; 3]]) -> Self {
        let mut all = Self { stiffness: [[0.0; 3]; 3], coupling: [0.0; 3], rotation: 0.0 };
        for (&step, &[a, b, _]) in offsets.iter().zip(weights) {
            let (n, t) = (direction_product(step), shear_row(step));
            for i in 0..3 {
                (0..3).for_each(|j| all.stiffness[i][j] += a * n[i] * n[j] + b * t[i] * t[j]);
                all.coupling[i] += b * t[i];
            }
            all.rotation += b;
        }
        all
    }

    /// Stiffness of a uniform strain in equilibrium, where points turn freely: `C − h hᵀ/H`.
    pub fn effective(&self) -> Mat<3, 3> {
        let (c, h) = (&self.stiffness, &self.coupling);
        let free = if self.rotation > 0.0 { 1.0 / self.rotation } else { 0.0 };
        from_fn(|i| from_fn(|j| c[i][j] - h[i] * h[j] * free))
    }

    /// [`effective`](Self::effective) in axes turned by an angle, rad.
    pub fn effective_along(&self, angle: f64) -> Mat<3, 3> {
        turned(&self.effective(), [angle.cos(), -angle.sin()])
    }
}

/// `T = (−n_x n_y, n_x n_y, (n_x² − n_y²)/2)`: the shear of a bond in a uniform strain is `T·ε + r`.
pub(super) fn shear_row([a, b, _]: Cell) -> [f64; 3] {
    let squared = f64::from(a * a + b * b);
    let product = f64::from(a * b) / squared;
    [-product, product, 0.5 * f64::from(a * a - b * b) / squared]
}
