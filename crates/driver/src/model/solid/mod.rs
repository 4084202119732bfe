//! What both models of solids share: their keys but for the moduli, and their bonds on bodies.

mod critical;
mod material;
mod resolve;

pub(super) use material::{SolidBonds, SolidParameters};
pub(super) use resolve::{Bonds, REFUSED, USUAL, bonds};

use super::{Place, Refusal};
use peristat_assembly::model::solid::SolidError;

impl From<SolidError> for Refusal {
    fn from(error: SolidError) -> Self {
        let place = match error {
            SolidError::NotRepresentable { .. } | SolidError::NoNeighbours { .. } => Place::Horizon,
            SolidError::TooThin | SolidError::MaterialsNeedBorder | SolidError::Coincident { .. } => {
                Place::Body
            }
            SolidError::AreaNeedsCells => Place::Key("volume_factor"),
            SolidError::EdgesNeedMatched => Place::Key("edges"),
            SolidError::PoissonRatio { .. } => Place::Key("poisson_ratio"),
        };
        Self::new(&error, place)
    }
}
