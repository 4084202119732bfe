//! Corners at which stresses are infinite, by what is known on both sides and the angle between them.
//!
//! Where the normal displacement is zero and the shear, the body and its image in the edge are one in an even state; where the
//! displacement along the edge is zero and the normal stress, in an odd one. So a corner between such edges and free ones is half of a
//! free corner: its stresses are infinite from an angle of 180° of both halves, and in odd states from 257° (Williams, J. Appl. Mech.
//! 19 (1952) 526-528). Between two such edges the field r^λ has λ = π/ω − 1, where one is even and one odd π/(2ω) − 1.

use crate::diagnostic::{Faults, root, tidy};
use peristat_assembly::correction::BorderPiece;

/// Ends of pieces are one up to this part of a spacing.
const SAME: f64 = 1e-6;
/// Sine of the angle by which a border may turn further: chords of a curve turn by less.
const SMOOTH: f64 = 0.2;
/// How far from a corner its sides are looked at, in parts of a piece.
const BESIDE: f64 = 1e-3;
/// Part of a unit vector below which it is across another.
const ACROSS: f64 = 1e-6;

/// Adds a fault for each kind of them that the border has; a line of symmetry is a whole side, and meets no edge at more than 90°.
pub(super) fn check(pieces: &[BorderPiece], spacing: f64, faults: &mut Faults) {
    let ends: Vec<End> =
        pieces.iter().flat_map(|piece| [0.0, 1.0].map(|share| End::new(piece, share))).collect();
    let pairs = ends.iter().enumerate().flat_map(|(k, end)| {
        let others = ends[k + 1..].iter().filter(|other| other.is_here(end, SAME * spacing));
        others.map(move |other| (end, other))
    });
    let mut told: Vec<&str> = Vec::new();
    for (one, other) in pairs {
        let (angle, most) = (one.angle(other), one.side.most(other.side));
        let is_smooth = one.held == other.held && (angle - 180.0).abs() <= SMOOTH.asin().to_degrees();
        if is_smooth || angle <= most + SMOOTH.asin().to_degrees() * f64::from(u8::from(most > 0.0)) {
            continue;
        }
        let [x, y] = one.at.map(tidy);
        let (what, hint) = match (one.side, other.side) {
            (Side::Free, Side::Free) => (
                format!("in the corner at ({x}, {y}), which turns into it"),
                "round the corner by an arc of several spacings, or leave `limit` out",
            ),
            (Side::Clamped, Side::Free) | (Side::Free, Side::Clamped) => (
                format!("at ({x}, {y}), where a clamped edge meets another one"),
                "hold the edge across its line alone, with one point held along it, or leave `limit` out",
            ),
            _ => (
                format!(
                    "at ({x}, {y}), where an edge that is held along one axis meets another one at {}°: they are finite up to {most}°",
                    tidy((10.0 * angle).round() / 10.0)
                ),
                "end it at a corner of 90° or less, or leave `limit` out",
            ),
        };
        if !told.contains(&hint) {
            told.push(hint);
            let message = format!("`local` is no limit of this body: stresses are infinite {what}");
            faults.error(root("limit"), message).hint(hint);
        }
    }
}

/// What is known on a side of a corner.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    /// The traction.
    Free,
    /// The displacement across the edge, and the shear.
    Across,
    /// The displacement along the edge, and the normal stress.
    Along,
    /// The displacement along an axis that the edge is oblique to.
    Oblique,
    /// The displacement.
    Clamped,
}

impl Side {
    fn of(held: [bool; 2], [x, y]: [f64; 2]) -> Self {
        match held {
            [false, false] => Self::Free,
            [true, true] => Self::Clamped,
            [along_x, _] => match if along_x { [x, y] } else { [y, x] } {
                [_, other] if other.abs() < ACROSS => Self::Across,
                [own, _] if own.abs() < ACROSS => Self::Along,
                _ => Self::Oblique,
            },
        }
    }

    /// The largest angle of a corner with another side at which stresses are finite, degrees; zero where none is known.
    fn most(self, other: Self) -> f64 {
        match (self, other) {
            (Self::Free, Self::Free) | (Self::Clamped, Self::Clamped) => 180.0,
            (Self::Across, Self::Free) | (Self::Free, Self::Across) => 90.0,
            (Self::Along, Self::Free) | (Self::Free, Self::Along) => 128.0,
            (Self::Across, Self::Across) | (Self::Along, Self::Along) => 90.0,
            (Self::Across, Self::Along) | (Self::Along, Self::Across) => 45.0,
            _ => 0.0,
        }
    }
}

/// An end of a piece: where it is, how the piece goes on from it, its normal, and what is known on it.
struct End {
    at: [f64; 2],
    along: [f64; 2],
    normal: [f64; 2],
    held: [bool; 2],
    side: Side,
}

impl End {
    fn new(BorderPiece { part, held }: &BorderPiece, share: f64) -> Self {
        let (at, next) = (part.at(share), part.at((share - BESIDE).abs()));
        let d = [0, 1].map(|k| next[k] - at[k]);
        let (length, normal) = (d[0].hypot(d[1]), part.normal(share));
        Self { at, along: d.map(|x| x / length), normal, held: *held, side: Side::of(*held, normal) }
    }

    fn is_here(&self, other: &Self, tolerance: f64) -> bool {
        (self.at[0] - other.at[0]).hypot(self.at[1] - other.at[1]) <= tolerance
    }

    /// The angle of the body between this piece and another one, degrees.
    fn angle(&self, other: &Self) -> f64 {
        let along = |v: [f64; 2]| v[0] * other.along[0] + v[1] * other.along[1];
        let (cosine, sine) = (along(self.along), -along(self.normal));
        let angle = sine.atan2(cosine).to_degrees();
        if angle < 0.0 { angle + 360.0 } else { angle }
    }
}
