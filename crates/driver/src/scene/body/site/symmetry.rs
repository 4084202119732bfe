//! Sides of a body that are mirrors, and beyond which it has images therefore.

use super::holes;
use crate::diagnostic::{Faults, JsonPath, root, suggest};
use peristat_assembly::body::{self, Crack, Edge, Face, Outline, SquareLattice};
use peristat_assembly::model::plane::Mirrors;

/// What has sides.
#[derive(Clone, Copy)]
pub(crate) enum Sides<'a> {
    /// An outline in the plane.
    Edges(&'a Outline),
    /// A solid, which may be flat on sides of the box around it, at these positions.
    Solid(&'a [Option<f64>; 6]),
}

impl<'a> Sides<'a> {
    /// Those of a body; listed points have none.
    pub(crate) fn of(outline: Option<&'a Outline>, solid: Option<&'a [Option<f64>; 6]>) -> Option<Self> {
        outline.map(Self::Edges).or(solid.map(Self::Solid))
    }

    /// Their names.
    fn names(self) -> impl Iterator<Item = &'static str> {
        let count = if matches!(self, Self::Solid(_)) { 6 } else { 4 };
        body::SIDES.into_iter().take(count)
    }

    /// The edge or face that is a whole side of the box around the body, and the position of the side.
    pub(crate) fn whole(self, side: usize) -> Option<(String, f64)> {
        match self {
            Self::Edges(outline) => edge_on(outline, side),
            Self::Solid(sides) => sides[side].map(|at| (body::SIDES[side].to_string(), at)),
        }
    }
}

/// Mirrors of a body: their lines, their positions and the edges they replace; and its joined edges.
#[derive(Clone, Debug, Default)]
pub(crate) struct Symmetry {
    /// Lines on the lattice.
    pub(crate) mirrors: Mirrors,
    /// Positions of the lines, or planes: left, right, bottom, top, back, front.
    pub(crate) at: [Option<f64>; 6],
    /// Whether the sides are faces of a solid, not edges.
    pub(crate) is_solid: bool,
    /// Names of the edges or faces on them.
    pub(crate) edges: Vec<String>,
    /// Faces of a solid behind which it goes on.
    pub(crate) goes_on: Vec<Face>,
    /// Names of those on the axis of a body of revolution.
    pub(crate) axis: Vec<String>,
    /// Names of the edges or faces that are joined to the opposite ones.
    pub(crate) joined: Vec<String>,
}

/// Mirrors of the case.
pub(crate) fn symmetry(
    names: &[String],
    sides: Option<Sides>,
    lattice: Option<&SquareLattice>,
    faults: &mut Faults,
) -> Symmetry {
    let is_solid = matches!(sides, Some(Sides::Solid(_)));
    let mut symmetry = Symmetry { is_solid, ..Symmetry::default() };
    for (k, name) in names.iter().enumerate() {
        let path = root("symmetry").index(k);
        let names = || sides.map_or_else(|| body::SIDES[..4].to_vec(), |sides| sides.names().collect());
        let Some(side) = names().iter().position(|side| side == name) else {
            faults
                .error(path, format!("there is no side `{name}` to be a mirror"))
                .hint(suggest(name, names().into_iter()));
            continue;
        };
        let (Some(sides), Some(lattice)) = (sides, lattice) else {
            faults
                .error(path, "mirrors need a body that fills a lattice: `rectangle` or `outline`, in space `block` or `solid`")
                .hint("hold the displacement across the line of symmetry by a support instead");
            continue;
        };
        if lattice.is_turned() {
            faults
                .error(
                    path,
                    "mirrors need a lattice whose rows run along x, and those of this one are turned",
                )
                .hint("model the whole body");
            continue;
        }
        let Some((edge, at)) = sides.whole(side) else {
            let message = match is_solid {
                true => format!("the body is not flat on its {name} side"),
                false => format!("the body has no straight edge all along its {name} side"),
            };
            faults.error(path, message).hint(match is_solid {
                true => "a mirror is a flat side of the box around the body: cut the part in half before it is exported",
                false => "a mirror is a whole side of the box around the body",
            });
            continue;
        };
        if symmetry.at[side].replace(at).is_some() {
            faults.error(path, format!("`{name}` stands twice"));
            continue;
        }
        symmetry.edges.push(edge);
        if is_solid {
            symmetry.goes_on.push(Face { axis: side / 2, is_high: side % 2 == 1, at });
        }
        let path = root("symmetry").index(k);
        symmetry.mirrors.set_line(side, line_on(lattice, sides, (side, at), &path, faults));
    }
    symmetry
}

