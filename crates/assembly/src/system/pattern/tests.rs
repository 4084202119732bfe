use super::*;
use crate::body::SquareLattice;
use crate::condition::{Equation, Unknown};
use crate::law::Bilinear;
use crate::model::BodyModel;
use crate::model::Points;
use crate::model::bond_plane::{
    BondPlane, Influence, PlaneMaterial, PlaneParameters, PlaneState, VolumeFactor, Weights,
};
use crate::model::plane::{Calibration, Edges, Mirrors, SofteningModel};
use crate::stiffness::{HistoryBond, HistoryBonds, Kinematics};
use crate::system::System;
use std::sync::Arc;

const X: usize = 0;
const Y: usize = 1;

fn plate() -> BondPlane {
    plate_with(Calibration::Published, Edges::None)
}

fn plate_with(calibration: Calibration, edges: Edges) -> BondPlane {
    let lattice = Arc::new(SquareLattice::rectangle(1.0, [0.0; 2], [9, 7]));
    let parameters = PlaneParameters {
        material: PlaneMaterial { youngs_modulus: 73_100.0, thickness: 25.0, state: PlaneState::Strain },
        horizon_ratio: 3.0,
        influence: Influence::Constant,
        calibration,
        weights: Weights::Nearest,
        volume_factor: VolumeFactor::Ramp,
        edges,
    };
    BondPlane::on_lattice(lattice, Mirrors::NONE, parameters, &[]).unwrap()
}

fn equation(terms: &[(usize, usize, f64)], value: f64) -> Equation {
    let terms = terms.iter().map(|&(component, point, c)| (Unknown { component, point }, c)).collect();
    Equation { terms, value, origin: String::new() }
}

/// Two pins that turn, one held along x and moved along y at its first point, the other free; a prescribed edge; a roller on
/// a slope.
fn equations(plate: &BondPlane) -> Vec<Equation> {
    let number = |i: usize, j: usize| {
        let at = [i as f64 + 0.5, j as f64 + 0.5];
        (0..plate.points()).find(|&p| plate.place(p) == at).expect("a cell")
    };
    let mut all = Vec::new();
    for (i, j) in [(2, 4), (6, 3)] {
        let [a, b] = [number(i, j), number(i + 1, j)];
        // The rotation is u_y(b) − u_y(a), their distance being one.
        all.push(equation(&[(X, b, 1.0), (X, a, -1.0)], 0.0));
        for (di, dj) in [(0, 1), (1, 1), (0, 2), (1, 2)] {
            let (p, [x, y]) = (number(i + di, j + dj), [di, dj].map(|d| d as f64));
            all.push(equation(&[(X, p, 1.0), (X, a, -1.0), (Y, b, y), (Y, a, -y)], 0.0));
            all.push(equation(&[(Y, p, 1.0), (Y, a, -1.0), (Y, b, -x), (Y, a, x)], 0.0));
        }
        if i == 2 {
            all.push(equation(&[(X, a, 1.0)], 0.0));
            all.push(equation(&[(Y, a, 1.0)], 0.3));
        }
    }
    (0..9).for_each(|i| all.push(equation(&[(Y, number(i, 0), 1.0)], -0.1)));
    all.push(equation(&[(X, number(0, 1), 0.8), (Y, number(0, 1), 0.6)], 0.02));
    all
}

/// The points of a bond with their shares in the difference of displacements.
fn ends(bond: &HistoryBond<2>) -> [(u32, f64); 2] {
    let [i, j] = bond.points;
    [(i, -1.0), (j, 1.0)]
}

struct Ready {
    system: System<2>,
    bonds: Vec<HistoryBond<2>>,
    pattern: DifferencePattern<2>,
}

fn ready() -> Ready {
    let plate = plate();
    let system = System::new(&plate, Vec::new(), equations(&plate)).unwrap();
    assert!(system.constraints().has_slaves() && system.constraints().moves());
    let bonds = plate.history_bonds(&|_| Some(0));
    let pattern = DifferencePattern::new(plate.points(), system.constraints(), bonds.iter().map(ends));
    Ready { system, bonds, pattern }
}

fn dense(matrix: &CsMat<f64>) -> Vec<Vec<f64>> {
    let mut dense = vec![vec![0.0; matrix.cols()]; matrix.rows()];
    for (&value, (row, column)) in matrix {
        assert!(column <= row, "the lower triangle");
        dense[row][column] = value;
    }
    dense
}

fn block(bond: &HistoryBond<2>) -> Mat<2, 2> {
    bond.direction.map(|a| bond.direction.map(|b| bond.stiffness * (a * b)))
}

/// Largest difference of two matrices over the largest entry, without the diagonals of constrained unknowns.
fn difference(system: &System<2>, a: &[Vec<f64>], b: &[Vec<f64>]) -> f64 {
    let (mut worst, mut largest) = (0.0_f64, 0.0_f64);
    for (row, (a, b)) in a.iter().zip(b).enumerate() {
        let held = system.constraints().rows().iter().any(|r| r.unknown == row);
        for (column, (a, b)) in a.iter().zip(b).enumerate().filter(|(column, _)| !(held && *column == row)) {
            assert!(!held || (*a == 0.0 && *b == 0.0), "({row}, {column}) is constrained");
            worst = worst.max((a - b).abs());
            largest = largest.max(b.abs());
        }
    }
    worst / largest
}

