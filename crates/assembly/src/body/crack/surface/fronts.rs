//! Where surfaces end within a body: parts of rims and of straight edges.

use super::super::front::{FrontPlace, Recess};
use super::edge::Edge;
use super::{CrackSurface, Flat, Piece};
use nalgebra::Vector3;
use std::f64::consts::TAU;

/// The fronts of a surface.
#[derive(Clone, Debug)]
pub struct Fronts {
    /// The rims of a disc or ring.
    rims: Vec<Rim>,
    edges: Vec<Edge>,
}

/// A rim of a disc or ring.
#[derive(Clone, Copy, Debug)]
struct Rim {
    /// Its centre, m, and directions of length one, the last one across its plane.
    centre: Vector3<f64>,
    axes: [Vector3<f64>; 3],
    /// Its radius, m.
    radius: f64,
    /// 1, or −1 if the crack lies around it.
    side: f64,
}

impl CrackSurface {
    /// Parts of its border beyond which a body goes on.
    pub fn fronts(&self, recess: &Recess) -> Fronts {
        let rims = self.pieces.iter().flat_map(Piece::rims).filter(|rim| rim.is_front(recess)).collect();
        let edges = self.border.iter().flat_map(|edge| edge.fronts(recess)).collect();
        Fronts { rims, edges }
    }

    /// The same with its fronts so far back; a ring or disc that would be lost stays.
    pub(in super::super) fn receded(&self, recess: &Recess) -> Self {
        let fronts = self.fronts(recess);
        let [Piece { origin, axes, shape: Flat::Ring { inner, outer }, .. }] = self.pieces[..] else {
            return Self { spared: fronts.edges, recess: recess.by, ..self.clone() };
        };
        let mut radii = [inner, outer];
        for rim in fronts.rims {
            radii[if rim.side < 0.0 { 0 } else { 1 }] -= rim.side * recess.by;
        }
        Self::disc(origin.into(), axes[2].into(), radii).unwrap_or_else(|_| self.clone())
    }
}

impl Fronts {
    /// The place that is nearest to some place, m; none without fronts, or on the axis of a disc.
    pub fn near(&self, place: [f64; 3]) -> Option<FrontPlace> {
        let place = Vector3::from(place);
        let of_rims = self.rims.iter().filter_map(|rim| rim.place_near(place));
        let of_edges = self.edges.iter().map(|edge| edge.place_near(place));
        let far = |found: &FrontPlace| (Vector3::from(found.at) - place).norm();
        of_rims.chain(of_edges).min_by(|a, b| far(a).total_cmp(&far(b)))
    }
}

impl Piece {
    fn rims(&self) -> Vec<Rim> {
        let Flat::Ring { inner, outer } = self.shape else { return Vec::new() };
        let rim = |radius: f64, side: f64| Rim { centre: self.origin, axes: self.axes, radius, side };
        let inside = (inner > 0.0).then(|| rim(inner, -1.0));
        inside.into_iter().chain([rim(outer, 1.0)]).collect()
    }
}

impl Rim {
    /// Whether the body goes on somewhere beyond it.
    fn is_front(&self, recess: &Recess) -> bool {
        /// Most places that are looked at.
        const PLACES: f64 = 1e6;
        let count = (TAU * self.radius / recess.step).ceil().clamp(16.0, PLACES);
        (0..count as u32).any(|k| {
            let angle = TAU * (f64::from(k) + 0.5) / count;
            let away = self.axes[0] * angle.cos() + self.axes[1] * angle.sin();
            (recess.goes_on)((self.centre + away * self.radius).into(), (away * self.side).into())
        })
    }

    /// The place on it that is nearest to some place, m.
    fn place_near(&self, place: Vector3<f64>) -> Option<FrontPlace> {
        let arm = place - self.centre;
        let away = (arm - self.axes[2] * arm.dot(&self.axes[2])).try_normalize(0.0)?;
        Some(FrontPlace {
            at: (self.centre + away * self.radius).into(),
            ahead: (away * self.side).into(),
            normal: self.axes[2].into(),
        })
    }
}
