//! Words of messages.

/// A number for a message: without the last digits, which rounding left, and not longer than it must be.
pub(crate) fn tidy(value: f64) -> String {
    let rounded: f64 = format!("{value:.11e}").parse().unwrap_or(value);
    let (plain, scientific) = (rounded.to_string(), format!("{rounded:e}"));
    if plain.len() <= scientific.len() + 6 { plain } else { scientific }
}

/// How alike two names must be (Jaro-Winkler) for the one to be offered for the other.
const ALIKE: f64 = 0.75;
/// Letters that a slip of the hand adds, drops, changes or swaps.
const SLIP: usize = 2;
/// Fewest letters of a stem that says what a name is about.
const STEM: usize = 4;
/// Names that are offered at most.
const OFFERED: usize = 6;

/// The names nearest to `name`, for a hint.
pub(crate) fn suggest<'a>(name: &str, known: impl Iterator<Item = &'a str>) -> String {
    let known: Vec<&str> = known.collect();
    match did_you_mean(&meant(name, &known)) {
        Some(question) => question,
        None if known.is_empty() => "there are none".into(),
        None => format!("known are {}", known.join(", ")),
    }
}

/// The names that `name` may stand for. Who misses by a slip means a name that is as near as the
/// nearest one; who misses by more knows its stem, such as `bond_`, and may mean any name that begins with it.
pub(super) fn meant<'a>(name: &str, known: &[&'a str]) -> Vec<&'a str> {
    let name = name.to_lowercase();
    let likeness = |known: &str| strsim::jaro_winkler(&name, &known.to_lowercase());
    let changes = |known: &str| strsim::osa_distance(&name, &known.to_lowercase());
    let nearest = known.iter().copied().max_by(|a, b| likeness(a).total_cmp(&likeness(b)));
    let Some(nearest) = nearest.filter(|nearest| likeness(nearest) > ALIKE) else { return Vec::new() };
    let (fewest, stem) = (changes(nearest), stem(&name, nearest));
    let is_like = |other: &&str| match fewest <= SLIP {
        true => changes(other) <= fewest && likeness(other) > ALIKE,
        false => stem.len() >= STEM && other.starts_with(stem),
    };
    let mut all: Vec<&str> = known.iter().copied().filter(|k| *k == nearest || is_like(k)).collect();
    // Those that a slip could mean alike stay in their order, which is that of `_1`, `_2`.
    if fewest > SLIP {
        all.sort_by(|a, b| likeness(b).total_cmp(&likeness(a)));
    }
    all.truncate(OFFERED);
    all
}

/// What both names begin with, in whole words.
fn stem<'a>(name: &str, nearest: &'a str) -> &'a str {
    let common: usize =
        name.chars().zip(nearest.chars()).take_while(|(a, b)| a == b).map(|(_, b)| b.len_utf8()).sum();
    match common == name.len() {
        true => &nearest[..common],
        false => nearest[..common].rfind('_').map_or("", |end| &nearest[..=end]),
    }
}

/// Names as a question; none of no name.
pub(super) fn did_you_mean(names: &[&str]) -> Option<String> {
    Some(format!("did you mean {}?", choice(names)?))
}

/// Names as a choice among them, such as `` `a`, `b` or `c` ``.
pub(super) fn choice(names: &[&str]) -> Option<String> {
    let (last, others) = names.split_last()?;
    Some(match others {
        [] => format!("`{last}`"),
        others => format!("`{}` or `{last}`", others.join("`, `")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_names_that_may_be_meant_are_offered() {
        let known = ["bond_plane", "bond_solid", "state_plane", "principal_stress_1", "principal_stress_2"];
        for (name, names) in [
            ("bond_based", "`bond_plane` or `bond_solid`"),
            ("principal_stress", "`principal_stress_1` or `principal_stress_2`"),
            ("bond_plain", "`bond_plane`"),
            ("state_plain", "`state_plane`"),
        ] {
            assert_eq!(suggest(name, known.into_iter()), format!("did you mean {names}?"));
        }
        assert!(suggest("xyz", known.into_iter()).starts_with("known are bond_plane, "));
        assert_eq!(suggest("xyz", [].into_iter()), "there are none");
    }

    #[test]
    fn a_number_in_a_message_has_no_rounding_digits_and_no_row_of_zeros() {
        assert_eq!(tidy(0.1 + 0.2), "0.3");
        assert_eq!(tidy(20.0 * 0.05 - 0.05), "0.95");
        assert_eq!(tidy(1e100), "1e100");
        assert_eq!(tidy(-1e-100), "-1e-100");
        assert_eq!(tidy(12_345.678_9), "12345.6789");
    }
}
