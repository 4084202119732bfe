//! No correction: bonds beyond the end are missing.

use super::{EndKind, EndTreatment};

/// First order at clamped ends.
pub(super) const ENTRY: EndTreatment = EndTreatment {
    name: "truncated",
    about: "bonds beyond an end are missing; first order at clamped ends",
    splits: false,
    end: |_| EndKind::Truncated,
};
