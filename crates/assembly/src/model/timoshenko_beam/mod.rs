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

pub mod bond_law;
mod chain;
pub mod end_treatment;
mod load;
mod recover;
mod weights;

pub use chain::{Chain, ChainError, Grid, Line};
pub use load::{BeamLoads, Distributed, Intensity, PointAction};
pub use recover::{BeamFields, SectionForces};
pub use weights::{VolumeFactor, bond_weights};

use self::bond_law::{BondLaw, BondShear};
use self::end_treatment::EndTreatment;
use super::Model;
use crate::bonds::{BondGeometry, BondModel, Point, Rows};
use crate::condition::Equation;
use crate::stiffness::{Lattice, LatticeBonds, Term};

/// What a beam is made of and how its bonds are calibrated.
#[derive(Clone, Copy, Debug)]
pub struct BeamParameters {
    /// Bending stiffness EI, N m², > 0.
    pub bending_stiffness: f64,
    /// Shear stiffness S = κGA, N, > 0.
    pub shear_stiffness: f64,
    /// Area A, m², > 0; only energy densities depend on it.
    pub area: f64,
    /// Part of the volume of a point at the edge of the horizon.
    pub volume_factor: VolumeFactor,
    /// Shear stiffness of a bond.
    pub bond_law: &'static BondLaw,
    /// What happens to the bonds cut off by an end.
    pub end_treatment: &'static EndTreatment,
}

/// Measures and moduli of a beam bond: `(Δφ, ξγ)` with `(EI/ξ, S_b/ξ)`.
#[derive(Clone, Copy, Debug)]
pub struct BeamBond {
    /// Bending stiffness EI, N m².
    pub bending_stiffness: f64,
    /// Shear stiffness S, N.
    pub shear_stiffness: f64,
    /// ⟨ξ²⟩ of the family, m².
    pub mean_square_length: f64,
    /// Bond law.
    pub law: &'static BondLaw,
}

impl BondModel<2, 2> for BeamBond {
    const DIFFERENCE: [[bool; 2]; 2] = [[false, true], [true, false]];
    const MEAN: [[bool; 2]; 2] = [[false, false], [false, true]];

    fn rows(&self, bond: &BondGeometry) -> Rows<2, 2> {
        let xi = bond.xi[0];
        Rows { difference: [[0.0, 1.0], [1.0, 0.0]], mean: [[0.0, 0.0], [0.0, -xi]] }
    }

    fn moduli(&self, bond: &BondGeometry) -> [f64; 2] {
        let length = bond.length();
        let shear = (self.law.shear_stiffness)(&BondShear {
            bending_stiffness: self.bending_stiffness,
            shear_stiffness: self.shear_stiffness,
            length,
            mean_square_length: self.mean_square_length,
        });
        [self.bending_stiffness / length, shear / length]
    }
}

/// A beam of one or several straight lines, discretised.
#[derive(Clone, Debug)]
pub struct TimoshenkoBeam {
    parameters: BeamParameters,
    chains: Vec<Chain>,
    bonds: Vec<LatticeBonds<2, 2, BeamBond>>,
    points: usize,
}

impl TimoshenkoBeam {
    /// Discretises the lines; points are numbered line by line, ghosts of a line around its real points.
    ///
    /// # Errors
    /// [`ChainError`] as [`Chain::new`].
    pub fn new(parameters: BeamParameters, lines: Vec<Line>) -> Result<Self, ChainError> {
        let BeamParameters { volume_factor, end_treatment, .. } = parameters;
        let chains: Vec<Chain> = lines
            .into_iter()
            .map(|line| Chain::new(line, volume_factor, end_treatment))
            .collect::<Result<_, _>>()?;
        let points = chains.iter().map(Chain::extended).sum();
        let mut first = 0;
        let mut bonds = Vec::new();
        for chain in &chains {
            let lattice = Lattice { points, first, count: chain.extended() };
            bonds.push(lattice_bonds(&parameters, chain, lattice));
            first += chain.extended();
        }
        Ok(Self { parameters, chains, bonds, points })
    }

    /// The parameters.
    pub fn parameters(&self) -> &BeamParameters {
        &self.parameters
    }

    /// The lines with their bonds.
    pub fn chains(&self) -> &[Chain] {
        &self.chains
    }

    /// The bonds of every line.
    pub fn bonds(&self) -> &[LatticeBonds<2, 2, BeamBond>] {
        &self.bonds
    }

    /// Number of a line's first real point.
    pub fn first_real(&self, chain: usize) -> usize {
        self.bonds[chain].lattice().first + self.chains[chain].ghosts[0]
    }

    /// Numbers of the real points, line by line.
    pub fn real_points(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.chains.len()).flat_map(|c| {
            let first = self.first_real(c);
            first..first + self.chains[c].points
        })
    }
}

fn lattice_bonds(
    parameters: &BeamParameters,
    chain: &Chain,
    lattice: Lattice,
) -> LatticeBonds<2, 2, BeamBond> {
    let h = chain.spacing;
    // ⟨ξ²⟩ belongs to a full family, also where the beam is shorter than the horizon.
    let weights = bond_weights(chain.line().horizon_ratio, parameters.volume_factor);
    let moment = |power: i32| -> f64 {
        weights.iter().enumerate().map(|(k, a)| ((k + 1) as f64).powi(power) * a).sum()
    };
    // What covers add to the bonds between neighbours, where the ratio is not whole.
    let lack = if parameters.end_treatment.covers() { 1.0 - moment(1) } else { 0.0 };
    let model = BeamBond {
        bending_stiffness: parameters.bending_stiffness,
        shear_stiffness: parameters.shear_stiffness,
        mean_square_length: h * h * (moment(3) + lack) / (moment(1) + lack),
        law: parameters.bond_law,
    };
    let offsets: Vec<_> = chain
        .weights
        .iter()
        .enumerate()
        .map(|(k, &weight)| {
            let step = k + 1;
            (step, BondGeometry { xi: [step as f64 * h, 0.0, 0.0] }, weight)
        })
        .collect();
    LatticeBonds::new(lattice, &model, &offsets, &chain.overrides)
}

impl Model<2> for TimoshenkoBeam {
    const UNKNOWNS: [&'static str; 2] = ["w", "phi"];
    const RIGID_MOTIONS: &'static [&'static str] = &["translation along w", "rotation"];

    fn points(&self) -> usize {
        self.points
    }

    fn position(&self, point: usize) -> Point {
        let chain = self.bonds.partition_point(|b| b.lattice().first <= point) - 1;
        [self.chains[chain].position(point - self.bonds[chain].lattice().first), 0.0, 0.0]
    }

    fn terms(&self) -> Vec<Box<dyn Term<2>>> {
        self.bonds.iter().map(|b| Box::new(b.clone()) as Box<dyn Term<2>>).collect()
    }

    fn relations(&self) -> Vec<Equation> {
        let of =
            |(chain, bonds): (&Chain, &LatticeBonds<2, 2, BeamBond>)| chain.relations(bonds.lattice().first);
        self.chains.iter().zip(&self.bonds).flat_map(of).collect()
    }

    fn rigid_motion(&self, kind: usize, position: Point) -> [f64; 2] {
        if kind == 0 { [1.0, 0.0] } else { [position[0], 1.0] }
    }
}
