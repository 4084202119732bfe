//! Plates whose bonds break.

use super::body::scaled_eigenvalues;
use super::steps::perforated;
use super::{assert_close, parameters, plate, section, square};
use crate::body::SquareLattice;
use crate::model::plate_bending::{
    CriticalCurvature, CriticalCurvatures, CriticalShear, PlateBending, PlateParameters,
};
use crate::model::{Breakable, Model};
use crate::stiffness::Term;

const EVERY: CriticalCurvature = CriticalCurvature { curvature: 1.0, shear: CriticalShear::Strain(1.0) };

/// Numbers of all bonds that are there.
fn bonds(plate: &PlateBending) -> Vec<u64> {
    let n = plate.nodes().points();
    // Every bond bends and shears.
    let u: Vec<f64> = (0..3 * n).map(|k| ((k * k) as f64).sin()).collect();
    let sections = 1 + plate.sections().others.len();
    let mut found = Vec::new();
    plate.for_each_ratio(&u, &CriticalCurvatures(vec![EVERY; sections]), &mut |bond, _| found.push(bond));
    found
}

/// Those between columns of points to the left and to the right of a place.
fn across(plate: &PlateBending, x: f64) -> Vec<u64> {
    let is_across = |bond: &u64| {
        let [a, b] = plate.ends(*bond).map(|point| plate.nodes().place(point)[0]);
        (a - x) * (b - x) < 0.0
    };
    bonds(plate).into_iter().filter(is_across).collect()
}

fn energy(terms: &[Box<dyn Term<3>>], u: &[f64]) -> f64 {
    terms.iter().map(|term| term.survey(u).energy).sum()
}

#[test]
fn what_breaks_takes_its_energy_and_its_forces() {
    for plate in [perforated(1.5, 0.3), square(6, parameters(1.5, 0.01))] {
        let n = plate.nodes().points();
        let u: Vec<f64> = (0..3 * n).map(|k| (k as f64 * 0.7).cos()).collect();
        let of = |terms: &[Box<dyn Term<3>>]| {
            let mut force = vec![0.0; 3 * n];
            terms.iter().for_each(|term| term.add_force(&u, &mut force));
            force
        };
        let (mut broken, mut lost) = (plate.clone(), vec![0.0; 3 * n]);
        let mut released = 0.0;
        // In three goes, so that cells lose triangles that have lost some before.
        for go in 0..3 {
            let now: Vec<u64> = bonds(&broken).into_iter().filter(|bond| bond % 5 == go).collect();
            let part = broken.part(&now);
            released += energy(&part, &u);
            lost.iter_mut().zip(of(&part)).for_each(|(lost, f)| *lost += f);
            broken.break_bonds(&now);
        }
        let (before, after) = (plate.terms(), broken.terms());
        assert_close(energy(&after, &u), energy(&before, &u) - released, 1e-12);
        let scale = of(&before).iter().fold(0.0, |most: f64, f| most.max(f.abs()));
        let sums = of(&after).into_iter().zip(lost).map(|(f, lost)| f + lost);
        assert!(sums.zip(of(&before)).all(|(f, before)| (f - before).abs() < 1e-13 * scale));
        let tangent = super::stiffness(n, &after) * nalgebra::DVector::from_column_slice(&u);
        assert!(tangent.iter().zip(of(&after)).all(|(f, exact)| (f - exact).abs() < 1e-13 * scale));
        let damage = broken.damage();
        let cut = bonds(&plate).len() - bonds(&broken).len();
        assert!(
            cut > 50 && damage.iter().all(|d| (0.0..=1.0).contains(d)) && damage.iter().any(|d| *d > 0.5)
        );
    }
}

#[test]
fn a_plate_that_is_cut_through_is_two() {
    for nu in [-0.4, 0.0, 0.3, 1.0 / 3.0, 0.45] {
        let parameters = PlateParameters { section: section(nu, 0.05), ..parameters(1.5, 0.05) };
        let mut plate = plate(SquareLattice::rectangle(0.1, [0.0; 2], [7, 4]), parameters);
        plate.break_bonds(&across(&plate, 0.35));
        let values = scaled_eigenvalues(&plate);
        // 1e-2 and more is found.
        assert!(values[5].abs() < 1e-12 && values[6] > 5e-3, "{nu}: {:?}", &values[..8]);
        assert_eq!(plate.connected().spans().len(), 2);
    }
}

#[test]
fn critical_strains_hold_the_energy_of_a_crack() {
    let plate = square(10, parameters(1.5, 0.3));
    let critical = plate.critical_of_energy(&[2.0]).0[0];
    // β = 0.65 and c_dev = 0.05 at ν = 0.3; 0.75 h are the bonds of the four half offsets, a quarter each.
    assert_close(critical.curvature.powi(2), 2.0 / (0.1 * (2.0 * 0.65 * 0.75 + 0.25 * 0.05)), 1e-12);
    // Weights of shear of P2: 0.330717489 along, 0.169282511 across the diagonals.
    let crossing = 0.1 * (0.330717489 + 2.0 * 0.169282511);
    let CriticalShear::Energy(energy) = critical.shear else { panic!("{critical:?}") };
    assert_close(energy, 2.0 / crossing, 1e-8);
}

#[test]
fn thick_plates_break_in_shear_at_the_strain_of_their_energy() {
    // Weights are a third along and a sixth across the diagonals: S γ_c² 2h/3 = G_c t.
    let plate = square(10, parameters(1.5, 1e3));
    let strain = (2.0_f64 / (3.5e-6 * 0.1 * 2.0 / 3.0)).sqrt();
    let n = plate.nodes().points();
    let mut u = vec![0.0; 3 * n];
    (0..n).for_each(|p| u[p] = strain * plate.nodes().place(p)[1]);
    let mut largest = 0.0_f64;
    plate.for_each_ratio(&u, &plate.critical_of_energy(&[2.0]), &mut |_, ratio| largest = largest.max(ratio));
    assert_close(largest, 1.0, 1e-6);
}
