//! What the keys become.

use super::super::bond_choice::BondChoice;
use super::super::solid::{Bonds, REFUSED, SolidBonds, USUAL, bonds};
use super::super::{Asked, Keys, Material, Model, Refused};
use super::{NAME, StateSolidKeys};
use crate::diagnostic::{Faults, positive, root};
use peristat_assembly::model::state_solid::StateSolidParameters;

impl Keys for StateSolidKeys {
    fn model(&self) -> Model {
        Model::StateSolid(self.clone())
    }

    fn thickness(&self) -> f64 {
        1.0
    }

    fn is_solid(&self) -> bool {
        true
    }

    fn takes_points(&self) -> bool {
        false
    }

    fn refuses(&self) -> Vec<Refused> {
        REFUSED.to_vec()
    }

    fn with_usual_bonds(&self) -> Model {
        Model::StateSolid(Self { calibration: None, volume_factor: None, edges: None, ..self.clone() })
    }

    fn resolve(&self, _: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let path = root("model").key(NAME);
        let mut fine = positive(self.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
        if !(self.poisson_ratio > -1.0 && self.poisson_ratio < 0.5) {
            faults.error(
                path.key("poisson_ratio"),
                format!("`poisson_ratio` must be above -1 and below 1/2, found {}", self.poisson_ratio),
            );
            fine = false;
        }
        let choice = BondChoice { weights: None, volume_factor: self.volume_factor };
        let given = (self.calibration, choice, self.edges);
        let Bonds { calibration, volume_factor, edges } = bonds(given, &path, faults)?;
        let parameters = StateSolidParameters {
            youngs_modulus: self.youngs_modulus,
            poisson_ratio: self.poisson_ratio,
            horizon_ratio: 0.0,
            influence: self.influence,
            calibration,
            volume_factor: volume_factor.unwrap_or_default(),
            edges,
        };
        let keys = Self { calibration: Some(calibration), volume_factor, edges: Some(edges), ..self.clone() };
        fine.then(|| {
            Box::new(SolidBonds { keys, parameters, usual_horizon_ratio: USUAL }) as Box<dyn Material>
        })
    }
}
