//! Peridynamic Timoshenko beam, static and linear.
//!
//! Yang, Oterkus and Oterkus, Procedia Structural Integrity 28 (2020) 464-471, Eqs. (10)-(13), without inertia. With
//! `ξ = |x_j − x_k|` and `s = sign(x_j − x_k)`, force and moment densities at point k vanish:
//!
//! ```text
//! (12b)  Σ_j c_s [ (w_j − w_k)/ξ − (φ_j + φ_k)/2 s ] V_j + b = 0
//! (12a)  Σ_j c_b (φ_j − φ_k)/ξ V_j + ½ Σ_j c_s [ (w_j − w_k) s − (φ_j + φ_k)/2 ξ ] V_j + b̃ = 0
//! c_b = 2 EI/(δ² A²),   c_s = 2 κG/(δ² A)
//! ```
//!
//! They are the gradient of `U = Σ_bonds ½ α/ξ [ EI (Δφ)² + S_b (ξγ)² ]` with the measures `Δφ = φ_j − φ_i` and
//! `ξγ = w_j − w_i − ξ (φ_i + φ_j)/2` (x_j > x_i) and the dimensionless weight `α = 2 V_i V_j ν/(δ² A²)`: the area
//! cancels, and a bond is a one-point-integrated Timoshenko element of length ξ.
//!
//! Signs: w and loads are positive alike, φ = w′ where shear is rigid, `M = EI φ′`, `V = S (w′ − φ)`,
//! `V′ + q = 0`, `M′ + V + c = 0`.

mod bond;
pub mod bond_law;
mod breaking;
mod chain;
pub mod end_treatment;
mod load;
mod motion;
mod recover;
mod sizes;
mod strain;
mod terms;
#[cfg(test)]
mod tests;
mod toughness;
mod weights;

pub use bond::{BeamBond, UniformBending, UniformSection, UniformStretch};
pub use breaking::{CriticalStrain, CriticalStrains};
pub use chain::{Axial, BondTable, Chain, ChainError, Grid, Line};
pub use load::{Along, BeamLoads, ChainLoads, Distributed, Element, Inside, Intensity, PointAction};
pub use recover::SectionForces;
pub use strain::{
    ForceMethod, FromLeft, FromRight, NoStrainForm, Redundants, Resultant, STRAIN_BLOCK, StrainAction,
    StrainBand, StrainChecks, StrainForm, StrainSupport,
};
pub use weights::{VolumeFactor, bond_weights};

use self::bond_law::BondLaw;
use self::end_treatment::EndTreatment;

/// Component of the deflection, across the member.
pub const W: usize = 0;
/// Component of the rotation.
pub const PHI: usize = 1;
/// Component of the displacement along the member, in bodies that have it.
pub const U: usize = 2;

/// How bonds are calibrated, for all lines of a body.
#[derive(Clone, Copy, Debug)]
pub struct BeamParameters {
    /// Part of the volume of a point at the edge of the horizon.
    pub volume_factor: VolumeFactor,
    /// Shear stiffness of a bond of a uniform section; where a section varies, bonds are the exact elements of their
    /// spans.
    pub bond_law: &'static BondLaw,
    /// What happens to the bonds cut off by an end.
    pub end_treatment: &'static EndTreatment,
}

/// Straight members in a plane, discretised.
///
/// As a [`Model<2>`](super::Model) its points have the unknowns (w, φ) across the axis; as a `Model<3>` (w, φ, u) in the
/// axes of their member. Only equations join different members.
#[derive(Clone, Debug)]
pub struct TimoshenkoBeam {
    parameters: BeamParameters,
    chains: Vec<Chain>,
    first: Vec<usize>,
    points: usize,
}

impl TimoshenkoBeam {
    /// Discretises the lines; points are numbered line by line, ghosts of a line around its real points.
    ///
    /// # Errors
    /// [`ChainError`] as [`Chain::new`].
    pub fn new(parameters: BeamParameters, lines: Vec<Line>) -> Result<Self, ChainError> {
        let chains: Vec<Chain> =
            lines.into_iter().map(|line| Chain::new(line, &parameters)).collect::<Result<_, _>>()?;
        let mut points = 0;
        let mut first = Vec::with_capacity(chains.len());
        for chain in &chains {
            first.push(points);
            points += chain.extended();
        }
        Ok(Self { parameters, chains, first, points })
    }

    /// The parameters.
    pub fn parameters(&self) -> &BeamParameters {
        &self.parameters
    }

    /// The lines with their bonds.
    pub fn chains(&self) -> &[Chain] {
        &self.chains
    }

    /// Number of points, ghosts included.
    pub fn points(&self) -> usize {
        self.points
    }

    /// Number of a line's first point, a ghost where it has any.
    pub fn first(&self, chain: usize) -> usize {
        self.first[chain]
    }

    /// Number of a line's first real point.
    pub fn first_real(&self, chain: usize) -> usize {
        self.first[chain] + self.chains[chain].ghosts[0]
    }

    /// The line that a point belongs to.
    pub fn chain_of(&self, point: usize) -> usize {
        self.first.partition_point(|&first| first <= point) - 1
    }
}
