//! Keys of a case that have no meaning for a plate in bending.

use crate::case::{Body, Case, Load, Solver};
use crate::diagnostic::{Faults, JsonPath, root};

/// Adds a fault for every such key.
pub(super) fn check(case: &Case, faults: &mut Faults) {
    let keys = [
        ("links", !case.links.is_empty(), "points are held by `supports`"),
        ("rigid", !case.rigid.is_empty(), "points are held by `supports`"),
        ("periodic", !case.periodic.is_empty(), "model half of the plate beside a line of `symmetry`"),
        ("cracks", !case.cracks.is_empty(), "a slot that parts cells is a `holes` polygon"),
        ("crack_fronts", case.crack_fronts.is_some(), "plates in bending have no cracks"),
        ("stress_intensity", !case.stress_intensity.is_empty(), "plates in bending have no cracks"),
        ("limit", case.is_corrected(), "use a smaller spacing"),
        ("corrections", case.corrections.is_some(), "leave it out"),
        ("path", case.path.is_some(), "the bonds of a plate in bending do not soften"),
        ("strengths", case.strengths.is_some(), "put a `limit` on a probe of `von_mises`, or of `M_1`"),
    ];
    for (key, _, hint) in keys.iter().filter(|key| key.1) {
        faults.error(root(key), format!("`{key}` is not for plates in bending")).hint(*hint);
    }
    if matches!(case.body, Body::Points(_) | Body::Mesh(_)) {
        faults
            .error(root("body"), "a plate in bending needs a lattice, with points on its edges")
            .hint("take `rectangle` or `outline`; an outline is also read from a drawing");
    }
    let name = match case.solver {
        Solver::Auto | Solver::Sparse | Solver::Multigrid => return,
        Solver::Strain => "strain",
        Solver::Band => "band",
        Solver::Pcg => "pcg",
    };
    faults
        .error(root("solver"), format!("the solver `{name}` does not solve for plates in bending"))
        .hint("use `auto`, `sparse` or `multigrid`");
}

/// Adds a fault for a load of another body.
pub(super) fn refuse(load: &Load, path: &JsonPath, faults: &mut Faults) {
    let (key, hint) = match load {
        Load::Distributed(_) => ("distributed", "a force per length is a `line`, one per area a `pressure`"),
        Load::Traction(_) => ("traction", "a force or moment per length of an edge is a `line`"),
        Load::BodyForce(_) => ("body_force", "a force per area is a `pressure`"),
        Load::Spin(_) => ("spin", "plates in bending move across their plane alone"),
        Load::Point(_)
        | Load::Pressure(_)
        | Load::Line(_)
        | Load::Gravity(_)
        | Load::Temperature(_)
        | Load::InitialStrain(_) => return,
    };
    faults.error(path.key(key), format!("`{key}` does not act on plates in bending")).hint(hint);
}
