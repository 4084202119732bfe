//! The bond constant of the continuum and the factors that lattices use with it.

use super::super::super::plane::length;
use super::super::{PlaneParameters, VolumeFactor};
use super::overlap::cell_in_disc;
use crate::body::Cell;

/// Micromodulus c, N/m⁶: `c ω s` is the force density of a bond of stretch s.
///
/// From equal energy in an equal stretch ε of all directions, `¼ c ε² t ∫ ω ξ 2π ξ dξ = (C11 + C12) ε²`:
/// `c = 2 (C11 + C12)/(π t ∫₀^δ ω ξ² dξ)`. With ω = 1 this is `9E/(π t δ³)` in plane stress and `48E/(5π t δ³)` in plane
/// strain. `horizon` is δ, m.
pub(in super::super) fn micromodulus(parameters: &PlaneParameters, horizon: f64) -> f64 {
    let material = &parameters.material;
    let bulk = material.c11() * 4.0 / 3.0;
    let moment = parameters.influence.second_moment() * horizon.powi(3);
    2.0 * bulk / (std::f64::consts::PI * material.thickness * moment)
}

/// Weights of the offsets, `a = c ω β V ξ`, Pa, and the parts β of the neighbours' volumes.
pub(in super::super) fn weights(parameters: &PlaneParameters, offsets: &[Cell]) -> (Vec<f64>, Vec<f64>) {
    let m = parameters.horizon_ratio;
    // In spacings: V = t, ξ = |offset|.
    let c = micromodulus(parameters, m) * parameters.material.thickness;
    let parts: Vec<f64> = offsets.iter().map(|&step| part(parameters.volume_factor, m, step)).collect();
    let weight =
        |(&step, &part): (&Cell, &f64)| c * parameters.influence.at(length(step) / m) * part * length(step);
    (offsets.iter().zip(&parts).map(weight).collect(), parts)
}

/// Part β of the volume of the neighbour at an offset inside a horizon of `m` spacings.
fn part(factor: VolumeFactor, m: f64, step: Cell) -> f64 {
    match factor {
        VolumeFactor::Area => cell_in_disc(step, m),
        _ => radial_part(factor, length(step), m, 1.0),
    }
}

/// Part β by the distance `xi` alone, of a neighbour of width `h`, inside a horizon.
pub(in crate::model) fn radial_part(factor: VolumeFactor, xi: f64, horizon: f64, h: f64) -> f64 {
    let inside = xi * xi <= horizon * horizon * (1.0 + 1e-9);
    let ramp = ((horizon + 0.5 * h - xi) / h).clamp(0.0, 1.0);
    match factor {
        VolumeFactor::Full => f64::from(inside),
        VolumeFactor::Clip => ramp * f64::from(inside),
        VolumeFactor::Ramp | VolumeFactor::Area => ramp,
    }
}
