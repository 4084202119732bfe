//! Mirror images beyond every supported end.

use super::{EndKind, EndTreatment};

/// Exact for sine loads on simple supports; first order at clamps. Free ends are covered.
pub(super) const ENTRY: EndTreatment = EndTreatment {
    name: "image",
    about: "mirror images beyond every supported end; exact for sine loads on simple supports, first order at clamps",
    splits: false,
    end: |support| match (support.w, support.phi) {
        (None, None) => EndKind::Covered,
        _ => EndKind::Mirrored,
    },
};
