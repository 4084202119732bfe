//! The points of a body and its border.

use super::drawn::Plan;
use super::snap::Snap;
use super::{border_names, boundary, drawn, files, solid, solid_file};
use crate::case::{Body, Case, Hole, PointsBody};
use crate::diagnostic::{Faults, JsonPath, root, tidy};
use crate::input::Folder;
use crate::input::gmsh::Curve;
use crate::memory;
use crate::model::{Keys, hints};
use peristat_assembly::body::{
    self, FillError, Group, HoleError, Outline, OutlineError, PointBody, Polygon, Shape, Wall,
};

/// Memory per point of what a scene keeps of a lattice and its model, bytes.
pub(super) const PER_POINT: f64 = 150.0;

/// Path of the body in a case, with the key of its kind.
pub(crate) fn path(case: &Case) -> JsonPath {
    let body = root("body");
    match &case.body {
        Body::Rectangle(_) => body.key("rectangle"),
        Body::Outline(_) => body.key("outline"),
        Body::Points(_) => body.key("points"),
        Body::Mesh(_) => body.key("mesh"),
        Body::Block(_) => body.key("block"),
        Body::Solid(_) => body.key("solid"),
        _ => body,
    }
}

/// A body, its outline in the plane or its walls in space if it has some, and the named curves of a mesh.
pub(crate) struct Built {
    pub(crate) body: PointBody,
    pub(crate) outline: Option<Outline>,
    pub(crate) solid: Option<BuiltSolid>,
    pub(crate) curves: Vec<Curve>,
    /// Named parts of a body in the plane that a mesh outlines.
    pub(crate) parts: Vec<Group>,
    /// Hash of the file that lists the points, or draws the outline.
    pub(crate) file: Option<blake3::Hash>,
}

/// What bounds a solid, and parts of it.
#[derive(Default)]
pub(crate) struct BuiltSolid {
    /// Named parts of its border.
    pub(crate) walls: Vec<Wall>,
    /// Where it is flat on sides of the box around it, in the order of the sides.
    pub(crate) sides: [Option<f64>; 6],
    /// Named parts of it.
    pub(crate) parts: Vec<Group>,
}

impl Built {
    /// A body with nothing else.
    pub(super) fn of(body: PointBody) -> Self {
        Self { body, outline: None, solid: None, curves: Vec::new(), parts: Vec::new(), file: None }
    }
}

