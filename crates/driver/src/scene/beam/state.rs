//! Right-hand sides of a beam.

use super::eigenstrain::Eigenstrain;
use peristat_assembly::model::timoshenko_beam::BeamLoads;

/// One right-hand side: a load step, a load case or a combination.
#[derive(Clone, Debug)]
pub struct State {
    /// Name in results.
    pub name: String,
    /// Factor on the loads as written; 1 for load cases and combinations.
    pub load_factor: f64,
    /// Factor on prescribed motions.
    pub motion_factor: f64,
    /// The loads, factors included.
    pub loads: BeamLoads,
    /// Strains without stress, factors included.
    pub eigenstrains: Vec<Eigenstrain>,
}
