//! Entries and eigenvalues of stiffness matrices that an independent Python implementation gives, and six zero modes.

use super::*;

/// Of the block, spacing and Young's modulus one: the corner along x, `(0, 3, 2)` along x and z, `(3, 3, 2)` along x, the trace,
/// the least elastic and the largest eigenvalue.
fn check(name: &str, solid: &dyn Solvable<3>, expected: [f64; 7]) {
    let (lattice, _) = solid.lattice().unwrap();
    let (n, k) = (solid.points(), matrix(solid));
    let at = |cell: [i32; 3], c: usize| {
        let row = c * n + lattice.number(cell).unwrap();
        k[(row, row)]
    };
    let mut eigenvalues: Vec<f64> = k.clone().symmetric_eigenvalues().iter().copied().collect();
    eigenvalues.sort_by(f64::total_cmp);
    let most = eigenvalues[3 * n - 1];
    // 3e-15 measured.
    assert!(
        eigenvalues[..6].iter().all(|value| value.abs() < 1e-13 * most),
        "{name} {:?}",
        &eigenvalues[..7]
    );
    let found = [
        at([0, 0, 0], 0),
        at([0, 3, 2], 0),
        at([0, 3, 2], 2),
        at([3, 3, 2], 0),
        k.trace(),
        eigenvalues[6],
        most,
    ];
    // What the reference does not tell is no number.
    for (found, expected) in found.iter().zip(expected).filter(|of| !of.1.is_nan()) {
        // The reference has twelve decimals.
        assert!((found - expected).abs() < 1e-11 * (1.0 + expected), "{name}: {found} {expected}");
    }
}

#[test]
fn stiffness_matrices_are_those_of_the_reference() {
    let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], [7, 6, 5]));
    let with = |horizon_ratio: f64, edges: SolidEdges| {
        let parameters = BondSolidParameters { horizon_ratio, edges, ..BONDS };
        BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap()
    };
    let bonds = |horizon_ratio: f64| with(horizon_ratio, SolidEdges::Overlay);
    let state = |horizon_ratio: f64, influence: Influence| {
        let parameters = StateSolidParameters { horizon_ratio, influence, ..STATE };
        StateSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap()
    };
    check(
        "bonds 3",
        &bonds(3.0),
        [
            2.086061556516,
            2.150689313156,
            2.285791729543,
            1.086346390402,
            1528.689702821,
            0.065088015983,
            5.195005534098,
        ],
    );
    check(
        "bonds 2",
        &bonds(2.0),
        [
            2.165014044730,
            2.402455013490,
            2.421655401967,
            1.807365040471,
            1610.519071082,
            0.063355375819,
            5.199557570740,
        ],
    );
    check(
        "border 2",
        &with(2.0, SolidEdges::Border),
        [
            3.835471768543,
            2.264935644976,
            2.005824677186,
            f64::NAN,
            1446.754648497,
            0.069712575825,
            9.882039698784,
        ],
    );
    check(
        "border 3",
        &with(3.0, SolidEdges::Border),
        [
            3.236098996317,
            1.393838339917,
            1.094893818590,
            f64::NAN,
            898.818727158,
            0.067506023622,
            7.308917153641,
        ],
    );
    check(
        "state 3",
        &state(3.0, Influence::Linear),
        [
            2.167266785926,
            2.282980185700,
            2.185436037315,
            1.165523062538,
            1504.033419489,
            0.062640534541,
            5.540985455091,
        ],
    );
    check(
        "state 2",
        &state(2.0, Influence::Inverse),
        [
            2.210004975169,
            2.481278556284,
            2.337596739301,
            1.723801668134,
            1595.639774810,
            0.060949395696,
            5.703321299069,
        ],
    );
}
