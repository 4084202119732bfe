//! Cases to begin with, one for every kind of body that a model is for.

/// Cases to begin with, by name.
pub const STARTS: [(&str, &str); 7] = [
    ("timoshenko_beam", include_str!("timoshenko_beam.json")),
    ("plane_frame", include_str!("plane_frame.json")),
    ("bond_plane", include_str!("bond_plane.json")),
    ("beam_bond_orthotropic", include_str!("beam_bond_orthotropic.json")),
    ("shell_membrane", include_str!("shell_membrane.json")),
    ("state_plane", include_str!("state_plane.json")),
    ("axisymmetric", include_str!("axisymmetric.json")),
];
