//! Plates of beam bonds pass the checks of every model: fibres at several angles, also in one body, all calibrations and edges,
//! lines of symmetry, turned lattices, random cuts, and after random bonds have broken.

use super::consistency::{Noise, check};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::BodyModel;
use peristat_assembly::model::beam_bond_orthotropic::{
    BeamBondOrthotropic, Laminae, OrthotropicMaterial, OrthotropicParameters,
};
use peristat_assembly::model::plane::{Calibration, CriticalStretch, Edges, Mirrors};
use peristat_assembly::model::{Breakable, Model, Points};
use peristat_assembly::stiffness::Term;
use proptest::prelude::*;
use std::sync::Arc;

/// Degrees from the rows of the lattice, and horizon ratios.
const FIBRES: [(f64, f64); 6] =
    [(0.0, 3.0), (90.0, 2.0), (45.0, 3.0), (15.0, 3.2), (-30.0, 4.0), (117.0, 3.2)];

/// Fibres, treatments of edges that a calibration allows, an angle of the lattice.
fn parameters(choice: usize) -> OrthotropicParameters {
    let pick = |k: usize, of: usize| choice / k % of;
    let (degrees, horizon_ratio) = FIBRES[pick(1, 6)];
    let edges = [Edges::Overlay, Edges::None, Edges::Volume, Edges::Energy][pick(6, 4)];
    let matched = edges == Edges::Overlay || pick(24, 2) == 0 || degrees % 45.0 != 0.0;
    let lattice_angle = [0.0, 0.3][pick(48, 2)];
    OrthotropicParameters {
        material: OrthotropicMaterial {
            youngs_modulus_1: 4.0,
            youngs_modulus_2: 1.0,
            poisson_ratio_12: 0.28,
            shear_modulus_12: 0.42,
            thickness: 0.7,
        },
        fibre_angle: degrees.to_radians() + lattice_angle,
        lattice_angle,
        horizon_ratio,
        calibration: if matched { Calibration::Matched } else { Calibration::Published },
        start: None,
        edges,
    }
}

/// Energy of some unknowns in terms.
fn energy(terms: &[Box<dyn Term<3>>], u: &[f64]) -> f64 {
    terms.iter().map(|term| term.survey(u).energy).sum()
}

/// Breaks some bonds that are stretched: what is left is a model, and the energy falls by that of the part.
fn check_broken(plate: &mut BeamBondOrthotropic, noise: &mut Noise, seed: u64) {
    let u = noise.vector(3 * plate.points());
    let offsets = BeamBondOrthotropic::offsets(plate.parameters(), &[]).expect("the bonds exist").len();
    let mut bonds = Vec::new();
    plate.for_each_ratio(&u, &CriticalStretch::new(vec![1.0; offsets]), &mut |bond, _| bonds.push(bond));
    let mut broken: Vec<u64> = bonds.into_iter().filter(|_| noise.next() > 0.6).collect();
    broken.sort_unstable();
    let (before, part) = (energy(&plate.terms(), &u), energy(&plate.part(&broken), &u));
    plate.break_bonds(&broken);
    let after = energy(&plate.terms(), &u);
    // Nothing but rounding.
    assert!((before - part - after).abs() <= 1e-13 * before, "{before} {part} {after}");
    assert!(plate.damage().iter().all(|d| (0.0..=1.0 + 1e-12).contains(d)));
    check::<3, _>(plate, &Vec::new, seed);
}

proptest! {
    #![proptest_config(super::cases(40))]

    #[test]
    fn a_lattice_of_beam_bonds_is_consistent_in_any_treatment_intact_and_broken(
        columns in 2_i32..70, rows in 2_i32..6, choice in 0_usize..96, holes in 0_usize..8, cut in 0_usize..40,
        mirrored in prop::array::uniform4(any::<bool>()), seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let parameters = parameters(choice);
        let holes: Vec<[i32; 2]> =
            (0..holes).map(|_| [noise.index(columns as usize) as i32, noise.index(rows as usize) as i32]).collect();
        let real = SquareLattice::plane(0.5, [1.0, -3.0], 0..columns, 0..rows, |c| !holes.contains(&c));
        let real = if parameters.lattice_angle == 0.0 { real } else { real.turned(parameters.lattice_angle, [1.0, -3.0]) };
        // Only fibres along or across a line are their own image in it.
        let fibres = parameters.relative_angle().to_degrees();
        let has_mirrors = parameters.lattice_angle == 0.0 && (fibres.abs() < 1e-9 || (fibres - 90.0).abs() < 1e-9);
        let line = |k: usize, at: i32| (has_mirrors && mirrored[k]).then_some(at);
        let mirrors = Mirrors::in_plane([line(0, 0), line(1, columns)], [line(2, 0), line(3, rows)]);
        let depth = BeamBondOrthotropic::depth(&parameters, &[]).expect("the bonds exist");
        let lattice = mirrors.extended(&real, depth);
        let offsets = BeamBondOrthotropic::offsets(&parameters, &[]).expect("the bonds exist");
        let cuts: Vec<(usize, usize)> =
            (0..cut).map(|_| (noise.index(offsets.len()), noise.index(lattice.points()))).collect();
        let mut plate = BeamBondOrthotropic::on_lattice(Arc::new(lattice), mirrors, parameters, &cuts)
            .expect("as before");
        prop_assert!(plate.damage().iter().all(|d| (0.0..=1.0).contains(d)));
        check::<3, _>(&plate, &Vec::new, seed);
        if mirrors.is_none() {
            check_broken(&mut plate, &mut noise, seed);
        }
    }

    #[test]
    fn laminae_side_by_side_are_one_body(
        columns in 3_i32..70, rows in 3_i32..7, choice in 0_usize..6, turns in prop::array::uniform2(0_usize..5),
        edges in any::<bool>(), stiff in any::<bool>(), cut in 0_usize..20, seed in any::<u64>()
    ) {
        let mut noise = Noise(seed);
        let edges = if edges { Edges::Overlay } else { Edges::Border };
        let own = parameters(choice);
        let parameters = OrthotropicParameters { edges, horizon_ratio: own.horizon_ratio.max(3.2), ..own };
        let angles = turns.map(|k| own.fibre_angle + [30.0_f64, 45.0, 72.0, 90.0, -10.0][k].to_radians()).to_vec();
        let lattice = SquareLattice::plane(0.5, [1.0, -3.0], 0..columns, 0..rows, |_| true);
        let first = noise.index(columns as usize) as i32;
        let own = |p: usize| u8::from(lattice.cell(p)[0] >= first) + u8::from(lattice.cell(p)[0] >= first + 2);
        let of: Vec<u8> = (0..lattice.points()).map(own).collect();
        let factors = if stiff { of.iter().map(|own| 1.0 + 9.0 * f64::from(*own)).collect() } else { Vec::new() };
        let offsets = BeamBondOrthotropic::offsets(&parameters, &angles).expect("the bonds exist");
        let cuts: Vec<(usize, usize)> =
            (0..cut).map(|_| (noise.index(offsets.len()), noise.index(lattice.points()))).collect();
        let parts = (factors, Laminae { angles, of });
        let plate = BeamBondOrthotropic::mixed(Arc::new(lattice), Mirrors::NONE, parameters, &cuts, parts)
            .expect("as before");
        check::<3, _>(&plate, &Vec::new, seed);
    }
}
