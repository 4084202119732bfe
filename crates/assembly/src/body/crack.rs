//! Cracks: polylines in the plane, and surfaces in space, that cut the bonds they meet.

mod front;
mod surface;

use super::convex::strip;
use super::geometry::{Point, between_segments, in_space, minus};
use super::lattice::{Cell, SquareLattice, plus};
use std::ops::Range;
use thiserror::Error;

pub use front::{FrontPlace, Recess};
pub use surface::{CrackSurface, CrackSurfaceError, Fronts};

/// A bond this close to a crack meets it, in spacings.
pub const CRACK_SLACK: f64 = 1e-6;

/// Why vertices make no crack. Vertices count from one.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CrackError {
    /// Fewer than two vertices.
    #[error("a crack has at least two vertices, found {found}")]
    TooFewVertices {
        /// How many there are.
        found: usize,
    },
    /// A coordinate is infinite or no number.
    #[error("vertex {vertex} of the crack is not finite")]
    NotFinite {
        /// Which vertex.
        vertex: usize,
    },
    /// A vertex is at the place of the next one.
    #[error("vertices {vertex} and {} of the crack are at the same place", .vertex + 1)]
    Repeated {
        /// The first of the two.
        vertex: usize,
    },
}

/// A polyline, or in solids a surface, that cuts bonds.
///
/// One rule decides: a bond is cut if its segment comes within a slack of it, [`CRACK_SLACK`] spacings for a
/// lattice. Ties are therefore cut: bonds through a tip or a bend, bonds that end on the crack or
/// run along it. Whether segments cross is decided by exact predicates, and the slack is far above the rounding of
/// coordinates, so rounding decides nothing. A crack through points cuts all bonds of these points; place it between
/// them. A crack that shall open the border of a body starts a spacing outside it.
///
/// A crack acts some tenths of a spacing longer than the bonds that it cuts so: [`Crack::receded`] is the one that acts as long as this.
#[derive(Clone, Debug, PartialEq)]
pub struct Crack(Shape);

#[derive(Clone, Debug, PartialEq)]
enum Shape {
    Path(Vec<Point>),
    Surface(CrackSurface),
}

impl From<CrackSurface> for Crack {
    fn from(surface: CrackSurface) -> Self {
        Self(Shape::Surface(surface))
    }
}

impl Crack {
    /// The polyline of `vertices`, m.
    ///
    /// # Errors
    /// [`CrackError`].
    pub fn new(vertices: Vec<[f64; 2]>) -> Result<Self, CrackError> {
        if vertices.len() < 2 {
            return Err(CrackError::TooFewVertices { found: vertices.len() });
        }
        if let Some(k) = vertices.iter().position(|v| !v.iter().all(|x| x.is_finite())) {
            return Err(CrackError::NotFinite { vertex: k + 1 });
        }
        match vertices.windows(2).position(|w| w[0] == w[1]) {
            Some(k) => Err(CrackError::Repeated { vertex: k + 1 }),
            None => Ok(Self(Shape::Path(vertices))),
        }
    }

    /// Vertices from end to end, m; a surface has none.
    pub fn vertices(&self) -> &[[f64; 2]] {
        match &self.0 {
            Shape::Path(vertices) => vertices,
            Shape::Surface(_) => &[],
        }
    }

    /// The surface, of a crack in a solid.
    pub fn surface(&self) -> Option<&CrackSurface> {
        match &self.0 {
            Shape::Path(_) => None,
            Shape::Surface(surface) => Some(surface),
        }
    }

    fn segments(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        self.vertices().windows(2).map(|w| [w[0], w[1]])
    }

    /// Whether the bond from `a` to `b` (m) comes within `slack` (m) of the crack: the same for both directions of both.
    pub fn cuts(&self, a: [f64; 3], b: [f64; 3], slack: f64) -> bool {
        let flat = |[x, y, _]: [f64; 3]| [x, y];
        match &self.0 {
            Shape::Path(_) => self.segments().any(|segment| segment_cuts(segment, flat(a), flat(b), slack)),
            Shape::Surface(surface) => surface.cuts(a, b, slack),
        }
    }

    /// The same moved by a vector, m.
    #[must_use]
    pub fn shifted(&self, by: [f64; 3]) -> Self {
        Self(match &self.0 {
            Shape::Path(path) => Shape::Path(path.iter().map(|v| [v[0] + by[0], v[1] + by[1]]).collect()),
            Shape::Surface(surface) => Shape::Surface(surface.shifted(by)),
        })
    }

    /// Its image in lines or planes across the axes, at these positions, m.
    #[must_use]
    pub fn reflected(&self, at: [Option<f64>; 3]) -> Self {
        let image = |v: &Point| [0, 1].map(|k| at[k].map_or(v[k], |line| 2.0 * line - v[k]));
        Self(match &self.0 {
            Shape::Path(path) => Shape::Path(path.iter().map(image).collect()),
            Shape::Surface(surface) => Shape::Surface(surface.reflected(at)),
        })
    }
}

