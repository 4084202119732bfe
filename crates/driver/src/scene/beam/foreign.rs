//! Keys of a case that have no meaning for a beam.

use crate::case::{At, Body, Case, Load, Solver};
use crate::diagnostic::root;
use crate::diagnostic::{Faults, JsonPath};
use crate::model::hints;

/// Adds a fault for every key that is for bodies in the plane, places aside; whether the body is one for beams.
pub(super) fn check(case: &Case, faults: &mut Faults) -> bool {
    let cracks = format!("a beam is a line: cracks need the model `{}`", hints::PLANE);
    let intensities =
        format!("stress intensities are those of `cracks`, which need the model `{}`", hints::PLANE);
    let keys = [
        ("symmetry", !case.symmetry.is_empty(), "hold the motions that the symmetry excludes by a support"),
        (
            "materials",
            !case.materials.is_empty() && !matches!(case.body, Body::Frame(_)),
            "the moduli of a line are in `model`, those that vary along it in `stiffness`; members of a `frame` have `materials`",
        ),
        ("periodic", !case.periodic.is_empty(), "join the ends of a line by `links`"),
        ("cracks", !case.cracks.is_empty(), &*cracks),
        (
            "regions",
            !case.regions.is_empty(),
            "places on beams are written by `x`, or by `joint` and `member`",
        ),
        ("rigid", !case.rigid.is_empty(), "points of a beam that move together are joined by `links`"),
        ("lines", !case.lines.is_empty(), "all points of a beam are written anyway"),
        ("path", case.path.is_some(), "beams do not soften: `fracture` breaks their bonds"),
        ("limit", case.is_corrected(), "refine the line: its error is estimated by itself"),
        ("corrections", case.corrections.is_some(), "leave it out"),
        ("crack_fronts", case.crack_fronts.is_some(), "leave it out"),
        ("stress_intensity", !case.stress_intensity.is_empty(), &*intensities),
    ];
    for (key, _, hint) in keys.iter().filter(|k| k.1) {
        faults.error(root(key), format!("`{key}` is for bodies in the plane")).hint(*hint);
    }
    if case.strengths.is_some() {
        faults
            .error(root("strengths"), "`strengths` judge the stresses of plates, shells and solids")
            .hint("put a `limit` on a probe of `stress_top` or `stress_bottom`");
    }
    // Which ones solve for a beam that breaks is said elsewhere.
    if case.fracture.is_none() && matches!(case.solver, Solver::Multigrid | Solver::Pcg) {
        let name = if case.solver == Solver::Multigrid { "multigrid" } else { "pcg" };
        faults
            .error(root("solver"), format!("the solver `{name}` is for bodies in the plane"))
            .hint("use `auto`, `strain`, `band` or `sparse`");
    }
    let fits = matches!(case.body, Body::Line(_) | Body::Lines(_) | Body::Frame(_));
    if !fits {
        faults
            .error(root("body"), "the model `timoshenko_beam` needs a body of lines")
            .hint(format!("take `line`, `lines` or `frame`; bodies in the plane are for `{}`", hints::PLANE));
    }
    fits
}

/// Adds a fault for every key of a place that is for bodies in the plane.
pub(super) fn check_place(at: &At, path: &JsonPath, hint: &str, faults: &mut Faults) -> bool {
    let keys = [
        ("y", at.y.is_some()),
        ("region", at.region.is_some()),
        ("inward", at.inward.is_some()),
        ("edge", at.edge.is_some()),
    ];
    let found = keys.iter().find(|k| k.1);
    if let Some((key, _)) = found {
        faults.error(path.key(*key), format!("`{key}` is for bodies in the plane")).hint(hint);
    }
    found.is_none()
}

/// Adds a fault for a load that is for bodies in the plane.
pub(super) fn refuse(load: &Load, path: &JsonPath, faults: &mut Faults) {
    let key = match load {
        Load::Traction(_) => "traction",
        Load::BodyForce(_) => "body_force",
        Load::Pressure(_) => "pressure",
        Load::Spin(_) => "spin",
        Load::Point(_)
        | Load::Distributed(_)
        | Load::Gravity(_)
        | Load::Line(_)
        | Load::Temperature(_)
        | Load::InitialStrain(_) => return,
    };
    faults
        .error(path.key(key), format!("`{key}` is for bodies in the plane"))
        .hint("on a beam forces per length are `distributed`, others `point`");
}
