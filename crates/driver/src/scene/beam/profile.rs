//! Whether quantities that vary along a line are what they must be.

use crate::diagnostic::{Faults, JsonPath, tidy};
use peristat_assembly::material::Profile;

/// Parts of a range at whose ends a polynomial is looked at.
const PARTS: usize = 4096;

/// Part of a range by which a place before a jump is before it.
const BEFORE: f64 = 1e-12;

/// Adds a fault where a profile has no values: an empty polynomial, a table that is none.
pub(super) fn is_well_formed(profile: &Profile, path: &JsonPath, faults: &mut Faults) -> bool {
    match profile {
        Profile::Uniform(_) => true,
        Profile::Polynomial(coefficients) => {
            if coefficients.is_empty() {
                faults
                    .error(path.key("polynomial"), "a polynomial needs at least its constant")
                    .hint("[a, b, c] is a + b s + c s²");
            }
            !coefficients.is_empty()
        }
        Profile::Table(pairs) => is_table(pairs, &path.key("table"), faults),
    }
}

fn is_table(pairs: &[[f64; 2]], path: &JsonPath, faults: &mut Faults) -> bool {
    if pairs.len() < 2 {
        let found = if pairs.is_empty() { "none" } else { "one" };
        faults
            .error(path.clone(), format!("a table needs at least two pairs [s, value], found {found}"))
            .hint("`uniform` says that a value is the same everywhere");
        return false;
    }
    for k in 1..pairs.len() {
        let (s, before) = (pairs[k][0], pairs[k - 1][0]);
        if s < before {
            let message = format!("the distances of a table must not decrease, found {s} after {before}");
            faults.error(path.index(k), message);
            return false;
        }
        if k > 1 && s == pairs[k - 2][0] {
            faults
                .error(path.index(k), format!("three pairs of a table have the distance {s}"))
                .hint("two are a jump: the value before it and the value after it");
            return false;
        }
    }
    true
}

/// Distances from the start of a range at which profiles are looked at: where tables bend or jump, on both sides, and
/// close to each other where there is a polynomial.
pub(super) fn places(profiles: &[&Profile], length: f64) -> Vec<f64> {
    let curved = profiles.iter().any(|p| matches!(p, Profile::Polynomial(_)) && p.uniform().is_none());
    let parts = if curved { PARTS } else { 1 };
    let mut all: Vec<f64> = (0..=parts).map(|k| length * k as f64 / parts as f64).collect();
    let knots = profiles.iter().flat_map(|p| p.breaks()).map(|pair| pair[0]);
    let inside = knots.filter(|s| *s > 0.0 && *s < length);
    all.extend(inside.flat_map(|s| [s - BEFORE * length, s]));
    all
}

/// Adds a fault where a profile is not greater than zero somewhere in a range.
pub(super) fn is_positive(
    profile: &Profile,
    name: &str,
    length: f64,
    path: &JsonPath,
    faults: &mut Faults,
) -> bool {
    let least = lowest(profile, length);
    let fine = least.1 > 0.0;
    if !fine {
        let place = if profile.uniform().is_some() {
            String::new()
        } else {
            format!(" at {} from the start", tidy(least.0))
        };
        faults.error(
            path.clone(),
            format!("`{name}` must be greater than zero, found {}{place}", tidy(least.1)),
        );
    }
    fine
}

/// The smallest value of a profile in a range, and where it is.
pub(super) fn lowest(profile: &Profile, length: f64) -> (f64, f64) {
    let values = places(&[profile], length).into_iter().map(|s| (s, profile.value(s)));
    values.fold((0.0, f64::INFINITY), |least, v| if v.1 < least.1 { v } else { least })
}

/// The largest value of a profile in a range.
pub(super) fn highest(profile: &Profile, length: f64) -> f64 {
    places(&[profile], length).into_iter().map(|s| profile.value(s)).fold(f64::NEG_INFINITY, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_lowest_value_is_found_between_the_ends() {
        // (s − 1/2)² − 1e-7 is negative over 6e-4 of the range.
        let dip = Profile::Polynomial(vec![0.25 - 1e-7, -1.0, 1.0]);
        let (s, value) = lowest(&dip, 1.0);
        assert!((s - 0.5).abs() < 1e-3 && value < 0.0);
        // The value before a jump counts, one beyond the range does not.
        let jump = Profile::Table(vec![[0.0, 3.0], [0.5, 1.0], [0.5, 2.0], [1.0, 2.0], [2.0, -9.0]]);
        let (s, value) = lowest(&jump, 1.0);
        assert!((s - 0.5).abs() < 1e-11 && (value - 1.0).abs() < 1e-10);
    }
}
