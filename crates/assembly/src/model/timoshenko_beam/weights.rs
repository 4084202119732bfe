//! Dimensionless bond weights of a chain, by the number of spacings.

use serde::{Deserialize, Serialize};

/// How much of a neighbour's volume lies inside the horizon.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum VolumeFactor {
    /// The volume of a point at the edge of the horizon counts by half, so that `Σ n α_n = 1` for a whole ratio.
    #[default]
    HalfEdge,
    /// Every volume counts in full: `(m + 1)/m` too stiff at any spacing. Kept because it is often published.
    Full,
}

/// Weights `α_n = 2 ν_n / r²` of the bonds over `n = 1, 2, …` spacings, `r = δ/h`.
///
/// With `V = A h` the whole of Eq. (12) depends on EI, S and these numbers. ν is the part of a neighbour's volume
/// inside the horizon, `r + 1/2 − n` between 0 and 1 for [`VolumeFactor::HalfEdge`].
pub fn bond_weights(horizon_ratio: f64, factor: VolumeFactor) -> Vec<f64> {
    // A ratio computed from lengths is whole up to rounding.
    let whole = horizon_ratio.round();
    let ratio = if (horizon_ratio - whole).abs() < 1e-9 * whole { whole } else { horizon_ratio };
    let part = |n: usize| match factor {
        VolumeFactor::HalfEdge => (ratio + 0.5 - n as f64).clamp(0.0, 1.0),
        VolumeFactor::Full => f64::from(n as f64 <= ratio),
    };
    // Written so that whole ratios give Σ n α_n = 1 to rounding.
    (1..).map(part).take_while(|&part| part > 0.0).map(|part| 2.0 * part / (ratio * ratio)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moment(weights: &[f64]) -> f64 {
        weights.iter().enumerate().map(|(k, a)| (k + 1) as f64 * a).sum()
    }

    #[test]
    fn half_edge_weights_have_unit_moment() {
        for m in 1..=12 {
            let weights = bond_weights(m as f64, VolumeFactor::HalfEdge);
            assert_eq!(weights.len(), m);
            assert!((moment(&weights) - 1.0).abs() < 4e-16, "m = {m}");
        }
        // δ = 3.015 h with the usual edge factor: 2·(1 + 2 + 3·0.515)/3.015².
        let weights = bond_weights(3.015, VolumeFactor::HalfEdge);
        assert!((moment(&weights) - 0.999_975).abs() < 1e-6, "{}", moment(&weights));
    }

    #[test]
    fn full_weights_are_too_stiff_by_one_over_m() {
        assert!((moment(&bond_weights(3.0, VolumeFactor::Full)) - 4.0 / 3.0).abs() < 1e-15);
    }
}
