//! Weights of the bonds of a lattice point: one per offset for bending, one for shear.
//!
//! Both sum to one over half of the offsets. With the angle θ of an offset those of bending have `Σ ω cos 4θ = 0`, an isotropic
//! fourth moment, and are next to the lengths of the bonds, which those of the published plate are. Those of shear have
//! `Σ s ξ² cos 4θ = 0`: the moment balance of a point in a state of constant shear force is `div M + Σ(s/2) γ − X ∶ ∇∇φ` with
//! `X = Σ s ξ² n⊗n⊗n⊗n/12`, which vanishes for `V = S γ` if X is isotropic and the weights sum to one.

use super::{PlateError, PlateParameters, ShearLaw};
use crate::body::Cell;
use crate::model::plane::{direction_product, is_up, is_within, length, project};
use nalgebra::{DMatrix, DVector};

/// An offset with its weights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Weighted {
    /// From the lower point of a bond to the other, cells.
    pub(super) step: Cell,
    /// Weight in bending.
    pub(super) bending: f64,
    /// Weight in shear.
    pub(super) shear: f64,
}

/// Half of the offsets to the neighbours of a point on a lattice of a spacing, m, with their weights.
///
/// # Errors
/// [`PlateError`] where there are none.
pub(super) fn weights(parameters: &PlateParameters, spacing: f64) -> Result<Vec<Weighted>, PlateError> {
    let m = parameters.horizon_ratio;
    let steps = offsets(m);
    if !steps.iter().any(|[a, b, _]| a * b != 0) {
        return Err(PlateError::NotIsotropic { horizon_ratio: m });
    }
    let bending = bending(&steps);
    let shear = match parameters.shear_law {
        ShearLaw::Corrected => shear(parameters, spacing, &steps, &bending)?,
        ShearLaw::Published => bending.clone(),
    };
    let all = steps.iter().zip(bending.iter().zip(shear.iter()));
    Ok(all.map(|(&step, (&bending, &shear))| Weighted { step, bending, shear }).collect())
}

/// One of each pair of opposite offsets within the horizon, row by row.
fn offsets(m: f64) -> Vec<Cell> {
    let reach = (m + 1e-9).floor() as i32;
    let all = (0..=reach).flat_map(|b| (-reach..=reach).map(move |a| [a, b, 0]));
    all.filter(|&step| is_up(step) && is_within(step, m)).collect()
}

/// `cos 4θ` of the angle of an offset from the rows.
fn fourfold(step: Cell) -> f64 {
    let [xx, yy, xy] = direction_product(step);
    (xx - yy).powi(2) - 4.0 * xy * xy
}

/// The weights of bending; the offsets are whole under the symmetries of the square, so that `Σ ω sin 4θ` is zero by itself.
fn bending(steps: &[Cell]) -> DVector<f64> {
    let lengths = DVector::from_iterator(steps.len(), steps.iter().map(|&step| length(step)));
    let start = &lengths / lengths.sum();
    let matrix = DMatrix::from_fn(2, steps.len(), |e, k| if e == 0 { 1.0 } else { fourfold(steps[k]) });
    project(&matrix, &DVector::from_column_slice(&[1.0, 0.0]), &start, &start)
}

/// The weights of shear: those next to the ones of bending, relatively, with the two sums.
fn shear(
    parameters: &PlateParameters,
    spacing: f64,
    steps: &[Cell],
    bending: &DVector<f64>,
) -> Result<DVector<f64>, PlateError> {
    let moment = |&step: &Cell| {
        let xi = spacing * length(step);
        xi * xi * parameters.shear(1.0, xi)
    };
    let moments: Vec<f64> = steps.iter().map(moment).collect();
    let largest = moments.iter().fold(0.0_f64, |most, m| most.max(*m));
    let rows = DMatrix::from_fn(2, steps.len(), |e, k| match e {
        0 => bending[k],
        _ => bending[k] * fourfold(steps[k]) * moments[k] / largest,
    });
    let missing = DVector::from_column_slice(&[1.0, 0.0]) - rows.column_sum();
    let inverse = (&rows * rows.transpose()).try_inverse();
    let multipliers = inverse.map_or_else(|| DVector::zeros(2), |inverse| inverse * missing);
    let factors = rows.transpose() * multipliers;
    let weights = bending.zip_map(&factors, |weight, factor| weight * (1.0 + factor));
    match weights.iter().copied().fold(f64::INFINITY, f64::min) {
        least if least > 0.0 => Ok(weights),
        least => Err(PlateError::NegativeShear { weight: least }),
    }
}
