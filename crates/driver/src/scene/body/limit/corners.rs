//! Corners at which stresses are infinite: those that turn into a body, and the ends of clamped edges.

use crate::diagnostic::{Faults, root, tidy};
use peristat_assembly::correction::BorderPiece;

/// Ends of pieces are one up to this part of a spacing.
const SAME: f64 = 1e-6;
/// Sine of the angle by which a border may turn inwards: chords of a curve turn by less.
const SMOOTH: f64 = 0.2;
/// How far from a corner its sides are looked at, in parts of a piece.
const BESIDE: f64 = 1e-3;

/// Adds a fault for each kind of them that the border has.
pub(super) fn check(pieces: &[BorderPiece], spacing: f64, faults: &mut Faults) {
    let ends: Vec<End> =
        pieces.iter().flat_map(|piece| [0.0, 1.0].map(|share| End::new(piece, share))).collect();
    let tolerance = SAME * spacing;
    let enters =
        |end: &&End| ends.iter().any(|other| other.is_here(end, tolerance) && other.is_entered_by(end));
    if let Some(End { at: [x, y], .. }) = ends.iter().find(enters) {
        let [x, y] = [x, y].map(|x| tidy(*x));
        faults
            .error(root("limit"), format!("`local` is no limit of this body: stresses are infinite in the corner at ({x}, {y}), which turns into it"))
            .hint("round the corner by an arc of several spacings, or leave `limit` out");
    }
    let is_clamped = |end: &End| end.held == [true; 2];
    let ends_free = |end: &&End| {
        is_clamped(end) && ends.iter().any(|other| other.is_here(end, tolerance) && !is_clamped(other))
    };
    if let Some(End { at: [x, y], .. }) = ends.iter().find(ends_free) {
        let [x, y] = [x, y].map(|x| tidy(*x));
        faults
            .error(root("limit"), format!("`local` is no limit of this body: stresses are infinite at ({x}, {y}), where a clamped edge meets another one"))
            .hint("hold the edge across its line alone, with one point held along it, or leave `limit` out");
    }
}

/// An end of a piece: where it is, how the piece goes on from it, and its normal.
struct End {
    at: [f64; 2],
    along: [f64; 2],
    normal: [f64; 2],
    held: [bool; 2],
}

impl End {
    fn new(BorderPiece { part, held }: &BorderPiece, share: f64) -> Self {
        let (at, next) = (part.at(share), part.at((share - BESIDE).abs()));
        let d = [0, 1].map(|k| next[k] - at[k]);
        let length = d[0].hypot(d[1]);
        Self { at, along: d.map(|x| x / length), normal: part.normal(share), held: *held }
    }

    fn is_here(&self, other: &Self, tolerance: f64) -> bool {
        (self.at[0] - other.at[0]).hypot(self.at[1] - other.at[1]) <= tolerance
    }

    /// Whether another piece goes on from here in front of the border.
    fn is_entered_by(&self, other: &Self) -> bool {
        self.normal[0] * other.along[0] + self.normal[1] * other.along[1] > SMOOTH
    }
}
