//! Closed forms: strips (P7), series of plates.

use super::{
    Held, Solver, assert_close, deflection, fixed, line, parameters, plate, pressure, solve, square,
};
use crate::body::SquareLattice;

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

#[test]
fn a_thick_plate_tends_to_its_series_with_order_two() {
    // Navier's series with the shear of Mindlin's plate, t = 0.2.
    let exact = 0.00490431096;
    let error = |cells: i32| {
        let plate = square(cells, parameters(1.5, 0.2));
        deflection(&plate, &solve(&plate, Held::HardSupports, &super::lumped(&plate)), [0.5; 2]) / exact - 1.0
    };
    let [coarse, fine] = [8, 16].map(error);
    assert!((fine + 2.5e-3).abs() < 1e-4, "{fine}");
    assert!(((coarse / fine).log2() - 2.0).abs() < 0.2, "{coarse} {fine}");
}
