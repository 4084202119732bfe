//! Round factors for deformed shapes.

/// The factor with which a displacement is drawn as a tenth of a size: one of 1, 2, 5 times a power of ten, not above it.
pub(super) fn magnification(size: f64, largest: f64) -> f64 {
    let wanted = 0.1 * size / largest;
    if wanted.is_finite() { round(wanted) } else { 1.0 }
}

/// The largest of 1, 2, 5 times a power of ten that is not above `value`.
fn round(value: f64) -> f64 {
    let power = value.log10().floor() as i32;
    // Negative powers by division: their own rounding would show.
    let scaled = |lead: f64| if power < 0 { lead / 10_f64.powi(-power) } else { lead * 10_f64.powi(power) };
    [5.0, 2.0, 1.0].into_iter().map(scaled).find(|v| *v <= value).unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::round;

    #[test]
    fn factors_are_round_numbers() {
        assert_eq!([1.0, 3.7, 640.0, 0.093, 9.99e-7].map(round), [1.0, 2.0, 500.0, 0.05, 5e-7]);
    }
}
