//! State-based plates whose border is completed along the path of the missing bonds.
//!
//! The energy is that of the bonds of a body with `λ = μ`, whose border completes them, and of the dilatations of all points,
//! `Σ ½ (λ−μ) V_k ϑ_k²`. Both are exact for every uniform strain, and what acts on a point in a uniform stress is what its
//! tractions have there.

mod border;
mod families;
mod fields;
mod hoops;
mod model;
mod newton;
mod own_bonds;
mod reach;
mod rings;
mod sources;
mod term;
mod transport;

use super::super::bond_plane::CentralBond;
use super::super::plane::{
    Edges, Kind, LatticeBody, Mirrors, Neighbourhood, half_offsets, has_border, is_within,
};
use super::body::{cell_volume, with_axis};
use super::sets::Maker;
use super::weights::offsets;
use super::{StateError, StateParameters};
use crate::body::{Cell, SquareLattice};
use families::{Dilatations, NONE};
use rings::ringed;
use sources::Bonded;
use std::sync::Arc;
use term::JointTerm;

/// A state-based plate whose border is completed.
#[derive(Clone, Debug)]
pub struct BorderedState {
    parameters: StateParameters,
    pub(super) plate: Bonded,
    /// None where `λ = μ`.
    pub(super) dilatations: Option<Dilatations>,
    term: JointTerm,
}

impl BorderedState {
    /// Whether the border of a lattice can be completed so.
    pub fn has_border(parameters: &StateParameters, lattice: &SquareLattice, mirrors: &Mirrors) -> bool {
        let has_border = match parameters.is_axisymmetric() {
            true => ringed(parameters, lattice, *mirrors).is_ok_and(|(lattice, mirrors)| {
                let reach = parameters.horizon_ratio as i32;
                let depth = Edges::Border.depth(reach);
                has_border(&mirrors.extended(&lattice, depth), &mirrors, reach)
            }),
            false => has_border(lattice, mirrors, parameters.horizon_ratio as i32),
        };
        has_border && neighbourhood(parameters, lattice).is_ok()
    }

    /// A plate on the cells of a lattice without images.
    ///
    /// # Errors
    /// [`StateError::NoBorder`] where dilatations cannot be completed, [`StateError::NoNeighbours`].
    pub fn on_lattice(
        real: &SquareLattice,
        mirrors: Mirrors,
        parameters: StateParameters,
    ) -> Result<Self, StateError> {
        let body = match parameters.is_axisymmetric() {
            true => {
                let (real, mirrors) = ringed(&parameters, real, mirrors)?;
                Self::made(&real, mirrors, parameters, Edges::Border)?
            }
            false => Self::made(real, mirrors, parameters, Edges::Border)?,
        };
        let is_left = body.dilatations.as_ref().is_some_and(|of| of.left > NONE);
        match body.plate.kind.edges == Edges::Border && !is_left {
            true => Ok(body),
            false => Err(StateError::NoBorder),
        }
    }

    /// One with these edges, or without a border whose blocks are known with an overlay.
    fn made(
        real: &SquareLattice,
        mirrors: Mirrors,
        parameters: StateParameters,
        edges: Edges,
    ) -> Result<Self, StateError> {
        let neighbourhood = neighbourhood(&parameters, real)?;
        let volume = cell_volume(&parameters, real.spacing());
        let kind = Kind {
            bond: CentralBond { volume },
            edges,
            thickness: volume / (real.spacing() * real.spacing()),
            stretch_moduli: [3.0 * parameters.shear_modulus(); 2],
        };
        let lattice = Arc::new(mirrors.extended(real, edges.depth(neighbourhood.reach())));
        Ok(Self::new(LatticeBody::new(lattice, mirrors, neighbourhood, kind, &[]), parameters))
    }

    /// The body at twice the spacing, whose axis comes back by itself.
    fn coarser_ring(&self) -> Option<Self> {
        let Bonded { lattice, mirrors, .. } = &self.plate;
        let mut coarse = mirrors.coarser()?;
        coarse.lines[0][0] = None;
        let real = mirrors.real(lattice).coarser();
        let (mirrors, _) = with_axis(&self.parameters, &real, coarse).ok()?;
        Self::made(&real, mirrors, self.parameters, Edges::Overlay).ok()
    }

    fn new(plate: Bonded, parameters: StateParameters) -> Self {
        let dilatations = parameters.has_families().then(|| Dilatations::new(&plate, &parameters));
        let term = JointTerm::new(&plate, dilatations.as_ref());
        Self { parameters, plate, dilatations, term }
    }

    /// The parameters.
    pub fn parameters(&self) -> &StateParameters {
        &self.parameters
    }
}

/// The bonds of some families: of the weight w in a family with the weighted volume q they have `16 μ w ξ²/q`.
fn neighbourhood(parameters: &StateParameters, real: &SquareLattice) -> Result<Neighbourhood<1>, StateError> {
    let m = parameters.horizon_ratio;
    if m < 1.5 {
        return Err(StateError::NoNeighbours(m));
    }
    let half = offsets(parameters);
    let all: Vec<Cell> = half.iter().copied().chain(half.iter().map(|o| o.map(|k| -k))).collect();
    let plain = Maker::new(parameters, real, &all, false)?.plain();
    let weight = |o: &Cell| {
        let index = half.iter().position(|h| h == o).filter(|_| is_within(*o, m));
        let square = f64::from(o[0] * o[0] + o[1] * o[1]);
        [index.map_or(0.0, |k| 16.0 * parameters.shear_modulus() * plain.weights[k] * square / plain.q)]
    };
    let steps = half_offsets(m, 1);
    let weights: Vec<[f64; 1]> = steps.iter().map(weight).collect();
    if weights.iter().any(|w| w[0] < 0.0) {
        return Err(StateError::NoBorder);
    }
    Ok(Neighbourhood::new(&steps, &weights, &vec![1.0; steps.len()]))
}
