//! Gaps narrower than bonds part solids, too.

use super::*;

/// Two blocks with a layer, and with two, between them have no force in common, and neither family feels the other.
#[test]
fn a_gap_narrower_than_bonds_parts_a_solid() {
    for width in [1, 2] {
        let inside = |[_, _, k]: [i32; 3]| !(4..4 + width).contains(&k);
        let lattice = Arc::new(SquareLattice::new(1.0, [0.0; 3], [0..5, 0..4, 0..9], inside));
        let upper = |solid: &dyn Solvable<3>| {
            planes(solid, |[.., z]| if z > 5.0 { [0.3, 0.0, 1.0] } else { [0.0; 3] })
        };
        for (name, solid) in solids(&lattice) {
            let solid = &*solid;
            let most = force(solid, &upper(solid)).iter().fold(0.0, |most: f64, f| most.max(f.abs()));
            assert!(most < 1e-12, "{width} {name}: {most}");
            assert!(solid.damage().iter().all(|damage| *damage == 0.0), "{width} {name}");
        }
    }
}

/// A slot of one layer that ends inside: the bonds across it go, but for those around its end.
#[test]
fn a_slot_of_a_solid_parts_what_is_not_around_its_end() {
    let inside = |[i, _, k]: [i32; 3]| k != 4 || i > 4;
    let lattice = Arc::new(SquareLattice::new(1.0, [0.0; 3], [0..9, 0..4, 0..9], inside));
    let body = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, BONDS, &[]).unwrap();
    let solid: &dyn Solvable<3> = &body;
    // One column of points above the slot is moved: what feels it below it are those that a chain joins.
    let n = solid.points();
    let feels = |column: i32| {
        let mut u = vec![0.0; 3 * n];
        u[2 * n + lattice.number([column, 1, 5]).unwrap()] = 1.0;
        force(solid, &u)[2 * n + lattice.number([column, 1, 3]).unwrap()] != 0.0
    };
    assert_eq!([0, 1, 2, 3, 4, 5].map(feels), [false, false, false, false, true, true]);
}
