//! What holds for solids of listed points.

mod lattice;

use super::super::super::solid::tests::{BONDS, energy, force, gradient, linear, matrix};
use super::*;
use crate::model::bond_plane::Influence;
use crate::model::bond_plane::tests::bodies::{difference, largest, random};
use crate::model::plane::Solvable;
use crate::model::solid::SolidModel;
use crate::model::{BodyModel, Model, Points};
use nalgebra::Matrix6;

const STRESS: [f64; 6] = [1.0, 0.3, -0.5, 0.2, -0.4, 0.7];

/// Scattered points in a block with a hole through it, volumes that differ, in a unit of length.
fn scattered(unit: f64) -> (Vec<[f64; 3]>, Vec<f64>) {
    let (mut positions, mut volumes) = (Vec::new(), Vec::new());
    for k in 0..9 * 8 * 7 {
        let at = [k % 9, k / 9 % 8, k / 72].map(|x| x as f64);
        let shift = |s: usize| 0.6 * (((k * s) % 101) as f64 / 101.0 - 0.5);
        let [x, y, z] = [0, 1, 2].map(|axis| at[axis] + shift([37, 61, 83][axis]));
        if (x - 4.0).hypot(y - 3.5) > 1.7 {
            positions.push([x, y, z].map(|x| unit * x));
            volumes.push(unit.powi(3) * (1.0 + 0.5 * shift(17)));
        }
    }
    (positions, volumes)
}

fn cloud(unit: f64, horizon: f64, parameters: BondSolidParameters) -> BondSolidCloud {
    let (positions, volumes) = scattered(unit);
    assert!((380..460).contains(&positions.len()), "{}", positions.len());
    BondSolidCloud::new(positions, volumes, horizon * unit, parameters, &|_, _| false).unwrap()
}

/// Stress, energy densities, the load of the stress and the whole energy in a uniform strain.
fn check_fields(name: &str, solid: &BondSolidCloud) {
    let (n, strain) = (solid.points(), solid.strain_of(STRESS));
    let u = linear(solid, gradient(strain));
    let fields = solid.fields(&u);
    let density = 0.5 * (0..6).map(|q| STRESS[q] * strain[q]).sum::<f64>();
    for p in 0..n {
        let error = (0..6).map(|q| (fields.stress[q][p] - STRESS[q]).abs()).fold(0.0, f64::max);
        assert!(error < 1e-12, "{name} {p}: {error:e}");
        assert!((fields.energy_density[p] / density - 1.0).abs() < 1e-12, "{name} {p}");
    }
    let mut load = vec![0.0; 3 * n];
    solid.add_stress_load(&|_, _| STRESS, &mut load);
    let internal = force(solid, &u);
    assert!(difference(&load, &internal) < 1e-12 * largest(&internal), "{name}");
    let volume: f64 = (0..n).map(|p| solid.volume(p)).sum();
    assert!((energy(solid, &u) / (density * volume) - 1.0).abs() < 1e-12, "{name}");
}

#[test]
fn any_cloud_has_the_stiffness_of_the_material() {
    for influence in [Influence::Constant, Influence::Inverse, Influence::Linear] {
        for (unit, horizon, edges) in
            [(1.0, 2.2, SolidEdges::Overlay), (1e-3, 2.2, SolidEdges::Border), (1.0, 3.0, SolidEdges::Border)]
        {
            let solid = cloud(unit, horizon, BondSolidParameters { influence, edges, ..BONDS });
            assert_eq!((solid.uncorrected(), solid.faces()), (0, SolidEdges::Overlay));
            assert!(solid.triangles() > solid.points() && solid.damage().iter().all(|d| *d == 0.0));
            check_fields(&format!("{influence:?} {unit} {horizon}"), &solid);
        }
    }
}

/// Every kind of uniform strain by itself: the energy is ½ ε:C:ε V.
#[test]
fn every_uniform_strain_has_its_energy() {
    let solid = cloud(1.0, 2.2, BONDS);
    let volume: f64 = (0..solid.points()).map(|p| solid.volume(p)).sum();
    let stiffness = solid.stiffness();
    for r in 0..6 {
        for c in 0..=r {
            let strain: [f64; 6] = std::array::from_fn(|q| f64::from(q == r) - 0.4 * f64::from(q == c));
            let exact: f64 =
                (0..36).map(|k| 0.5 * strain[k / 6] * stiffness[k / 6][k % 6] * strain[k % 6]).sum();
            let found = energy(&solid, &linear(&solid, gradient(strain))) / volume;
            assert!((found / exact - 1.0).abs() < 1e-12, "{r} {c}: {found} {exact}");
        }
    }
}

