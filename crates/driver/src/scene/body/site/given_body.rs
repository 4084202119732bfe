//! The body of a case, its material, mirrors and cracks.

use super::body::BuiltSolid;
use super::cracks::{self, NamedCrack};
use super::model_inputs::ModelInputs;
use super::symmetry::{Sides, Symmetry};
use super::{body, held_angle, of_case, periodic, size, symmetry};
use crate::case::{Case, CrackFronts};
use crate::diagnostic::{Faults, tidy};
use crate::input::Folder;
use crate::input::gmsh::Curve;
use crate::model::{About, Keys, Material, Mixture, USUAL_HORIZON_RATIO};
use crate::scene::{horizon, root};
use peristat_assembly::body::{Group, Outline, PointBody, SquareLattice, Wall, in_space};
use peristat_assembly::model::plane::{Edges, FARTHEST, Mirrors};

/// The largest horizon ratio: the bonds of a point grow with its square, and what finds their moduli with its fourth power.
const MOST_RATIO: f64 = 100.0;

/// Up to this ratio horizons that end beyond the body are answered, with a doubt: families of so few points cost nothing.
const MOST_BEYOND: f64 = 12.0;

/// The longest horizon with which bonds that end on the axis are found to be within 1 % there, spacings.
const EXACT_ON_AXIS: f64 = 2.0;

/// What a case says of its body, before it has points in a model.
pub(crate) struct GivenBody {
    pub(crate) inputs: ModelInputs,
    pub(crate) outline: Option<Outline>,
    pub(crate) walls: Vec<Wall>,
    pub(crate) parts: Vec<Group>,
    pub(crate) curves: Vec<Curve>,
    pub(crate) cracks: Vec<NamedCrack>,
}

