//! Outlines of bodies: a polygon with holes and named edges.

use super::geometry::to_segment;
use super::hole::{Hole, HoleError, Shape};
use super::named::BorderGroup;
use super::polygon::{Polygon, PolygonError};
use super::turn::Turn;
use thiserror::Error;

/// Sine of the angle by which the chords of a curve turn at most.
const SMOOTH: f64 = 0.2;

/// A straight edge of an outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Edge {
    /// `left`, `right`, `bottom`, `top` of a rectangle; `edge_1`, … of a polygon, from vertex 1 to vertex 2, ….
    pub name: String,
    /// First end, m.
    pub from: [f64; 2],
    /// Second end, m.
    pub to: [f64; 2],
    /// Unit normal that points out of the body.
    pub normal: [f64; 2],
    /// Whether it is one of several chords of a curve, which are named together.
    pub is_chord: bool,
}

impl Edge {
    /// Distance of a position, m.
    pub fn distance(&self, position: [f64; 2]) -> f64 {
        to_segment(position, self.from, self.to)
    }
}

/// Why a rectangle or polygon is no outline.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum OutlineError {
    /// A size of a rectangle is not above zero.
    #[error("the {} of a rectangle must be above zero, found {found}", ["width", "height"][*.axis])]
    Size {
        /// 0 along x, 1 along y.
        axis: usize,
        /// What was given.
        found: f64,
    },
    /// The place of a rectangle is infinite or no number.
    #[error("the corner of a rectangle must be finite")]
    Corner,
    /// The vertices are not those of a simple polygon.
    #[error(transparent)]
    Polygon(#[from] PolygonError),
}

/// A simple polygon with holes, in the plane. Borders belong to the body. Holes may overlap each other and the outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    polygon: Polygon,
    edges: Vec<Edge>,
    holes: Vec<Hole>,
    pub(super) groups: Vec<BorderGroup>,
    rectangle: bool,
}

impl Outline {
    /// A rectangle with edges `bottom`, `right`, `top`, `left`; lower left corner and size in m.
    ///
    /// # Errors
    /// [`OutlineError::Size`] and [`OutlineError::Corner`].
    pub fn rectangle(from: [f64; 2], size: [f64; 2]) -> Result<Self, OutlineError> {
        if let Some(axis) = (0..2).find(|&k| !(size[k] > 0.0 && size[k].is_finite())) {
            return Err(OutlineError::Size { axis, found: size[axis] });
        }
        let to = [from[0] + size[0], from[1] + size[1]];
        if !(from.iter().chain(&to).all(|x| x.is_finite())) {
            return Err(OutlineError::Corner);
        }
        let polygon = Polygon::new(vec![from, [to[0], from[1]], to, [from[0], to[1]]])?;
        let names = ["bottom", "right", "top", "left"].map(String::from);
        let edges = edges(&polygon, names.map(|name| (name, false)));
        Ok(Self { edges, polygon, holes: Vec::new(), groups: Vec::new(), rectangle: true })
    }

    /// A polygon with edges `edge_1`, …; edge `k` goes from vertex `k` to the next one, vertices count from one.
    ///
    /// # Errors
    /// [`OutlineError::Polygon`].
    pub fn polygon(vertices: Vec<[f64; 2]>) -> Result<Self, OutlineError> {
        let sides = vec![1; vertices.len()];
        Self::curved(vertices, &sides)
    }

    /// A polygon of sides `edge_1`, … of so many edges each; several are the chords of a curve, which are named together.
    ///
    /// # Errors
    /// [`OutlineError::Polygon`].
    pub fn curved(vertices: Vec<[f64; 2]>, sides: &[usize]) -> Result<Self, OutlineError> {
        let polygon = Polygon::new(vertices)?;
        let name = |(k, &chords): (usize, &usize)| {
            let of_chord = move |j: usize| (format!("edge_{}.{}", k + 1, j + 1), true);
            let chord = move |j| if chords == 1 { (format!("edge_{}", k + 1), false) } else { of_chord(j) };
            (0..chords).map(chord)
        };
        let edges = edges(&polygon, sides.iter().enumerate().flat_map(name));
        let groups = BorderGroup::of_curves(sides);
        Ok(Self { edges, polygon, holes: Vec::new(), groups, rectangle: false })
    }

