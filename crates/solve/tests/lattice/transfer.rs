//! Bilinear interpolation between the centres of cells that are joined.

use super::level::Level;

/// The coarse cells whose values a fine one takes, bilinear between centres, with their shares; those outside or
/// behind the cut count nothing and the others more.
pub(super) fn sources(fine: &Level, coarse: &Level, p: usize) -> ([usize; 4], [f64; 4]) {
    let axis = |i: usize, n: usize| {
        let other = if i.is_multiple_of(2) { (i / 2).checked_sub(1) } else { Some(i / 2 + 1) };
        let other = other.filter(|o| *o < n);
        [(i / 2, 0.75), (other.unwrap_or(i / 2), 0.25)]
    };
    let (mut cells, mut shares) = ([0; 4], [0.0; 4]);
    let mut all = 0.0;
    for (b, (j, v)) in axis(p / fine.width, coarse.height()).into_iter().enumerate() {
        for (a, (i, u)) in axis(p % fine.width, coarse.width).into_iter().enumerate() {
            let q = j * coarse.width + i;
            cells[2 * b + a] = q;
            let joined = coarse.inside[q] && !coarse.cut(fine.centre(p), coarse.centre(q));
            shares[2 * b + a] = if joined { u * v } else { 0.0 };
            all += shares[2 * b + a];
        }
    }
    (cells, shares.map(|s| if all > 0.0 { s / all } else { 0.0 }))
}
