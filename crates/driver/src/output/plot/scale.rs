//! The range of an axis, its ticks, and short words for its numbers.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};

/// Smallest part of its largest number that a range spans; below it tick labels would need too many digits.
const NARROWEST: f64 = 1e-5;
/// Differences below this part of the largest number are rounding: a constant.
const EQUAL: f64 = 1e-9;
/// Numbers below this are drawn as zero: their differences have no digits left.
const TINY: f64 = 1e-290;
/// Numbers above this have differences that overflow.
const HUGE: f64 = 1e290;

/// One axis of a diagram.
#[derive(Debug, Clone)]
pub(super) struct Scale {
    pub(super) low: f64,
    pub(super) high: f64,
    pub(super) ticks: Vec<f64>,
    /// Power of ten, a multiple of 3, that tick labels leave out.
    exponent: i32,
    decimals: usize,
    /// Whether it runs the other way.
    turned: bool,
}

impl Scale {
    /// A range around all values, wider by the part `padding` on both sides, with about `count` ticks.
    ///
    /// `None` if there is no value, or one that is not finite or too large to be drawn.
    pub(super) fn new(values: impl Iterator<Item = f64>, padding: f64, count: f64) -> Option<Self> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values {
            // `max` and `min` would pass over a NaN.
            if value.is_nan() || value.abs() >= HUGE {
                return None;
            }
            (low, high) = (low.min(value), high.max(value));
        }
        if low > high {
            return None;
        }
        let size = low.abs().max(high.abs());
        if size < TINY {
            (low, high) = (-1.0, 1.0);
        } else if high - low < EQUAL * size {
            (low, high) = (low - size / 2.0, high + size / 2.0);
        } else if high - low < NARROWEST * size {
            let middle = low / 2.0 + high / 2.0;
            (low, high) = (middle - NARROWEST * size / 2.0, middle + NARROWEST * size / 2.0);
        }
        let margin = padding * (high - low);
        (low, high) = (low - margin, high + margin);

        let step = nice((high - low) / count);
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        // Multiples, not sums: so that zero is zero.
        let ticks: Vec<f64> = (first..=last).map(|i| i as f64 * step).collect();
        let exponent = exponent_of(ticks.iter().fold(0.0, |largest: f64, tick| largest.max(tick.abs())));
        let decimals = -(step.log10() + 1e-9).floor() as i32 + exponent;
        Some(Scale { low, high, ticks, exponent, decimals: decimals.max(0) as usize, turned: false })
    }

    /// The same, or running the other way.
    pub(super) fn turned(self, turned: bool) -> Self {
        Self { turned, ..self }
    }

    /// The label of a tick.
    pub(super) fn label(&self, tick: f64) -> String {
        fixed(tick, self.exponent, self.decimals)
    }

    /// The factor that the labels leave out, if any: `×10⁻⁶`.
    pub(super) fn factor(&self) -> Option<String> {
        (self.exponent != 0).then(|| factor(self.exponent))
    }
}

impl Ranged for Scale {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, limit: (i32, i32)) -> i32 {
        let part = (value - self.low) / (self.high - self.low);
        let part = if self.turned { 1.0 - part } else { part };
        limit.0 + (part * f64::from(limit.1 - limit.0)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, hint: Hint) -> Vec<f64> {
        // Light points are lines between the ticks: none.
        if hint.weight().allow_light_points() { Vec::new() } else { self.ticks.clone() }
    }

    fn range(&self) -> std::ops::Range<f64> {
        self.low..self.high
    }
}

impl ValueFormatter<f64> for Scale {
    fn format_ext(&self, tick: &f64) -> String {
        self.label(*tick)
    }
}

/// Round values strictly between two others, as nearly `count` of them as there can be.
pub(crate) fn levels([low, high]: [f64; 2], count: usize) -> Vec<f64> {
    let inside = |factor: f64| {
        let scale = Scale::new([low, high].into_iter(), 0.0, factor * count as f64);
        let ticks = scale.into_iter().flat_map(|scale| scale.ticks);
        ticks.filter(|tick| low < *tick && *tick < high).collect::<Vec<f64>>()
    };
    // Steps are rounded up: finer ones may have the better number.
    let all = [1.0, 1.25, 1.6, 2.0, 2.5].map(inside);
    all.into_iter().min_by_key(|ticks| ticks.len().abs_diff(count)).unwrap_or_default()
}

/// A number with four digits: `0.004`, `-12.35`, `1.234×10⁻⁶`.
pub(crate) fn short(value: f64) -> String {
    let exponent = exponent_of(value.abs());
    let digits = (value.abs() / 10_f64.powi(exponent)).log10().floor();
    let text = fixed(value, exponent, (3.0 - digits).clamp(0.0, 6.0) as usize);
    let text = match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.'),
        false => &text,
    };
    if exponent == 0 { text.to_string() } else { format!("{text}{}", factor(exponent)) }
}

