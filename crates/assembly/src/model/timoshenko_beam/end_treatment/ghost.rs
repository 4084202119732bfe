//! Ghost points as the literature sets them.

use super::{EndKind, EndTreatment};

/// Clamped ends continue rigidly with full bond weight, others are mirrored, free ends truncated.
pub(super) const ENTRY: EndTreatment = EndTreatment {
    name: "ghost",
    about: "ghost points: fixed beyond a clamped end, mirrored beyond a simple or guided one; first order at clamps",
    splits: false,
    end: |support| match (support.w, support.phi) {
        (None, None) => EndKind::Truncated,
        (Some(_), Some(_)) => EndKind::Continued,
        _ => EndKind::Mirrored,
    },
};
