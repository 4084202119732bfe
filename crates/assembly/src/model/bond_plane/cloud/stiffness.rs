//! How stiff the bonds of a cloud are, and what its points lack.

use super::super::super::plane::{Edges, energy_factor, volume_factor};
use super::super::PlaneParameters;
use super::Pair;
use crate::bonds::Mat;
use nalgebra::Matrix3;

/// Moments `M = (1/V) ½ Σ k ξ² N Nᵀ`, Pa, of all points: their stiffness in uniform strains.
fn moments(pairs: &[Pair], volumes: &[f64]) -> Vec<Mat<3, 3>> {
    let mut moments = vec![[[0.0; 3]; 3]; volumes.len()];
    for pair in pairs {
        let (n, half) = (pair.product(), 0.5 * pair.stiffness * pair.length * pair.length);
        for p in pair.ends() {
            for r in 0..3 {
                (0..3).for_each(|c| moments[p][r][c] += half / volumes[p] * n[r] * n[c]);
            }
        }
    }
    moments
}

/// Multiplies every bond by the smaller scale of its ends, the largest with which `C − g M` is positive semidefinite.
pub(super) fn scale(pairs: &mut [Pair], volumes: &[f64], stiffness: &Mat<3, 3>) {
    let c = Matrix3::from_fn(|r, k| stiffness[r][k]).symmetric_eigen();
    let root = c.eigenvectors
        * Matrix3::from_diagonal(&c.eigenvalues.map(|v| 1.0 / v.sqrt()))
        * c.eigenvectors.transpose();
    let scale_of = |moment: &Mat<3, 3>| {
        let relative = root * Matrix3::from_fn(|r, k| moment[r][k]) * root;
        1.0 / relative.symmetric_eigenvalues().max()
    };
    let scales: Vec<f64> = moments(pairs, volumes).iter().map(scale_of).collect();
    for pair in pairs {
        let [i, j] = pair.ends();
        pair.stiffness *= scales[i].min(scales[j]);
    }
}

/// What every point lacks of the stiffness of the material, Pa.
pub(super) fn deficits(pairs: &[Pair], volumes: &[f64], stiffness: &Mat<3, 3>) -> Vec<Mat<3, 3>> {
    let mut deficits = moments(pairs, volumes);
    for deficit in &mut deficits {
        for r in 0..3 {
            (0..3).for_each(|c| deficit[r][c] = stiffness[r][c] - deficit[r][c]);
        }
    }
    deficits
}

/// Applies the treatments `volume` and `energy`.
pub(super) fn treat(pairs: &mut [Pair], volumes: &[f64], horizon: f64, parameters: &PlaneParameters) {
    match parameters.edges {
        Edges::Border | Edges::Overlay | Edges::None => {}
        Edges::Volume => {
            let mut family = vec![0.0; volumes.len()];
            for pair in pairs.iter() {
                let [i, j] = pair.ends();
                family[i] += pair.part * volumes[j];
                family[j] += pair.part * volumes[i];
            }
            let full = std::f64::consts::PI * horizon * horizon * parameters.material.thickness;
            for pair in pairs {
                pair.stiffness *= volume_factor(full, pair.ends().map(|p| family[p]));
            }
        }
        Edges::Energy => {
            let c11 = parameters.material.c11();
            let ratio = |m: &Mat<3, 3>| [c11 / m[0][0], c11 / m[1][1]];
            let ratios: Vec<[f64; 2]> = moments(pairs, volumes).iter().map(ratio).collect();
            for pair in pairs {
                let [x, y, _] = pair.product();
                pair.stiffness *= energy_factor([x, y], pair.ends().map(|p| ratios[p]));
            }
        }
    }
}
