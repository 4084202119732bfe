//! Points, bonds and motions of bodies.

use super::{parameters, plate, section, stiffness};
use crate::body::SquareLattice;
use crate::model::Model;
use crate::model::plate_bending::{PlateBending, PlateParameters, ShearLaw};
use nalgebra::DMatrix;

/// 12 × 10 cells with a hole.
pub(super) fn holed(parameters: PlateParameters) -> PlateBending {
    let inside = |[i, j]: [i32; 2]| !((5..8).contains(&i) && (4..7).contains(&j));
    plate(SquareLattice::plane(0.1, [0.0; 2], 0..12, 0..10, inside), parameters)
}

#[test]
fn points_lie_on_edges_and_share_the_area_of_the_cells() {
    let plate = holed(parameters(1.5, 0.3));
    assert_eq!(plate.nodes().points(), 139);
    let total: f64 = (0..139).map(|p| plate.nodes().area(p)).sum();
    assert!((total - 1.11).abs() < 1e-14);
    let corner = plate.nodes().number([0, 0]).unwrap();
    assert_eq!(plate.nodes().place(corner), [0.0, 0.0]);
    assert!((plate.nodes().area(corner) - 0.0025).abs() < 1e-16);
}

#[test]
fn bonds_and_pieces_are_those_of_the_line_cover() {
    // P17.
    let count = |m: f64| {
        let plate = holed(parameters(m, 0.3));
        [plate.bonds() + plate.pieces(), plate.pieces()]
    };
    assert_eq!(count(1.5), [472, 0]);
    let [all, pieces] = count(3.0);
    assert_eq!(all, 1918);
    assert!(pieces > 0);
}

#[test]
fn edges_run_around_the_body_and_its_holes() {
    let edges = holed(parameters(1.5, 0.3)).nodes().edges();
    assert_eq!(edges.len(), 2 * (12 + 10) + 4 * 3);
    let sum = |k: usize| edges.iter().map(|edge| edge.outward[k]).sum::<f64>();
    assert_eq!([sum(0), sum(1)], [0.0; 2]);
}

/// Eigenvalues of the stiffness with a diagonal of ones, ascending.
pub(super) fn scaled_eigenvalues(plate: &PlateBending) -> Vec<f64> {
    let k = stiffness(plate.nodes().points(), &plate.terms());
    let scale: Vec<f64> = k.diagonal().iter().map(|d| 1.0 / d.sqrt()).collect();
    let scaled = DMatrix::from_fn(k.nrows(), k.ncols(), |a, b| scale[a] * k[(a, b)] * scale[b]);
    let mut values: Vec<f64> = scaled.symmetric_eigenvalues().iter().copied().collect();
    values.sort_by(f64::total_cmp);
    values
}

#[test]
fn a_free_plate_has_three_motions_without_energy_at_every_thickness() {
    // P8.
    let inside = |[i, j]: [i32; 2]| !((3..5).contains(&i) && (3..5).contains(&j));
    let cells = SquareLattice::plane(0.1, [0.0; 2], 0..8, 0..7, inside);
    for m in [1.5, 2.0, 3.0, 3.2] {
        for (nu, t) in [(-0.5, 0.3), (0.0, 1e-4), (0.3, 0.3), (0.3, 1e-4), (0.45, 1e-4)] {
            let parameters =
                PlateParameters { section: section(nu, t), horizon_ratio: m, shear_law: ShearLaw::Corrected };
            let values = scaled_eigenvalues(&plate(cells.clone(), parameters));
            assert!(values[2].abs() < 1e-12, "m = {m}, nu = {nu}, t = {t}: {values:?}");
            assert!(values[3] > 5e-4, "m = {m}, nu = {nu}, t = {t}: {}", values[3]);
        }
    }
}

#[test]
fn rigid_motions_move_without_force() {
    // P5; the largest entry of the stiffness is the unit.
    for m in [1.5, 3.0] {
        let plate = holed(parameters(m, 1e-3));
        let (n, terms) = (plate.nodes().points(), plate.terms());
        let scale = stiffness(n, &terms).amax();
        for kind in 0..3 {
            let mut u = vec![0.0; 3 * n];
            for point in 0..n {
                let motion = plate.rigid_motion(kind, point, [0.3, 0.2, 0.0]);
                (0..3).for_each(|c| u[c * n + point] = motion[c]);
            }
            let mut force = vec![0.0; 3 * n];
            terms.iter().for_each(|term| term.add_force(&u, &mut force));
            let largest = force.iter().fold(0.0_f64, |most, f| most.max(f.abs()));
            assert!(largest < 1e-14 * scale, "{kind}: {largest} of {scale}");
        }
    }
}
