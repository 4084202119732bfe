//! Bodies, helpers, and what holds for every solid.

mod bodies;
mod border;
mod breaking;
mod cut;
mod golden;
mod mirrors;
mod patch;
mod slots;

pub(in crate::model) use bodies::*;

use super::*;
use crate::body::SquareLattice;
use crate::model::Points;
use crate::model::bond_plane::{Influence, VolumeFactor, Weights};
use crate::model::bond_solid::{BondSolid, BondSolidParameters};
use crate::model::plane::{Calibration, Mirrors, Solvable};
use crate::model::state_solid::{StateSolid, StateSolidParameters};
use std::sync::Arc;

pub(in crate::model) const BONDS: BondSolidParameters = BondSolidParameters {
    youngs_modulus: 1.0,
    horizon_ratio: 2.0,
    influence: Influence::Constant,
    calibration: Calibration::Matched,
    weights: Weights::Nearest,
    volume_factor: VolumeFactor::Ramp,
    edges: SolidEdges::Overlay,
};

pub(in crate::model) const STATE: StateSolidParameters = StateSolidParameters {
    youngs_modulus: 1.0,
    poisson_ratio: 0.3,
    horizon_ratio: 2.0,
    influence: Influence::Inverse,
    calibration: Calibration::Matched,
    volume_factor: VolumeFactor::Ramp,
    edges: SolidEdges::Overlay,
};

/// One solid of either kind and of every influence and horizon that is worth a test.
fn solids(lattice: &Arc<SquareLattice>) -> Vec<(String, Box<dyn Solvable<3>>)> {
    let mut all: Vec<(String, Box<dyn Solvable<3>>)> = Vec::new();
    for (horizon_ratio, influence) in [
        (2.0, Influence::Constant),
        (3.0, Influence::Linear),
        (3.0, Influence::Constant),
        (4.0, Influence::Inverse),
    ] {
        let parameters = BondSolidParameters { horizon_ratio, influence, ..BONDS };
        let body = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
        all.push((format!("bonds {horizon_ratio} {influence:?}"), Box::new(body)));
    }
    for horizon_ratio in [2.0, 3.0, 4.0] {
        let parameters = BondSolidParameters { horizon_ratio, edges: SolidEdges::Border, ..BONDS };
        let body = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
        all.push((format!("border {horizon_ratio}"), Box::new(body)));
    }
    for (poisson_ratio, horizon_ratio, influence) in [
        (0.3, 3.0, Influence::Linear),
        (0.3, 3.0, Influence::Inverse),
        (-0.4, 2.0, Influence::Inverse),
        (0.45, 2.0, Influence::Linear),
        (0.25, 4.0, Influence::Inverse),
    ] {
        let parameters = StateSolidParameters { poisson_ratio, horizon_ratio, influence, ..STATE };
        let body = StateSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
        all.push((format!("state {poisson_ratio} {horizon_ratio} {influence:?}"), Box::new(body)));
        let parameters = StateSolidParameters { edges: SolidEdges::Border, ..parameters };
        let body = StateSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
        all.push((format!("state border {poisson_ratio} {horizon_ratio} {influence:?}"), Box::new(body)));
    }
    all
}
