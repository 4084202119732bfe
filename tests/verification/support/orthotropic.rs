//! Plates of beam bonds made by hand: materials, lattices, dense stiffnesses.

use nalgebra::{DMatrix, DVector};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::Points;
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamBondOrthotropic, OrthotropicMaterial, OrthotropicParameters,
};
use peristat_assembly::model::plane::{Calibration, Edges, Mirrors};
use peristat_assembly::system::System;
use std::sync::Arc;

/// E1/E2 = 4, MPa and mm.
pub(crate) const A: OrthotropicMaterial = OrthotropicMaterial {
    youngs_modulus_1: 41_000.0,
    youngs_modulus_2: 10_400.0,
    poisson_ratio_12: 0.28,
    shear_modulus_12: 4_300.0,
    thickness: 1.0,
};

/// E1/E2 = 12.5, MPa and mm.
pub(crate) const B: OrthotropicMaterial = OrthotropicMaterial {
    youngs_modulus_1: 105_000.0,
    youngs_modulus_2: 8_400.0,
    poisson_ratio_12: 0.32,
    shear_modulus_12: 4_000.0,
    thickness: 0.6,
};

/// Matched bonds without overlay on a lattice along x.
pub(crate) fn parameters(
    material: OrthotropicMaterial,
    degrees: f64,
    horizon_ratio: f64,
) -> OrthotropicParameters {
    OrthotropicParameters {
        material,
        fibre_angle: degrees.to_radians(),
        lattice_angle: 0.0,
        horizon_ratio,
        calibration: Calibration::Matched,
        start: None,
        edges: Edges::None,
    }
}

/// A whole plate of so many cells.
pub(crate) fn plate(parameters: OrthotropicParameters, spacing: f64, cells: [i32; 2]) -> BeamBondOrthotropic {
    let lattice = Arc::new(SquareLattice::rectangle(spacing, [0.0; 2], cells));
    BeamBondOrthotropic::on_lattice(lattice, Mirrors::NONE, parameters, &[]).expect("the bonds exist")
}

/// Stiffness of a plate with free edges, unknowns by planes.
pub(crate) fn stiffness(plate: &BeamBondOrthotropic) -> DMatrix<f64> {
    let system = System::<3>::new(plate, Vec::new(), Vec::new()).expect("no contradiction");
    let n = system.points();
    let k = system.stiffness().to_csr(|point, component| component * n + point);
    let mut dense = DMatrix::zeros(3 * n, 3 * n);
    for (&value, (i, j)) in &k {
        dense[(i, j)] += value;
    }
    dense
}

/// Unknowns of all points in a uniform displacement gradient, rotations those of the body.
pub(crate) fn uniform(plate: &BeamBondOrthotropic, g: [[f64; 2]; 2]) -> Vec<f64> {
    let n = plate.points();
    let turn = plate.scale(2) * 0.5 * (g[1][0] - g[0][1]);
    let along = |row: [f64; 2]| (0..n).map(move |p| (row, p));
    let displacement = g.into_iter().flat_map(along).map(|(row, p)| {
        let [x, y] = plate.place(p);
        row[0] * x + row[1] * y
    });
    displacement.chain((0..n).map(|_| turn)).collect()
}

/// The unknowns `u` where `is_free` says no, and what equilibrium without loads makes of the others.
pub(crate) fn relaxed(
    plate: &BeamBondOrthotropic,
    u: &[f64],
    is_free: impl Fn([f64; 2]) -> bool,
) -> Vec<f64> {
    let (k, n) = (stiffness(plate), plate.points());
    let (free, held): (Vec<usize>, Vec<usize>) = (0..3 * n).partition(|i| is_free(plate.place(i % n)));
    let part = |rows: &[usize], columns: &[usize]| k.select_rows(rows).select_columns(columns);
    let given = DVector::from_iterator(held.len(), held.iter().map(|&i| u[i]));
    let load = -(part(&free, &held) * given);
    let found = part(&free, &free).cholesky().expect("a held plate").solve(&load);
    let mut all = u.to_vec();
    free.iter().zip(found.iter()).for_each(|(&i, &value)| all[i] = value);
    all
}
