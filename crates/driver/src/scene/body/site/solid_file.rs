//! The points of a solid from a file, its walls and its parts.

use super::body::{Built, BuiltSolid, PER_POINT, resolves};
use super::files;
use crate::case::SolidBody;
use crate::diagnostic::{Faults, JsonPath, tidy};
use crate::input::Folder;
use crate::input::surface::{SolidFile, Triangles};
use crate::memory;
use peristat_assembly::body::{
    Facet, Grid, GridError, Group, PointBody, SIDES, SquareLattice, Surface, SurfaceError,
};

/// Memory per row of cells, bytes: its first cell, and where it crosses the surface.
const PER_ROW: f64 = 200.0;

/// Volumes of cells and surface that differ by more are worth a doubt. A ball of eight cells across has 3 % too much or too little.
const VOLUME: f64 = 0.05;

/// The body that a file holds.
pub(super) fn build(
    given: &SolidBody,
    folder: &Folder,
    path: &JsonPath,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Built> {
    let scale = given.scale.unwrap_or(1.0);
    if !(scale > 0.0 && scale.is_finite()) {
        faults.error(path.key("scale"), format!("`scale` must be greater than zero, found {scale}"));
        return None;
    }
    let (file, hash) = files::solid(folder, &given.file, max_memory, path, faults)?;
    let SolidFile { surface, parts } = file.scaled(scale);
    let surface = closed(surface, &given.file, path, faults)?;
    let grid = grid(&surface, given.spacing, path, max_memory, faults)?;
    let filled = surface.fill(&grid);
    if let Some([x, y, z]) = filled.inside_out.map(|at| at.map(tidy)) {
        faults
            .error(path.key("file"), format!("the solid {} has a shell that is inside out: ({x}, {y}, {z}) is in it", given.file))
            .hint("shells that look inwards are cavities, and must be in the body: turn the triangles of this one");
        return None;
    }
    let lattice = filled.lattice;
    if lattice.points() == 0 {
        faults
            .error(path.key("spacing"), "no cell has its centre in the body: the spacing is too large")
            .hint("use a smaller spacing");
        return None;
    }
    warn(&surface, &grid, &lattice, path, faults);
    let parts = parts.into_iter().map(|(name, around)| part(name, around, &grid, &lattice, path, faults));
    let parts = parts.collect::<Option<Vec<Group>>>()?;
    let flat = surface.flat_sides();
    let sides = std::array::from_fn(|side| flat[side].then(|| grid.side(side)));
    let solid = BuiltSolid { walls: surface.walls(&grid, &lattice), sides, parts };
    Some(Built { solid: Some(solid), file: Some(hash), ..Built::of(PointBody::Solid(lattice)) })
}

/// The surface, if it is one, with the names of its parts.
fn closed(triangles: Triangles, file: &str, path: &JsonPath, faults: &mut Faults) -> Option<Surface> {
    let Triangles { facets, names } = triangles;
    let surface = match Surface::new(facets, names) {
        Ok(surface) => surface,
        Err(error) => {
            faults.error(path.key("file"), format!("the solid {file} {error}")).hint(match error {
                SurfaceError::Empty => "export a part that has a surface",
                SurfaceError::NotFinite { .. } | SurfaceError::Flat => "export the part again",
                SurfaceError::Open { .. } => {
                    "export one closed body as a whole, or close its holes in a program that repairs surfaces"
                }
                SurfaceError::Turned { .. } => {
                    "let a program that repairs surfaces turn all normals outwards"
                }
                SurfaceError::InsideOut => {
                    "turn all normals outwards: corners run counter-clockwise, seen from outside"
                }
            });
            return None;
        }
    };
    if let Some(name) = surface.misnamed() {
        let message = match SIDES.contains(&name) {
            true => format!(
                "the part `{name}` of {file} is not the {name} side of the box around it, whose name it has"
            ),
            false => format!("the part `{name}` of {file} has the name of all parts without a name"),
        };
        faults.error(path.key("file"), message).hint("give the part another name");
        return None;
    }
    match surface.without_area() {
        0 => {}
        count => {
            let are =
                if count == 1 { "triangle has no area and is" } else { "triangles have no area and are" };
            faults.warning(path.key("file"), format!("{count} {are} passed over"));
        }
    }
    Some(surface)
}

/// The cells around it, if they fit into memory.
fn grid(
    surface: &Surface,
    spacing: f64,
    path: &JsonPath,
    max_memory: Option<u64>,
    faults: &mut Faults,
) -> Option<Grid> {
    let place = path.key("spacing");
    if !resolves(surface.bounds(), spacing, &path.key("file"), faults) {
        return None;
    }
    let grid = match surface.grid(spacing) {
        Ok(grid) => grid,
        Err(error) => {
            let fault = faults.error(place, error.to_string());
            if let GridError::TooManyCells { .. } = error {
                fault.hint(format!("at most {} fit into the box: use a larger spacing, or a `scale` if the file has other units", u32::MAX));
            }
            return None;
        }
    };
    let points = (surface.volume() / spacing.powi(3)).round();
    let what = format!("{points:e} points");
    let bytes = points * PER_POINT + grid.lines() * PER_ROW;
    memory::fits(bytes, (&what, "use a larger spacing"), max_memory, place, faults).then_some(grid)
}

/// Doubts about how well cells fill it.
fn warn(surface: &Surface, grid: &Grid, lattice: &SquareLattice, path: &JsonPath, faults: &mut Faults) {
    let flat = surface.flat_sides();
    let off = grid.is_off();
    if let Some(axis) = (0..3).find(|&axis| off[axis] && (flat[2 * axis] || flat[2 * axis + 1])) {
        let [name, count, cells] = [
            ["x", "y", "z"][axis].to_string(),
            grid.cells[axis].to_string(),
            tidy((1e4 * grid.exact[axis]).round() / 1e4),
        ];
        let numbers: Vec<String> = grid.fitting().into_iter().map(tidy).collect();
        faults
            .warning(
                path.key("spacing"),
                format!(
                    "the body is {cells} cells along {name}, {count} take its place: its flat sides are moved"
                ),
            )
            .hint(match &numbers[..] {
                [] => "take a spacing of which the box around the body is a whole multiple".to_string(),
                [one] => format!("the nearest spacing that fits is {one}"),
                _ => format!("the nearest spacings that fit are {}", numbers.join(" and ")),
            });
    }
    let filled = lattice.points() as f64 * grid.spacing.powi(3) / surface.volume();
    if (filled - 1.0).abs() > VOLUME {
        let percent = (100.0 * filled).round();
        faults
            .warning(path.key("spacing"), format!("the cells have {percent} % of the volume of the body"))
            .hint("use a smaller spacing: thin parts need several cells; overlapping shells count once in cells");
    }
}

/// The points of a part of the body.
fn part(
    name: String,
    around: Vec<Facet>,
    grid: &Grid,
    lattice: &SquareLattice,
    path: &JsonPath,
    faults: &mut Faults,
) -> Option<Group> {
    let surface = Surface::new(around, Vec::new());
    let own = match surface {
        Ok(surface) => surface.fill(grid).lattice,
        Err(error) => {
            faults
                .error(path.key("file"), format!("the physical volume `{name}` {error}"))
                .hint("mesh the body again");
            return None;
        }
    };
    let cells = own.runs().iter().flat_map(|run| run.columns.clone().map(|column| run.cell(column)));
    let points = cells.filter_map(|cell| lattice.number(cell)).map(|point| point as u32).collect();
    Some(Group { name, points })
}
