//! Critical stretches and the energy that cracks release.

use super::*;

/// Spacing, m.
const H: f64 = 0.5e-3;

fn diagonal() -> BeamNeighbourhood {
    BeamNeighbourhood::new(&parameters(B, 45.0, 3.0)).unwrap()
}

#[test]
fn cracks_release_what_the_independent_implementation_says() {
    // N/mm, NumPy: 3.020 along and 56.165 across the fibres, of which bonds along them 54.06.
    let stretches = CriticalStretches { fibre: 0.03, matrix: 0.02 };
    let rates = stretches.release_rates(&diagonal(), H);
    assert!((rates.matrix / 3.0201e3 - 1.0).abs() < 1e-4, "{}", rates.matrix);
    assert!((rates.fibre / 56.165e3 - 1.0).abs() < 1e-4, "{}", rates.fibre);
    let fibres = CriticalStretches { fibre: 0.03, matrix: 0.0 }.release_rates(&diagonal(), H);
    assert!((fibres.fibre / 54.06e3 - 1.0).abs() < 1e-3 && fibres.matrix == 0.0);
}

#[test]
fn stretches_by_energy_release_what_they_were_made_for() {
    let bonds = diagonal();
    let rates = ReleaseRates { fibre: 56.165e3, matrix: 3.0201e3 };
    let found = CriticalStretches::by_energy(rates, &bonds, H).unwrap();
    // The stretches above, of rates rounded to 1e-5.
    assert!((found.fibre / 0.03 - 1.0).abs() < 2e-5 && (found.matrix / 0.02 - 1.0).abs() < 2e-5, "{found:?}");
    let back = found.release_rates(&bonds, H);
    assert!((back.fibre / rates.fibre - 1.0).abs() < 1e-14);
    assert!((back.matrix / rates.matrix - 1.0).abs() < 1e-14);
}

#[test]
fn published_stretches_release_other_energies() {
    // Inverse of s = √(4πG/(9Eδ)), δ = 3.015 h: 3.628 N/mm along the fibres and 102.03 across.
    let rates = ReleaseRates { fibre: 102.03e3, matrix: 3.628e3 };
    let found = CriticalStretches::published(rates, &B, 3.015 * H);
    assert!((found.fibre / 0.03 - 1.0).abs() < 1e-4 && (found.matrix / 0.02 - 1.0).abs() < 1e-4, "{found:?}");
}

#[test]
fn toughness_that_no_stretch_has_is_refused() {
    let error = |fibre, bonds: &BeamNeighbourhood| {
        CriticalStretches::by_energy(ReleaseRates { fibre, matrix: 3.0e3 }, bonds, H).unwrap_err()
    };
    let small = error(2.0e3, &diagonal());
    assert!(matches!(small, OrthotropicError::FibreReleaseTooSmall { .. }));
    assert!(small.to_string().contains("; increase the fibre energy release rate"), "{small}");
    let oblique = BeamNeighbourhood::new(&parameters(B, 15.0, 3.2)).unwrap();
    let error = error(50.0e3, &oblique);
    assert!(error.to_string().ends_with("; turn the lattice with the fibres"), "{error}");
}
