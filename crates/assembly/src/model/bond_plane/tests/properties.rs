//! Symmetry, force as the derivative of energy, definiteness, diagonal blocks, damage.

use super::super::*;
use super::bodies::*;
use crate::model::plane::{Calibration, Edges, Mirrors};
use crate::model::{Model, Points};

/// Plates of all kinds, some with a crack that ends inside.
fn planes() -> Vec<(&'static str, BondPlane)> {
    let mut all = Vec::new();
    for (edges, calibration) in [
        (Edges::Border, Calibration::Matched),
        (Edges::Overlay, Calibration::Matched),
        (Edges::Volume, Calibration::Matched),
        (Edges::None, Calibration::Published),
        (Edges::Energy, Calibration::Published),
    ] {
        let parameters = PlaneParameters { edges, calibration, ..parameters(3.0, MM_MPA) };
        let offsets = BondPlane::offsets(&parameters).unwrap();
        for (name, lattice) in bodies(1.0) {
            // Everything that crosses between columns 11 and 12 below row 4.
            let mut cuts = Vec::new();
            for lower in 0..lattice.points() {
                for (k, step) in offsets.iter().enumerate() {
                    let [i, j, _] = lattice.cell(lower);
                    if (i < 12) != (i + step[0] < 12) && j.max(j + step[1]) < 4 {
                        cuts.push((k, lower));
                    }
                }
            }
            all.push((name, plane(&lattice, parameters)));
            all.push((name, BondPlane::on_lattice(lattice, Mirrors::NONE, parameters, &cuts).unwrap()));
        }
    }
    all
}

#[test]
fn forces_are_derivatives_of_the_energy() {
    for (name, plane) in planes() {
        let u = random(2 * plane.points());
        let f = force(&plane, &u);
        let scale = largest(&f);
        for k in (0..u.len()).step_by(37) {
            // Energies are quadratic: central differences round only.
            let moved = [0.5, -0.5].map(|d| {
                let mut u = u.clone();
                u[k] += d;
                energy(&plane, &u)
            });
            assert!((moved[0] - moved[1] - f[k]).abs() < 1e-10 * scale, "{name} {k}");
        }
        let half = 0.5 * u.iter().zip(&f).map(|(u, f)| u * f).sum::<f64>();
        assert!((energy(&plane, &u) / half - 1.0).abs() < 1e-13, "{name}");
    }
}

#[test]
fn the_stiffness_is_semidefinite_with_the_force_as_its_product() {
    for (name, plane) in planes() {
        let k = matrix(&plane);
        let u = random(2 * plane.points());
        let product = &k * nalgebra::DVector::from_column_slice(&u);
        let f = force(&plane, &u);
        assert!(difference(product.as_slice(), &f) < 1e-13 * largest(&f), "{name}");
        let n = plane.points();
        let mut blocks = vec![[[0.0; 2]; 2]; n];
        plane.terms().iter().for_each(|t| t.add_diagonal(&mut blocks));
        for p in 0..n {
            for r in 0..2 {
                (0..2).for_each(|c| {
                    let error = (blocks[p][r][c] - k[(r * n + p, c * n + p)]).abs();
                    assert!(error < 1e-13 * k.amax(), "{name} {p}");
                });
            }
        }
        let size = k.amax();
        let eigenvalues = k.symmetric_eigenvalues();
        let least = eigenvalues.min();
        assert!(least > -1e-13 * size, "{name}: {least:e}");
        let free = eigenvalues.iter().filter(|v| v.abs() < 1e-9 * size).count();
        assert_eq!(free, 3, "{name}");
    }
}

#[test]
fn damage_is_the_cut_share_of_the_family() {
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [20, 20]));
    let parameters = parameters(3.0, MM_MPA);
    let offsets = BondPlane::offsets(&parameters).unwrap();
    let mut cuts = Vec::new();
    for lower in 0..lattice.points() {
        for (k, step) in offsets.iter().enumerate() {
            let [_, j, _] = lattice.cell(lower);
            if (j < 10) != (j + step[1] < 10) {
                cuts.push((k, lower));
            }
        }
    }
    let plane = BondPlane::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &cuts).unwrap();
    let damage = plane.damage();
    let at = |row| damage[lattice.number([10, row, 0]).unwrap()];
    // Of 28 neighbours 7, 5 + ... lie in the rows beyond: rows at distance 1, 2, 3 hold 5, 5 and 1 points.
    let expected = [(9, 11.0), (8, 6.0), (7, 1.0), (6, 0.0), (10, 11.0), (12, 1.0), (13, 0.0)];
    expected.iter().for_each(|&(row, count)| assert!((at(row) - count / 28.0).abs() < 1e-15, "{row}"));
    // What never was joined is no damage; a point that loses the rest of its family has none left.
    let (apart, broken): (Vec<_>, Vec<_>) = cuts.iter().partition(|c| offsets[c.0][0] != 0);
    let mut other = plane.clone();
    other.never_joined(&apart);
    assert!(broken.len() < apart.len());
    // Of its family the point below the line has lost three straight above it, and 8 were never there.
    assert!((other.damage()[lattice.number([10, 9, 0]).unwrap()] - 3.0 / 20.0).abs() < 1e-15);
    other.never_joined(&cuts);
    assert!(other.damage().iter().all(|&d| d == 0.0));
    // The two halves are held together by nothing: overlay triangles do not bridge a crack.
    let mut parts = crate::stiffness::ConnectedParts::new(plane.points());
    plane.terms().iter().for_each(|t| t.join(&mut parts));
    assert_eq!(parts.numbered().spans().len(), 2);
}

#[test]
fn points_without_triangles_are_counted() {
    let row = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [9, 1]));
    assert_eq!(plane(&row, parameters(3.0, MM_MPA)).uncorrected(), 9);
}
