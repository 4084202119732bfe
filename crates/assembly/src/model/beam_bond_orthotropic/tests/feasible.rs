//! Which materials and angles matched bonds represent, and what they have then.

use super::*;
use crate::model::plane::is_within;

const ANGLES: [f64; 11] = [0.0, 5.0, 10.0, 15.0, 20.0, 22.5, 26.565_051_177_077_99, 30.0, 35.0, 40.0, 45.0];

/// Asserts the moduli, the rotation modulus and the lack of coupling.
fn assert_exact(parameters: &OrthotropicParameters, bonds: &BeamNeighbourhood) {
    let material = &parameters.material;
    let [[c11, c12, _], _, [_, _, c66]] = material.stiffness();
    let moments = bonds.moments();
    let expected = material.stiffness_at(parameters.relative_angle());
    let off = difference(&moments.stiffness, &expected).max(difference(&moments.effective(), &expected));
    // Largest over whole degrees of A and B, m from 3 to 10: 2.6e-15, 2.6e-15 and 1.7e-17 of C11.
    assert!(off <= 1e-13 * c11, "{parameters:?}: {}", off / c11);
    let rotation = 4.0 * (c66 - c12);
    assert!((moments.rotation - rotation).abs() <= 1e-13 * c11, "{parameters:?}");
    assert!(moments.coupling.iter().all(|h| h.abs() <= 1e-15 * c11), "{parameters:?}");
    assert!(bonds.is_consistent());
    assert!((bonds.effective_shear_modulus() - c66).abs() <= 1e-13 * c11);
    assert!(bonds.weights().iter().flatten().all(|w| *w >= 0.0 && w.is_finite()));
    // Every bond inside the horizon holds rotations.
    for (&step, [_, b, q]) in bonds.offsets().iter().zip(bonds.weights()) {
        assert_eq!(
            *b > 0.0 && *q > 0.0,
            is_within(step, parameters.horizon_ratio),
            "{parameters:?} {step:?}"
        );
    }
}

#[test]
fn moderate_fibres_exist_at_every_angle() {
    for (m, degrees) in [3.0, 3.2, 4.0, 5.0, 6.0].into_iter().flat_map(|m| ANGLES.map(|a| (m, a))) {
        let parameters = parameters(A, degrees, m);
        assert_exact(&parameters, &BeamNeighbourhood::new(&parameters).unwrap());
    }
}

#[test]
fn stiff_fibres_exist_at_every_angle_from_a_ratio_of_3_17() {
    for (m, degrees) in [3.2, 4.0, 5.0, 6.0].into_iter().flat_map(|m| ANGLES.map(|a| (m, a))) {
        let parameters = parameters(B, degrees, m);
        assert_exact(&parameters, &BeamNeighbourhood::new(&parameters).unwrap());
    }
    for degrees in ANGLES {
        let parameters = parameters(B, degrees, 3.015);
        match BeamNeighbourhood::new(&parameters) {
            Ok(bonds) => assert_exact(&parameters, &bonds),
            Err(error @ OrthotropicError::NotRepresentable { residual, .. }) => {
                assert!((5.0..=20.0).contains(&degrees), "{degrees}: {error}");
                assert!((1e-6..3e-2).contains(&residual), "{degrees}: {residual}");
                assert!(
                    error.to_string().ends_with("; increase the horizon ratio (3.2 represents every angle)")
                );
            }
            Err(error) => panic!("{error}"),
        }
        let refused = BeamNeighbourhood::new(&parameters).is_err();
        assert_eq!(refused, (5.0..=20.0).contains(&degrees), "{degrees}");
    }
}

#[test]
fn isotropic_bodies_have_any_poisson_ratio_below_a_third() {
    for (m, nu) in
        [1.5, 2.0, 3.0, 4.0].into_iter().flat_map(|m| [-0.5, 0.0, 0.2, 0.3, 0.33].map(|nu| (m, nu)))
    {
        for degrees in [0.0, 17.0] {
            let parameters = parameters(OrthotropicMaterial::isotropic(70e9, nu, 2e-3), degrees, m);
            assert_exact(&parameters, &BeamNeighbourhood::new(&parameters).unwrap());
        }
    }
}