#[test]
fn bonds_are_nowhere_stiffer_than_the_material_and_somewhere_as_stiff() {
    let solid = cloud(1.0, 2.2, BondSolidParameters { edges: SolidEdges::None, ..BONDS });
    assert_eq!((solid.triangles(), solid.faces()), (0, SolidEdges::None));
    // Moments of all points, a column per strain.
    let columns: Vec<[Vec<f64>; 6]> = (0..6)
        .map(|r| solid.fields(&linear(&solid, gradient(std::array::from_fn(|q| f64::from(q == r))))).stress)
        .collect();
    let stiffness = solid.stiffness();
    let least = (0..solid.points()).map(|p| {
        let lack = Matrix6::from_fn(|q, r| stiffness[q][r] - columns[r][q][p]);
        assert!((lack - lack.transpose()).amax() < 1e-14);
        lack.symmetric_eigenvalues().min()
    });
    let least: Vec<f64> = least.collect();
    assert!(least.iter().all(|least| *least > -1e-14), "{least:?}");
    assert!(least.iter().any(|least| *least < 1e-14));
}

#[test]
fn a_cloud_is_symmetric_and_has_six_rigid_motions() {
    let solid = cloud(1.0, 2.0, BONDS);
    let n = solid.points();
    let k = matrix(&solid);
    let size = k.amax();
    let (u, v) = (random(3 * n), random(3 * n).into_iter().rev().collect::<Vec<_>>());
    let work = |u: &[f64], v: &[f64]| force(&solid, u).iter().zip(v).map(|(f, v)| f * v).sum::<f64>();
    assert!((work(&u, &v) - work(&v, &u)).abs() < 1e-12 * work(&u, &u));
    let product = &k * nalgebra::DVector::from_vec(u.clone());
    assert!(difference(product.as_slice(), &force(&solid, &u)) < 1e-12 * largest(product.as_slice()));
    let values = k.symmetric_eigenvalues();
    assert!(values.min() > -1e-13 * size, "{:e}", values.min() / size);
    assert_eq!(values.iter().filter(|v| v.abs() < 1e-9 * size).count(), 6);
    let scale = energy(&solid, &linear(&solid, gradient([1.0, 0.0, 0.0, 0.0, 0.0, 0.0])));
    for kind in 0..6 {
        let motions = (0..n).map(|p| solid.rigid_motion(kind, p, [5.0, -3.0, 2.0]));
        let mut u = vec![0.0; 3 * n];
        motions.enumerate().for_each(|(p, motion)| (0..3).for_each(|c| u[c * n + p] = motion[c]));
        assert!(largest(&u) > 0.9 && energy(&solid, &u).abs() < 1e-24 * scale, "{kind}");
    }
}

#[test]
fn forces_of_strains_are_the_adjoint_of_stresses() {
    for edges in [SolidEdges::Overlay, SolidEdges::None] {
        let solid = cloud(1.0, 2.2, BondSolidParameters { edges, ..BONDS });
        let n = solid.points();
        let (u, mut t) = (random(3 * n), random(6 * n).into_iter().rev().collect::<Vec<_>>());
        let stress = solid.fields(&u).stress;
        let terms: Vec<f64> = (0..6 * n).map(|k| t[k] * stress[k / n][k % n] * solid.volume(k % n)).collect();
        let mut load = vec![0.0; 3 * n];
        solid.add_strain_work(&mut t, &mut load);
        let work: f64 = load.iter().zip(&u).map(|(f, u)| f * u).sum();
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        assert!((work - terms.iter().sum::<f64>()).abs() < 1e-14 * size && size > 1.0, "{edges:?}");
    }
}

