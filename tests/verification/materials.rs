//! Bodies of several materials: bonds in series, what they leave given back, against layers, inclusions and numbers of an
//! independent implementation in NumPy (the prototypes of the rule `Sc+pt1`).

use crate::support::mixed::{Stiffness, line, parameters, plate, prescribed};
use nalgebra::{DMatrix, DVector};
use peristat_assembly::body::SquareLattice;
use peristat_assembly::model::plane::{Edges, PlaneModel};
use peristat_assembly::model::{BodyModel, Points};

/// Two layers of 14 rows that do not move along x nor vary along it, pulled across by five rows at either end: the extra elongation
/// at the interface in spacings of the strain of the softer side.
fn jump(contrast: f64, ratio: f64) -> f64 {
    const ROWS: usize = 28;
    const COLUMNS: usize = 21;
    let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [COLUMNS as i32, ROWS as i32]);
    let modulus = |[_, y]: [f64; 2]| if y < 14.0 { 1.0 } else { contrast };
    let plate = plate(lattice, parameters(ratio, Edges::Border), modulus);
    let (stiffness, n) = (Stiffness::of(&plate), plate.points());
    let column = |row: usize| -> Vec<f64> {
        let moved = (0..2 * n).map(|k| f64::from(u8::from(k >= n && (k - n) / COLUMNS == row)));
        let force = stiffness.forces(&moved.collect::<Vec<_>>());
        (0..ROWS).map(|at| force[n + COLUMNS * at + COLUMNS / 2]).collect()
    };
    let rows =
        DMatrix::from_columns(&(0..ROWS).map(|row| DVector::from_vec(column(row))).collect::<Vec<_>>());
    let exact = |row: usize| {
        let y = row as f64 + 0.5;
        if y < 14.0 { y } else { 14.0 + (y - 14.0) / contrast }
    };
    let (free, held): (Vec<usize>, Vec<usize>) = (0..ROWS).partition(|row| (5..23).contains(row));
    let part = |of: &[usize]| rows.select_rows(&free).select_columns(of);
    let load = -(part(&held) * DVector::from_iterator(held.len(), held.iter().map(|&row| exact(row))));
    let found = part(&free).lu().solve(&load).expect("held rows");
    let near = |from: usize| -> Vec<(f64, f64)> {
        (from..from + 3).map(|row| (row as f64 + 0.5, found[row - 5])).collect()
    };
    let [low, high] = [line(&near(7)), line(&near(18))];
    ((high[0] + 14.0 * high[1]) - (low[0] + 14.0 * low[1])) / low[1]
}

#[test]
fn layers_in_series_have_no_jump() {
    // Sc+pt1 at m = 3 of the prototype; without what is given back 0.043, 0, 0, and by the mean of both ends -0.2083, -1.0833,
    // -1.9090.
    for (contrast, expected) in [(2.0, -0.0281), (10.0, -0.0373), (100.0, -0.0050)] {
        let found = jump(contrast, 3.0);
        assert!((found - expected).abs() <= 2e-4, "{contrast}: {found}");
    }
    // Measured -0.0378, -0.0322, -0.0041 at m = 2.
    for (contrast, ratio) in [2.0, 10.0, 100.0].into_iter().flat_map(|c| [2.0, 3.0, 4.0].map(|m| (c, m))) {
        let found = jump(contrast, ratio);
        assert!(found.abs() <= 0.04, "{contrast}, {ratio}: {found}");
    }
}

