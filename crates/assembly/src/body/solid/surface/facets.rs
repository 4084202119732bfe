//! Triangles of a surface.

use super::closed::{self, SurfaceError};
use std::collections::HashMap;

/// A triangle of a surface; seen from outside of the body its corners run counter-clockwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// Its corners, m.
    pub corners: [[f64; 3]; 3],
    /// Which of the names of the surface it has.
    pub name: Option<u32>,
}

/// A closed surface around a body. Its triangles meet at corners of the same coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Surface {
    pub(super) facets: Vec<Facet>,
    pub(super) names: Vec<String>,
    low: [f64; 3],
    high: [f64; 3],
    /// Triangles that had no area.
    flat: usize,
}

impl Surface {
    /// A surface of triangles and the names that they have.
    ///
    /// Triangles without area are passed over: they bound nothing.
    ///
    /// # Errors
    /// [`SurfaceError`]: it is none, not closed, inside out, or some of it looks the other way.
    pub fn new(facets: Vec<Facet>, names: Vec<String>) -> Result<Self, SurfaceError> {
        closed::finite(&facets)?;
        let mut points = HashMap::new();
        let mut number = |corner: [f64; 3]| {
            let next = points.len() as u32;
            // Both zeros are the same place.
            *points.entry(corner.map(|x| (x + 0.0).to_bits())).or_insert(next)
        };
        let numbered: Vec<[u32; 3]> = facets.iter().map(|facet| facet.corners.map(&mut number)).collect();
        closed::check(&facets, &numbered)?;
        let all = || facets.iter().flat_map(|facet| facet.corners);
        let fold = |start: f64, of: fn(f64, f64) -> f64| {
            [0, 1, 2].map(|k| all().map(|corner| corner[k]).fold(start, of))
        };
        let (low, high) = (fold(f64::INFINITY, f64::min), fold(f64::NEG_INFINITY, f64::max));
        let count = facets.len();
        let facets: Vec<Facet> = facets.into_iter().filter(|facet| facet.area() > 0.0).collect();
        let surface = Self { flat: count - facets.len(), facets, names, low, high };
        let size: f64 = (0..3).map(|k| high[k] - low[k]).product();
        match surface.volume() {
            volume if volume.abs() <= 1e-12 * size || size <= 0.0 => Err(SurfaceError::Flat),
            volume if volume < 0.0 => Err(SurfaceError::InsideOut),
            _ => Ok(surface),
        }
    }

    /// Number of its triangles that have an area.
    pub fn triangles(&self) -> usize {
        self.facets.len()
    }

    /// Number of triangles that were given and had no area.
    pub fn without_area(&self) -> usize {
        self.flat
    }

    /// Lowest and highest corner of the box around it, m.
    pub fn bounds(&self) -> [[f64; 3]; 2] {
        [self.low, self.high]
    }

    /// Volume inside, m³; where shells overlap it counts as often as they do.
    pub fn volume(&self) -> f64 {
        let middle = [0, 1, 2].map(|k| 0.5 * (self.low[k] + self.high[k]));
        let part = |facet: &Facet| {
            let [a, b, c] = facet.corners.map(|corner| minus(corner, middle));
            dot(a, cross(b, c)) / 6.0
        };
        self.facets.iter().map(part).sum()
    }

    /// Positions are the same within this length, m: rounding of coordinates, which files may hold in single precision.
    pub(super) fn rounding(&self) -> f64 {
        let largest = self.low.iter().chain(&self.high).fold(0.0_f64, |most, x| most.max(x.abs()));
        2.0 * f64::from(f32::EPSILON) * largest
    }
}

impl Facet {
    /// Its area as a vector along its outward normal, m².
    pub(super) fn area_vector(&self) -> [f64; 3] {
        let [a, b, c] = self.corners;
        cross(minus(b, a), minus(c, a)).map(|x| 0.5 * x)
    }

    /// Its area, m².
    pub(super) fn area(&self) -> f64 {
        norm(self.area_vector())
    }

    /// Its outward unit normal.
    pub(super) fn normal(&self) -> [f64; 3] {
        let area = self.area_vector();
        let length = norm(area);
        area.map(|x| x / length)
    }

    /// Its lowest and highest coordinates along an axis, m.
    pub(super) fn range(&self, axis: usize) -> [f64; 2] {
        let [a, b, c] = self.corners.map(|corner| corner[axis]);
        [a.min(b).min(c), a.max(b).max(c)]
    }
}

pub(super) fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|k| a[k] - b[k])
}

pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|k| a[k] * b[k]).sum()
}

pub(super) fn norm(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
