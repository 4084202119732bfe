//! What has no limit of local elasticity that corrections find.

use crate::case::{BodyForce, Case, Load};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::model::{Surface, hints};
use crate::scene::body::hold::held_body::HeldBody;
use crate::scene::body::load::traction::on_border::OnBorder;
use crate::scene::body::load::traction::profile::Profile;
use peristat_assembly::body::{Outline, PointBody, Shape};
use peristat_assembly::model::plane::Calibration;

/// Most corrections: behind them nothing but rounding is left.
const MOST: usize = 4;

/// Points per radius of a hole that fits see on one side of it alone.
const NARROWEST: f64 = 3.0;

/// Leave it out, and the results are those of the bonds.
const LEAVE: &str = "leave `limit` out: the results are those of the bonds then";

/// Faults of the keys themselves, in any case.
pub(crate) fn check_keys(case: &Case, faults: &mut Faults) {
    let Some(corrections) = case.corrections else { return };
    let path = root("corrections");
    if !case.is_corrected() {
        faults
            .error(path, "`corrections` lead to the limit `local`, which is not asked for")
            .hint("write \"limit\": \"local\", or leave `corrections` out");
    } else if corrections > MOST {
        faults.error(path, format!("`corrections` must be from 0 to {MOST}, found {corrections}")).hint(
            "two leave an error of about 1e-4, three of 1e-5; where more are needed the spacing is too large",
        );
    }
}

/// The outline of a body whose displacements can be corrected; faults of all that stands against it.
pub(super) fn body<'a>(site: &HeldBody<'a>, faults: &mut Faults) -> Option<&'a Outline> {
    let case = site.ground.case;
    let mut tell = |why: &str, hint: &str| {
        faults.error(root("limit"), format!("`local` is no limit of this body: {why}")).hint(hint);
    };
    if case.is_traced() || !site.cracks.is_empty() {
        tell("at cracks, and where bonds fail, stresses have no polynomials to correct them by", LEAVE);
    }
    let about = site.inputs.material.about();
    let moves_in_plane =
        matches!(about.components, ["ux", "uy"] | ["ux", "uy", "phi"]) && about.surface == Surface::Flat;
    if !moves_in_plane {
        tell("its points do more than move in their plane", LEAVE);
    }
    if about.has_families {
        tell(
            "beside a border families answer a load by another displacement than local elasticity does, and corrections do not converge",
            &format!("take the model `{}`, or leave `limit` out", hints::PLANE),
        );
    }
    if about.calibration != Calibration::Matched {
        tell(
            "bonds of the calibration `published` have other moduli than the material",
            "leave `calibration` out",
        );
    }
    if !site.inputs.materials.is_one() || !case.materials.is_empty() {
        tell("at an interface, and where moduli vary, no polynomial is in equilibrium", LEAVE);
    }
    if !case.periodic.is_empty() || !case.rigid.is_empty() {
        tell("its sides are joined, or parts of it are rigid", LEAVE);
    }
    let PointBody::Lattice(lattice) = site.ground.body else {
        tell("listed points and meshes have no true border", "give the body as a rectangle or an outline");
        return None;
    };
    if lattice.is_turned() {
        tell("the rows of its lattice run along neither x nor y", "leave the angle of the lattice out");
    }
    let outline = site.outline?;
    if outline.holes().iter().any(|hole| matches!(hole.shape, Shape::Polygon(_))) {
        tell(
            "stresses are infinite in the corners of a polygonal hole",
            "round the hole, or leave `limit` out",
        );
    }
    let spacing = lattice.spacing();
    let narrowest = outline.holes().iter().map(|hole| match &hole.shape {
        Shape::Circle { radius, .. } | Shape::Slot { radius, .. } => *radius,
        Shape::Ellipse { half_axes, .. } => half_axes[0].min(half_axes[1]),
        Shape::Polygon(_) => f64::INFINITY,
    });
    let narrowest = narrowest.fold(f64::INFINITY, f64::min) / spacing;
    if narrowest < NARROWEST {
        let found = tidy((10.0 * narrowest).round() / 10.0);
        tell(
            &format!(
                "a hole has {found} points per radius, and its stresses are not polynomials over less than {NARROWEST}"
            ),
            "use a smaller spacing",
        );
    }
    (!faults.has_errors()).then_some(outline)
}

/// Adds a fault where lines of symmetry stand across a weight.
pub(super) fn weight(weights: &[[f64; 3]], site: &HeldBody, faults: &mut Faults) {
    let is_mirrored =
        |axis: usize| site.inputs.symmetry.at[2 * axis..2 * axis + 2].iter().any(Option::is_some);
    if weights.iter().any(|weight| (0..2).any(|axis| weight[axis] != 0.0 && is_mirrored(axis))) {
        faults
            .error(root("limit"), "a line of symmetry stands across the weight: behind it things would fall the other way, and `local` has no stress of that")
            .hint("hold the side by a support, or leave `limit` out");
    }
}

/// Faults of supports that hold rotations of points.
pub(super) fn rotations(case: &Case, faults: &mut Faults) {
    let held = case.supports.iter().position(|support| support.phi.is_some());
    if let Some(k) = held {
        faults
            .error(
                root("supports").index(k).key("phi"),
                "the limit `local` knows no rotations of points: local elasticity has none",
            )
            .hint("hold the edge by its displacements alone");
    }
}

/// Faults of loads whose stresses no polynomial has.
pub(super) fn loads(case: &Case, faults: &mut Faults) {
    let cases = case.load_cases.iter().enumerate();
    let cases = cases.map(|(k, load_case)| (root("load_cases").index(k).key("loads"), &load_case.loads));
    for (path, loads) in std::iter::once((root("loads"), &case.loads)).chain(cases) {
        for (k, load) in loads.iter().enumerate() {
            load_fault(load, &path.index(k), faults);
        }
    }
}

fn load_fault(load: &Load, path: &JsonPath, faults: &mut Faults) {
    let (key, why) = match load {
        Load::Point(_) => ("point", "under a force at a point they are infinite"),
        Load::Temperature(_) => ("temperature", "a body that heat stretches has others"),
        Load::InitialStrain(_) => ("initial_strain", "a body with strains of its own has others"),
        Load::BodyForce(load) if load.region.is_some() || is_formula(load) => {
            ("body_force", "a force that varies within the body is not among what is in balance with them")
        }
        Load::Gravity(load) if load.region.is_some() => {
            ("gravity", "the weight of a part is not among what is in balance with them")
        }
        Load::Spin(_) => ("spin", "forces of a spin are not among what is in balance with them"),
        // What acts on no body in the plane has its own fault.
        Load::Traction(_)
        | Load::BodyForce(_)
        | Load::Gravity(_)
        | Load::Pressure(_)
        | Load::Line(_)
        | Load::Distributed(_) => return,
    };
    faults
        .error(
            path.key(key),
            format!("the limit `local` has stresses of tractions and of a uniform weight: {why}"),
        )
        .hint("load the body otherwise, or leave `limit` out");
}

/// Whether a force per volume varies.
fn is_formula(load: &BodyForce) -> bool {
    load.density.as_ref().is_some_and(|density| density.0.iter().any(|amount| amount.number().is_none()))
}

/// A fault of a traction that is not smooth along its border.
pub(super) fn profile(on: &OnBorder, faults: &mut Faults) {
    if matches!(on.profile, Profile::Hertz { .. }) {
        faults
            .error(on.path.key("hertz"), "the slope of a contact pressure is infinite at its ends: the limit `local` has no stresses there")
            .hint("leave `limit` out");
    }
}