    /// Cuts a hole.
    ///
    /// # Errors
    /// [`HoleError`]; the outline stays as it was.
    pub fn cut(&mut self, hole: Hole) -> Result<(), HoleError> {
        hole.shape.check()?;
        let is_taken = |name: &&str| self.members(name).is_some();
        if let Some(name) = hole.name.as_deref().filter(is_taken) {
            return Err(HoleError::SameName { name: name.into() });
        }
        if !hole.shape.meets(&self.polygon) {
            return Err(HoleError::Outside);
        }
        self.holes.push(hole);
        Ok(())
    }

    /// The same outline in other axes, where a rectangle is none along them.
    pub(super) fn seen_from(&self, axes: &Turn) -> Self {
        let polygon = self.polygon.seen_from(axes);
        let holes = self.holes.iter().map(|h| Hole { name: h.name.clone(), shape: h.shape.seen_from(axes) });
        Self {
            edges: edges(&polygon, self.edges.iter().map(|e| (e.name.clone(), e.is_chord))),
            holes: holes.collect(),
            groups: self.groups.clone(),
            polygon,
            rectangle: false,
        }
    }

    /// Straight edges; where a hole crosses one, it still has its whole length.
    pub fn edges(&self) -> &[Edge] {
        &self.edges
    }

    /// The edge of a name.
    pub fn edge(&self, name: &str) -> Option<&Edge> {
        self.edges.iter().find(|e| e.name == name)
    }

    /// Holes in the order in which they were cut.
    pub fn holes(&self) -> &[Hole] {
        &self.holes
    }

    /// The hole of a name.
    pub fn hole(&self, name: &str) -> Option<&Hole> {
        self.holes.iter().find(|h| h.name.as_deref() == Some(name))
    }

    /// Its border without the holes.
    pub fn border(&self) -> &Polygon {
        &self.polygon
    }

    /// Whether it was made as a rectangle.
    pub fn is_rectangle(&self) -> bool {
        self.rectangle
    }

    /// Lower left and upper right corner of the box around it, m.
    pub fn bounds(&self) -> [[f64; 2]; 2] {
        self.polygon.bounds()
    }

    /// Whether a position is in the body, borders included.
    pub fn contains(&self, position: [f64; 2]) -> bool {
        self.polygon.contains(position) && !self.holes.iter().any(|h| h.shape.removes(position))
    }

    /// Whether its border has a corner that turns into the body, by more than chords of a curve do.
    pub fn turns_inward(&self) -> bool {
        let of_holes = self.holes.iter().filter_map(|hole| match &hole.shape {
            Shape::Polygon(polygon) => Some(polygon),
            _ => None,
        });
        self.polygon.turns().any(|sine| sine < -SMOOTH)
            || of_holes.into_iter().any(|hole| hole.turns().any(|sine| sine > SMOOTH))
    }

    /// Whether a position is no farther from its border than a distance, m.
    pub fn borders(&self, position: [f64; 2], within: f64) -> bool {
        let is_on = |hole: &Hole| hole.shape.distance(position) <= within && self.polygon.contains(position);
        self.edges.iter().any(|edge| edge.distance(position) <= within) || self.holes.iter().any(is_on)
    }
}

fn edges(polygon: &Polygon, names: impl IntoIterator<Item = (String, bool)>) -> Vec<Edge> {
    let named = names.into_iter().enumerate();
    named
        .map(|(k, (name, is_chord))| {
            let [from, to] = polygon.edge(k);
            Edge { name, from, to, normal: polygon.normal(k), is_chord }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_turn_into_the_body_and_curves_do_not() {
        let around = |radius: f64, from: f64, to: f64| {
            let at = move |k: u32| (from + (to - from) * f64::from(k) / 64.0).sin_cos();
            (0..=64).map(at).map(move |(sin, cos)| [radius * cos, radius * sin])
        };
        let turns = |vertices: Vec<[f64; 2]>| Outline::polygon(vertices).unwrap().turns_inward();
        let corner = vec![[-1.0, 0.0], [0.0, 0.0], [0.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let backwards = corner.iter().rev().copied().collect();
        assert!(turns(corner) && turns(backwards));
        let half = std::f64::consts::PI;
        assert!(!turns(around(2.0, 0.0, half).chain(around(1.0, half, 0.0)).collect()));
        let mut plate = Outline::rectangle([0.0; 2], [4.0, 4.0]).unwrap();
        assert!(!plate.turns_inward());
        plate.cut(Hole { name: None, shape: Shape::Circle { centre: [2.0; 2], radius: 0.5 } }).unwrap();
        assert!(!plate.turns_inward());
        let square = Polygon::new(vec![[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0]]).unwrap();
        plate.cut(Hole { name: None, shape: Shape::Polygon(square) }).unwrap();
        assert!(plate.turns_inward());
    }
}
