//! The body of a case in the plane, its material, mirrors and cracks.

use super::super::{horizon, root};
use super::keys::PlaneKeys;
use super::model::Recipe;
use super::{NamedCrack, PlaneBonds, body, cracks, held_angle, periodic, size, state_based, symmetry};
use crate::case::{Case, Model};
use crate::diagnostic::{Faults, tidy};
use crate::input::Folder;
use crate::input::gmsh::Curve;
use peristat_assembly::body::{Outline, PlaneBody, SquareLattice};
use peristat_assembly::model::plane::{Edges, FARTHEST, Mirrors, has_border};
use peristat_assembly::model::state_based::BorderedState;

/// The largest horizon ratio: the bonds of a point grow with its square, and what finds their moduli with its fourth power.
const MOST_RATIO: f64 = 100.0;

/// What a case says of its body, before it has points in a model.
pub(super) struct Parts {
    pub(super) recipe: Recipe,
    pub(super) outline: Option<Outline>,
    pub(super) curves: Vec<Curve>,
    pub(super) cracks: Vec<NamedCrack>,
}

/// The body of the case, its material and its cracks.
pub(super) fn parts(
    case: &Case,
    model: &mut dyn PlaneKeys,
    folder: &Folder,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Parts> {
    let listed = matches!(case.body, crate::case::Body::Points(_) | crate::case::Body::Mesh(_));
    let bonds = model.bonds(case, listed, faults);
    let cracks = cracks::cracks(case, faults);
    let built = body::build(case, model.thickness(), model.lattice_angle(), folder, max_memory, faults);
    let spacing = built.as_ref().map(|b| b.body.spacing());
    let lattice = match built.as_ref().map(|b| &b.body) {
        Some(PlaneBody::Lattice(lattice)) => Some(lattice),
        _ => None,
    };
    // Squares turned by right angles are the same.
    let angle = if lattice.is_some_and(SquareLattice::is_turned) { model.lattice_angle() } else { 0.0 };
    let bonds = bonds.map(|bonds| bonds.with_lattice_angle(angle));
    let usual = bonds.map_or(3.0, |bonds| bonds.usual_horizon_ratio());
    let ratio = horizon::horizon_ratio(case, spacing.unwrap_or(1.0), usual, faults);
    let body::Built { mut body, outline, curves, file } = built?;
    if let (PlaneBody::Lattice(lattice), Some(outline)) = (&mut body, &outline)
        && bonds.is_some_and(|bonds| bonds.is_revolved())
    {
        *lattice = outline.with_centres(lattice.clone());
    }
    let lattice = match &body {
        PlaneBody::Lattice(lattice) => Some(lattice),
        PlaneBody::Cloud(_) => None,
    };
    let touches_axis = match bonds.is_some_and(|bonds| bonds.is_revolved()) {
        true => state_based::check_revolved(case, (outline.as_ref(), lattice), faults)?,
        false => false,
    };
    let mut symmetry = symmetry::symmetry(&case.symmetry, outline.as_ref(), lattice, faults);
    if let (true, Some(outline), Some(lattice)) = (touches_axis, &outline, lattice) {
        symmetry.add_axis(outline, lattice);
    }
    periodic::join(case, outline.as_ref(), lattice, &mut symmetry, faults);
    let (bonds, ratio) = (bonds?, ratio?);
    if ratio > MOST_RATIO {
        let key = if case.horizon.is_some() { "horizon" } else { "horizon_ratio" };
        faults
            .error(root(key), format!("a horizon of {} spacings has too many bonds per point", tidy(ratio)))
            .hint(format!(
                "the largest horizon ratio of bodies in the plane is {MOST_RATIO}; more than 12 never pays"
            ));
        return None;
    }
    let bonds = bonds.with_horizon_ratio(ratio);
    let bonds = completed(case, bonds, (lattice, outline.as_ref()), (&symmetry.mirrors, ratio), faults);
    let cracks = cracks?;
    if !size::fits(case, &bonds, (&body, outline.as_ref()), (&cracks, &symmetry.mirrors), max_memory, faults)
    {
        return None;
    }
    let horizon = ratio * body.spacing();
    // The other treatments of edges know whole cells only, and loads have the volumes of the model.
    let body = match body {
        PlaneBody::Lattice(lattice) if !bonds.is_exact_at_edges() => {
            PlaneBody::Lattice(lattice.with_whole_cells())
        }
        body => body,
    };
    let breaks = case.fracture.is_some() || case.path.is_some();
    let recipe = Recipe { body, file, symmetry, bearings: Vec::new(), bonds, horizon, breaks };
    Some(Parts { recipe, outline, curves, cracks })
}

/// A doubt about the axial forces of a body of revolution whose border completes its families: weights that are linear in the radius
/// leave some at corners. Measured 1.5 % in the elongation of a solid bar of ten points.
fn warn_of_corners(faults: &mut Faults) {
    faults
        .warning(
            root("model").key("axisymmetric").key("edges"),
            "beside corners of whole cells forces along the axis are off, by one or two per cent of the largest",
        )
        .hint("use `ghosts`, the default, for bodies whose borders run along the lattice; `border` is for spheres and cones");
}

/// Bonds with the edges that a body can have: where its border cannot be completed, triangles complete its points.
fn completed(
    case: &Case,
    bonds: PlaneBonds,
    (lattice, outline): (Option<&SquareLattice>, Option<&Outline>),
    (mirrors, ratio): (&Mirrors, f64),
    faults: &mut Faults,
) -> PlaneBonds {
    let is_cut = lattice.is_some_and(|lattice| !lattice.blocks().is_empty());
    // Families do not break beside a border that completes them.
    let breaks = case.fracture.is_some() || case.path.is_some() || !case.cracks.is_empty();
    let may_break = breaks && bonds.has_families();
    // On whole cells ghosts are as good, at less cost.
    let is_usual = matches!(&case.model, Model::StatePlane(model) if model.edges.is_none());
    if is_usual && !is_cut {
        return bonds.without_border(Edges::Overlay);
    }
    let can_end = !may_break
        && lattice.is_some_and(|lattice| match &bonds {
            PlaneBonds::State(parameters) => BorderedState::has_border(parameters, lattice, mirrors),
            _ => has_border(lattice, mirrors, ratio as i32),
        });
    if can_end && !outline.is_some_and(|outline| held_angle::is_held(case, outline)) {
        if bonds.is_revolved() && bonds.edges() == Some(Edges::Border) {
            warn_of_corners(faults);
        }
        return bonds;
    }
    if may_break && bonds.edges() == Some(Edges::Border) {
        faults
            .warning(
                root("model").key(case.model.name()).key("edges"),
                "families do not break beside a border that completes them: the edges are `ghosts`",
            )
            .hint("give the edges `ghosts`, the default");
    } else if is_cut && !can_end && bonds.edges() == Some(Edges::Border) {
        let (why, hint) = match mirrors.joined {
            _ if ratio >= f64::from(FARTHEST + 1) => {
                ("the horizon is too long to follow it", "use a horizon of ten spacings at most")
            }
            [false, false, _] => (
                "single rows and thin tips do not tell how it moves",
                "round off tips, or use a smaller spacing",
            ),
            _ => ("sides are joined", "model the whole body, or half of it beside a line of symmetry"),
        };
        let others = if bonds.has_families() { "ghosts" } else { "overlay" };
        faults
            .warning(
                root("body"),
                format!("the border cuts cells, and {why}: stresses beside slanted and round edges can be off by half, as with the edges `{others}`"),
            )
            .hint(hint);
    }
    // Triangles complete the edges, but do not soften.
    bonds.without_border(if case.path.is_some() { Edges::None } else { Edges::Overlay })
}