/// Two layers of eight rows, 24 long, pulled along by their ends: the force that lacks, in spacings of the stiffer layer, and the
/// largest error of the strain across beside the interface.
fn parallel(contrast: f64, ratio: f64, edges: Edges) -> [f64; 2] {
    let lattice = SquareLattice::rectangle(1.0, [0.0; 2], [24, 16]);
    let plate = plate(lattice, parameters(ratio, edges), |[_, y]| if y < 8.0 { 1.0 } else { contrast });
    let is_held = |x: f64| !(4.0..=20.0).contains(&x);
    let held = prescribed(&plate, |p, [x, _]| [is_held(x).then_some(x), (p == 3 * 24 + 12).then_some(0.0)]);
    let stiffness = Stiffness::of(&plate);
    let u = stiffness.relaxed(&held);
    let force = stiffness.forces(&u);
    let n = plate.points();
    let pulled: f64 = (0..n).filter(|p| p % 24 >= 20).map(|p| force[p]).sum();
    let across = |row: usize| u[n + 24 * (row + 1) + 12] - u[n + 24 * row + 12] + 1.0 / 3.0;
    let error = (5..10).map(|row| across(row).abs()).fold(0.0, f64::max);
    [(pulled - 8.0 - 8.0 * contrast) / contrast, error]
}

#[test]
fn layers_beside_each_other_share_the_force() {
    for (contrast, lacks, strain) in [(2.0, -0.005, 0.025), (10.0, -0.005, 0.040), (100.0, -0.007, 0.071)] {
        let [found, error] = parallel(contrast, 3.0, Edges::Overlay);
        assert!(
            (found - lacks).abs() <= 1e-3 && (error - strain).abs() <= 1e-3,
            "{contrast}: {found} {error}"
        );
    }
    // Measured -1e-4, -0.0016, -0.0028, and 0.013, 0.036, 0.056.
    for contrast in [2.0, 10.0, 100.0] {
        let [found, error] = parallel(contrast, 2.0, Edges::Border);
        assert!(found.abs() <= 0.004 && error <= 0.06, "{contrast}: {found} {error}");
    }
}

/// Under one strain, every layer has the stress of its own modulus.
#[test]
fn a_uniform_strain_has_the_stress_of_every_point() {
    for (ratio, edges) in
        [(2.0, Edges::Border), (3.0, Edges::Border), (2.0, Edges::Overlay), (3.0, Edges::Overlay)]
    {
        let lattice = SquareLattice::rectangle(0.5, [0.0; 2], [14, 12]);
        let modulus = |[x, y]: [f64; 2]| if x > 3.0 && y > 2.0 { 25.0 } else { 1.0 };
        let plate = plate(lattice, parameters(ratio, edges), modulus);
        // Corners between two free sides have the energy of shear on the mean of all of them alone.
        let strain = [1.0, -0.25, if ratio == 2.0 || edges == Edges::Overlay { 0.5 } else { 0.0 }];
        let n = plate.points();
        let u: Vec<f64> = (0..2 * n)
            .map(|k| {
                let [x, y] = plate.place(k % n);
                if k < n { strain[0] * x + strain[2] * y } else { strain[1] * y }
            })
            .collect();
        let fields = plate.fields(&u);
        let c = plate.stiffness();
        let mut worst = 0.0_f64;
        for p in 0..n {
            let factor = modulus(plate.place(p));
            for q in 0..3 {
                let exact: f64 = (0..3).map(|k| factor * c[q][k] * strain[k]).sum();
                worst = worst.max((fields.stress[q][p] - exact).abs() / factor);
            }
            let energy: f64 =
                (0..9).map(|k| 0.5 * factor * strain[k / 3] * c[k / 3][k % 3] * strain[k % 3]).sum();
            worst = worst.max((fields.energy_density[p] - energy).abs() / factor);
        }
        let told = plate.strain(&fields.stress);
        worst = (0..3 * n).fold(worst, |w, k| w.max((told[k / n][k % n] - strain[k / n]).abs()));
        let energy: f64 = Stiffness::of(&plate).forces(&u).iter().zip(&u).map(|(f, u)| 0.5 * f * u).sum();
        let expected: f64 = (0..n).map(|p| fields.energy_density[p] * 0.25).sum();
        assert!(worst <= 1e-13 && (energy / expected - 1.0).abs() <= 1e-12, "{worst} {energy} {expected}");
    }
}
