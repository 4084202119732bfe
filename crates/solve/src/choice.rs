//! Which factorisation suits a matrix.

/// The two direct methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// [`BandCholesky`](crate::BandCholesky)
    Band,
    /// [`SparseCholesky`](crate::SparseCholesky)
    Sparse,
}

/// What the choice depends on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Profile {
    /// Order of the matrix.
    pub unknowns: usize,
    /// Largest distance of a non-zero entry from the diagonal.
    pub half_bandwidth: usize,
    /// Stored entries of one triangle, the diagonal included.
    pub entries: usize,
}

// Measured on strips of a square lattice, 29 entries per row of a triangle: the band
// kernel is faster up to a half bandwidth of 150 (fill 5), analysis not counted, and
// needs half the memory; at 240 (fill 8) it is slower.

/// Half bandwidths for which nothing beats the band kernel, whatever the fill.
const NARROW: usize = 15;
/// Half bandwidths beyond which the work, which grows with the square, is too much.
const WIDE: usize = 160;
/// Fill (band entries per entry of the matrix) that the simpler loop makes up for.
const FILL: f64 = 6.0;

/// The method for a matrix, and the reason in one sentence.
#[must_use]
pub fn choose(profile: &Profile) -> (Method, String) {
    let Profile { unknowns, half_bandwidth, entries } = *profile;
    let width = half_bandwidth.saturating_add(1).min(unknowns);
    // The last columns are cut short by the end of the matrix.
    let band = unknowns as f64 * width as f64 - 0.5 * width as f64 * (width as f64 - 1.0);
    let fill = band / entries.max(1) as f64;
    let place = format!("half bandwidth {half_bandwidth} of {unknowns} unknowns");
    let narrow = half_bandwidth <= NARROW || (half_bandwidth <= WIDE && fill <= FILL);
    if narrow {
        let reason = if fill < 1.05 {
            format!("{place}: the band factor has no fill")
        } else {
            format!("{place}: the band factor has only {fill:.1} times the entries of the matrix")
        };
        return (Method::Band, reason);
    }
    let reason = if fill > FILL {
        format!("{place}: a band factor would have {fill:.1} times the entries of the matrix")
    } else {
        format!("{place}: the work of a band factor, which grows with the square, is too much")
    };
    (Method::Sparse, reason)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn method(unknowns: usize, half_bandwidth: usize, entries: usize) -> Method {
        let profile = Profile { unknowns, half_bandwidth, entries };
        choose(&profile).0
    }

    #[test]
    fn a_chain_is_a_band() {
        let profile = Profile {
            unknowns: 2_000_002,
            half_bandwidth: 7,
            entries: 15_999_988, // 8 per column less the 28 cut off at the end
        };
        let (method, reason) = choose(&profile);
        assert_eq!(method, Method::Band);
        assert_eq!(reason, "half bandwidth 7 of 2000002 unknowns: the band factor has no fill");
    }

    #[test]
    fn a_square_lattice_is_not() {
        // 100 x 100 points, 2 unknowns each, 28 neighbours: rows of 100 points.
        assert_eq!(method(20_000, 607, 20_000 * 29), Method::Sparse);
    }

    #[test]
    fn a_narrow_strip_is_and_a_chain_with_one_far_link_is_not() {
        assert_eq!(method(10_000, 40, 10_000 * 25), Method::Band);
        assert_eq!(method(10_000, 9_999, 10_000 * 8), Method::Sparse);
    }

    #[test]
    fn every_method_has_its_reason() {
        let reason = |unknowns, half_bandwidth, entries| {
            let profile = Profile { unknowns, half_bandwidth, entries };
            choose(&profile).1
        };
        // Expected fills by hand: (1000 * 41 - 820) / 20000, (1000 * 401 - 80200) / 20000.
        assert_eq!(
            reason(1000, 40, 20_000),
            "half bandwidth 40 of 1000 unknowns: the band factor has only 2.0 times the entries of \
             the matrix"
        );
        assert_eq!(
            reason(1000, 400, 20_000),
            "half bandwidth 400 of 1000 unknowns: a band factor would have 16.0 times the entries \
             of the matrix"
        );
        assert_eq!(
            reason(1000, 999, 500_500), // the whole triangle
            "half bandwidth 999 of 1000 unknowns: the work of a band factor, which grows with the \
             square, is too much"
        );
    }

    #[test]
    fn nothing_at_all_is_a_band() {
        assert_eq!(method(0, 0, 0), Method::Band);
        assert_eq!(method(1, 0, 1), Method::Band);
    }
}
