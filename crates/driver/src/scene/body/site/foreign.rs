//! Keys of a case that have no meaning for a body in the plane.

use crate::case::{Body, Case, Solver};
use crate::diagnostic::{Faults, root};

/// Adds a fault for every key that is for beams.
pub(crate) fn check(case: &Case, faults: &mut Faults) {
    let keys = [
        (
            "foundation",
            !case.foundation.is_empty(),
            "beams, and plates that bend",
            "springs under a region are supports with `ux_spring` or `uy_spring`",
        ),
        ("links", !case.links.is_empty(), "beams", "points that move together are a region under `rigid`"),
    ];
    for (key, _, of, hint) in keys.iter().filter(|k| k.1) {
        faults.error(root(key), format!("`{key}` is for {of}")).hint(*hint);
    }
    crate::scene::fracture::check(case, faults);
    crate::scene::path::check(case, faults);
    let listed = matches!(case.body, Body::Points(_) | Body::Mesh(_));
    match case.solver {
        // Which ones solve for a body that breaks has been said.
        _ if case.is_traced() => {}
        Solver::Band | Solver::Strain => {
            let name = if case.solver == Solver::Band { "band" } else { "strain" };
            faults
                .error(root("solver"), format!("the solver `{name}` is for beams"))
                .hint("use `auto`, `sparse`, `multigrid` or `pcg`");
        }
        Solver::Multigrid if listed => {
            faults
                .error(root("solver"), "the solver `multigrid` needs a body that fills a lattice")
                .hint("use `auto`, `sparse` or `pcg` for listed points and meshes");
        }
        _ => {}
    }
}
