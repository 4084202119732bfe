//! Borders that cut cells, along fibres or not: uniform stresses are in equilibrium, and points do not turn in them.

use super::*;
use crate::body::{Hole, Outline, Shape};
use crate::model::BodyModel;
use crate::model::plane::through_border::through_border;
use crate::model::plane::{Mirrors, PlaneModel};
use crate::model::{Model, Points};
use nalgebra::DMatrix;
use std::sync::Arc;

/// Spacing, m.
const H: f64 = 1e-3;

fn plate(outline: &Outline, turned: f64, material: OrthotropicMaterial, m: f64) -> BeamBondOrthotropic {
    let lattice_angle = turned.to_radians();
    let parameters =
        OrthotropicParameters { lattice_angle, edges: Edges::Border, ..parameters(material, turned, m) };
    let lattice = Arc::new(outline.fill_turned(H, lattice_angle).unwrap());
    let plate = BeamBondOrthotropic::on_lattice(lattice, Mirrors::NONE, parameters, &[]).unwrap();
    assert_eq!((plate.uncorrected(), BodyModel::edges(&plate)), (0, Some(Edges::Border)));
    plate
}

/// A plate with a hole whose rows run along its sides, and one whose rows run along fibres at 30 degrees.
fn plates() -> Vec<(f64, BeamBondOrthotropic)> {
    let oblique = [[0.0, 3.1], [14.4, 0.0], [16.0, 12.2], [2.2, 14.5]].map(|at| at.map(|x| H * x));
    let oblique = Outline::polygon(oblique.to_vec()).unwrap();
    let mut pierced = Outline::rectangle([0.0; 2], [15.0 * H, 13.0 * H]).unwrap();
    let hole = Shape::Circle { centre: [7.4 * H, 6.7 * H], radius: 3.2 * H };
    pierced.cut(Hole { name: None, shape: hole }).unwrap();
    let of = |outline: &Outline, turned, material, m| {
        let holes = outline.holes().iter().filter_map(|hole| match hole.shape {
            Shape::Circle { radius, .. } => Some(std::f64::consts::PI * radius * radius),
            _ => None,
        });
        let area = outline.border().area().abs() - holes.sum::<f64>();
        (area, plate(outline, turned, material, m))
    };
    vec![
        of(&oblique, 0.0, A, 3.0),
        of(&oblique, 30.0, B, 3.2),
        of(&pierced, 0.0, A, 3.0),
        of(&pierced, 30.0, B, 3.2),
    ]
}

/// Unknowns of the strain of a stress, with a rotation w of the body and of its points.
fn uniform(plate: &BeamBondOrthotropic, stress: [f64; 3], w: f64) -> Vec<f64> {
    let (n, [xx, yy, xy]) = (plate.points(), plate.strain_of(stress));
    let mut u = vec![plate.scale(2) * w; 3 * n];
    for p in 0..n {
        let [x, y] = plate.place(p);
        u[p] = xx * x + (0.5 * xy - w) * y;
        u[n + p] = (0.5 * xy + w) * x + yy * y;
    }
    u
}

fn force(plate: &BeamBondOrthotropic, u: &[f64]) -> Vec<f64> {
    let mut force = vec![0.0; u.len()];
    plate.terms().iter().for_each(|term| term.add_force(u, &mut force));
    force
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |most, v| most.max(v.abs()))
}

#[test]
fn every_uniform_strain_has_the_energy_of_the_true_area() {
    for (area, plate) in plates() {
        for stress in [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.3, -0.2, 1.0]] {
            let u = uniform(&plate, stress, 1e-10);
            let strain = plate.strain_of(stress);
            let density = (0..3).map(|k| 0.5 * stress[k] * strain[k]).sum::<f64>();
            let found: f64 = plate.terms().iter().map(|term| term.survey(&u).energy).sum();
            // Corners, where two borders cut a block, are sampled: 2e-5 is found.
            let ratio = found / (density * area * plate.thickness());
            assert!((ratio - 1.0).abs() < 2e-4, "{ratio}");
            let fields = plate.fields(&u);
            for (found, stress) in fields.stress.iter().zip(stress) {
                let off = found.iter().map(|s| (s - stress).abs()).fold(0.0, f64::max);
                // 1e-13 is found.
                assert!(off < 1e-12, "{off:e}");
            }
        }
    }
}

#[test]
fn tractions_on_the_true_border_hold_every_uniform_stress() {
    let corners = [[0.0, 3.1], [14.4, 0.0], [16.0, 12.2], [2.2, 14.5]].map(|at| at.map(|x| H * x));
    let outline = Outline::polygon(corners.to_vec()).unwrap();
    for (_, plate) in &plates()[..2] {
        for stress in [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.7, -1.3, 0.4]] {
            let internal = force(plate, &uniform(plate, stress, 0.0));
            let sides: Vec<_> = outline.edges().iter().map(|e| ([e.from, e.to], e.normal)).collect();
            let load = through_border(plate, &sides, stress);
            let off: Vec<f64> = internal.iter().zip(&load).map(|(a, b)| a - b).collect();
            let (forces, couples) = off.split_at(2 * plate.points());
            let [forces, couples] = [forces, couples].map(|off| largest(off) / largest(&load));
            // 3e-15 is found; couples are in equilibrium over two spacings only: 1.6e-3 and 2.6e-2 per spacing.
            assert!(forces < 1e-12 && couples < 3e-2, "{forces:e} {couples:e}");
        }
    }
}

#[test]
fn only_rigid_motions_cost_nothing() {
    for (_, plate) in plates() {
        let size = 3 * plate.points();
        let mut matrix = DMatrix::zeros(size, size);
        for k in 0..size {
            let mut unit = vec![0.0; size];
            unit[k] = 1.0;
            matrix.column_mut(k).copy_from_slice(&force(&plate, &unit));
        }
        let values = matrix.symmetric_eigenvalues();
        let most = values.max();
        assert_eq!(values.iter().filter(|v| **v < 1e-9 * most).count(), 3);
        assert!(values.min() > -1e-13 * most, "{:e}", values.min() / most);
    }
}
