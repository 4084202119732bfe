//! A free plate has no energy in its rigid motions and some in every other one.

use super::*;
use crate::bonds::{BondGeometry, BondModel, block};
use nalgebra::DMatrix;

/// Points along the sides.
const SIZE: [i32; 2] = [14, 8];

/// Stiffness of a free plate of unit spacing and unit volumes, in units of E2; unknowns `u, v, hθ` per point.
fn stiffness(bonds: &BeamNeighbourhood, unit: f64) -> DMatrix<f64> {
    let [columns, rows] = SIZE;
    let number = |[a, b]: [i32; 2]| {
        ((0..columns).contains(&a) && (0..rows).contains(&b)).then_some((b * columns + a) as usize)
    };
    let model = BeamBond { volume: 1.0, turning: 1.0 };
    let n = 3 * (columns * rows) as usize;
    let mut matrix = DMatrix::zeros(n, n);
    for (&[a, b, _], weights) in bonds.offsets().iter().zip(bonds.weights()) {
        let geometry = BondGeometry { xi: [f64::from(a), f64::from(b), 0.0] };
        let (ends, moduli) = (model.rows(&geometry), model.moduli(&geometry));
        let modulus: [f64; 3] = std::array::from_fn(|k| weights[k] * moduli[k] / unit);
        let ends = [ends.first(), ends.second()];
        for (x, y) in (0..columns * rows).map(|k| (k % columns, k / columns)) {
            let (Some(i), Some(j)) = (number([x, y]), number([x + a, y + b])) else { continue };
            for (r, s) in [(0, 0), (0, 1), (1, 0), (1, 1)] {
                let part = block(&ends[r], &modulus, &ends[s]);
                let at = [3 * [i, j][r], 3 * [i, j][s]];
                (0..9).for_each(|k| matrix[(at[0] + k / 3, at[1] + k % 3)] += part[k / 3][k % 3]);
            }
        }
    }
    matrix
}

#[test]
fn free_plates_have_three_free_motions() {
    let wide = OrthotropicMaterial { poisson_ratio_12: 0.36, ..A };
    let soft = OrthotropicMaterial { shear_modulus_12: 3500.0 * MPA, ..A };
    for (material, degrees, m) in [(A, 0.0, 3.0), (B, 30.0, 3.2), (wide, 0.0, 3.0), (soft, 0.0, 3.0)] {
        let bonds = BeamNeighbourhood::new(&parameters(material, degrees, m)).unwrap();
        let mut values: Vec<f64> =
            stiffness(&bonds, material.youngs_modulus_2).symmetric_eigenvalues().iter().copied().collect();
        values.sort_by(f64::total_cmp);
        let (free, least, most) = (&values[..3], values[3], values[values.len() - 1]);
        // Per largest value: at most 1.2e-15 in rigid motions, at least 2.8e-3 in others.
        assert!(free.iter().all(|v| v.abs() < 2e-14 * most), "{free:?} {most}");
        assert!(least > 1e-3 * most, "{least} {most}");
    }
}
