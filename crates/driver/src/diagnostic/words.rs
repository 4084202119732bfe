//! Words of messages.

/// A number for a message: without the last digits, which rounding left, and not longer than it must be.
pub(crate) fn tidy(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let (plain, scientific) = (rounded.to_string(), format!("{rounded:e}"));
    if plain.len() <= scientific.len() + 6 { plain } else { scientific }
}

/// The name nearest to `name`, for a hint.
pub(crate) fn suggest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    let nearest = known.iter().map(|k| (strsim::jaro_winkler(name, k), k)).max_by(|a, b| a.0.total_cmp(&b.0));
    match nearest {
        Some((likeness, nearest)) if likeness > 0.75 => format!("did you mean `{nearest}`?"),
        Some(_) => format!("known are {}", known.join(", ")),
        None => "there are none".into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_in_a_message_has_no_rounding_digits_and_no_row_of_zeros() {
        assert_eq!(tidy(0.1 + 0.2), "0.3");
        assert_eq!(tidy(20.0 * 0.05 - 0.05), "0.95");
        assert_eq!(tidy(1e100), "1e100");
        assert_eq!(tidy(-1e-100), "-1e-100");
        assert_eq!(tidy(12_345.678_9), "12345.6789");
    }
}