/// The body of the case; the keys of its model give its thickness and along what the rows of a lattice run.
pub(crate) fn build(
    case: &Case,
    keys: &dyn Keys,
    folder: &Folder,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Built> {
    let path = path(case);
    if keys.is_solid() {
        if let Body::Solid(given) = &case.body {
            return solid_file::build(given, folder, &path, max_memory, faults);
        }
        if let (Body::Points(b), true) = (&case.body, keys.takes_points()) {
            return listed(b, keys, folder, &path, max_memory, faults);
        }
        let (body, solid) = solid::build((case, keys), &path, max_memory, faults)?;
        return Some(Built { solid: Some(solid), ..Built::of(body) });
    }
    let mut drawn = None;
    let (mut outline, spacing) = match &case.body {
        Body::Rectangle(b) => {
            let made = Outline::rectangle(b.from, b.size);
            let snap = Snap::new(&[b.from, [0, 1].map(|k| b.from[k] + b.size[k])], &[], &b.holes);
            (cut(made, (&b.holes, None, &snap), &path, faults)?, b.spacing)
        }
        Body::Outline(b) => {
            let plan = drawn::plan(b, folder, &path, max_memory, faults)?;
            let snap = Snap::new(&[], &plan.vertices, &plan.holes);
            let made = Outline::curved(snap.positions(&plan.vertices), &plan.sides);
            let made = made.map_err(|error| drawn::by_sides(error, &plan.sides));
            let mut outline = cut(made, (&plan.holes, plan.file.map(|_| plan.drawn), &snap), &path, faults)?;
            plan.name(b, &mut outline, &path, faults);
            drawn = Some(plan);
            (outline, b.spacing)
        }
        Body::Points(b) => return listed(b, keys, folder, &path, max_memory, faults),
        Body::Mesh(b) => {
            let (body, curves, file) = files::mesh(folder, &b.file, max_memory, &path, faults)?;
            if !resolves(bounds(&body), body.spacing(), &path.key("file"), faults) {
                return None;
            }
            return Some(Built { curves, file: Some(file), ..Built::of(body) });
        }
        _ => {
            let message = format!("the model `{}` needs a body in the plane", case.model.name());
            faults.error(root("body"), message).hint({
                let bodies = match keys.takes_points() {
                    true => "`rectangle`, `outline`, `points` or `mesh`",
                    false => "`rectangle` or `outline`",
                };
                format!("take {bodies}; lines and frames are for `{}`", hints::LINES)
            });
            return None;
        }
    };
    border_names::give(case, &mut outline, faults);
    fill((case, keys), (outline, spacing), drawn, max_memory, faults)
}

/// A body of listed points.
fn listed(
    given: &PointsBody,
    keys: &dyn Keys,
    folder: &Folder,
    path: &JsonPath,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Built> {
    let kind = (if keys.is_solid() { 3 } else { 2 }, keys.thickness());
    let (body, file) = files::points(folder, &given.file, kind, max_memory, path, faults)?;
    let fine = resolves(bounds(&body), body.spacing(), &path.key("file"), faults);
    fine.then(|| Built { file: Some(file), ..Built::of(body) })
}

/// An outline filled with points.
fn fill(
    (case, keys): (&Case, &dyn Keys),
    (outline, spacing): (Outline, f64),
    drawn: Option<Plan>,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Built> {
    let path = path(case);
    let before = drawn.as_ref().map_or(0, |plan| plan.drawn);
    let key = match (outline.is_rectangle(), is_from_file(case)) {
        (true, _) => "from",
        (_, true) => "file",
        _ => "vertices",
    };
    if !resolves(outline.bounds(), spacing, &path.key(key), faults) {
        return None;
    }
    let filled = outline.cells(spacing, keys.lattice_angle()).and_then(|cells| {
        let box_points = f64::from(cells[0]) * f64::from(cells[1]);
        let fits = fits(&outline, box_points, max_memory, &path, faults)
            && boundary::fits(&outline, spacing, max_memory, (&path, before), faults);
        Ok(if fits { Some(outline.fill_turned(spacing, keys.lattice_angle())?) } else { None })
    });
    match filled {
        Ok(lattice) => {
            let lattice = lattice?;
            let parts = drawn.as_ref().map_or(Vec::new(), |plan| plan.groups(&lattice));
            let file = drawn.and_then(|plan| plan.file);
            Some(Built { outline: Some(outline), parts, file, ..Built::of(PointBody::Lattice(lattice)) })
        }
        Err(error) => {
            let holes = match (&case.body, &drawn) {
                (Body::Rectangle(b), _) => &b.holes[..],
                (_, Some(plan)) => &plan.holes,
                _ => &[],
            };
            unfilled(&error, (holes, before), &path, faults);
            None
        }
    }
}

/// Whether the outline of a case is that of a file.
fn is_from_file(case: &Case) -> bool {
    matches!(&case.body, Body::Outline(body) if body.file.is_some())
}

/// Rounding of coordinates must be below this, in spacings.
const ROUNDING: f64 = 1e-6;

/// Whether doubles tell positions in a box much finer than the spacing.
pub(super) fn resolves<const N: usize>(
    bounds: [[f64; N]; 2],
    spacing: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let largest = bounds.iter().flatten().fold(0.0_f64, |m, x| m.max(x.abs()));
    // Spacings that are none have a fault of their own.
    if !(largest * f64::EPSILON > ROUNDING * spacing && spacing > 0.0) {
        return true;
    }
    let [largest, spacing] = [largest, spacing].map(tidy);
    faults
        .error(
            path.clone(),
            format!("beside coordinates up to {largest} a spacing of {spacing} is lost in rounding"),
        )
        .hint("put the origin near the body");
    false
}

/// The box around the points of a body, with the whole cells of a lattice.
pub(super) fn bounds(body: &PointBody) -> [[f64; 3]; 2] {
    let half = if body.cells().is_some() { 0.5 * body.spacing() } else { 0.0 };
    let points = (0..body.points()).map(|p| body.position(p));
    points.fold([[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]], |[low, high], p| {
        [[0, 1, 2].map(|k| low[k].min(p[k] - half)), [0, 1, 2].map(|k| high[k].max(p[k] + half))]
    })
}

/// The outline with its holes, without the noise of their coordinates.
fn cut(
    made: Result<Outline, OutlineError>,
    (holes, drawn, snap): (&[Hole], Option<usize>, &Snap),
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Outline> {
    let mut outline = match made {
        Ok(outline) => Some(outline),
        Err(error) => {
            let place = match &error {
                OutlineError::Size { axis, .. } => path.key("size").index(*axis),
                OutlineError::Corner => path.key("from"),
                OutlineError::Polygon(_) => path.key(if drawn.is_some() { "file" } else { "vertices" }),
            };
            faults.error(place, error.to_string());
            None
        }
    };
    for (k, hole) in holes.iter().enumerate() {
        // What a file draws is at fault there.
        let before = drawn.unwrap_or(0);
        let of_file = (k < before).then(|| path.key("file"));
        let path = path.key("holes").index(k.saturating_sub(before));
        let (key, shape) = match snap.hole(hole) {
            Hole::Circle(c) => ("circle", Ok(Shape::Circle { centre: c.centre, radius: c.radius })),
            Hole::Ellipse(e) => {
                ("ellipse", Shape::ellipse(e.centre, e.half_axes, e.angle.unwrap_or(0.0).to_radians()))
            }
            Hole::Slot(s) => ("slot", Ok(Shape::Slot { from: s.from, to: s.to, radius: s.radius })),
            Hole::Polygon(p) => ("polygon", Polygon::new(p.vertices).map(Shape::Polygon).map_err(Into::into)),
        };
        let path = path.key(key);
        let cut = shape.and_then(|shape| {
            let hole = body::Hole { name: hole.name().map(Into::into), shape };
            outline.as_mut().map_or(Ok(()), |outline| outline.cut(hole))
        });
        if let Err(error) = cut {
            let place = match &error {
                HoleError::Radius { .. } => path.key("radius"),
                HoleError::HalfAxis { axis, .. } => path.key("half_axes").index(*axis),
                HoleError::Polygon(_) => path.key("vertices"),
                HoleError::SameName { .. } => path.key("name"),
                HoleError::NotFinite | HoleError::Outside => path,
            };
            faults.error(of_file.unwrap_or(place), error.to_string());
        }
    }
    outline
}

/// Whether the points of an outline fit into memory; `box_points` are those of the box around it.
fn fits(
    outline: &Outline,
    box_points: f64,
    max_memory: Option<u64>,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let [low, high] = outline.bounds();
    let share = outline.border().area() / ((high[0] - low[0]) * (high[1] - low[1]));
    let points = (box_points * share).round();
    let what = format!("{points:e} points");
    memory::fits(points * PER_POINT, (&what, "use a larger spacing"), max_memory, path.key("spacing"), faults)
}

/// A fault for an outline that cells do not fill.
fn unfilled(error: &FillError, (holes, drawn): (&[Hole], usize), path: &JsonPath, faults: &mut Faults) {
    match error {
        FillError::Spacing { found } => {
            faults.error(path.key("spacing"), format!("`spacing` must be greater than zero, found {found}"));
        }
        FillError::NotWhole { cells, fitting } => {
            let [a, b] = cells.map(tidy);
            let fault = faults.error(
                path.key("size"),
                format!("the rectangle is {a} × {b} cells, which are not whole numbers"),
            );
            let numbers: Vec<String> = fitting.iter().map(|s| tidy(*s)).collect();
            match numbers.is_empty() {
                true => fault.hint("both sides must be whole multiples of the spacing"),
                false if numbers.len() == 1 => {
                    fault.hint(format!("the nearest spacing that fits is {}", numbers[0]))
                }
                false => fault.hint(format!("the nearest spacings that fit are {}", numbers.join(" and "))),
            };
        }
        FillError::TooManyCells { cells } => {
            faults
                .error(path.key("spacing"), format!("{cells:e} cells are too many to number"))
                .hint(format!("at most {} fit into the box around the body", u32::MAX));
        }
        FillError::NoPoints => {
            faults
                .error(path.key("spacing"), "no cell has its centre in the body: the spacing is too large")
                .hint("use a smaller spacing");
        }
        FillError::NoCellInHole { hole } => {
            let place = match hole.checked_sub(drawn) {
                Some(k) => path.key("holes").index(k),
                None => path.key("file"),
            };
            let called = match holes.get(*hole).and_then(Hole::name) {
                Some(name) => format!("the hole `{name}`"),
                None => "this hole".into(),
            };
            faults
                .error(place, format!("no cell has its centre in {called}: it would do nothing"))
                .hint("use a smaller spacing; a hole needs several cells to be one");
        }
    }
}