#[test]
fn the_filled_matrix_is_the_assembled_one() {
    let Ready { system, bonds, pattern } = ready();
    let mut matrix = pattern.matrix();
    pattern.fill(|k| block(&bonds[k]), &mut matrix);
    let (found, expected) = (dense(&matrix), dense(&system.assemble_sparse()));
    let error = difference(&system, &found, &expected);
    // Measured: 6e-16.
    assert!(error < 1e-13, "{error:e}");
    for row in system.constraints().rows() {
        assert_eq!(found[row.unknown][row.unknown], 1.0);
    }
    for (k, &place) in pattern.diagonal().iter().enumerate() {
        assert_eq!(matrix.data()[place as usize], found[k][k]);
    }
}

#[test]
fn bonds_that_end_on_the_border_make_the_assembled_matrix() {
    let plate = plate_with(Calibration::Matched, Edges::Border);
    let system = System::new(&plate, Vec::new(), equations(&plate)).unwrap();
    let elastic = vec![Bilinear::elastic()];
    let between = plate.history_bonds(&|_| Some(0));
    let ended = plate.ended_bonds(&mut |_, _| Some(0));
    assert!(ended.len() > 100);
    let bonds = HistoryBonds::new(plate.points(), Kinematics::Linear, elastic, between).with_ended(ended);
    let ends = (0..bonds.list().len()).map(|k| bonds.shares(k));
    let pattern = DifferencePattern::<2>::new(plate.points(), system.constraints(), ends);
    let mut matrix = pattern.matrix();
    pattern.fill(|k| block(&bonds.list()[k]), &mut matrix);
    let error = difference(&system, &dense(&matrix), &dense(&system.assemble_sparse()));
    // Measured: 1e-15.
    assert!(error < 1e-13, "{error:e}");
}

#[test]
fn columns_of_bonds_make_the_matrix() {
    let Ready { system, bonds, pattern } = ready();
    let size = system.size();
    let mut sum = vec![vec![0.0; size]; size];
    for (k, bond) in bonds.iter().enumerate() {
        let column = pattern.column(k, &bond.direction);
        for &(row, a) in &column {
            column
                .iter()
                .filter(|(c, _)| *c <= row)
                .for_each(|&(c, b)| sum[row][c] += bond.stiffness * a * b);
        }
        // The rate of elongation of some motion of the independent unknowns.
        let mut u: Vec<f64> = (0..size).map(|i| ((i * 7919 % 1013) as f64) / 1013.0 - 0.5).collect();
        let along: f64 = column.iter().map(|&(unknown, c)| c * u[unknown]).sum();
        system.constraints().expand(0.0, &mut u);
        let [i, j] = bond.points.map(|p| p as usize);
        let n = system.points();
        let exact: f64 = (0..2).map(|c| bond.direction[c] * (u[c * n + j] - u[c * n + i])).sum();
        // Measured: 4e-16 of displacements of about one.
        assert!((along - exact).abs() < 1e-14, "{along} {exact}");
    }
    let error = difference(&system, &sum, &dense(&system.assemble_sparse()));
    // Measured: 6e-16.
    assert!(error < 1e-13, "{error:e}");
}

#[test]
fn filling_again_leaves_no_trace() {
    let Ready { bonds, pattern, .. } = ready();
    let mut matrix = pattern.matrix();
    pattern.fill(|k| block(&bonds[k]), &mut matrix);
    let first = matrix.clone();
    // Blocks of another kind, not along the bonds and not definite.
    pattern.fill(|k| [[-1.0, k as f64], [k as f64, 3.0]], &mut matrix);
    assert_ne!(first, matrix);
    pattern.fill(|k| block(&bonds[k]), &mut matrix);
    assert_eq!(first, matrix);
}

/// Blocks that resist turning, too: as `Tᵀ K T` made of them one by one.
#[test]
fn whole_blocks_fall_on_their_places() {
    let Ready { system, bonds, pattern } = ready();
    let any = |k: usize| {
        let value = |s: usize| ((k * s) % 101) as f64 / 101.0 - 0.4;
        [[value(17), value(29)], [value(29), value(43)]]
    };
    let mut matrix = pattern.matrix();
    pattern.fill(any, &mut matrix);
    let found = dense(&matrix);
    let (n, size) = (system.points(), system.size());
    let held = |k: usize| system.constraints().rows().iter().any(|r| r.unknown == k);
    let mut worst = 0.0_f64;
    for column in (0..size).filter(|&k| !held(k)) {
        let mut u = vec![0.0; size];
        u[column] = 1.0;
        system.constraints().expand(0.0, &mut u);
        let mut force = vec![0.0; size];
        for (k, bond) in bonds.iter().enumerate() {
            let ([i, j], block) = (bond.points.map(|p| p as usize), any(k));
            for r in 0..2 {
                let f: f64 = (0..2).map(|c| block[r][c] * (u[c * n + j] - u[c * n + i])).sum();
                force[r * n + i] -= f;
                force[r * n + j] += f;
            }
        }
        system.constraints().restrict(&mut force);
        for row in column..size {
            if !held(row) {
                worst = worst.max((found[row][column] - force[row]).abs());
            }
        }
    }
    // Entries are of the order of ten; measured: 2e-14.
    assert!(worst < 1e-12, "{worst:e}");
}
