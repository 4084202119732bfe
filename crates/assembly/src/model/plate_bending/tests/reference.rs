//! Deflections of another implementation (P9 to P19).

use super::body::holed;
use super::{
    Held, Solver, assert_close, deflection, fixed, line, lumped, parameters, pressure, solve, square,
};
use crate::model::plate_bending::{Bed, PlateParameters, ShearLaw};
use crate::stiffness::Spring;
use std::f64::consts::PI;

const MIDDLE: [f64; 2] = [0.5, 0.5];
const TIP: [f64; 2] = [1.0, 0.5];

/// Deflections of a square of 8 × 8 cells, `[m = 1.5, m = 3]`.
fn assert_squares(rows: &[(f64, Held, [f64; 2])], load: fn(&super::PlateBending) -> Vec<f64>, at: [f64; 2]) {
    for &(t, held, expected) in rows {
        for (m, expected) in [1.5, 3.0].into_iter().zip(expected) {
            let plate = square(8, parameters(m, t));
            let u = solve(&plate, held, &load(&plate));
            assert_close(deflection(&plate, &u, at), expected, 1e-10);
        }
    }
}

#[test]
fn squares_on_all_edges_under_a_lumped_pressure() {
    let rows = [
        (0.2, Held::HardSupports, [4.852736762693e-3, 4.873299828171e-3]),
        (1e-4, Held::HardSupports, [3.965656548573e-3, 3.965139841552e-3]),
        (0.2, Held::Clamped, [2.187102647050e-3, 2.236752433719e-3]),
        (0.1, Held::Clamped, [1.519775018959e-3, 1.533452169276e-3]),
        (1e-4, Held::Clamped, [1.266450811014e-3, 1.276058483379e-3]),
        (0.2, Held::SoftSupports, [5.363091160436e-3, 5.618712890243e-3]),
        (0.1, Held::SoftSupports, [4.455129104059e-3, 4.646362913666e-3]),
    ];
    assert_squares(&rows, lumped, MIDDLE);
}

#[test]
fn cantilevers_under_a_lumped_pressure_and_a_line_load() {
    let rows = [
        (0.2, Held::LeftClamped, [0.1366694158026, 0.1369299621042]),
        (1e-4, Held::LeftClamped, [0.1295764190466, 0.1296876220040]),
    ];
    assert_squares(&rows, lumped, TIP);
    let rows = [
        (0.2, Held::LeftClamped, [0.3624700313450, 0.3632560255785]),
        (1e-4, Held::LeftClamped, [0.3471488789826, 0.3475331527382]),
    ];
    assert_squares(&rows, line, TIP);
}

#[test]
fn squares_under_a_pressure_with_edge_couples() {
    let rows = [
        (0.2, Held::HardSupports, [4.948481377018e-3, 4.969249803631e-3]),
        (1e-4, Held::HardSupports, [4.060342950920e-3, 4.059996423824e-3]),
        (1e-4, Held::SoftSupports, [4.163261820135e-3, 4.285361267272e-3]),
    ];
    assert_squares(&rows, pressure, MIDDLE);
    let rows = [
        (0.2, Held::LeftClamped, [0.1361403116394, 0.1364034793782]),
        (1e-4, Held::LeftClamped, [0.1290282334790, 0.1291420061423]),
    ];
    assert_squares(&rows, pressure, TIP);
}

#[test]
fn the_published_law_locks() {
    let rows = [
        (0.1, [1.385804974126e-3, 1.026825607512e-3]),
        // The plate deflects by 1.27e-3.
        (1e-4, [6.715154607e-8, 4.184993801e-9]),
    ];
    for (t, expected) in rows {
        for (m, expected) in [1.5, 3.0].into_iter().zip(expected) {
            let published = PlateParameters { shear_law: ShearLaw::Published, ..parameters(m, t) };
            let plate = square(8, published);
            let u = solve(&plate, Held::Clamped, &lumped(&plate));
            assert_close(deflection(&plate, &u, MIDDLE), expected, 1e-8);
        }
    }
}

#[test]
fn a_cantilever_with_a_hole() {
    let rows = [
        (0.3, [[0.2927241599628, 0.2966429614903], [0.1661234267091, 0.1685365828466]], 1e-10),
        (1e-3, [[0.2655654554306, 0.2674369059746], [0.1437570278242, 0.1448280321832]], 1e-9),
    ];
    for (t, expected, tolerance) in rows {
        for (k, m) in [1.5, 3.0].into_iter().enumerate() {
            let plate = holed(parameters(m, t));
            let u = solve(&plate, Held::LeftClamped, &lumped(&plate));
            assert_close(deflection(&plate, &u, [1.2, 1.0]), expected[0][k], tolerance);
            assert_close(deflection(&plate, &u, [0.8, 0.7]), expected[1][k], tolerance);
        }
    }
}

#[test]
fn a_square_on_a_foundation_under_a_sine() {
    let rows = [
        (0.2, 1e3, 7.6130187190e-4),
        (0.2, 1e5, 9.9687440602e-6),
        (1e-3, 1e3, 7.1956527670e-4),
        (1e-3, 1e5, 9.9611785000e-6),
    ];
    for (t, foundation, expected) in rows {
        let plate = square(8, parameters(1.5, t));
        let (nodes, n) = (plate.nodes(), plate.nodes().points());
        let springs = (0..n).map(|p| Spring::on(0, p, foundation * nodes.area(p))).collect();
        let mut load = vec![0.0; 3 * n];
        for (p, f) in load.iter_mut().enumerate().take(n) {
            let [x, y] = nodes.place(p);
            *f = nodes.area(p) * (PI * x).sin() * (PI * y).sin();
        }
        let u = Solver::new(&plate, springs, &fixed(&plate, Held::HardSupports)).solve(&load);
        assert_close(deflection(&plate, &u, MIDDLE), expected, 1e-9);
    }
}

/// A free plate with a hole under a uniform pressure on a uniform bed: it sinks by `q/k` evenly.
#[test]
fn free_plates_sink_evenly_on_a_uniform_bed() {
    for (m, t, bed) in [(1.5, 0.2, 1e2), (1.5, 1e-3, 1e5), (3.0, 0.05, 1e3)] {
        let plate = holed(parameters(m, t));
        let n = plate.nodes().points();
        let springs = Bed::new(plate.nodes(), plate.nodes().edges()).springs(&vec![bed; n]);
        let u = Solver::new(&plate, springs, &[]).solve(&pressure(&plate));
        let off = (0..n).map(|p| (u[p] * bed - 1.0).abs()).fold(0.0, f64::max);
        // 2e-13 is found.
        assert!(off < 1e-11, "{m}, {t}: {off:e}");
    }
}