/// Layers so dense that the nearest points of every point lie in its own.
#[test]
fn dense_layers_are_completed_across_them() {
    let at = |k: i32| [f64::from(k % 8) * 0.4, f64::from(k / 8 % 8) * 0.4, f64::from(k / 64)];
    let positions: Vec<[f64; 3]> = (0..256).map(at).collect();
    let solid = BondSolidCloud::new(positions, vec![0.16; 256], 1.5, BONDS, &|_, _| false).unwrap();
    assert_eq!(solid.uncorrected(), 0);
    check_fields("layers", &solid);
}

#[test]
fn a_cut_separates_a_body() {
    let (positions, volumes) = scattered(1.0);
    let cut = |a: [f64; 3], b: [f64; 3]| (a[2] < 3.0) != (b[2] < 3.0);
    let solid = BondSolidCloud::new(positions, volumes, 2.2, BONDS, &cut).unwrap();
    assert_eq!(solid.connected().spans().len(), 2);
    assert_eq!(cloud(1.0, 2.2, BONDS).connected().spans().len(), 1);
    let damage = solid.damage();
    for (p, damage) in damage.iter().enumerate() {
        let far = (solid.position(p)[2] - 3.0).abs();
        assert!((0.0..1.0).contains(damage) && (far < 2.2 || *damage == 0.0), "{p} {damage}");
    }
    assert!(damage.iter().any(|d| *d > 0.3));
    // Each part moves by itself.
    let n = solid.points();
    let mut u = vec![0.0; 3 * n];
    (0..n).filter(|&p| solid.position(p)[2] > 3.0).for_each(|p| u[p] = 1.0);
    assert_eq!(energy(&solid, &u), 0.0);
}

#[test]
fn points_of_a_plane_and_a_line_are_not_corrected() {
    for depth in [1, 6] {
        let positions: Vec<[f64; 3]> =
            (0..6 * depth).map(|k| [f64::from(k % 6), 0.3, f64::from(k / 6)]).collect();
        let n = positions.len();
        let solid = BondSolidCloud::new(positions, vec![1.0; n], 2.2, BONDS, &|_, _| false).unwrap();
        assert_eq!((solid.uncorrected(), solid.triangles()), (n, 0));
        let stress = solid.fields(&linear(&solid, gradient([1.0, 0.0, 0.0, 0.0, 0.0, 0.0]))).stress;
        assert!(stress[0].iter().all(|s| *s > 0.0 && *s < 1.2), "{:?}", stress[0]);
        assert!(solid.calibration_error() < 1e-12);
    }
}

#[test]
fn what_clouds_cannot_have_is_refused() {
    let of = |parameters, positions: Vec<[f64; 3]>| {
        let volumes = vec![8.0; positions.len()];
        BondSolidCloud::new(positions, volumes, 3.0, parameters, &|_, _| false).map(|solid| solid.points())
    };
    let pair = vec![[0.0; 3], [0.0, 0.0, 1.0]];
    let published = BondSolidParameters { calibration: Calibration::Published, ..BONDS };
    assert_eq!(of(published, pair.clone()), Err(SolidError::EdgesNeedMatched));
    let bare = BondSolidParameters { edges: SolidEdges::None, ..published };
    assert_eq!(of(bare, pair.clone()), Ok(2));
    let area = BondSolidParameters { volume_factor: VolumeFactor::Area, ..bare };
    assert_eq!(of(area, pair), Err(SolidError::AreaNeedsCells));
    assert_eq!(of(BONDS, vec![[0.0; 3]; 2]), Err(SolidError::Coincident { first: 0, second: 1 }));
    let apart = of(BONDS, vec![[0.0; 3], [0.0, 0.0, 4.0]]);
    assert_eq!(apart, Err(SolidError::NoNeighbours { horizon_ratio: 1.5 }));
}

#[test]
fn what_a_cloud_is_not_is_said() {
    let solid: Box<dyn Solvable<3>> = Box::new(cloud(1.0, 2.0, BONDS));
    assert!(solid.coarser(&|_, _| Vec::new()).is_none() && solid.breaking().is_none());
    assert!(solid.unbreakable().is_some() && solid.lattice().is_none() && solid.ghosts().is_empty());
    let of = solid.as_solid().unwrap();
    assert!(of.bonds_of_a_point().is_empty() && of.cut_bonds().is_empty() && of.bonds_on_border().is_none());
}
