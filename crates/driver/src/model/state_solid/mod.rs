//! The model `state_solid`: solids of state-based families.

mod keys;
mod resolve;
mod words;

pub use keys::StateSolidKeys;

use super::entry::plain;
use super::solid::SolidParameters;
use super::{Entry, Growth, MaterialSummary, Model, Start};
use crate::units::Units;
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::solid::SolidEdges;
use peristat_assembly::model::state_solid::StateSolidParameters;

/// Name in case files.
const NAME: &str = "state_solid";

impl SolidParameters for StateSolidParameters {
    type Keys = StateSolidKeys;
    const NAME: &'static str = NAME;
    const HAS_FAMILIES: bool = true;

    fn model(&self, keys: StateSolidKeys, edges: SolidEdges) -> Model {
        Model::StateSolid(StateSolidKeys { edges: Some(edges), ..keys })
    }

    fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    fn bulk_modulus(&self) -> f64 {
        self.youngs_modulus / (3.0 * (1.0 - 2.0 * self.poisson_ratio))
    }

    fn shear_modulus(&self) -> f64 {
        0.5 * self.youngs_modulus / (1.0 + self.poisson_ratio)
    }

    fn influence(&self) -> Influence {
        self.influence
    }

    fn horizon_ratio(&mut self) -> &mut f64 {
        &mut self.horizon_ratio
    }

    fn edges(&mut self) -> &mut SolidEdges {
        &mut self.edges
    }

    fn calibration(&self) -> Calibration {
        self.calibration
    }

    fn summary(&self, units: Units) -> MaterialSummary {
        words::summary(self, units)
    }
}

/// What can be chosen.
const OPTIONS: [(&str, &str); 5] = [
    ("calibration matched", "bonds with the exact moduli of the material (default)"),
    ("calibration published", "bonds of the continuum: moduli are off on every lattice, and more near faces"),
    ("edges border", "bonds end on the border (default of matched)"),
    ("edges overlay", "tetrahedra replace missing bonds: exact for every uniform strain"),
    ("edges none", "points near faces are too soft (default of published)"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "an isotropic solid of state-based families, any Poisson's ratio: block",
    bodies: &[("solid block with cut-outs, or from STL or Gmsh, any Poisson's ratio", "solids")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a thick plate with a bore", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