/// The body of the case, its material and its cracks.
pub(crate) fn read(
    case: &Case,
    keys: &dyn Keys,
    folder: &Folder,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<GivenBody> {
    let asked = of_case::asked(case);
    let mut material = keys.resolve(&asked, faults);
    let cracks = cracks::cracks((case, keys.is_solid()), folder, max_memory, faults);
    let built = body::build(case, keys, folder, max_memory, faults);
    let spacing = built.as_ref().map(|b| b.body.spacing());
    let lattice = match built.as_ref().map(|b| &b.body) {
        Some(PointBody::Lattice(lattice)) => Some(lattice),
        _ => None,
    };
    // Squares turned by right angles are the same.
    let angle = if lattice.is_some_and(SquareLattice::is_turned) { keys.lattice_angle() } else { 0.0 };
    material.iter_mut().for_each(|material| material.set_lattice_angle(angle));
    let usual = material.as_ref().map_or(USUAL_HORIZON_RATIO, |material| material.usual_horizon_ratio());
    let ratio = horizon::horizon_ratio(case, spacing.unwrap_or(1.0), usual, faults);
    let body::Built { mut body, outline, solid, curves, parts: own, file } = built?;
    if let (PointBody::Lattice(lattice), Some(outline)) = (&mut body, &outline)
        && material.as_ref().is_some_and(|material| material.surface().axis().is_some())
    {
        *lattice = outline.with_centres(lattice.clone());
    }
    let lattice = body.cells();
    let touches_axis = match &material {
        Some(material) => material.touches_axis(&asked, (outline.as_ref(), lattice), faults)?,
        None => false,
    };
    let sides = Sides::of(outline.as_ref(), solid.as_ref().map(|solid| &solid.sides));
    let mut symmetry = symmetry::symmetry(&case.symmetry, sides, lattice, faults);
    if let (true, Some(outline), Some(lattice)) = (touches_axis, &outline, lattice) {
        symmetry.add_axis(outline, lattice);
    }
    periodic::join(case, sides, lattice, &mut symmetry, faults);
    let BuiltSolid { mut walls, mut parts, .. } = solid.unwrap_or_default();
    parts.extend(own);
    if let PointBody::Solid(lattice) = &body {
        walls.iter_mut().for_each(|wall| wall.mirror(&symmetry.goes_on, lattice));
    }
    let (mut material, ratio) = (material?, ratio?);
    if ratio > MOST_RATIO {
        faults
            .error(
                root(of_case::horizon_key(case)),
                format!("a horizon of {} spacings has too many bonds per point", tidy(ratio)),
            )
            .hint(format!("the largest horizon ratio of bodies is {MOST_RATIO}; more than 12 never pays"));
        return None;
    }
    if ratio > MOST_BEYOND && !ends_within((&body, outline.as_ref()), ratio, &symmetry, case, faults) {
        return None;
    }
    material.set_horizon_ratio(ratio);
    complete(case, &mut *material, (lattice, outline.as_ref()), &symmetry.mirrors, faults);
    let cracks = cracks?;
    if !size::fits(
        case,
        &*material,
        (&body, outline.as_ref()),
        (&cracks, &symmetry.mirrors),
        max_memory,
        faults,
    ) {
        return None;
    }
    let horizon = ratio * body.spacing();
    // The other treatments of edges know whole cells only, and loads have the volumes of the model.
    let body = match body {
        PointBody::Lattice(lattice) if !material.about().is_exact_at_edges => {
            PointBody::Lattice(lattice.with_whole_cells())
        }
        body => body,
    };
    let breaks = case.fracture.is_some() || case.path.is_some();
    let (bearings, materials) = (Vec::new(), Mixture::default());
    // A crack that grows is that of the bonds that broke, which cross it up to its end.
    let usual = if breaks { CrackFronts::Crossed } else { CrackFronts::Effective };
    let crack_fronts = case.crack_fronts.unwrap_or(usual);
    let inputs =
        ModelInputs { body, file, symmetry, bearings, material, materials, horizon, breaks, crack_fronts };
    Some(GivenBody { inputs, outline, walls, parts, curves, cracks })
}

/// Whether a horizon ends within the body, the longest line of which is the diagonal of the box around it; a fault if not.
fn ends_within(
    (body, outline): (&PointBody, Option<&Outline>),
    ratio: f64,
    symmetry: &Symmetry,
    case: &Case,
    faults: &mut Faults,
) -> bool {
    let [low, high] = outline.map_or_else(|| body::bounds(body), |outline| outline.bounds().map(in_space));
    let size = &symmetry.whole([0, 1, 2].map(|k| high[k] - low[k]))[..body.axes()];
    let (horizon, longest) = (ratio * body.spacing(), size.iter().map(|s| s * s).sum::<f64>().sqrt());
    if horizon <= longest * (1.0 + 1e-9) {
        return true;
    }
    let size = size.iter().map(|s| tidy(*s)).collect::<Vec<_>>().join(" × ");
    let most = longest.max(MOST_BEYOND * body.spacing());
    let [horizon, most] = [horizon, most].map(tidy);
    faults
        .error(
            root(of_case::horizon_key(case)),
            format!(
                "a horizon of {horizon} ends beyond the body, which is {size}: every point sees all others"
            ),
        )
        .hint(format!(
            "three spacings are usual, {} here; the longest that is solved is {most}",
            tidy(3.0 * body.spacing())
        ));
    false
}

/// A doubt about the axial forces of a body of revolution whose border completes its families: weights that are linear in the radius
/// leave some at corners. Measured 1.5 % in the elongation of a solid bar of ten points.
fn warn_of_corners(model: &str, faults: &mut Faults) {
    faults
        .warning(
            root("model").key(model).key("edges"),
            "beside corners of whole cells forces along the axis are off, by one or two per cent of the largest",
        )
        .hint("use `ghosts`, the default, for bodies whose borders run along the lattice; `border` is for spheres and cones");
}

/// A doubt about what is beside the axis: of bodies with many points to their radius what is left over there is small beside the volumes
/// of the border, and not beside those of the axis. Measured in solid cylinders of 18 to 28 points.
fn warn_of_axis(model: &str, faults: &mut Faults) {
    faults
        .warning(
            root("model").key(model).key("edges"),
            "beside the axis stresses can be off by 7 per cent of the largest, and displacements by 14",
        )
        .hint("use `ghosts`, the default, where the border of a solid body runs along the lattice, or a `horizon_ratio` of 2");
}

/// Gives a material the edges that a body can have: where its border cannot be completed, triangles complete its points.
fn complete(
    case: &Case,
    material: &mut (dyn Material + 'static),
    (lattice, outline): (Option<&SquareLattice>, Option<&Outline>),
    mirrors: &Mirrors,
    faults: &mut Faults,
) {
    let about = material.about();
    let ends_on_border = about.edges == Some(Edges::Border);
    let is_cut = lattice.is_some_and(|lattice| !lattice.blocks().is_empty());
    // Families in the plane do not break beside a border that completes them; those of solids do.
    let is_plane = lattice.is_none_or(SquareLattice::is_plane);
    let breaks = is_plane && (case.is_traced() || !case.cracks.is_empty());
    let may_break = breaks && about.has_families;
    // On whole cells ghosts are as good, at less cost.
    if about.ends_where_cut && !is_cut {
        return material.leave_border(Edges::Overlay);
    }
    let left = if is_cut { material.leaves_cut_border(mirrors) } else { None };
    let can_end =
        !may_break && left.is_none() && lattice.is_some_and(|lattice| material.has_border(lattice, mirrors));
    if can_end && !outline.is_some_and(|outline| held_angle::is_held(case, outline)) {
        if material.surface().axis().is_some() && ends_on_border {
            warn_of_corners(about.name, faults);
            let touches_axis = mirrors.lines[0][0].is_some();
            if touches_axis && about.horizon_ratio > EXACT_ON_AXIS {
                warn_of_axis(about.name, faults);
            }
        }
        return;
    }
    if may_break && ends_on_border {
        faults
            .warning(
                root("model").key(about.name).key("edges"),
                "families do not break beside a border that completes them: the edges are `ghosts`",
            )
            .hint("give the edges `ghosts`, the default");
    } else if is_cut && !can_end && ends_on_border {
        warn_of_staircase(&about, left, mirrors, faults);
    }
    // Triangles complete the edges, but do not soften.
    material.leave_border(if case.path.is_some() { Edges::None } else { Edges::Overlay });
}

/// A doubt about a border that cuts cells and cannot be followed.
fn warn_of_staircase(
    about: &About,
    left: Option<(&'static str, &'static str)>,
    mirrors: &Mirrors,
    faults: &mut Faults,
) {
    let otherwise = || match mirrors.joined {
        _ if about.horizon_ratio >= f64::from(FARTHEST + 1) => {
            ("the horizon is too long to follow it", "use a horizon of ten spacings at most")
        }
        [false, false, _] => (
            "single rows, thin tips and slots of a few rows do not tell how it moves",
            "round off tips, draw a slot as a crack or wider than five rows, or use a smaller spacing",
        ),
        _ => ("sides are joined", "model the whole body, or half of it beside a line of symmetry"),
    };
    let (why, hint) = left.unwrap_or_else(otherwise);
    let others = if about.has_families { "ghosts" } else { "overlay" };
    faults
        .warning(
            root("body"),
            format!("the border cuts cells, and {why}: stresses beside slanted and round edges can be off by half, as with the edges `{others}`"),
        )
        .hint(hint);
}
