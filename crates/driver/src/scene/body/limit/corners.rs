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

/// Free corners that turn into the body, beside which fits are rough; a fault for each kind of others that the border has. A line of
/// symmetry is a whole side, and meets no edge at more than 90°.
pub(super) fn check(pieces: &[BorderPiece], spacing: f64, faults: &mut Faults) -> Vec<[f64; 2]> {
    let mut singular = Vec::new();
    let mut told: Vec<&str> = Vec::new();
    for [one, other] in pairs(pieces, spacing) {
        let (angle, most) = (one.angle(&other), one.side.most(other.side));
        if one.is_continued_by(&other)
            || angle <= most + SMOOTH.asin().to_degrees() * f64::from(u8::from(most > 0.0))
        {
            continue;
        }
        if (one.side, other.side) == (Side::Free, Side::Free) {
            singular.push(one.at);
            continue;
        }
        let [x, y] = one.at.map(tidy);
        let (what, hint) = match (one.side, other.side) {
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
    warn(&singular, faults);
    singular
}

/// Adds a warning about corners that turn into the body.
fn warn(singular: &[[f64; 2]], faults: &mut Faults) {
    let Some([x, y]) = singular.first().map(|at| at.map(tidy)) else { return };
    let others = match singular.len() - 1 {
        0 => String::new(),
        more => format!(" and in {more} more"),
    };
    faults
        .warning(
            root("limit"),
            format!("stresses are infinite in the corner at ({x}, {y}){others}, which turns into the body: one correction is all that does no harm, the error remains of the order of the spacing, and within five spacings stresses are those of the grid"),
        )
        .hint("round the corner by an arc of several spacings");
}

/// Ends of pieces that meet.
pub(super) fn pairs(pieces: &[BorderPiece], spacing: f64) -> impl Iterator<Item = [End; 2]> {
    let pieces = pieces.iter().enumerate();
    let ends: Vec<End> = pieces.flat_map(|piece| [0.0, 1.0].map(|share| End::new(piece, share))).collect();
    let count = ends.len();
    let of = move |k: usize| {
        let others = ends[k + 1..].iter().filter(|other| other.is_here(&ends[k], SAME * spacing));
        others.map(|other| [ends[k], *other]).collect::<Vec<_>>()
    };
    (0..count).flat_map(of)
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
#[derive(Clone, Copy, Debug)]
pub(super) struct End {
    /// Number of the piece; none of a line of symmetry.
    pub(super) piece: Option<usize>,
    pub(super) share: f64,
    pub(super) at: [f64; 2],
    pub(super) along: [f64; 2],
    pub(super) normal: [f64; 2],
    pub(super) held: [bool; 2],
    side: Side,
}

impl End {
    pub(super) fn new((number, BorderPiece { part, held }): (usize, &BorderPiece), share: f64) -> Self {
        let (at, next) = (part.at(share), part.at((share - BESIDE).abs()));
        let d = [0, 1].map(|k| next[k] - at[k]);
        let (length, normal) = (d[0].hypot(d[1]), part.normal(share));
        let along = d.map(|x| x / length);
        Self { piece: Some(number), share, at, along, normal, held: *held, side: Side::of(*held, normal) }
    }

    /// A place of a line of symmetry across an axis.
    pub(super) fn of_line(axis: usize, at: [f64; 2]) -> Self {
        let [normal, along] = [0, 1].map(|k| [0, 1].map(|c| if (c == axis) == (k == 0) { 1.0 } else { 0.0 }));
        let held = [axis == 0, axis == 1];
        Self { piece: None, share: 0.0, at, along, normal, held, side: Side::Across }
    }

    fn is_here(&self, other: &Self, tolerance: f64) -> bool {
        (self.at[0] - other.at[0]).hypot(self.at[1] - other.at[1]) <= tolerance
    }

    /// Whether the border goes on smoothly from here with another piece, on which as much is known.
    pub(super) fn is_continued_by(&self, other: &Self) -> bool {
        self.held == other.held && (self.angle(other) - 180.0).abs() <= SMOOTH.asin().to_degrees()
    }

    /// The angle of the body between this piece and another one, degrees.
    fn angle(&self, other: &Self) -> f64 {
        let along = |v: [f64; 2]| v[0] * other.along[0] + v[1] * other.along[1];
        let (cosine, sine) = (along(self.along), -along(self.normal));
        let angle = sine.atan2(cosine).to_degrees();
        if angle < 0.0 { angle + 360.0 } else { angle }
    }
}
