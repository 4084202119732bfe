//! Surfaces that cut the bonds of solids: discs, rings, plane polygons and triangles.

mod edge;
mod fronts;
mod grown;

use super::super::geometry::{Point, between_segments, distance, to_segment};
use super::super::polygon::{Polygon, PolygonError};
use edge::{Edge, border_edges};
use nalgebra::Vector3;
use thiserror::Error;

pub use fronts::Fronts;

/// How far the corners of a polygon may lie off its plane, over its size.
const FLAT: f64 = 1e-6;

/// Why something is no surface of a crack. Corners count from one.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum CrackSurfaceError {
    /// A direction without length, or one that is not finite.
    #[error("the normal of the disc has no direction")]
    NoNormal,
    /// A radius that is none.
    #[error("the radius must be a number above zero, and the inner one between zero and it")]
    NoRadius,
    /// Corners on one line, or fewer than three.
    #[error("these corners make no polygon with an area")]
    NoArea,
    /// A corner off the plane of the others.
    #[error("corner {corner} lies off the plane of the others")]
    NotFlat {
        /// Which corner.
        corner: usize,
    },
    /// Corners that make no polygon in their plane.
    #[error("{0}")]
    Polygon(#[from] PolygonError),
    /// A coordinate is infinite or no number.
    #[error("coordinates must be finite")]
    NotFinite,
}

/// A surface that cuts bonds, of plane pieces.
#[derive(Clone, Debug, PartialEq)]
pub struct CrackSurface {
    pieces: Vec<Piece>,
    /// Straight edges of one piece alone.
    border: Vec<Edge>,
    /// Parts of its border next to which it cuts nothing, and how far from them, m.
    spared: Vec<Edge>,
    recess: f64,
}

/// A plane part of a surface.
#[derive(Clone, Debug, PartialEq)]
struct Piece {
    /// Its origin, m, two directions in it and its normal.
    origin: Vector3<f64>,
    axes: [Vector3<f64>; 3],
    shape: Flat,
    /// Corners of the box around it, m.
    bounds: [[f64; 3]; 2],
}

/// What a piece is in its plane.
#[derive(Clone, Debug, PartialEq)]
enum Flat {
    /// Around the origin.
    Ring {
        inner: f64,
        outer: f64,
    },
    Polygon(Polygon),
}

impl CrackSurface {
    /// A disc of a centre, m, a normal of any length and a radius, m; with an inner radius above zero a ring.
    ///
    /// # Errors
    /// [`CrackSurfaceError::NoNormal`], [`CrackSurfaceError::NoRadius`], [`CrackSurfaceError::NotFinite`].
    pub fn disc(
        centre: [f64; 3],
        normal: [f64; 3],
        [inner, outer]: [f64; 2],
    ) -> Result<Self, CrackSurfaceError> {
        if !centre.iter().all(|x| x.is_finite()) {
            return Err(CrackSurfaceError::NotFinite);
        }
        if !(outer.is_finite() && 0.0 <= inner && inner < outer) {
            return Err(CrackSurfaceError::NoRadius);
        }
        let normal = unit(normal.into()).ok_or(CrackSurfaceError::NoNormal)?;
        // Across the axis that the normal is farthest from.
        let first = normal.cross(&Vector3::ith(normal.iamin(), 1.0)).normalize();
        let half = normal.map(|n| outer * (1.0 - n * n).max(0.0).sqrt());
        let bounds = [-1.0, 1.0].map(|sign| [0, 1, 2].map(|k| centre[k] + sign * half[k]));
        let axes = [first, normal.cross(&first), normal];
        let shape = Flat::Ring { inner, outer };
        Ok(Self::of(vec![Piece { origin: centre.into(), axes, shape, bounds }], Vec::new()))
    }

    /// A polygon of three corners or more, m, in a plane.
    ///
    /// # Errors
    /// [`CrackSurfaceError`], but those of discs.
    pub fn polygon(corners: &[[f64; 3]]) -> Result<Self, CrackSurfaceError> {
        Ok(Self::of(vec![Piece::polygon(corners)?], border_edges(&[corners.to_vec()])))
    }

