//! What bonds do in a state.

use crate::bonds::Mat;
use std::array::from_fn;

/// Which elongation a displacement gives a bond.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum Kinematics {
    /// `e = n·(u_j − u_i)` along the undeformed bond: a turn by θ looks like a stretch of −θ²/2.
    #[default]
    Linear,
    /// `e = |y_j − y_i| − ξ`: rigid motions of any size cost nothing.
    Finite,
}

/// What a bond does in a state.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Answer<const D: usize> {
    /// Unit vector along the bond as it lies now.
    pub direction: [f64; D],
    /// Elongation e, m.
    pub elongation: f64,
    /// Axial force N, N, positive in tension.
    pub force: f64,
    /// `dN/de`, N/m.
    pub tangent: f64,
    /// Secant stiffness, N/m, >= 0.
    pub secant: f64,
    /// Force over the length that the bond has now, N/m: what resists its turning; zero for linear kinematics.
    pub turning: f64,
}

impl<const D: usize> Answer<D> {
    /// Numbers in it beside the direction.
    pub const SCALARS: usize = 5;

    /// All numbers in it, the direction first.
    pub fn numbers(&self) -> impl Iterator<Item = f64> + use<D> {
        let scalars = [self.elongation, self.force, self.tangent, self.secant, self.turning];
        self.direction.into_iter().chain(scalars)
    }

    /// The answer of such [`Self::numbers`].
    ///
    /// # Panics
    /// They are not `D` and [`Self::SCALARS`].
    #[must_use]
    pub fn of_numbers(numbers: &[f64]) -> Self {
        let (direction, scalars) = numbers.split_at(D);
        let &[elongation, force, tangent, secant, turning] = scalars else { panic!("as many as there are") };
        Self { direction: from_fn(|c| direction[c]), elongation, force, tangent, secant, turning }
    }

    /// At rest.
    pub(super) const REST: Self =
        Self { direction: [0.0; D], elongation: 0.0, force: 0.0, tangent: 0.0, secant: 0.0, turning: 0.0 };

    /// The block `(1 − θ) K_t + θ K_s` of the tangent and the secant stiffness on the difference of displacements,
    /// `k n nᵀ + (N/L)(I − n nᵀ)`. The secant one is without the compression that would make it indefinite.
    pub fn block(&self, secant_part: f64) -> Mat<D, D> {
        let axial = (1.0 - secant_part) * self.tangent + secant_part * self.secant;
        let across = if secant_part > 0.0 {
            (1.0 - secant_part) * self.turning + secant_part * self.turning.max(0.0)
        } else {
            self.turning
        };
        let n = &self.direction;
        from_fn(|r| from_fn(|c| (axial - across) * (n[r] * n[c]) + if r == c { across } else { 0.0 }))
    }
}

/// What all bonds do in a state.
#[derive(Clone, Debug)]
pub struct BondAnswers<const D: usize> {
    /// Bond by bond.
    pub bonds: Vec<Answer<D>>,
    /// Incremental potential since the committed state, and what was stored there, J.
    pub energy: f64,
}
