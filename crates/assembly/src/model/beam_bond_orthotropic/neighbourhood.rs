//! Neighbours of a point of a lattice and the beam bonds to them.

use super::super::plane::{Calibration, Neighbourhood, direction_product, half_offsets, is_within};
use super::calibration::{Fibres, matched, published};
use super::moments::shear_row;
use super::{Moments, OrthotropicError, OrthotropicParameters, Start};
use crate::body::Cell;
use std::array::from_fn;

/// One of each pair of opposite offsets to the neighbours of a point, with the weights of their bonds.
#[derive(Clone, Debug, PartialEq)]
pub struct BeamNeighbourhood {
    neighbourhood: Neighbourhood<3>,
    is_fibre: Vec<bool>,
    direction: [f64; 2],
    start: Option<Start>,
    angle: f64,
    horizon_ratio: f64,
}

impl BeamNeighbourhood {
    /// Calibrated bonds.
    ///
    /// # Errors
    /// All of [`OrthotropicError`] that do not speak of energy release rates.
    pub fn new(parameters: &OrthotropicParameters) -> Result<Self, OrthotropicError> {
        parameters.material.check()?;
        let m = parameters.horizon_ratio;
        let all = half_offsets(m, 1);
        let offsets: Vec<Cell> = all.iter().copied().filter(|&step| is_within(step, m)).collect();
        if offsets.is_empty() {
            return Err(OrthotropicError::NoNeighbours { horizon_ratio: m });
        }
        let angle = parameters.relative_angle();
        let fibres = Fibres::new(angle, &offsets);
        let (weights, start) = match parameters.calibration {
            Calibration::Matched => {
                let (weights, start) = matched::weights(parameters, &offsets, &fibres)?;
                (weights, Some(start))
            }
            Calibration::Published if parameters.edges.is_exact() => {
                return Err(OrthotropicError::OverlayNeedsMatched);
            }
            Calibration::Published if parameters.start.is_some() => {
                return Err(OrthotropicError::StartNeedsMatched);
            }
            Calibration::Published => (published::weights(parameters, &offsets, &fibres)?, None),
        };
        // Sides of triangles beyond the horizon have no bonds.
        let inside = |step: &Cell| offsets.iter().position(|o| o == step);
        let all_weights: Vec<[f64; 3]> =
            all.iter().map(|step| inside(step).map_or([0.0; 3], |k| weights[k])).collect();
        let neighbourhood = Neighbourhood::new(&all, &all_weights, &parts(&all, m));
        let is_fibre =
            neighbourhood.offsets.iter().map(|step| inside(step).is_some_and(|k| fibres.along[k])).collect();
        Ok(Self { neighbourhood, is_fibre, direction: fibres.direction, start, angle, horizon_ratio: m })
    }

    /// Bonds of a body whose points have fibres at several angles: those of the parameters, and others from x, rad.
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub(super) fn of_laminae(
        parameters: &OrthotropicParameters,
        angles: &[f64],
    ) -> Result<Neighbourhood<3>, OrthotropicError> {
        let of = |angle: f64| Self::new(&OrthotropicParameters { fibre_angle: angle, ..*parameters });
        let own = Self::new(parameters)?.neighbourhood;
        if angles.is_empty() {
            return Ok(own);
        }
        let m = parameters.horizon_ratio;
        let all = half_offsets(m, 1);
        let weights = |of: &Neighbourhood<3>| -> Vec<[f64; 3]> {
            let at = |step: &Cell| of.offsets.iter().position(|own| own == step);
            all.iter().map(|step| at(step).map_or([0.0; 3], |k| of.weights[k])).collect()
        };
        let others = angles.iter().map(|&angle| Ok(weights(&of(angle)?.neighbourhood)));
        let others = others.collect::<Result<Vec<_>, OrthotropicError>>()?;
        let own = weights(&own);
        let along: Vec<_> = std::iter::once(&own).chain(&others).map(|of| along(&all, of)).collect();
        Ok(Neighbourhood::of_tables(&all, (&own, &others), &along, &parts(&all, m)))
    }

    /// The offsets of all bonds and of possible sides of triangles, cells, row by row: upwards, or to the right in the same
    /// row.
    pub fn offsets(&self) -> &[Cell] {
        &self.neighbourhood.offsets
    }

    /// `[a, b, q]`, Pa, per offset: moduli of stretch, shear and bend of its bonds, per volume of a point. None is
    /// negative; zeros are possible, and beyond the horizon all there is.
    pub fn weights(&self) -> &[[f64; 3]] {
        &self.neighbourhood.weights
    }

    /// Per offset, whether its bonds lie exactly along the fibres.
    pub fn is_fibre(&self) -> &[bool] {
        &self.is_fibre
    }

    /// The start that was taken; none of bonds as published.
    pub fn start(&self) -> Option<Start> {
        self.start
    }

    /// Horizon per spacing.
    pub fn horizon_ratio(&self) -> f64 {
        self.horizon_ratio
    }

    /// Angle of the fibres from the rows of the lattice, rad.
    pub fn relative_angle(&self) -> f64 {
        self.angle
    }

    /// Unit vector along the fibres in the axes of the lattice; exactly that of their bonds if there are any.
    pub fn direction(&self) -> [f64; 2] {
        self.direction
    }

    /// What all bonds have together in a uniform strain, in the axes of the lattice.
    pub fn moments(&self) -> Moments {
        Moments::new(&self.neighbourhood.offsets, &self.neighbourhood.weights)
    }

    /// Shear modulus along the fibres that a body has in equilibrium, Pa: less than G12 where strain and rotation are
    /// coupled.
    pub fn effective_shear_modulus(&self) -> f64 {
        self.moments().effective_along(self.angle)[2][2]
    }

    /// Whether points of a body in uniform strain turn with it, so that its moduli are those of the bonds.
    pub fn is_consistent(&self) -> bool {
        let moments = self.moments();
        let coupling = moments.coupling.iter().fold(0.0_f64, |most, h| most.max(h.abs()));
        coupling <= 1e-10 * moments.stiffness[0][0].max(moments.stiffness[1][1])
    }
}

/// Per offset, whether its bonds are within the horizon, of some spacings.
fn parts(all: &[Cell], horizon_ratio: f64) -> Vec<f64> {
    all.iter().map(|&step| f64::from(is_within(step, horizon_ratio))).collect()
}

/// Power of what all bonds resist along one of them, the rest of that bond's own weight, by which its part in a lamina stretches.
/// Laminae at 0 and 90 degrees in series are then -0.03 to 0.04 spacings of the softer one too long, of moduli that are 2 to 38 times
/// as large along the fibres as across. One alone makes them 0.04 to 0.09 too short, zero up to 0.23 too long.
const TOGETHER: f64 = 0.7;
/// The least weight of a bond that counts, over what all resist.
const LEAST: f64 = 1e-3;

/// What materials resist to a stretch and a shear along each bond where these pass several of them; a bend is as the shear.
fn along(all: &[Cell], weights: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let stiffness = Moments::new(all, weights).stiffness;
    let of = |row: [f64; 3]| (0..9).map(|k| row[k / 3] * stiffness[k / 3][k % 3] * row[k % 3]).sum::<f64>();
    let along = |(step, own): (&Cell, &[f64; 3])| {
        let shear = of(shear_row(*step));
        let together = [of(direction_product(*step)), shear, shear];
        from_fn(|m| together[m] * (own[m] / together[m]).max(LEAST).powf(1.0 - TOGETHER))
    };
    all.iter().zip(weights).map(along).collect()
}
