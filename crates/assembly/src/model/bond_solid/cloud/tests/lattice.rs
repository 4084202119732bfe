//! Listed points that are those of a lattice.

use super::*;
use crate::model::bond_solid::BondSolid;
use crate::model::plane::Mirrors;
use crate::model::solid::tests::bodies;

#[test]
fn a_published_cloud_of_cells_is_the_published_lattice() {
    let (_, lattice) = &bodies(0.5)[1];
    let positions: Vec<[f64; 3]> = (0..lattice.points()).map(|p| lattice.position(p)).collect();
    for (volume_factor, influence) in [
        (VolumeFactor::Full, Influence::Constant),
        (VolumeFactor::Clip, Influence::Inverse),
        (VolumeFactor::Ramp, Influence::Linear),
    ] {
        let calibration = Calibration::Published;
        let parameters =
            BondSolidParameters { calibration, volume_factor, influence, edges: SolidEdges::None, ..BONDS };
        let volumes = vec![0.125; positions.len()];
        let cloud = BondSolidCloud::new(positions.clone(), volumes, 1.0, parameters, &|_, _| false).unwrap();
        let solid = BondSolid::on_lattice(lattice.clone(), Mirrors::NONE, parameters, &[]).unwrap();
        let u = random(3 * positions.len());
        let forces = [force(&solid, &u), force(&cloud, &u)];
        assert!(difference(&forces[0], &forces[1]) < 1e-13 * largest(&forces[0]), "{volume_factor:?}");
        let fields = [solid.fields(&u), cloud.fields(&u)];
        for q in 0..6 {
            let error = difference(&fields[0].stress[q], &fields[1].stress[q]);
            assert!(error < 1e-12 * largest(&fields[0].stress[q]), "{volume_factor:?}");
        }
        let error = difference(&fields[0].energy_density, &fields[1].energy_density);
        assert!(error < 1e-12 * largest(&fields[0].energy_density), "{volume_factor:?}");
    }
}

/// Points of a regular lattice: far from faces bonds have cubic symmetry, and the softer of both shears, or the stretch, is what
/// scales them.
#[test]
fn bonds_of_a_regular_lattice_are_as_stiff_as_they_can_be() {
    let (_, lattice) = &bodies(1.0)[0];
    let positions: Vec<[f64; 3]> = (0..lattice.points()).map(|p| lattice.position(p)).collect();
    let parameters = BondSolidParameters { edges: SolidEdges::None, ..BONDS };
    // The bonds of a point and of its neighbours stay within two cells.
    let amid = (0..positions.len()).find(|&p| {
        let near = |q: &&[f64; 3]| (0..3).all(|k| (q[k] - positions[p][k]).abs() < 2.5);
        positions.iter().filter(near).count() == 125
    });
    let amid = amid.unwrap();
    let solid =
        BondSolidCloud::new(positions, vec![1.0; lattice.points()], 1.5, parameters, &|_, _| false).unwrap();
    let column = |r: usize| {
        let u = linear(&solid, gradient(std::array::from_fn(|q| f64::from(q == r))));
        solid.fields(&u).stress.map(|plane| plane[amid])
    };
    // ½ Σ k ξ² N Nᵀ, k = s/ξ, of 6 neighbours at 1 and 12 at √2: C11 = s (1 + √2), C12 = C44 = s/√2.
    let (c11, c12) = (1.0 + 2.0_f64.sqrt(), 0.5_f64.sqrt());
    // Moduli of the material for volume, 2.0; shear across axes, 0.8, and along them, 0.4.
    let s = (2.0 / (c11 + 2.0 * c12)).min(0.8 / (c11 - c12)).min(0.4 / c12);
    let (first, fourth) = (column(0), column(3));
    assert!((first[0] - s * c11).abs() < 1e-14 && (first[1] - s * c12).abs() < 1e-14, "{first:?} {s}");
    assert!((fourth[3] - s * c12).abs() < 1e-14 && fourth[0].abs() < 1e-15, "{fourth:?}");
}