/// The line between cells on a side of the body at this position; a fault if it is not on a border of cells.
pub(crate) fn line_on(
    lattice: &SquareLattice,
    sides: Sides,
    (side, at): (usize, f64),
    path: &JsonPath,
    faults: &mut Faults,
) -> i32 {
    let range = [lattice.columns(), lattice.rows(), lattice.layers()][side / 2].clone();
    let line = if side.is_multiple_of(2) { range.start } else { range.end };
    let whole = lattice.corner()[side / 2] + f64::from(line) * lattice.spacing();
    if (whole - at).abs() > 1e-6 * lattice.spacing() {
        let holes = match sides {
            Sides::Edges(outline) => holes::that_remove_side(outline, side, lattice.spacing()),
            Sides::Solid(_) => Vec::new(),
        };
        if let [first, more @ ..] = &holes[..] {
            let who = match more {
                [] => format!("{first} takes"),
                _ => format!("{} take", holes.join(" and ")),
            };
            faults
                .error(path.clone(), format!("{who} away all of the {} side", body::SIDES[side]))
                .hint("a side that goes on behind a mirror, or is joined, needs cells: make the hole smaller or the body larger");
            return line;
        }
        faults
            .error(path.clone(), format!("the {} side is not on a border of cells", body::SIDES[side]))
            .hint("make the size of the body a whole multiple of the spacing");
    }
    line
}

/// The edge that is a whole side of the box around a body, and the position of the side.
pub(crate) fn edge_on(outline: &Outline, side: usize) -> Option<(String, f64)> {
    let [low, high] = outline.bounds();
    let axis = side / 2;
    let at = if side.is_multiple_of(2) { low[axis] } else { high[axis] };
    let along = 1 - axis;
    let whole = |e: &&Edge| {
        let ends = [e.from[along].min(e.to[along]), e.from[along].max(e.to[along])];
        e.from[axis] == at && e.to[axis] == at && ends == [low[along], high[along]]
    };
    outline.edges().iter().find(whole).map(|e| (e.name.clone(), at))
}

impl Symmetry {
    /// Cracks with their images, by one reflection along each axis.
    pub(crate) fn with_images(&self, cracks: &[Crack]) -> Vec<Crack> {
        let [left, right, below, above, back, front] = self.at;
        let along = |low: Option<f64>, high: Option<f64>| {
            [None].into_iter().chain([low, high].into_iter().flatten().map(Some)).collect::<Vec<_>>()
        };
        let mut all = Vec::new();
        for crack in cracks {
            for x in along(left, right) {
                for y in along(below, above) {
                    all.extend(along(back, front).into_iter().map(|z| crack.reflected([x, y, z])));
                }
            }
        }
        all
    }

    /// Makes the axis of a body of revolution, which begins there, a mirror. The body may touch it in parts.
    pub(crate) fn add_axis(&mut self, outline: &Outline, lattice: &SquareLattice) {
        let at = outline.bounds()[0][0];
        let on_axis = outline.edges().iter().filter(|e| e.from[0] == at && e.to[0] == at);
        self.axis = on_axis.map(|e| e.name.clone()).collect();
        self.edges.extend(self.axis.iter().cloned());
        self.at[0] = Some(at);
        self.mirrors.set_line(0, lattice.columns().start);
    }

    /// How far the whole body reaches along each axis, from how far its part does: behind a mirror it goes on, and between two, as
    /// where sides are joined, it has no end.
    pub(crate) fn whole(&self, part: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|k| match (self.mirrors.joined[k], self.mirrors.lines[k]) {
            (true, _) | (_, [Some(_), Some(_)]) => f64::INFINITY,
            (_, [None, None]) => part[k],
            _ => 2.0 * part[k],
        })
    }

    /// Whether an edge lies on a mirror.
    pub(crate) fn replaces(&self, edge: &str) -> bool {
        self.edges.iter().any(|e| e == edge)
    }

    /// Whether an edge is joined to the opposite one.
    pub(crate) fn joins(&self, edge: &str) -> bool {
        self.joined.iter().any(|e| e == edge)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turned_rows_have_no_mirrors() {
        let outline = Outline::rectangle([0.0; 2], [20.0, 10.0]).unwrap();
        for (angle, fine) in [(0.0, true), (0.3, false)] {
            let lattice = outline.fill_turned(1.0, angle).unwrap();
            let mut faults = Faults::default();
            let found = symmetry(&["left".into()], Some(Sides::Edges(&outline)), Some(&lattice), &mut faults);
            assert_eq!((faults.has_errors(), found.mirrors.is_none()), (!fine, !fine));
        }
    }
}
