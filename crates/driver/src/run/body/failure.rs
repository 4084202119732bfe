//! How near a material with fibres is to failing in plane stress, by criteria of the literature.

use crate::case::Strengths;

/// Components along 1, across 2 and in shear 12, of a tensor in the plane whose fibres are at an angle from x, rad.
pub(super) fn in_fibre_axes([x, y, xy]: [f64; 3], angle: f64) -> [f64; 3] {
    let (s, c) = angle.sin_cos();
    let both = 2.0 * s * c * xy;
    [c * c * x + s * s * y + both, s * s * x + c * c * y - both, s * c * (y - x) + (c * c - s * s) * xy]
}

/// X_t, X_c, Y_t, Y_c and S; none where one is missing.
fn all(strengths: &Strengths) -> Option<[f64; 5]> {
    let values = strengths.of_fibres().map(|(_, value)| value);
    values.iter().all(Option::is_some).then(|| values.map(Option::unwrap_or_default))
}

/// Tsai and Hill with the strengths of the signs of the stresses: 1 at failure, quadratic in the load (Azzi and Tsai 1965).
pub(super) fn tsai_hill([a, b, t]: [f64; 3], strengths: &Strengths) -> Option<f64> {
    let [xt, xc, yt, yc, s] = all(strengths)?;
    let x = if a < 0.0 { xc } else { xt };
    let y = if b < 0.0 { yc } else { yt };
    Some((a / x).powi(2) - a * b / (x * x) + (b / y).powi(2) + (t / s).powi(2))
}

/// The linear and the quadratic part of the index of Tsai and Wu (1971), with F12 = −√(F11 F22)/2.
fn tsai_wu_parts([a, b, t]: [f64; 3], strengths: &Strengths) -> Option<[f64; 2]> {
    let [xt, xc, yt, yc, s] = all(strengths)?;
    let [f11, f22] = [1.0 / (xt * xc), 1.0 / (yt * yc)];
    let linear = (1.0 / xt - 1.0 / xc) * a + (1.0 / yt - 1.0 / yc) * b;
    let quadratic = f11 * a * a + f22 * b * b - (f11 * f22).sqrt() * a * b + (t / s).powi(2);
    Some([linear, quadratic])
}

/// Tsai and Wu: 1 at failure.
pub(super) fn tsai_wu(stress: [f64; 3], strengths: &Strengths) -> Option<f64> {
    tsai_wu_parts(stress, strengths).map(|[linear, quadratic]| linear + quadratic)
}

/// Stresses over those of the same ratio at which the index of Tsai and Wu is one: proportional to the load.
pub(super) fn utilisation(stress: [f64; 3], strengths: &Strengths) -> Option<f64> {
    // The root R of q R² + l R = 1, upside down.
    tsai_wu_parts(stress, strengths)
        .map(|[linear, quadratic]| 0.5 * (linear + (linear * linear + 4.0 * quadratic).sqrt()))
}

/// Hashin (1980) for the fibres: 1 at failure.
pub(super) fn hashin_fibre([a, _, t]: [f64; 3], strengths: &Strengths) -> Option<f64> {
    let [xt, xc, _, _, s] = all(strengths)?;
    Some(if a < 0.0 { (a / xc).powi(2) } else { (a / xt).powi(2) + (t / s).powi(2) })
}

/// Hashin (1980) for the matrix, its strength in transverse shear half of that in compression: 1 at failure.
pub(super) fn hashin_matrix([_, b, t]: [f64; 3], strengths: &Strengths) -> Option<f64> {
    let [_, _, yt, yc, s] = all(strengths)?;
    let y = if b < 0.0 { yc } else { yt };
    Some((b / y).powi(2) + (t / s).powi(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Kaw, Mechanics of Composite Materials (2006), table 2.1: graphite and epoxy, MPa.
    const GRAPHITE: Strengths = Strengths {
        yield_stress: None,
        fibre_tension: Some(1500.0),
        fibre_compression: Some(1500.0),
        matrix_tension: Some(40.0),
        matrix_compression: Some(246.0),
        shear: Some(68.0),
    };

    #[test]
    fn an_angle_lamina_fails_at_the_loads_of_the_textbook() {
        // Examples 2.18 and 2.19: σ_x = 2S, σ_y = −3S, τ_xy = 4S on fibres at 60°; local stresses of S = 1 are 1.714, −2.714, −4.165.
        let stress = in_fibre_axes([2.0, -3.0, 4.0], 60_f64.to_radians());
        assert!(stress.iter().zip([1.714, -2.714, -4.165]).all(|(a, b)| (a - b).abs() < 5e-4), "{stress:?}");
        // Modified Tsai-Hill S = 16.06 MPa, Tsai-Wu S = 22.39 MPa.
        let hill = tsai_hill(stress, &GRAPHITE).unwrap().sqrt().recip();
        assert!((hill - 16.06).abs() < 5e-3, "{hill}");
        let wu = utilisation(stress, &GRAPHITE).unwrap().recip();
        assert!((wu - 22.39).abs() < 5e-3, "{wu}");
        let at_failure = stress.map(|s| wu * s);
        assert!((tsai_wu(at_failure, &GRAPHITE).unwrap() - 1.0).abs() < 1e-14);
    }

    #[test]
    fn every_strength_is_where_its_stress_alone_fails() {
        let criteria = [tsai_hill, tsai_wu, utilisation];
        for (stress, by_fibre) in [
            ([1500.0, 0.0, 0.0], Some(true)),
            ([-1500.0, 0.0, 0.0], Some(true)),
            ([0.0, 40.0, 0.0], Some(false)),
            ([0.0, -246.0, 0.0], Some(false)),
            ([0.0, 0.0, 68.0], None),
        ] {
            for criterion in criteria {
                let found = criterion(stress, &GRAPHITE).unwrap();
                assert!((found - 1.0).abs() < 1e-14, "{stress:?}: {found}");
            }
            let [fibre, matrix] = [hashin_fibre, hashin_matrix].map(|f| f(stress, &GRAPHITE).unwrap());
            let expected = match by_fibre {
                Some(true) => [1.0, 0.0],
                Some(false) => [0.0, 1.0],
                None => [1.0, 1.0],
            };
            assert_eq!([fibre, matrix], expected, "{stress:?}");
        }
        assert_eq!(tsai_wu([1.0; 3], &Strengths { shear: None, ..GRAPHITE }), None);
    }
}
