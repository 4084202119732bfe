//! Words of messages on fields.

use crate::case::FieldName;

/// The fields that there are where another one was asked for, for a hint.
pub(super) fn there_are(fields: &[FieldName]) -> String {
    let names: Vec<&str> = fields.iter().map(|f| f.name()).collect();
    format!("there are {}", names.join(", "))
}
