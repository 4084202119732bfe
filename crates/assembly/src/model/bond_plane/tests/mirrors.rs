//! Half and quarter models.

use super::super::*;
use super::bodies::*;
use crate::condition::Constraints;
use crate::model::plane::{Calibration, Edges, Mirrors, Solvable};
use std::ops::Range;

/// Fills in the images of a displacement.
fn with_images(plane: &dyn Solvable<2>, mut u: Vec<f64>) -> Vec<f64> {
    let constraints = Constraints::new(plane.points(), &plane.relations()).unwrap();
    for row in constraints.rows() {
        u[row.unknown] = row.masters.iter().map(|&(master, c)| c * u[master]).sum();
    }
    u
}

/// Forces on real points, those on images brought back.
fn restricted(plane: &dyn Solvable<2>, mut f: Vec<f64>) -> Vec<f64> {
    let constraints = Constraints::new(plane.points(), &plane.relations()).unwrap();
    for row in constraints.rows() {
        let value = std::mem::take(&mut f[row.unknown]);
        row.masters.iter().for_each(|&(master, c)| f[master] += c * value);
    }
    f
}

/// A body with a hole and slanted ends that is symmetric in both directions, and its cuts.
fn inside([i, j]: [i32; 2]) -> bool {
    let (x, y) = (f64::from(i) + 0.5, f64::from(j) + 0.5);
    x.hypot(y) > 2.3 && x.abs() + 0.5 * y.abs() < 11.0
}

/// Bonds that cross one of the segments `y = ±4, |x| > 6` and `x = 0, |y| > 6`.
fn cuts(lattice: &SquareLattice, offsets: &[Cell]) -> Vec<(usize, usize)> {
    let mut cuts = Vec::new();
    for p in 0..lattice.points() {
        let [i, j, _] = lattice.cell(p);
        let (x, y) = (f64::from(i) + 0.5, f64::from(j) + 0.5);
        for (k, &[a, b, _]) in offsets.iter().enumerate() {
            let (dx, dy) = (f64::from(a), f64::from(b));
            let along = |t: f64| (x + t * dx, y + t * dy, (0.0..=1.0).contains(&t));
            let rows = [4.0, -4.0].iter().any(|level| {
                let (at, _, crosses) = along((level - y) / dy);
                crosses && at.abs() >= 6.0
            });
            let (_, at, crosses) = along(-x / dx);
            if rows || (crosses && at.abs() >= 6.0) {
                cuts.push((k, p));
            }
        }
    }
    cuts
}

#[test]
fn half_and_quarter_models_are_the_full_body() {
    for (edges, calibration) in [
        (Edges::Border, Calibration::Matched),
        (Edges::Overlay, Calibration::Matched),
        (Edges::None, Calibration::Published),
        (Edges::Volume, Calibration::Published),
        (Edges::Energy, Calibration::Published),
    ] {
        for m in [2.0, 3.0, 4.0] {
            let parameters = PlaneParameters { edges, calibration, ..parameters(m, MM_MPA) };
            let offsets = BondPlane::offsets(&parameters).unwrap();
            // Parts of cells with the symmetries of the body.
            let part = |[i, j]: [i32; 2]| match ((2 * i + 1).abs(), (2 * j + 1).abs()) {
                (a, b) if (a + 3 * b) % 5 == 0 && edges != Edges::Border => {
                    ([i, j, 0], 0.5 + f64::from(a + b) / 40.0)
                }
                _ => ([i, j, 0], 1.0),
            };
            let lattice = |columns: Range<i32>, rows: Range<i32>| {
                let cells = rows.clone().flat_map(|j| columns.clone().map(move |i| part([i, j])));
                let areas: Vec<(Cell, f64)> = cells.collect();
                SquareLattice::plane(1.0, [0.0; 2], columns, rows, inside).with_areas(&areas)
            };
            let full = Arc::new(lattice(-12..12, -9..9));
            let cut = cuts(&full, &offsets);
            let full = BondPlane::on_lattice(full, Mirrors::NONE, parameters, &cut).unwrap();
            assert!(full.damage().iter().any(|&d| d > 0.3), "some bonds are cut");
            let parts = [
                (lattice(0..12, -9..9), Mirrors::in_plane([Some(0), None], [None; 2])),
                (lattice(-12..0, -9..9), Mirrors::in_plane([None, Some(0)], [None; 2])),
                (lattice(0..12, -9..0), Mirrors::in_plane([Some(0), None], [None, Some(0)])),
            ];
            for (real, mirrors) in parts {
                let part = mirrors.extended(&real, BondPlane::depth(&parameters).unwrap());
                let cut = cuts(&part, &offsets);
                let part = BondPlane::on_lattice(Arc::new(part), mirrors, parameters, &cut).unwrap();
                compare(&full, &part, mirrors);
            }
        }
    }
}

