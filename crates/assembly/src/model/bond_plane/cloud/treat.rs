//! What published treatments of edges make of the bonds of a cloud.

use super::super::super::cloud::{Pair, Sites, moments};
use super::super::super::plane::{Edges, energy_factor, volume_factor};
use super::super::PlaneParameters;
use crate::bonds::Mat;

/// Applies the treatments `volume` and `energy`.
pub(super) fn treat(pairs: &mut [Pair<2>], sites: &Sites<2>, horizon: f64, parameters: &PlaneParameters) {
    match parameters.edges {
        Edges::Border | Edges::Overlay | Edges::None => {}
        Edges::Volume => {
            let mut family = vec![0.0; sites.positions.len()];
            for pair in pairs.iter() {
                let [i, j] = pair.ends();
                family[i] += pair.part * sites.volume(j);
                family[j] += pair.part * sites.volume(i);
            }
            let full = std::f64::consts::PI * horizon * horizon * parameters.material.thickness;
            for pair in pairs {
                pair.stiffness *= volume_factor(full, pair.ends().map(|p| family[p]));
            }
        }
        Edges::Energy => {
            let c11 = parameters.material.c11();
            let ratio = |m: &Mat<3, 3>| [c11 / m[0][0], c11 / m[1][1]];
            let ratios: Vec<[f64; 2]> = moments(pairs, sites).iter().map(ratio).collect();
            for pair in pairs {
                let [x, y] = pair.direction.map(|n| n * n);
                pair.stiffness *= energy_factor([x, y], pair.ends().map(|p| ratios[p]));
            }
        }
    }
}
