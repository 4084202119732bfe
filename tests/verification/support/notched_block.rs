//! A block of solid with a notch, held so that nothing strains it.

use serde_json::{Value, json};

/// Gives a case the block and what holds it.
pub(crate) fn hold_freely(case: &mut Value) {
    let cut = json!({ "block": { "name": "notch", "from": [3, 3, 2], "size": [2, 2, 2] } });
    case["body"] = json!({ "block": { "size": [8, 5, 4], "spacing": 1, "cuts": [cut] } });
    case["supports"] = json!([
        { "at": { "x": 0.5, "y": 0.5, "z": 0.5 }, "ux": 0, "uy": 0, "uz": 0 },
        { "at": { "x": 7.5, "y": 0.5, "z": 0.5 }, "uy": 0, "uz": 0 },
        { "at": { "x": 0.5, "y": 4.5, "z": 0.5 }, "uz": 0 }
    ]);
}
