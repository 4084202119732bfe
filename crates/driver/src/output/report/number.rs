//! Numbers as they are set in books.

/// A number with six digits: `0.00320624`, `−1.5×10⁻⁶`, `2×10¹¹`.
pub fn number(value: f64) -> String {
    let size = value.abs();
    if size == 0.0 {
        return "0".into();
    }
    if !size.is_finite() {
        return if value.is_nan() { "-".into() } else { "∞".into() };
    }
    if (1e-3..1e6).contains(&size) {
        let digits = (5 - size.log10().floor() as i32).max(0) as usize;
        return trimmed(&format!("{value:.digits$}")).replace('-', "−");
    }
    typeset(&format!("{value:.5e}"))
}

/// A decimal number without zeros at its end.
fn trimmed(text: &str) -> &str {
    if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.') } else { text }
}

/// A text in which numbers such as `-2.50e-6` read `−2.5×10⁻⁶`.
pub fn typeset(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    let mut rest = text;
    // Digits in words and in names, `part 2e`, are none that end with an exponent.
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let before = &rest[..start];
        let after_word = before.ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '.');
        let signed = before.strip_suffix('-').filter(|b| !b.ends_with(|c: char| c.is_alphanumeric()));
        let tail = &rest[start..];
        let end = tail.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(tail.len());
        let (mantissa, tail) = tail.split_at(end);
        match exponent(tail) {
            Some((power, tail)) if !after_word => {
                out.push_str(signed.unwrap_or(before));
                if signed.is_some() {
                    out.push('−');
                }
                out.push_str(trimmed(mantissa));
                out.push_str(&times_ten_to(power));
                rest = tail;
            }
            _ => {
                match signed {
                    Some(before) => out.extend([before, "−"]),
                    None => out.push_str(before),
                }
                out.push_str(mantissa);
                rest = tail;
            }
        }
    }
    out + rest
}

/// The power of ten at the beginning of a text, `e-6`, and what follows it.
fn exponent(text: &str) -> Option<(i32, &str)> {
    let digits = text.strip_prefix('e')?;
    let sign = usize::from(digits.starts_with('-'));
    let end = digits[sign..].find(|c: char| !c.is_ascii_digit()).map_or(digits.len(), |k| sign + k);
    let (power, rest) = digits.split_at(end);
    let follows = rest.starts_with(|c: char| c.is_alphanumeric());
    power.parse().ok().filter(|_| !follows).map(|power| (power, rest))
}

fn times_ten_to(power: i32) -> String {
    const RAISED: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    if power == 0 {
        return String::new();
    }
    let raised = |c: char| c.to_digit(10).map_or('⁻', |digit| RAISED[digit as usize]);
    format!("×10{}", power.to_string().chars().map(raised).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_have_six_digits_and_true_signs() {
        let text = [0.0, 1.0, -0.003_206_24, 123_456.7, 2e11, -5.208_333_333e-7, f64::NAN].map(number);
        assert_eq!(text, ["0", "1", "−0.00320624", "123457", "2×10¹¹", "−5.20833×10⁻⁷", "-"]);
    }

    #[test]
    fn numbers_in_texts_are_set_and_words_are_left_alone() {
        let text = "A = 0.0025 m², EI = 1.60256e8 N, balance 0.0e0 and -8.60e-16, plane2e5, case_1e6, x-3, L/250, 2-D";
        let set = "A = 0.0025 m², EI = 1.60256×10⁸ N, balance 0 and −8.6×10⁻¹⁶, plane2e5, case_1e6, x-3, L/250, 2-D";
        assert_eq!(typeset(text), set);
        assert_eq!(typeset("at (-1.5, 2) of 3e"), "at (−1.5, 2) of 3e");
    }
}
