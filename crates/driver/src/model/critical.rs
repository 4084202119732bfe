//! At which strains bonds break, as cases write it for all models.

use crate::diagnostic::{Faults, JsonPath, positive};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Critical strains of bonds. By their stretch: `stretch`, or `fibre_stretch` and `matrix_stretch`. By the energy it takes to
/// open a crack: `energy_release_rate`, or `fibre_energy_release_rate` and `matrix_energy_release_rate`. By their bending:
/// `curvature` and `shear_strain`. One of these is given; which ones apply depends on the model.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Critical {
    /// Elongation over length at which every bond of a body in the plane or of a solid breaks, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stretch: Option<f64>,
    /// Elongation over length at which a bond along the fibres breaks, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_stretch: Option<f64>,
    /// Elongation over length at which every other bond breaks, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matrix_stretch: Option<f64>,
    /// Energy per area of a crack, > 0; of a beam per area of its section.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy_release_rate: Option<f64>,
    /// Energy per area of a crack across the fibres, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub fibre_energy_release_rate: Option<f64>,
    /// Energy per area of a crack along the fibres, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matrix_energy_release_rate: Option<f64>,
    /// How a stretch follows from an energy release rate; `growth` if not given, of beam bonds and of solids `energy`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub formula: Option<CriticalFormula>,
    /// Change of rotation over length at which a bond of a beam or of a plate in bending breaks, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub curvature: Option<f64>,
    /// Shear strain at which a bond of a beam or of a plate in bending breaks, > 0.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub shear_strain: Option<f64>,
}

/// How critical strains follow from an energy release rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum CriticalFormula {
    /// A long crack grows at the energy release rate, in any direction to a few percent with three spacings per
    /// horizon or more: the stretch of `energy` less what
    /// the lattice adds by holding each bond back until it breaks (lattice trapping, measured). Of central bonds in the plane; of plates
    /// in bending for a crack along the rows that opens by bending.
    Growth,
    /// The bonds that a crack on this lattice cuts take up the energy release rate. A long crack then needs more motion:
    /// 20 % with a horizon ratio of 3, 11 % with 4.
    Energy,
    /// The published formula of a full circle of bonds.
    Published,
}

/// A critical strain that must be there.
pub(crate) fn needed(value: Option<f64>, key: &str, path: &JsonPath, faults: &mut Faults) -> Option<f64> {
    match value {
        Some(value) => positive(value, key, path.key(key), faults).then_some(value),
        None => {
            faults.error(path.clone(), format!("`{key}` is missing"));
            None
        }
    }
}

/// Faults of keys that are for other models.
pub(crate) fn foreign(keys: &[(&str, Option<f64>)], hint: &str, path: &JsonPath, faults: &mut Faults) {
    for (key, _) in keys.iter().filter(|k| k.1.is_some()) {
        faults.error(path.key(*key), format!("`{key}` is for another model")).hint(hint);
    }
}
