//! What the keys become.

use super::super::{Asked, BodyKind, Keys, Material, Model, Refused};
use super::{NAME, Shell, ShellBonds};
use crate::diagnostic::{Faults, JsonPath, positive, root, tidy};
use peristat_assembly::model::shell_membrane::{ShellMembrane, ShellParameters};

/// How far a Poisson ratio may be off: 0.333 is a third.
const POISSON_SLACK: f64 = 1e-3;

/// Keys that have no meaning for shells, with the reason and what to do.
const REFUSED: [Refused; 4] = [
    Refused {
        key: "cracks",
        message: "`cracks` is for plates, not for shell membranes",
        hint: "cracks need the model `bond_plane` or `beam_bond_orthotropic`",
    },
    Refused {
        key: "fracture",
        message: "`fracture` is for plates, not for shell membranes",
        hint: "the bonds of a shell membrane do not break",
    },
    Refused {
        key: "path",
        message: "`path` is for plates, not for shell membranes",
        hint: "the bonds of a shell membrane do not soften",
    },
    Refused {
        key: "rigid",
        message: "`rigid` is for plates, not for shell membranes",
        hint: "a region that is held is a support with `ux`, `uy` and `w`",
    },
];

impl Keys for Shell {
    fn model(&self) -> Model {
        Model::ShellMembrane(self.clone())
    }

    fn thickness(&self) -> f64 {
        self.thickness
    }

    fn refuses(&self) -> Vec<Refused> {
        REFUSED.to_vec()
    }

    fn resolve(&self, asked: &Asked, faults: &mut Faults) -> Option<Box<dyn Material>> {
        let parameters = parameters(self, asked, faults)?;
        Some(Box::new(ShellBonds { keys: self.clone(), parameters }))
    }
}

/// The parameters; the horizon ratio is to be set.
fn parameters(given: &Shell, asked: &Asked, faults: &mut Faults) -> Option<ShellParameters> {
    let path = root("model").key(NAME);
    let mut fine = positive(given.youngs_modulus, "youngs_modulus", path.key("youngs_modulus"), faults);
    fine &= positive(given.thickness, "thickness", path.key("thickness"), faults);
    fine &= positive(given.radius, "radius", path.key("radius"), faults);
    if let Some(nu) = given.poisson_ratio.filter(|nu| (nu - 1.0 / 3.0).abs() > POISSON_SLACK) {
        faults
            .error(
                path.key("poisson_ratio"),
                format!("a shell membrane of central bonds has the Poisson ratio 1/3, found {}", tidy(nu)),
            )
            .hint("leave `poisson_ratio` out; another one needs a model with more than central bonds");
        fine = false;
    }
    check_body(given, asked, &path, faults);
    fine.then_some(ShellParameters {
        youngs_modulus: given.youngs_modulus,
        thickness: given.thickness,
        radius: given.radius,
        horizon_ratio: 0.0,
        kinematics: given.kinematics,
        calibration: given.calibration,
        ends: given.ends,
        bending: given.bending,
    })
}

/// Faults of a body that is no developed cylinder.
fn check_body(given: &Shell, asked: &Asked, path: &JsonPath, faults: &mut Faults) {
    let BodyKind::Rectangle { size, spacing, has_holes } = asked.body else {
        faults
            .error(asked.body_path.clone(), "a shell membrane needs a `rectangle`: its developed cylinder")
            .hint("its size is the length along the axis and the arc along the circumference");
        return;
    };
    if has_holes {
        faults.error(asked.body_path.key("holes"), "a shell membrane has no holes");
    }
    let (arc, whole) = (size[1], std::f64::consts::TAU * given.radius);
    // What is no number has a fault of its own.
    if !(arc > 0.0 && whole > 0.0 && spacing > 0.0) {
        return;
    }
    let is_joined = asked.joined.iter().any(|sides| sides.axis == 1);
    if let Some(k) = asked.joined.iter().position(|sides| sides.axis == 1 && sides.stretches) {
        faults
            .error(
                root("periodic").index(k).key("stretches"),
                "a tube does not stretch along its circumference",
            )
            .hint("it grows wider by `w`: leave `stretches` out");
    }
    let [found, needed] = [arc, whole].map(tidy);
    if !is_joined && arc > whole * (1.0 + 1e-3) {
        faults
            .error(
                asked.body_path.key("size").index(1),
                format!("the arc {found} is longer than the circumference {needed} of this radius"),
            )
            .hint("the second size is the arc along the circumference");
    }
    // A single row is its own image: nothing varies along the circumference.
    let is_row = arc < 1.5 * spacing;
    if is_joined && !is_row && ShellMembrane::parts_of_circumference(given.radius, arc).is_none() {
        faults
            .error(
                path.key("radius"),
                format!(
                    "a tube of radius {} has the circumference {needed}, and the joined arc is {found}",
                    tidy(given.radius)
                ),
            )
            .hint(format!(
                "give the radius {}, or an arc that is a whole part of the circumference, or a single row",
                tidy(arc / std::f64::consts::TAU)
            ));
    }
}