    /// Triangles, m; those without an area are left out.
    ///
    /// # Errors
    /// [`CrackSurfaceError::NoArea`] if none is left, [`CrackSurfaceError::NotFinite`].
    pub fn triangles(all: impl IntoIterator<Item = [[f64; 3]; 3]>) -> Result<Self, CrackSurfaceError> {
        let (mut pieces, mut outlines) = (Vec::new(), Vec::new());
        for corners in all {
            match Piece::polygon(&corners) {
                Ok(piece) => {
                    pieces.push(piece);
                    outlines.push(corners.to_vec());
                }
                Err(CrackSurfaceError::NotFinite) => return Err(CrackSurfaceError::NotFinite),
                Err(_) => {}
            }
        }
        if pieces.is_empty() {
            return Err(CrackSurfaceError::NoArea);
        }
        Ok(Self::of(pieces, border_edges(&outlines)))
    }

    fn of(pieces: Vec<Piece>, border: Vec<Edge>) -> Self {
        Self { pieces, border, spared: Vec::new(), recess: 0.0 }
    }

    /// Whether the bond from `a` to `b` (m) comes within `slack` (m) of the surface, where that is not spared: the same for both directions.
    pub fn cuts(&self, a: [f64; 3], b: [f64; 3], slack: f64) -> bool {
        let is_behind_front =
            |at: Vector3<f64>| self.spared.iter().all(|edge| edge.distance(at) >= self.recess - slack);
        self.pieces.iter().any(|piece| piece.meets(a, b, slack, &is_behind_front))
    }

    /// Lower and upper corners of the boxes around its pieces, m.
    pub fn boxes(&self) -> impl Iterator<Item = [[f64; 3]; 2]> + '_ {
        self.pieces.iter().map(|piece| piece.bounds)
    }

    /// The same moved by a vector, m.
    #[must_use]
    pub fn shifted(&self, by: [f64; 3]) -> Self {
        self.mapped(&|at| [0, 1, 2].map(|k| at[k] + by[k]), [1.0; 3])
    }

    /// Its image in planes across the axes, at these positions, m.
    #[must_use]
    pub fn reflected(&self, planes: [Option<f64>; 3]) -> Self {
        let place = |at: [f64; 3]| [0, 1, 2].map(|k| planes[k].map_or(at[k], |plane| 2.0 * plane - at[k]));
        self.mapped(&place, planes.map(|at| if at.is_some() { -1.0 } else { 1.0 }))
    }

    /// The same with its places moved and its directions multiplied along the axes.
    fn mapped(&self, place: &dyn Fn([f64; 3]) -> [f64; 3], signs: [f64; 3]) -> Self {
        let of = |piece: &Piece| {
            let ends = piece.bounds.map(place);
            let pick = |best: fn(f64, f64) -> f64| [0, 1, 2].map(|k| best(ends[0][k], ends[1][k]));
            Piece {
                origin: place(piece.origin.into()).into(),
                axes: piece.axes.map(|axis| axis.component_mul(&Vector3::from(signs))),
                shape: piece.shape.clone(),
                bounds: [pick(f64::min), pick(f64::max)],
            }
        };
        let at = |v: Vector3<f64>| Vector3::from(place(v.into()));
        let direction = |v: Vector3<f64>| v.component_mul(&Vector3::from(signs));
        Self {
            pieces: self.pieces.iter().map(of).collect(),
            border: self.border.iter().map(|edge| edge.mapped(&at, &direction)).collect(),
            spared: self.spared.iter().map(|edge| edge.mapped(&at, &direction)).collect(),
            recess: self.recess,
        }
    }
}

