//! Where the model stands in a case.

use crate::diagnostic::{JsonPath, root};

/// Path of the beam in a case.
pub(super) fn beam_path() -> JsonPath {
    root("model").key("timoshenko_beam")
}