fn fixed(value: f64, exponent: i32, decimals: usize) -> String {
    // In two steps, since 10^-exponent may overflow where the quotient does not.
    let scaled = value / 10_f64.powi(exponent);
    let text = format!("{scaled:.decimals$}");
    if text.bytes().all(|b| b"-0.".contains(&b)) {
        text.trim_start_matches('-').to_string()
    } else {
        text.replace('-', "−")
    }
}

/// The power of ten to leave out of numbers up to `largest`: none for everyday sizes, else a multiple of 3.
fn exponent_of(largest: f64) -> i32 {
    if largest == 0.0 || (0.01..10_000.0).contains(&largest) {
        return 0;
    }
    3 * ((largest.log10() + 1e-9) / 3.0).floor() as i32
}

fn factor(exponent: i32) -> String {
    format!("×{}", power_of_ten(exponent))
}

/// A power of ten: `10⁻⁶`.
pub(super) fn power_of_ten(exponent: i32) -> String {
    let raised = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        digit => char::from_u32('⁰' as u32 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    format!("10{}", exponent.to_string().chars().map(raised).collect::<String>())
}

/// The largest of 1, 2, 5 times a power of ten that is not much above `step`.
fn nice(step: f64) -> f64 {
    let power = 10_f64.powf(step.log10().floor());
    let lead = [1.0, 2.0, 5.0, 10.0].into_iter().find(|lead| lead * power >= 0.99 * step);
    lead.unwrap_or(10.0) * power
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(values: &[f64]) -> (Vec<String>, Option<String>) {
        let scale = Scale::new(values.iter().copied(), 0.0, 5.0).unwrap();
        (scale.ticks.iter().map(|&tick| scale.label(tick)).collect(), scale.factor())
    }

    #[test]
    fn isolines_are_about_as_many_as_asked_for() {
        assert_eq!(levels([7.8, 172.8], 8), [20.0, 40.0, 60.0, 80.0, 100.0, 120.0, 140.0, 160.0]);
        for count in 1..30 {
            let found = levels([7.8, 172.8], count).len();
            // Steps are 1, 2 or 5 times a power of ten: at worst their numbers are 2.5 apart.
            assert!(found.abs_diff(count) <= 1 + count / 2, "{found} of {count}");
        }
    }

    #[test]
    fn ticks_are_round_numbers_with_a_common_factor() {
        assert_eq!(labels(&[0.0, 1.0]).0, ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&[-1.0, 1.0]).0, ["−1.0", "−0.5", "0.0", "0.5", "1.0"]);
        assert_eq!(labels(&[0.0, 4200.0]).0, ["0", "1000", "2000", "3000", "4000"]);
        let (ticks, factor) = labels(&[0.0, -2.5e-6]);
        assert_eq!(
            (ticks, factor.as_deref()),
            (["−2.5", "−2.0", "−1.5", "−1.0", "−0.5", "0.0"].map(String::from).to_vec(), Some("×10⁻⁶"))
        );
        assert_eq!(labels(&[0.0, 1e9]).1.as_deref(), Some("×10⁹"));
        assert_eq!(labels(&[0.0, 1e-245]).1.as_deref(), Some("×10⁻²⁴⁶"));
    }

    #[test]
    fn degenerate_ranges_have_a_width_and_distinct_labels() {
        for values in [
            vec![0.0],
            vec![5.0, 5.0],
            vec![-1e-7],
            vec![1e6, 1e6 + 1e-9],
            vec![1e-300, 0.0],
            vec![1e289, -1e289],
        ] {
            let scale = Scale::new(values.iter().copied(), 0.08, 6.0).unwrap();
            assert!(scale.low < scale.high, "{values:?}");
            assert!((3..=12).contains(&scale.ticks.len()), "{values:?}: {:?}", scale.ticks);
            let mut labels: Vec<_> = scale.ticks.iter().map(|&tick| scale.label(tick)).collect();
            assert!(labels.iter().all(|label| label.chars().count() <= 12), "{labels:?}");
            labels.dedup();
            assert_eq!(labels.len(), scale.ticks.len(), "{labels:?}");
        }
    }

    #[test]
    fn what_cannot_be_drawn_is_refused() {
        for values in [vec![], vec![f64::NAN, 1.0], vec![1.0, f64::INFINITY], vec![1e300]] {
            assert!(Scale::new(values.iter().copied(), 0.0, 5.0).is_none(), "{values:?}");
        }
    }

    #[test]
    fn single_numbers_have_four_digits() {
        for (value, text) in [
            (0.004, "4×10⁻³"),
            (-12.3456, "−12.35"),
            (1.2346e-6, "1.235×10⁻⁶"),
            (0.0, "0"),
            (1500.0, "1500"),
            (0.5, "0.5"),
            (98765.0, "98.77×10³"),
        ] {
            assert_eq!(short(value), text);
        }
    }
}
