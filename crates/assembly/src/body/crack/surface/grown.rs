//! Discs and rings whose front grows as a whole: the rim of a disc, of a ring the inner one.

use super::{CrackSurface, Flat, Piece};
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
