//! Fronts of discs and rings: their rim, of a ring the inner one.

use super::super::front::{FrontPlace, Recess};
use super::edge::{self, Edge};
use super::{CrackSurface, Flat, Piece};
use nalgebra::Vector3;
use std::f64::consts::TAU;

impl CrackSurface {
    /// Radius of the front of a disc or ring, m; none of other surfaces.
    pub fn front_radius(&self) -> Option<f64> {
        let [Piece { shape: Flat::Ring { inner, outer }, .. }] = self.pieces[..] else { return None };
        Some(if inner > 0.0 { inner } else { outer })
    }

    /// A disc with its front moved outwards by a length, m, or a ring with its inner one moved inwards; none of other surfaces, or where
    /// nothing would be left.
    pub fn grown(&self, by: f64) -> Option<Self> {
        let [Piece { shape: Flat::Ring { inner, outer }, .. }] = self.pieces[..] else { return None };
        let radii = if inner > 0.0 { [inner - by, outer] } else { [0.0, outer + by] };
        let piece = &self.pieces[0];
        let fine = radii[0] > 0.0 || inner == 0.0;
        fine.then(|| Self::disc(piece.origin.into(), piece.axes[2].into(), radii).ok()).flatten()
    }

    /// The same with its front, as far as the body goes on beyond it, so far back; a ring or disc that would be lost stays.
    pub(in super::super) fn receded(&self, recess: &Recess) -> Self {
        if let [piece @ Piece { shape: Flat::Ring { inner, outer }, .. }] = &self.pieces[..] {
            let goes_on = |radius: f64, side: f64| piece.is_front(radius, side, recess);
            let inwards = if *inner > 0.0 && goes_on(*inner, -1.0) { recess.by } else { 0.0 };
            let outwards = if goes_on(*outer, 1.0) { recess.by } else { 0.0 };
            let radii = [inner + inwards, outer - outwards];
            let receded = Self::disc(piece.origin.into(), piece.axes[2].into(), radii);
            return receded.unwrap_or_else(|_| self.clone());
        }
        let spared = self.open.iter().flat_map(|edge| edge.fronts(recess)).collect();
        Self { spared, recess: recess.by, ..self.clone() }
    }

    /// The place of its front that is nearest to some place, m; none on the axis of a disc.
    pub fn front_near(&self, place: [f64; 3]) -> Option<FrontPlace> {
        if let [piece @ Piece { shape: Flat::Ring { inner, outer }, .. }] = &self.pieces[..] {
            return piece.rim_near([*inner, *outer], place.into());
        }
        let far = |edge: &&Edge| edge::distance(place.into(), &edge.ends);
        let nearest = self.open.iter().min_by(|a, b| far(a).total_cmp(&far(b)))?;
        Some(nearest.place_near(place.into()))
    }

    /// Places of a disc or ring a length, m, behind its front, in eight directions, and its normal; none of other surfaces.
    pub fn behind_front(&self, by: f64) -> Vec<([f64; 3], [f64; 3])> {
        let [Piece { origin, axes, shape: Flat::Ring { inner, outer }, .. }] = self.pieces[..] else {
            return Vec::new();
        };
        let radius = if inner > 0.0 { inner + by } else { outer - by };
        let angles = (0..8).map(|k| TAU * (f64::from(k) + 0.5) / 8.0);
        let at = |angle: f64| origin + (axes[0] * angle.cos() + axes[1] * angle.sin()) * radius;
        angles.map(|angle| (at(angle).into(), axes[2].into())).collect()
    }

    /// Middles of small parts of the plane of a disc or ring that [`Self::grown`] adds between two lengths, m, with their area, m²; none
    /// of other surfaces.
    pub fn added(&self, [from, to]: [f64; 2]) -> (Vec<[f64; 3]>, f64) {
        /// Parts around the front.
        const PARTS: u32 = 720;
        let [Piece { origin, axes, shape: Flat::Ring { inner, outer }, .. }] = self.pieces[..] else {
            return (Vec::new(), 0.0);
        };
        let ends = if inner > 0.0 { [inner - to, inner - from] } else { [outer + from, outer + to] };
        let radius = 0.5 * (ends[0] + ends[1]);
        let angles = (0..PARTS).map(|k| TAU * (f64::from(k) + 0.5) / f64::from(PARTS));
        let at = |angle: f64| origin + (axes[0] * angle.cos() + axes[1] * angle.sin()) * radius;
        let area = TAU * radius * (ends[1] - ends[0]) / f64::from(PARTS);
        (angles.map(|angle| at(angle).into()).collect(), area)
    }
}

impl Piece {
    /// The place of the rims of a disc or ring nearest to some place, m.
    fn rim_near(&self, [inner, outer]: [f64; 2], place: Vector3<f64>) -> Option<FrontPlace> {
        let arm = place - self.origin;
        let flat = arm - self.axes[2] * arm.dot(&self.axes[2]);
        let away = flat.try_normalize(0.0)?;
        let is_inner = inner > 0.0 && (flat.norm() - inner).abs() < (flat.norm() - outer).abs();
        let (radius, side) = if is_inner { (inner, -1.0) } else { (outer, 1.0) };
        Some(FrontPlace {
            at: (self.origin + away * radius).into(),
            ahead: (away * side).into(),
            normal: self.axes[2].into(),
        })
    }

    /// Whether the body goes on somewhere beyond a rim of a radius, m, outwards or, if `side` is below zero, inwards.
    fn is_front(&self, radius: f64, side: f64, recess: &Recess) -> bool {
        /// Most places that are looked at.
        const PLACES: f64 = 4096.0;
        let count = (TAU * radius / recess.step).ceil().clamp(16.0, PLACES);
        (0..count as u32).any(|k| {
            let angle = TAU * (f64::from(k) + 0.5) / count;
            let ahead = self.axes[0] * angle.cos() + self.axes[1] * angle.sin();
            (recess.goes_on)((self.origin + ahead * radius).into(), (ahead * side).into())
        })
    }
}
