//! Triangles of constant strain.

use crate::bonds::Mat;

/// Rows that make the strains `[ε_xx, ε_yy, γ_xy]` of a triangle from the displacements of two of its points relative to
/// the third, from which they lie at `first` and `second`, m.
pub(in super::super::super) fn strain_rows(first: [f64; 2], second: [f64; 2]) -> [Mat<3, 2>; 2] {
    let area = first[0] * second[1] - first[1] * second[0];
    // Gradients of the two shape functions.
    let gradients = [[second[1] / area, -second[0] / area], [-first[1] / area, first[0] / area]];
    gradients.map(|[x, y]| [[x, 0.0], [0.0, y], [y, x]])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn any_triangle_has_the_strain_of_a_linear_field() {
        let gradient = [[0.1, 0.7], [-0.3, 0.4]];
        let (first, second) = ([2.0, 0.5], [-0.3, 1.7]);
        let rows = strain_rows(first, second);
        let strain: [f64; 3] = std::array::from_fn(|m| {
            let part = |e: usize, at: [f64; 2]| -> f64 {
                (0..2).map(|c| rows[e][m][c] * (gradient[c][0] * at[0] + gradient[c][1] * at[1])).sum()
            };
            part(0, first) + part(1, second)
        });
        let expected = [0.1, 0.4, 0.7 - 0.3];
        assert!((0..3).all(|m| (strain[m] - expected[m]).abs() < 1e-15));
    }
}
