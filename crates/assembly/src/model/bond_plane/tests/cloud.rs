//! Clouds of points.

use super::super::*;
use super::bodies::*;
use super::patch::{STRAINS, check_fields, check_rigid, strain_of};
use crate::model::Breakable;
use crate::model::Points;
use crate::model::plane::{Calibration, CriticalStretch, Edges, PlaneModel};

/// Scattered points in a rectangle with a hole, areas that differ, in a unit of length.
pub(super) fn scattered(unit: f64) -> (Vec<[f64; 2]>, Vec<f64>) {
    let (mut positions, mut areas) = (Vec::new(), Vec::new());
    for k in 0..16 * 12 {
        let (i, j) = ((k % 16) as f64, (k / 16) as f64);
        let shift = |s: usize| 0.7 * (((k * s) % 101) as f64 / 101.0 - 0.5);
        let (x, y) = (i + shift(37), j + shift(61));
        if (x - 8.0).hypot(y - 6.0) > 2.5 {
            positions.push([unit * x, unit * y]);
            areas.push(unit * unit * (1.0 + 0.5 * shift(17)));
        }
    }
    (positions, areas)
}

fn cloud(units: [f64; 3], parameters: PlaneParameters) -> BondPlane {
    let (positions, areas) = scattered(units[0]);
    BondPlane::on_cloud(positions, areas, 3.0 * units[0], parameters, &|_, _| false).unwrap()
}

#[test]
fn any_cloud_passes_the_patch_test() {
    for units in UNITS {
        for influence in [Influence::Constant, Influence::Inverse, Influence::Linear] {
            let plane = cloud(units, PlaneParameters { influence, ..parameters(3.0, units) });
            assert_eq!(plane.uncorrected(), 0);
            check_rigid("cloud", &plane);
            for g in STRAINS {
                check_fields("cloud", &plane, g);
                let stress = plane.parameters().material.stress(strain_of(g));
                let exact = linear(&plane, g);
                let mut load = vec![0.0; exact.len()];
                plane.add_stress_load(None, &|_, _| stress, &mut load);
                let error = difference(&solve(&plane, &load, &exact), &exact) / largest(&exact);
                assert!(error < 1e-12, "{error:e}");
            }
        }
    }
}

#[test]
fn clouds_are_semidefinite_with_or_without_a_crack() {
    let (positions, areas) = scattered(1.0);
    let crack = |a: [f64; 2], b: [f64; 2]| (a[1] < 6.0) != (b[1] < 6.0) && a[0].min(b[0]) < 4.0;
    for cut in [false, true] {
        let plane =
            BondPlane::on_cloud(positions.clone(), areas.clone(), 3.0, parameters(3.0, MM_MPA), &|a, b| {
                cut && crack(a, b)
            });
        let plane = plane.unwrap();
        let k = matrix(&plane);
        let size = k.amax();
        let eigenvalues = k.symmetric_eigenvalues();
        assert!(eigenvalues.min() > -1e-14 * size, "{:e}", eigenvalues.min() / size);
        assert_eq!(eigenvalues.iter().filter(|v| v.abs() < 1e-9 * size).count(), 3);
        assert_eq!(plane.damage().iter().any(|&d| d > 0.2), cut);
    }
}

#[test]
fn a_published_cloud_of_cells_is_the_published_lattice() {
    let (_, lattice) = &bodies(1.0)[0];
    for factor in [VolumeFactor::Full, VolumeFactor::Clip, VolumeFactor::Ramp] {
        for edges in [Edges::None, Edges::Energy] {
            let parameters = PlaneParameters {
                calibration: Calibration::Published,
                volume_factor: factor,
                edges,
                ..parameters(3.0, MM_MPA)
            };
            let positions: Vec<[f64; 2]> = (0..lattice.points()).map(|p| lattice.place(p)).collect();
            let areas = vec![1.0; positions.len()];
            let cloud = BondPlane::on_cloud(positions, areas, 3.0, parameters, &|_, _| false).unwrap();
            let plane = plane(lattice, parameters);
            let u = random(2 * plane.points());
            let forces = [force(&plane, &u), force(&cloud, &u)];
            assert!(difference(&forces[0], &forces[1]) < 1e-13 * largest(&forces[0]), "{factor:?}");
            let fields = [plane.fields(&u), cloud.fields(&u)];
            for q in 0..3 {
                let error = difference(&fields[0].stress[q], &fields[1].stress[q]);
                assert!(error < 1e-12 * largest(&fields[0].stress[q]));
            }
        }
    }
}

#[test]
fn volumes_of_families_make_up_for_what_a_disc_lacks() {
    let of = |edges| {
        let published = PlaneParameters {
            calibration: Calibration::Published,
            volume_factor: VolumeFactor::Full,
            edges,
            ..parameters(3.0, MM_MPA)
        };
        let positions = vec![[0.0, 0.0], [1.0, 0.5]];
        BondPlane::on_cloud(positions, vec![1.0, 2.0], 3.0, published, &|_, _| false).unwrap()
    };
    let u = [0.0, 1e-3, 0.0, 0.0];
    let forces = [Edges::None, Edges::Volume].map(|edges| force(&of(edges), &u)[1]);
    // A disc of the radius 3 over the mean of the families, which are the other point each.
    let factor = 9.0 * std::f64::consts::PI / 1.5;
    assert!(forces[0] > 0.0 && (forces[1] / forces[0] / factor - 1.0).abs() < 1e-14, "{forces:?}");
}

#[test]
fn what_clouds_cannot_have_is_refused() {
    let of = |parameters, positions: Vec<[f64; 2]>| {
        let areas = vec![1.0; positions.len()];
        BondPlane::on_cloud(positions, areas, 3.0, parameters, &|_, _| false).map(|p| p.points())
    };
    let area = PlaneParameters {
        calibration: Calibration::Published,
        volume_factor: VolumeFactor::Area,
        edges: Edges::None,
        ..parameters(3.0, MM_MPA)
    };
    assert_eq!(of(area, vec![[0.0; 2]]), Err(BondPlaneError::AreaNeedsCells));
    let twice = of(parameters(3.0, MM_MPA), vec![[0.0; 2], [0.0; 2]]);
    assert_eq!(twice, Err(BondPlaneError::Coincident { first: 0, second: 1 }));
}

#[test]
fn a_point_that_loses_its_bonds_is_damaged_wholly() {
    for calibration in [Calibration::Matched, Calibration::Published] {
        let given = PlaneParameters { calibration, edges: Edges::None, ..parameters(3.0, MM_MPA) };
        let mut plane = cloud(MM_MPA, given);
        let n = plane.points();
        // All bonds are longer in a body that swells.
        let u: Vec<f64> = (0..2 * n).map(|k| plane.place(k % n)[k / n]).collect();
        let (mut own, mut neighbours) = (Vec::new(), Vec::new());
        plane.for_each_ratio(&u, &CriticalStretch::new(vec![0.5]), &mut |bond, ratio| {
            // A stretch of one.
            assert!((ratio - 2.0).abs() < 1e-12);
            let [i, j] = plane.ends(bond);
            if i == 70 || j == 70 {
                own.push(bond);
                neighbours.push(i + j - 70);
            }
        });
        assert!(own.len() > 10);
        plane.break_bonds(&own);
        for (point, damage) in plane.damage().into_iter().enumerate() {
            match point {
                70 => assert!((damage - 1.0).abs() < 1e-14, "{damage}"),
                _ if neighbours.contains(&point) => assert!(damage > 0.0 && damage < 0.2, "{damage}"),
                _ => assert_eq!(damage, 0.0),
            }
        }
    }
}
