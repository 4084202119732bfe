//! Moments and shear forces of states.

use super::{Held, parameters, plate, pressure, solve, square};
use crate::body::SquareLattice;

#[test]
fn moments_and_shear_forces_of_a_clamped_square() {
    // Legendre-Ritz of degree 26, t = 0.1: M_xx = 0.0494 and V_x = 0.412 in the middle of the left edge. Differences of
    // rotations have an error of 3.3e-2 at 16 cells and of 7.5e-3 at 32; shear forces continued to the edge one of 7e-3.
    let plate = square(32, parameters(1.5, 0.1));
    let fields = plate.fields(&solve(&plate, Held::Clamped, &pressure(&plate)), &[], &|_| [false; 2]);
    let at = plate.nodes().number([0, 16]).unwrap();
    let (moment, shear) = (fields.moment[at][0], fields.shear[at][0]);
    assert!((moment / 0.0494 - 1.0).abs() < 1e-2, "{moment}");
    assert!((shear / 0.412 - 1.0).abs() < 1e-2, "{shear}");
    // The middle of a Mindlin plate of this thickness, as tables have it: M_xx = -0.0231 for pressure along w.
    let middle = fields.moment[plate.nodes().number([16, 16]).unwrap()];
    assert!((middle[0] / -0.0231 - 1.0).abs() < 5e-3 && (middle[0] - middle[1]).abs() < 1e-12, "{middle:?}");
    assert!(middle[2].abs() < 1e-12);
}

#[test]
fn shear_forces_of_a_thin_strip_are_exact() {
    // A cantilever under a unit pressure, V = 1 - x; S (∇w − φ) is 1e5 times as large as its error there.
    let h = 1.0 / 16.0;
    let plate = plate(SquareLattice::rectangle(h, [0.0; 2], [16, 3]), parameters(1.5, 1e-4));
    let fields = plate.fields(&solve(&plate, Held::Strip, &pressure(&plate)), &[], &|_| [false; 2]);
    for (point, [x, y]) in fields.shear.iter().enumerate() {
        let exact = 1.0 - plate.nodes().place(point)[0];
        assert!((x - exact).abs() < 1e-8 && y.abs() < 1e-8, "{point}: {x} {y}, not {exact}");
    }
}

#[test]
fn moments_of_a_strip_under_a_tip_load_are_exact() {
    // Rotations are parabolas: central and one-sided differences of second order are exact.
    let h = 1.0 / 8.0;
    let plate = plate(SquareLattice::rectangle(h, [0.0; 2], [8, 3]), parameters(1.5, 0.01));
    let fields = plate.fields(&solve(&plate, Held::Strip, &super::line(&plate)), &[], &|_| [false; 2]);
    for (point, [xx, yy, xy]) in fields.moment.iter().enumerate() {
        let exact = 1.0 - plate.nodes().place(point)[0];
        assert!((xx - exact).abs() < 1e-10 && (yy - 0.3 * exact).abs() < 1e-10 && xy.abs() < 1e-10);
    }
}
