//! Cover correction: exact for every support, without ghost points.

use super::{EndKind, EndTreatment};

/// Supports are plain constraints of the end point.
pub(super) const ENTRY: EndTreatment = EndTreatment {
    name: "cover",
    about: "bonds between neighbours make up for the missing ones; exact for every support (default)",
    splits: true,
    end: |_| EndKind::Covered,
};
