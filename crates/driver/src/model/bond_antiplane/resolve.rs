//! What the keys become.

use super::super::{Asked, BodyKind, Keys, Material, Model, Refused};
use super::{Antiplane, NAME, ShearBonds};
use crate::diagnostic::{Faults, positive, root};
use peristat_assembly::model::bond_antiplane::AntiplaneParameters;
use peristat_assembly::model::plane::Edges;

/// Keys that have no meaning where points move across the plane, with the reason and what to do.
const REFUSED: [Refused; 3] = [
    Refused {
        key: "fracture",
        message: "`fracture` is for bodies that move in their plane",
        hint: "the bonds of a plate in antiplane shear do not break: use `stress_intensity`, which is K_III",
    },
    Refused {
        key: "path",
        message: "`path` is for bodies that move in their plane",
        hint: "the bonds of a plate in antiplane shear do not soften",
    },
    Refused {
        key: "rigid",
        message: "`rigid` is for bodies that move in their plane",
        hint: "a region that is held is a support with `w`",
    },
];

impl Keys for Antiplane {
    fn model(&self) -> Model {
        Model::BondAntiplane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn takes_points(&self) -> bool {
        false
    }

    fn refuses(&self) -> Vec<Refused> {
        REFUSED.to_vec()
    }

    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let path = root("model").key(NAME);
        let mut fine = positive(self.shear_modulus, "shear_modulus", path.key("shear_modulus"), faults);
        fine &= positive(self.thickness, "thickness", path.key("thickness"), faults);
        if asked.body == BodyKind::Points {
            faults
                .error(asked.body_path.clone(), format!("the model `{NAME}` needs a lattice"))
                .hint("take `rectangle` or `outline`");
            fine = false;
        }
        let parameters = AntiplaneParameters {
            shear_modulus: self.shear_modulus,
            thickness: self.thickness,
            horizon_ratio: 0.0,
            influence: self.influence,
            edges: self.edges.unwrap_or(Edges::Border),
        };
        fine.then(|| Box::new(ShearBonds { keys: self.clone(), parameters }) as Box<dyn Material>)
    }
}
