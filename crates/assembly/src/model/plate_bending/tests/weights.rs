//! Weights of offsets (P1, P2), the moduli of the published constants (P3), and neighbourhoods that have none.

use super::super::weights::{Weighted, weights};
use super::super::{PlateError, PlateParameters, ShearLaw};
use super::{parameters, section};
use crate::body::SquareLattice;
use std::f64::consts::PI;

fn of(all: &[Weighted], step: [i32; 2]) -> Weighted {
    *all.iter().find(|w| w.step == [step[0], step[1], 0]).unwrap()
}

/// Offsets of the first octant within three spacings.
const OCTANT: [[i32; 2]; 6] = [[0, 1], [1, 1], [0, 2], [1, 2], [2, 2], [0, 3]];

#[test]
fn weights_of_bending_are_those_next_to_the_lengths_that_are_isotropic() {
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-9, "{found} {expected}");
    let three = weights(&parameters(3.0, 0.3), 0.1).unwrap();
    let expected = [0.0333101614, 0.0494907168, 0.0652817479, 0.0770740710, 0.1018544723, 0.0959147595];
    OCTANT.iter().zip(expected).for_each(|(step, w)| near(of(&three, *step).bending, w));
    let next = weights(&parameters(1.5, 0.3), 0.1).unwrap();
    [[1, 0], [0, 1], [1, 1], [-1, 1]].iter().for_each(|step| near(of(&next, *step).bending, 0.25));
    let two = weights(&parameters(2.0, 0.3), 0.1).unwrap();
    let expected = [([1, 0], 0.0953081839), ([1, 1], 0.25), ([2, 0], 0.1546918161)];
    expected.iter().for_each(|(step, w)| near(of(&two, *step).bending, *w));
}

#[test]
fn weights_of_shear_balance_a_linear_moment() {
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-8, "{found} {expected}");
    let next = weights(&parameters(1.5, 0.3), 0.1).unwrap();
    near(of(&next, [1, 0]).shear, 0.330717489);
    near(of(&next, [1, 1]).shear, 0.169282511);
    let stiffness = |step: [i32; 2], length: f64| parameters(1.5, 0.3).shear(of(&next, step).shear, length);
    // Closed form of the eight next points: 1/(3/(2S) + h²/(8D)), and half of that.
    let (s, h) = (section(0.3, 0.3).shear, 0.1);
    let axis = 1.0 / (1.5 / s + h * h / 8.0);
    assert!((stiffness([1, 0], h) / axis - 1.0).abs() < 1e-13);
    assert!((stiffness([1, 1], h * 2.0_f64.sqrt()) / (0.5 * axis) - 1.0).abs() < 1e-13);
    let three = weights(&parameters(3.0, 0.3), 0.1).unwrap();
    let expected = [0.033298902, 0.049531669, 0.065132511, 0.077136918, 0.102490971, 0.095272110];
    OCTANT.iter().zip(expected).for_each(|(step, w)| near(of(&three, *step).shear, w));
}

#[test]
fn weights_of_shear_are_positive_at_every_thickness_and_horizon() {
    for m in [1.5, 2.0, 2.3, 2.9, 3.0, 3.2, 4.0, 5.0, 6.0] {
        for power in -6..=12 {
            let mut parameters = parameters(m, 1.0);
            parameters.section.shear = 10.0_f64.powi(power);
            let all = weights(&parameters, 1.0).unwrap();
            assert!(all.iter().all(|w| w.shear > 0.0), "{m} {power}");
        }
    }
}

/// Moduli of the lattice over those of the plate with ν = 1/3 for the constants of Diyaroglu et al., `a = 8 D x/(π m³)` and
/// `s = 6 S x/(π m³)` with x = ξ/h, as `[C11, C12, shear]`.
fn published_moduli(m: f64) -> [f64; 3] {
    let parameters = PlateParameters { shear_law: ShearLaw::Published, ..parameters(m, 1.0) };
    let (mut sums, nu) = ([0.0; 3], 1.0 / 3.0);
    for Weighted { step: [a, b, _], .. } in weights(&parameters, 1.0).unwrap() {
        let x = f64::from(a * a + b * b).sqrt();
        let [c, s] = [f64::from(a) / x, f64::from(b) / x];
        let bending = 8.0 * x / (PI * m.powi(3));
        sums[0] += bending * c.powi(4);
        sums[1] += bending * (c * s).powi(2);
        sums[2] += 6.0 * x / (PI * m.powi(3)) * c * c;
    }
    // The table divides by D (1, ν) of ν = 1/3 and by S.
    [sums[0], sums[1] / nu, sums[2]]
}

#[test]
fn published_constants_are_far_from_the_plate_at_every_horizon() {
    let table = [
        (2.0, [1.1800, 0.6752, 1.0538]),
        (3.0, [1.0528, 1.0051, 1.0409]),
        (4.0, [0.9743, 0.9266, 0.9624]),
        (6.0, [0.9905, 1.0239, 0.9989]),
    ];
    for (m, expected) in table {
        let found = published_moduli(m);
        found.iter().zip(expected).for_each(|(f, e)| assert!((f - e).abs() < 1e-4, "{m}: {found:?}"));
    }
}

#[test]
fn a_neighbourhood_without_diagonals_is_refused() {
    let found = weights(&parameters(1.0, 0.1), 0.1);
    assert_eq!(found, Err(PlateError::NotIsotropic { horizon_ratio: 1.0 }));
}

#[test]
fn a_solid_lattice_is_refused() {
    let cells = SquareLattice::cuboid(1.0, [0.0; 3], [2, 2, 2]);
    let found = super::super::PlateNodes::new(cells.into()).map(|nodes| nodes.points());
    assert_eq!(found, Err(PlateError::Lattice));
}
