//! Cracks through solids.

use super::*;

/// Bonds from below a height to above it.
fn across(lattice: &SquareLattice, offsets: &[[i32; 3]], layer: i32, until: i32) -> Vec<(usize, usize)> {
    let mut cuts = Vec::new();
    for p in 0..lattice.points() {
        let [column, _, from] = lattice.cell(p);
        for (k, step) in offsets.iter().enumerate() {
            if from < layer && from + step[2] >= layer && column < until {
                cuts.push((k, p));
            }
        }
    }
    cuts
}

#[test]
fn a_crack_through_the_body_parts_it() {
    let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], [6, 5, 8]));
    let cuts = across(&lattice, &BondSolid::offsets(&BONDS).unwrap(), 4, 6);
    let bonds = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, BONDS, &cuts).unwrap();
    let parameters = BondSolidParameters { edges: SolidEdges::Border, ..BONDS };
    let border = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &cuts).unwrap();
    assert_eq!((border.faces(), border.uncorrected()), (SolidEdges::Border, 0));
    let cuts = across(&lattice, &StateSolid::offsets(&STATE).unwrap(), 4, 6);
    let state = StateSolid::on_lattice(lattice.clone(), Mirrors::NONE, STATE, &cuts).unwrap();
    for solid in [&bonds as &dyn Solvable<3>, &border, &state] {
        assert_eq!(solid.connected().spans().len(), 2);
        let apart =
            planes(solid, |[x, y, z]| if z > 4.0 { [1.0, 2.0, 3.0] } else { [-0.1 * y, 0.1 * x, 0.0] });
        assert!(energy(solid, &apart).abs() < 1e-24);
        // Two of the layers beside the crack have lost bonds.
        let damage = solid.damage();
        let lost = |layer: i32| damage[lattice.number([3, 2, layer]).unwrap()];
        assert!(lost(3) > 0.3 && lost(4) > 0.3 && lost(1) == 0.0 && lost(6) == 0.0, "{damage:?}");
    }
}

#[test]
fn a_crack_makes_the_body_softer_and_leaves_rigid_motions_free() {
    let lattice = Arc::new(SquareLattice::cuboid(1.0, [0.0; 3], [6, 5, 8]));
    let cuts = across(&lattice, &StateSolid::offsets(&STATE).unwrap(), 4, 3);
    let with = |cuts: &[(usize, usize)]| {
        StateSolid::on_lattice(lattice.clone(), Mirrors::NONE, STATE, cuts).unwrap()
    };
    let (whole, cracked) = (with(&[]), with(&cuts));
    let u = linear(&whole, gradient([0.0, 0.0, 1.0, 0.0, 0.0, 0.0]));
    let ratio = energy(&cracked, &u) / energy(&whole, &u);
    assert!((0.5..0.95).contains(&ratio), "{ratio}");
    let turned = linear(&whole, [[0.0, -0.1, 0.0], [0.1, 0.0, 0.0], [0.0; 3]]);
    assert!(energy(&cracked, &turned).abs() < 1e-24);
}