#[test]
fn images_in_the_fibres_are_equal() {
    for (material, degrees) in [(A, 0.0), (A, 45.0), (B, 90.0), (B, 135.0)] {
        let bonds = BeamNeighbourhood::new(&parameters(material, degrees, 4.0)).unwrap();
        let swap = |[a, b, _]: Cell| if degrees % 90.0 == 0.0 { [a, -b, 0] } else { [b, a, 0] };
        let weights = |step: Cell| {
            let back = step.map(|k| -k);
            let k = bonds.offsets().iter().position(|o| *o == step || *o == back).unwrap();
            bonds.weights()[k]
        };
        bonds.offsets().iter().for_each(|&step| assert_eq!(weights(step), weights(swap(step)), "{step:?}"));
    }
}

#[test]
fn a_lattice_turned_with_the_fibres_sees_them_along_its_rows() {
    let straight = BeamNeighbourhood::new(&parameters(B, 0.0, 3.0)).unwrap();
    let angle = 0.3;
    let turned =
        OrthotropicParameters { fibre_angle: angle, lattice_angle: angle, ..parameters(B, 0.0, 3.0) };
    assert_eq!(BeamNeighbourhood::new(&turned).unwrap(), straight);
}

#[test]
fn units_and_thickness_do_not_change_the_shares() {
    let small = OrthotropicMaterial {
        youngs_modulus_1: B.youngs_modulus_1 / MPA,
        youngs_modulus_2: B.youngs_modulus_2 / MPA,
        shear_modulus_12: B.shear_modulus_12 / MPA,
        thickness: 7.0,
        ..B
    };
    let of = |material| BeamNeighbourhood::new(&parameters(material, 30.0, 3.2)).unwrap();
    for (a, b) in of(B).weights().iter().flatten().zip(of(small).weights().iter().flatten()) {
        assert!((a / MPA - b).abs() <= 1e-12 * B.youngs_modulus_1 / MPA);
    }
}

#[test]
fn an_asked_start_is_taken_or_refused() {
    let with =
        |material, degrees, start| OrthotropicParameters { start, ..parameters(material, degrees, 3.2) };
    let start = |p: OrthotropicParameters| BeamNeighbourhood::new(&p).map(|bonds| bonds.start());
    assert_eq!(start(with(A, 45.0, Some(Start::Oblique))), Ok(Some(Start::Oblique)));
    assert_eq!(start(with(A, 45.0, Some(Start::Aligned))), Ok(Some(Start::Aligned)));
    let refused = |p| start(p).unwrap_err();
    assert!(matches!(refused(with(A, 15.0, Some(Start::Aligned))), OrthotropicError::NoFibreBonds { .. }));
    let soft = OrthotropicMaterial { shear_modulus_12: 3500.0 * MPA, ..A };
    let error = refused(with(soft, 0.0, Some(Start::Aligned)));
    assert!(matches!(error, OrthotropicError::NegativeFibreShear { .. }));
    assert!(error.to_string().ends_with("in the start `aligned`; take the start `oblique`"), "{error}");
    assert_eq!(start(with(soft, 0.0, None)), Ok(Some(Start::Oblique)));
    let wide = OrthotropicMaterial { poisson_ratio_12: 0.36, ..A };
    let error = refused(with(wide, 0.0, Some(Start::Aligned)));
    assert!(matches!(error, OrthotropicError::NegativeMatrixShear { .. }), "{error}");
    for material in [soft, wide] {
        let parameters = with(material, 0.0, None);
        assert_exact(&parameters, &BeamNeighbourhood::new(&parameters).unwrap());
    }
    let none = OrthotropicParameters { horizon_ratio: 0.9, ..parameters(A, 0.0, 3.0) };
    assert!(matches!(BeamNeighbourhood::new(&none), Err(OrthotropicError::NoNeighbours { .. })));
}