fn segment_cuts([c, d]: [Point; 2], a: Point, b: Point, slack: f64) -> bool {
    let apart = |k: usize| a[k].max(b[k]) + slack < c[k].min(d[k]) || c[k].max(d[k]) + slack < a[k].min(b[k]);
    if apart(0) || apart(1) {
        return false;
    }
    // One order of the ends, so that rounding is the same in either direction.
    let ordered = |p: Point, q: Point| if p <= q { (p, q) } else { (q, p) };
    let ((a, b), (c, d)) = (ordered(a, b), ordered(c, d));
    between_segments(a, b, c, d) <= slack
}

/// The bonds of a lattice that cracks cut: for each the number of its class in `steps` and its point at the near end, from
/// which the step leads to the other; sorted, each bond once. Only points near the cracks are visited.
///
/// `steps` holds each pair of opposite offsets once. A coarser lattice is cut by the same cracks.
pub fn cut_bonds(lattice: &SquareLattice, steps: &[Cell], cracks: &[Crack]) -> Vec<(usize, usize)> {
    let slack = CRACK_SLACK * lattice.spacing();
    let mut found = Vec::new();
    for segment in cracks.iter().flat_map(Crack::segments) {
        for (class, &step) in steps.iter().enumerate() {
            near(lattice, segment, step, |row, columns| {
                for run in lattice.runs_of(row, 0) {
                    let own = columns.start.max(run.columns.start)..columns.end.min(run.columns.end);
                    lattice.shifted(run.line(), &own, step, |columns, _| {
                        let ends = |i| [run.cell(i), plus(run.cell(i), step)].map(|c| lattice.place_of(c));
                        let cut = columns.filter(|&i| {
                            let [a, b] = ends(i);
                            segment_cuts(segment, a, b, slack)
                        });
                        found.extend(cut.map(|i| (class, run.number(i))));
                    });
                }
            });
        }
    }
    for surface in cracks.iter().filter_map(Crack::surface) {
        for bounds in surface.boxes() {
            cut_by(lattice, steps, (surface, bounds), &mut found);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}

/// Adds the bonds that a surface cuts and that reach into a box around a part of it.
fn cut_by(
    lattice: &SquareLattice,
    steps: &[Cell],
    (surface, [low, high]): (&CrackSurface, [[f64; 3]; 2]),
    found: &mut Vec<(usize, usize)>,
) {
    let (spacing, corner) = (lattice.spacing(), lattice.corner());
    let slack = CRACK_SLACK * spacing;
    let reach = steps.iter().flatten().map(|k| k.abs()).max().unwrap_or(0);
    let ends = [(low, -1), (high, 1)].map(|(at, side)| {
        [0, 1, 2]
            .map(|k| ((at[k] - corner[k]) / spacing).clamp(-1e9, 1e9).floor() as i32 + side * (reach + 1))
    });
    let within = |own: Range<i32>, k: usize| own.start.max(ends[0][k])..own.end.min(ends[1][k] + 1);
    for layer in within(lattice.layers(), 2) {
        for row in within(lattice.rows(), 1) {
            for run in lattice.runs_of(row, layer) {
                for column in within(run.columns.clone(), 0) {
                    let (lower, cell) = (run.number(column), run.cell(column));
                    let from = lattice.centre(cell);
                    for (class, step) in steps.iter().enumerate() {
                        let upper = plus(cell, *step);
                        if surface.cuts(from, lattice.centre(upper), slack) && lattice.number(upper).is_some()
                        {
                            found.push((class, lower));
                        }
                    }
                }
            }
        }
    }
}

/// Columns per row from which a step may meet a segment: those of the parallelogram that the segment sweeps backwards
/// along the step.
fn near(lattice: &SquareLattice, segment: [Point; 2], step: Cell, mut visit: impl FnMut(i32, Range<i32>)) {
    // Cells far more than the slack, so that no rounding matters.
    const MARGIN: f64 = 1e-3;
    let [a, b] = segment.map(|p| lattice.in_cells(p).map(|x| x - 0.5));
    let step = [step[0], step[1]].map(f64::from);
    let swept = [a, b, minus(b, step), minus(a, step)];
    let heights = swept.map(|p| p[1]);
    let rows = lattice.rows();
    let from = heights.iter().fold(f64::INFINITY, |m, y| m.min(*y)) - MARGIN;
    let to = heights.iter().fold(f64::NEG_INFINITY, |m, y| m.max(*y)) + MARGIN;
    for row in rows.start.max(from.ceil() as i32)..rows.end.min(((to.floor()) as i32).saturating_add(1)) {
        let y = f64::from(row);
        if let Some([from, to]) = strip(&swept, [y - MARGIN, y + MARGIN]) {
            visit(row, (from - MARGIN).ceil() as i32..((to + MARGIN).floor() as i32).saturating_add(1));
        }
    }
}

/// The listed bonds that cracks cut, as their numbers in `pairs`; `slack` is a distance, m.
pub fn cut_pairs(
    positions: &[[f64; 2]],
    pairs: impl IntoIterator<Item = [u32; 2]>,
    slack: f64,
    cracks: &[Crack],
) -> Vec<usize> {
    let cut = |[i, j]: [u32; 2]| {
        let [a, b] = [i, j].map(|p| in_space(positions[p as usize]));
        cracks.iter().any(|c| c.cuts(a, b, slack))
    };
    pairs.into_iter().enumerate().filter_map(|(k, pair)| cut(pair).then_some(k)).collect()
}

#[cfg(test)]
mod tests;