impl Piece {
    fn polygon(corners: &[[f64; 3]]) -> Result<Self, CrackSurfaceError> {
        let Some(&origin) = corners.first() else { return Err(CrackSurfaceError::NoArea) };
        if !corners.iter().flatten().all(|x| x.is_finite()) {
            return Err(CrackSurfaceError::NotFinite);
        }
        let origin = Vector3::from(origin);
        let arms: Vec<Vector3<f64>> = corners.iter().map(|corner| Vector3::from(*corner) - origin).collect();
        let area: Vector3<f64> = arms.windows(2).map(|pair| pair[0].cross(&pair[1])).sum();
        let size = arms.iter().map(|arm| arm.norm()).fold(0.0, f64::max);
        let normal = unit(area).filter(|_| area.norm() > FLAT * size * size);
        let normal = normal.ok_or(CrackSurfaceError::NoArea)?;
        if let Some(k) = arms.iter().position(|arm| arm.dot(&normal).abs() > FLAT * size) {
            return Err(CrackSurfaceError::NotFlat { corner: k + 1 });
        }
        let along = arms.iter().copied().find_map(unit).ok_or(CrackSurfaceError::NoArea)?;
        let first = (along - normal * along.dot(&normal)).normalize();
        let axes = [first, normal.cross(&first), normal];
        let flat = arms.iter().map(|arm| [arm.dot(&axes[0]), arm.dot(&axes[1])]).collect();
        let pick = |best: fn(f64, f64) -> f64| {
            [0, 1, 2].map(|k| corners.iter().map(|corner| corner[k]).reduce(best).unwrap_or(origin[k]))
        };
        let bounds = [pick(f64::min), pick(f64::max)];
        Ok(Self { origin, axes, shape: Flat::Polygon(Polygon::new(flat)?), bounds })
    }

    /// Whether the bond from `a` to `b` comes within a slack of it, at a place that counts.
    fn meets(&self, a: [f64; 3], b: [f64; 3], slack: f64, counts: &dyn Fn(Vector3<f64>) -> bool) -> bool {
        let [low, high] = self.bounds;
        let apart = |k: usize| a[k].max(b[k]) + slack < low[k] || high[k] + slack < a[k].min(b[k]);
        if (0..3).any(apart) {
            return false;
        }
        // One order of the ends, so that rounding is the same in either direction.
        let (a, b) = if a <= b { (a, b) } else { (b, a) };
        let [from, to] =
            [a, b].map(|end| self.axes.map(|axis| axis.dot(&(Vector3::from(end) - self.origin))));
        let heights = [from[2], to[2]];
        if heights.iter().all(|z| z.abs() <= slack) {
            let ends = [[from[0], from[1]], [to[0], to[1]]];
            let nearest = self.shape.meets(ends[0], ends[1], slack);
            return nearest && ends.iter().any(|end| counts(self.place(*end)));
        }
        let beside = heights[0] * heights[1] > 0.0;
        let nearest = if heights[0].abs() < heights[1].abs() { 0.0 } else { 1.0 };
        if beside && heights[0].abs().min(heights[1].abs()) > slack {
            return false;
        }
        let share = if beside { nearest } else { heights[0] / (heights[0] - heights[1]) };
        let at = [0, 1].map(|k| from[k] + share * (to[k] - from[k]));
        self.shape.holds(at, slack) && counts(self.place(at))
    }

    /// A place of its plane in space, m.
    fn place(&self, at: Point) -> Vector3<f64> {
        self.origin + self.axes[0] * at[0] + self.axes[1] * at[1]
    }
}

impl Flat {
    /// Whether a place of its plane is within a slack of it.
    fn holds(&self, at: Point, slack: f64) -> bool {
        match self {
            Self::Ring { inner, outer } => (inner - slack..=outer + slack).contains(&at[0].hypot(at[1])),
            Self::Polygon(polygon) => {
                polygon.contains(at) || polygon.edges().any(|[a, b]| to_segment(at, a, b) <= slack)
            }
        }
    }

    /// Whether a piece of a line in its plane is within a slack of it.
    fn meets(&self, from: Point, to: Point, slack: f64) -> bool {
        match self {
            Self::Ring { inner, outer } => {
                let farthest = distance(from, [0.0; 2]).max(distance(to, [0.0; 2]));
                to_segment([0.0; 2], from, to) <= outer + slack && farthest >= inner - slack
            }
            Self::Polygon(polygon) => {
                polygon.contains(from)
                    || polygon.contains(to)
                    || polygon.edges().any(|[a, b]| between_segments(from, to, a, b) <= slack)
            }
        }
    }
}

fn unit(a: Vector3<f64>) -> Option<Vector3<f64>> {
    a.try_normalize(0.0).filter(|a| a.iter().all(|x| x.is_finite()))
}
