//! Bonds that end on the border: faces are in balance, and held ones hold.

use super::*;
use crate::model::bond_plane::tests::bodies::largest;
use nalgebra::{DMatrix, DVector};

fn bordered(lattice: SquareLattice, horizon_ratio: f64) -> BondSolid {
    let parameters = BondSolidParameters { horizon_ratio, edges: SolidEdges::Border, ..BONDS };
    let solid = BondSolid::on_lattice(Arc::new(lattice), Mirrors::NONE, parameters, &[]).unwrap();
    assert_eq!(solid.edges(), SolidEdges::Border);
    solid
}

/// Bodies whose faces, edges, re-entrant edges and holes are along the axes; the stress does not act on the faces across x and y.
#[test]
fn free_faces_are_in_balance() {
    for (name, inside) in [
        ("block", (|_| true) as fn([i32; 3]) -> bool),
        ("hole", |[i, j, _]| !((3..6).contains(&i) && (3..6).contains(&j))),
        ("L", |[i, j, _]| i < 4 || j < 3),
        ("staircase", |[i, j, _]| i + j < 10),
    ] {
        for horizon_ratio in [2.0, 3.0, 4.0] {
            let lattice = SquareLattice::new(1.0, [0.0; 3], [0..9, 0..8, 0..12], inside);
            let solid = bordered(lattice, horizon_ratio);
            let n = solid.points();
            let u = linear(&solid, gradient(solid.strain_of([0.0, 0.0, 1.0, 0.0, 0.0, 0.0])));
            let internal = force(&solid, &u);
            // Two layers hold each end.
            let is_end = |p: usize| [0, 1, 10, 11].contains(&solid.lattice().0.cell(p)[2]);
            let free = (0..3 * n).filter(|k| !is_end(k % n)).map(|k| internal[k].abs()).fold(0.0, f64::max);
            // 3e-15 measured; the overlay has 0.02 to 0.05.
            assert!(free < 1e-12, "{name} {horizon_ratio}: {free:e}");
            let end: f64 = (0..n).filter(|&p| solid.position(p)[2] > 6.0).map(|p| internal[2 * n + p]).sum();
            let area = (0..n).filter(|&p| solid.lattice().0.cell(p)[2] == 0).count() as f64;
            assert!((end / area - 1.0).abs() < 1e-12, "{name} {horizon_ratio}: {end}");
        }
    }
}

/// A shear leaves forces at corners alone, known per stress and spacing².
#[test]
fn shear_leaves_known_forces_at_corners() {
    for (horizon_ratio, expected) in [(2.0, 0.135466), (3.0, 0.037515), (4.0, 0.040407)] {
        let solid = bordered(SquareLattice::cuboid(1.0, [0.0; 3], [12, 12, 12]), horizon_ratio);
        let n = solid.points();
        let u = linear(&solid, gradient(solid.strain_of([0.0, 0.0, 0.0, 0.0, 0.0, 1.0])));
        let internal = force(&solid, &u);
        // The force on a corner is spread by its shares (3/2, −1/2)³ over the eight points there: along z they sum to it, and the
        // quarters of the faces have none along z.
        let near = |p: usize| solid.position(p).iter().all(|x| *x < 3.0);
        let sum: f64 = (0..n).filter(|&p| near(p)).map(|p| internal[2 * n + p]).sum();
        assert!((sum.abs() - expected).abs() < 1e-6, "{horizon_ratio} {sum}");
    }
}

/// Deflection at three quarters of a beam of length 4 and depth 1, `E = F = 1`, whose end is clamped by `u_0 = u_1/3` and loaded
/// with the shares (3/2, −1/2); an independent Python implementation. The limit of finite elements is 168.69.
#[test]
fn a_clamped_beam_bends_as_the_reference_does() {
    for (horizon_ratio, expected) in [(2.0, 164.9360), (3.0, 171.9507)] {
        let cells = 4;
        let h = 1.0 / f64::from(cells);
        let lattice = SquareLattice::cuboid(h, [0.0, -0.5, -0.5], [4 * cells, cells, cells]);
        let solid = bordered(lattice, horizon_ratio);
        let (n, k) = (solid.points(), matrix(&solid));
        let (lattice, _) = solid.lattice();
        let cell = |p: usize| lattice.cell(p);
        // Columns of the free points, those of the first layer with a third of the second.
        let free: Vec<usize> = (0..3 * n).filter(|unknown| cell(unknown % n)[0] > 0).collect();
        let mut map = DMatrix::zeros(3 * n, free.len());
        for (column, &unknown) in free.iter().enumerate() {
            map[(unknown, column)] = 1.0;
            let [i, j, l] = cell(unknown % n);
            if i == 1 {
                map[(unknown / n * n + lattice.number([0, j, l]).unwrap(), column)] = 1.0 / 3.0;
            }
        }
        let mut load = DVector::zeros(3 * n);
        for p in 0..n {
            let share = [(4 * cells - 1, 1.5), (4 * cells - 2, -0.5)]
                .iter()
                .find(|s| s.0 == cell(p)[0])
                .map_or(0.0, |s| s.1);
            load[2 * n + p] = share / f64::from(cells * cells);
        }
        let factor = (map.transpose() * k * &map).cholesky().expect("the clamp holds the beam");
        let u = &map * factor.solve(&(map.transpose() * load));
        let axis = |p: &usize| {
            let [x, y, z] = solid.position(*p);
            (x - 3.0).abs() < h && y.abs() < h && z.abs() < h
        };
        let around: Vec<usize> = (0..n).filter(axis).collect();
        assert_eq!(around.len(), 8);
        let deflection = around.iter().map(|p| u[2 * n + p]).sum::<f64>() / 8.0;
        assert!((deflection / expected - 1.0).abs() < 1e-3, "{horizon_ratio} {deflection}");
        assert!(largest(u.as_slice()) < 300.0);
    }
}