pub(super) fn compare(full: &dyn Solvable<2>, part: &dyn Solvable<2>, mirrors: Mirrors) {
    let whole = full.lattice().unwrap().0.clone();
    let lattice = part.lattice().unwrap().0.clone();
    let (n, np) = (full.points(), part.points());
    // A displacement with the symmetry.
    let values = random(2 * np);
    let mut u = [vec![0.0; 2 * n], vec![0.0; 2 * np]];
    for p in 0..n {
        let (image, signs) = mirrors.image(whole.cell(p));
        let real = lattice.number(image).unwrap();
        (0..2).for_each(|c| u[0][c * n + p] = signs[c] * values[c * np + real]);
    }
    u[1] = with_images(part, values);
    let copies = n as f64 / (np - part.ghosts().len()) as f64;
    let energies = [energy(full, &u[0]), copies * energy(part, &u[1])];
    assert!((energies[0] / energies[1] - 1.0).abs() < 1e-13, "{energies:?}");
    let forces = [force(full, &u[0]), restricted(part, force(part, &u[1]))];
    let fields = [full.as_plane().unwrap().fields(&u[0]), part.as_plane().unwrap().fields(&u[1])];
    let damage = [full.damage(), part.damage()];
    let mut loads = [vec![0.0; 2 * n], vec![0.0; 2 * np]];
    let stress = |_: usize, at: [f64; 2]| [1.0 + at[0].powi(2), 2.0 - at[1].powi(2), 0.3 * at[0] * at[1]];
    full.as_plane().unwrap().add_stress_load(None, &stress, &mut loads[0]);
    part.as_plane().unwrap().add_stress_load(None, &stress, &mut loads[1]);
    let loads = [loads[0].clone(), restricted(part, loads[1].clone())];
    let (f, l, s) = (largest(&forces[0]), largest(&loads[0]), largest(&fields[0].stress[0]));
    for q in (0..np).filter(|&q| mirrors.is_real(lattice.cell(q))) {
        let p = whole.number(lattice.cell(q)).unwrap();
        for c in 0..2 {
            assert!((forces[0][c * n + p] - forces[1][c * np + q]).abs() < 1e-13 * f);
            assert!((loads[0][c * n + p] - loads[1][c * np + q]).abs() < 1e-13 * l);
        }
        (0..3).for_each(|k| assert!((fields[0].stress[k][p] - fields[1].stress[k][q]).abs() < 1e-13 * s));
        let density = [fields[0].energy_density[p], fields[1].energy_density[q]];
        assert!((density[0] - density[1]).abs() < 1e-12 * density[0]);
        assert!((damage[0][p] - damage[1][q]).abs() < 1e-15);
        assert_eq!(full.volume(p), part.volume(q));
    }
    assert_eq!(part.volume(part.ghosts()[0] as usize), 0.0);
}

#[test]
fn coarser_bodies_keep_their_lines_of_symmetry() {
    let real = SquareLattice::rectangle(1.0, [0.0; 2], [24, 12]);
    let mirrors = Mirrors::in_plane([Some(0), None], [None, Some(12)]);
    let parameters = parameters(3.0, MM_MPA);
    let extended = Arc::new(mirrors.extended(&real, 3));
    let fine = BondPlane::on_lattice(extended, mirrors, parameters, &[]).unwrap();
    let coarse = fine.coarser(&|_, _| Vec::new()).unwrap();
    let (lattice, lines) = coarse.lattice().unwrap();
    assert_eq!(lattice.spacing(), 2.0);
    assert_eq!(lines.lines, [[Some(0), None], [None, Some(6)], [None; 2]]);
    assert_eq!(coarse.points() - coarse.ghosts().len(), 12 * 6);
    assert_eq!(coarse.points(), 15 * 9);
    // The stiffness of a plate does not depend on the spacing.
    let u = [&fine as &dyn Solvable<2>, &*coarse].map(|p| linear(p, [[1e-3, 0.0], [0.0, -2e-4]]));
    assert!((energy(&fine, &u[0]) / energy(&*coarse, &u[1]) - 1.0).abs() < 1e-13);
}
