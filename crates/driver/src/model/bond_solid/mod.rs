//! The model `bond_solid`: solids of central bonds.

mod keys;
mod resolve;
mod words;

pub use keys::BondSolidKeys;

use super::entry::plain;
use super::solid::SolidParameters;
use super::{AnyBody, Entry, Growth, MaterialSummary, Model, Refusal, Start};
use crate::units::Units;
use peristat_assembly::body::Cloud;
use peristat_assembly::model::bond_plane::Influence;
use peristat_assembly::model::bond_solid::{BondSolidCloud, BondSolidParameters, POISSON_RATIO};
use peristat_assembly::model::plane::Calibration;
use peristat_assembly::model::solid::SolidEdges;

/// Name in case files.
const NAME: &str = "bond_solid";

impl SolidParameters for BondSolidParameters {
    type Keys = BondSolidKeys;
    const NAME: &'static str = NAME;
    const HAS_FAMILIES: bool = false;

    fn model(&self, keys: BondSolidKeys, edges: SolidEdges) -> Model {
        Model::BondSolid(BondSolidKeys { edges: Some(edges), ..keys })
    }

    fn youngs_modulus(&self) -> f64 {
        self.youngs_modulus
    }

    fn bulk_modulus(&self) -> f64 {
        self.youngs_modulus / (3.0 * (1.0 - 2.0 * POISSON_RATIO))
    }

    fn shear_modulus(&self) -> f64 {
        0.5 * self.youngs_modulus / (1.0 + POISSON_RATIO)
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

    fn on_points(
        &self,
        cloud: &Cloud,
        horizon: f64,
        cut: &dyn Fn([f64; 3], [f64; 3]) -> bool,
    ) -> Result<AnyBody, Refusal> {
        let (positions, volumes) = (cloud.positions().to_vec(), cloud.sizes().to_vec());
        let body = BondSolidCloud::new(positions, volumes, horizon, *self, cut)?;
        Ok(AnyBody::Three(Box::new(body)))
    }

    fn summary(&self, units: Units) -> MaterialSummary {
        words::summary(self, units)
    }
}

/// What can be chosen.
const OPTIONS: [(&str, &str); 6] = [
    ("calibration matched", "bonds with the exact moduli of the material (default)"),
    (
        "weights isotropic",
        "exact bonds without a direction in the sixth moment: errors inside are of the fourth order where no body force acts",
    ),
    ("calibration published", "bonds of the continuum: moduli are off on every lattice, and more near faces"),
    ("edges border", "bonds end on the border (default of matched)"),
    ("edges overlay", "tetrahedra replace missing bonds: exact for every uniform strain"),
    ("edges none", "points near faces are too soft (default of published)"),
];

/// What the command says of it.
pub(super) const ENTRY: Entry = Entry {
    name: NAME,
    about: "an isotropic solid of central bonds, Poisson's ratio 1/4: block, points",
    bodies: &[("solid block with cut-outs, STL, Gmsh, or listed points, ν = 1/4", "solids")],
    options: || plain(&OPTIONS),
    starts: &[Start { name: NAME, about: "a clamped cantilever", case: include_str!("start.json") }],
    growth: Growth::Plane,
};
