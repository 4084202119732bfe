//! The horizon of a case, whatever its model.

use super::root;
use crate::case::Case;
use crate::diagnostic::{Faults, tidy};

/// Horizon over spacing; `usual` where the case says nothing.
pub(super) fn horizon_ratio(case: &Case, spacing: f64, usual: f64, faults: &mut Faults) -> Option<f64> {
    let (ratio, key, found) = match (case.horizon_ratio, case.horizon) {
        (Some(_), Some(_)) => {
            faults
                .error(root("horizon"), "`horizon_ratio` and `horizon` are both given")
                .hint("the horizon is horizon_ratio times the spacing: remove one");
            return None;
        }
        (None, Some(horizon)) => (
            horizon / spacing,
            "horizon",
            format!("the horizon {horizon} is shorter than the spacing {}", tidy(spacing)),
        ),
        (ratio, None) => {
            let ratio = ratio.unwrap_or(usual);
            (ratio, "horizon_ratio", format!("`horizon_ratio` must be at least 1, found {ratio}"))
        }
    };
    if !ratio.is_finite() || ratio < 1.0 - 1e-9 {
        faults
            .error(root(key), format!("{found}, so no point has a bond"))
            .hint("use 3 spacings, the usual choice");
        return None;
    }
    if ratio > 2e3 {
        faults
            .error(root(key), format!("a horizon of {ratio} spacings has too many bonds per point"))
            .hint("the largest horizon ratio is 2000; more than 12 never pays");
        return None;
    }
    Some(ratio)
}
