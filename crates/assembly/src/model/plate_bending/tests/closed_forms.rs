//! Closed forms: strips (P7), series of plates.

use super::{
    Held, Solver, assert_close, deflection, fixed, line, lumped, parameters, plate, pressure, square,
};
use crate::body::SquareLattice;
use crate::model::Model;
use crate::model::plate_bending::PlateBending;

#[test]
fn a_strip_is_exact_at_its_points() {
    for t in [0.2, 0.01, 1e-3, 1e-4] {
        for cells in [8, 16, 32] {
            let h = 1.0 / f64::from(cells);
            let plate = plate(SquareLattice::rectangle(h, [0.0; 2], [cells, 3]), parameters(1.5, t));
            let s = parameters(1.5, t).section.shear;
            let solver = Solver::new(&plate, Vec::new(), &fixed(&plate, Held::Strip));
            let tip = |load: Vec<f64>| deflection(&plate, &solver.solve(&load), [1.0, h]);
            // Of a cantilever of unit width under a unit force at its tip, and a unit pressure.
            assert_close(tip(line(&plate)), 1.0 / 3.0 + 1.0 / s, 1e-13);
            assert_close(tip(pressure(&plate)), 0.125 + 0.5 / s, 1e-13);
        }
    }
}

/// Unknowns under a load by conjugate gradients with the diagonal, for plates that are large for a dense factor.
fn iterated(plate: &PlateBending, held: Held, load: &[f64]) -> Vec<f64> {
    let (terms, n) = (plate.terms(), plate.nodes().points());
    let mut blocks = vec![[[0.0; 3]; 3]; n];
    terms.iter().for_each(|term| term.add_diagonal(&mut blocks));
    let mut inverse: Vec<f64> = (0..3 * n).map(|k| 1.0 / blocks[k % n][k / n][k / n]).collect();
    fixed(plate, held).into_iter().for_each(|unknown| inverse[unknown] = 0.0);
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let scaled = |r: &[f64]| r.iter().zip(&inverse).map(|(r, c)| r * c).collect::<Vec<f64>>();
    let (mut u, mut r) = (vec![0.0; 3 * n], load.to_vec());
    let mut p = scaled(&r);
    let mut rz = dot(&r, &p);
    let small = 1e-22 * rz;
    while rz > small {
        let mut q = vec![0.0; 3 * n];
        terms.iter().for_each(|term| term.add_force(&p, &mut q));
        let step = rz / dot(&p, &q);
        (0..3 * n).for_each(|k| (u[k], r[k]) = (u[k] + step * p[k], r[k] - step * q[k]));
        let z = scaled(&r);
        let before = std::mem::replace(&mut rz, dot(&r, &z));
        (0..3 * n).for_each(|k| p[k] = z[k] + rz / before * p[k]);
    }
    u
}

#[test]
fn squares_tend_to_their_series_with_order_two_at_every_thickness() {
    // P20: Navier's series with the shear of Mindlin's plate; the orders are those of the other implementation.
    let rows = [
        (0.2, 0.0049043109830, 2.02),
        (0.1, 0.0042728422413, 2.07),
        (0.01, 0.0040644575565, 2.23),
        (1e-4, 0.0040623528712, 2.00),
    ];
    for (t, exact, order) in rows {
        let error = |cells: i32| {
            let plate = square(cells, parameters(1.5, t));
            let u = iterated(&plate, Held::HardSupports, &lumped(&plate));
            deflection(&plate, &u, [0.5; 2]) / exact - 1.0
        };
        let found = 0.5 * (error(16) / error(64)).log2();
        assert!((found - order).abs() < 0.05, "t = {t}: {found}");
    }
}
