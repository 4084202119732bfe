//! The extremes of a smooth function between two positions.

/// A part between two positions in which a function is smooth, with its values at the ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) ends: [f64; 2],
    pub(super) values: [f64; 2],
}

/// Share of the part over which slopes are found: an extreme that is nearer to an end rises above it by the square of this.
const STEP: f64 = 1e-6;
/// What differs by less, relative to the largest value, is rounding.
const ROUNDING: f64 = 1e-14;

impl Part {
    /// The values at its ends, with their positions.
    pub(super) fn corners(&self) -> [(f64, f64); 2] {
        [0, 1].map(|k| (self.values[k], self.ends[k]))
    }

    /// The position at a share of its length.
    pub(super) fn at(&self, q: f64) -> f64 {
        self.ends[0] + q * (self.ends[1] - self.ends[0])
    }

    /// Whether the function may leave a range inside. At one of two places a cubic is three quarters as far from its chord as anywhere, or
    /// more; others have twice the room. None where it has no value.
    pub(super) fn may_leave(&self, [low, high]: [f64; 2], f: impl Fn(f64) -> Option<f64>) -> Option<bool> {
        const ROOM: f64 = 3.0;
        let [start, end] = self.values;
        let mut rise: f64 = 0.0;
        for q in [0.25, 0.75] {
            rise = rise.max(ROOM * (f(self.at(q))? - start - q * (end - start)).abs());
        }
        Some(start.max(end) + rise > high || start.min(end) - rise < low)
    }

    /// The value in the middle, and largest and smallest values inside, with their positions: at most one in each half. None where
    /// the function has no value.
    pub(super) fn peaks(&self, f: impl Fn(f64) -> Option<f64>) -> Option<Vec<(f64, f64)>> {
        let f = |q: f64| f(self.at(q));
        let [start, end] = self.values;
        let middle = f(0.5)?;
        let noise = ROUNDING * start.abs().max(middle.abs()).max(end.abs());
        let clean = |rise: f64| if rise.abs() > noise { rise / STEP } else { 0.0 };
        let slopes = [clean(f(STEP)? - start), clean(f(0.5 + STEP)? - middle), clean(end - f(1.0 - STEP)?)];
        let mut found = vec![(middle, self.at(0.5))];
        let halves = [([0.0, 0.5], [start, middle]), ([0.5, 1.0], [middle, end])];
        for ((ends, values), slopes) in halves.into_iter().zip(slopes.windows(2)) {
            if slopes[0] * slopes[1] < 0.0 {
                let sign = slopes[0].signum();
                let half = Half {
                    ends,
                    values: values.map(|v| sign * v),
                    slopes: [sign * slopes[0], sign * slopes[1]],
                };
                let (q, value) = half.top(|q| Some(sign * f(q)?))?;
                found.push((sign * value, self.at(q)));
            }
        }
        Some(found)
    }
}

/// An interval at whose start a function rises and at whose end it falls.
struct Half {
    ends: [f64; 2],
    values: [f64; 2],
    slopes: [f64; 2],
}

impl Half {
    /// Where the function is highest, and its value: parabolas through three points, from the top of the cubic with the same values
    /// and slopes.
    fn top(&self, f: impl Fn(f64) -> Option<f64>) -> Option<(f64, f64)> {
        // Beside a top at least this near, a parabola leaves its fourth power.
        const NEAR: f64 = 1e-4;
        const MOST: usize = 40;
        let point = |q: f64| Some((q, f(q)?));
        let [a, b] = self.ends;
        let mut three = [(a, self.values[0]), point(self.guess())?, (b, self.values[1])];
        for _ in 0..MOST {
            let [left, best, right] = three;
            if right.0 - left.0 < 4.0 * NEAR {
                break;
            }
            // A top that is found already is hemmed in from its farther side.
            let farther = if right.0 - best.0 > best.0 - left.0 { NEAR } else { -NEAR };
            let q = match vertex(three) {
                Some(q) if (q - best.0).abs() > NEAR => q,
                Some(_) => best.0 + farther,
                None => best.0 + 0.5 * if farther > 0.0 { right.0 - best.0 } else { left.0 - best.0 },
            };
            let new = point(q)?;
            let four = if q < best.0 { [left, new, best, right] } else { [left, best, new, right] };
            let first = usize::from(four[2].1 > four[1].1);
            three = [four[first], four[first + 1], four[first + 2]];
        }
        let best = three[1];
        let last = vertex(three).and_then(point).filter(|last| last.1 > best.1);
        Some(last.unwrap_or(best))
    }

    /// Where the cubic is highest.
    fn guess(&self) -> f64 {
        let [a, b] = self.ends;
        let [s, t] = self.slopes.map(|slope| slope * (b - a));
        let rise = self.values[1] - self.values[0];
        // Its slope is s + 2 m q + n q², with s > 0 and s + 2 m + n = t < 0: of both roots the one inside, without cancellation.
        let (m, n) = (3.0 * rise - 2.0 * s - t, 3.0 * (s + t - 2.0 * rise));
        let root = (m * m - s * n).sqrt();
        let q = if m < 0.0 { s / (root - m) } else { -(m + root) / n };
        a + (b - a) * if q > 0.0 && q < 1.0 { q } else { 0.5 }
    }
}

/// Where the parabola through three points is highest, if that is between them.
fn vertex([(x0, f0), (x1, f1), (x2, f2)]: [(f64, f64); 3]) -> Option<f64> {
    let (left, right) = ((f1 - f0) / (x1 - x0), (f2 - f1) / (x2 - x1));
    let bend = (right - left) / (x2 - x0);
    let x = 0.5 * (x0 + x1) - 0.5 * left / bend;
    (bend < 0.0 && x > x0 && x < x2).then_some(x)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The largest and the smallest value inside, with their positions.
    fn extremes(f: impl Fn(f64) -> f64, ends: [f64; 2]) -> [(f64, f64); 2] {
        let peaks = Part { ends, values: ends.map(&f) }.peaks(|x| Some(f(x))).unwrap();
        let by = |sign: f64| *peaks.iter().max_by(|a, b| (sign * a.0).total_cmp(&(sign * b.0))).unwrap();
        [by(1.0), by(-1.0)]
    }

    #[test]
    fn peaks_of_polynomials_are_found_wherever_they_are() {
        for top in [2.000_1, 2.05, 2.3, 2.5, 2.75, 2.99] {
            let [(value, x), _] = extremes(|x| 3.0 - 2.0 * (x - top) * (x - top), [2.0, 3.0]);
            assert!((value - 3.0).abs() < 1e-14 && (x - top).abs() < 1e-7, "{value} at {x}");
        }
        // The moment of a triangular load, x − x³: in its middle as high as the parabola through three points.
        let [(value, x), _] = extremes(|x| x - x * x * x, [0.0, 1.0]);
        assert!(
            (value - 2.0 / 27.0_f64.sqrt()).abs() < 1e-15 && (x - 1.0 / 3.0_f64.sqrt()).abs() < 1e-7,
            "{x}"
        );
        // One up and one down in the same part: x (x − 1/2) (x − 1) with its extremes at 1/2 ∓ 1/√12.
        let both = extremes(|x| x * (x - 0.5) * (x - 1.0), [0.0, 1.0]);
        for ((value, x), sign) in both.into_iter().zip([1.0, -1.0]) {
            assert!((value - sign * 3.0_f64.sqrt() / 36.0).abs() < 1e-15, "{value}");
            assert!((x - 0.5 + sign / 12.0_f64.sqrt()).abs() < 1e-7, "{x}");
        }
    }

    #[test]
    fn peaks_of_waves_are_found() {
        for start in [0.41, 0.9, 1.131, 1.5] {
            let [(value, x), _] = extremes(f64::sin, [start, start + 1.2]);
            assert!(
                (value - 1.0).abs() < 1e-14 && (x - 0.5 * std::f64::consts::PI).abs() < 1e-6,
                "{value} at {x}"
            );
            let [_, (value, _)] = extremes(|x| -x.sin(), [start, start + 1.2]);
            assert!((value + 1.0).abs() < 1e-14, "{value}");
        }
    }

    #[test]
    fn a_range_is_left_only_where_values_do() {
        let leaves = |f: &dyn Fn(f64) -> f64, range: [f64; 2]| {
            Part { ends: [0.0, 1.0], values: [f(0.0), f(1.0)] }.may_leave(range, |x| Some(f(x))).unwrap()
        };
        // As high as 1/4 in the middle, between ends of equal height; and up and down by √3/36 = 0.048 with the middle on the chord.
        let (hill, wave) = (|x: f64| x * (1.0 - x), |x: f64| x * (x - 0.5) * (x - 1.0));
        assert!(leaves(&hill, [0.0, 0.0]) && leaves(&hill, [-1.0, 0.24]) && !leaves(&hill, [-1.0, 1.0]));
        assert!(leaves(&wave, [0.0, 0.0]) && leaves(&wave, [-1.0, 0.048]) && leaves(&wave, [-0.048, 1.0]));
        assert!(!leaves(&wave, [-0.2, 0.2]) && !leaves(&|x| x, [0.0, 1.0]));
        assert_eq!(Part { ends: [0.0, 1.0], values: [0.0; 2] }.may_leave([0.0; 2], |_| None), None);
    }

    #[test]
    fn what_does_not_rise_inside_has_no_peak() {
        let count = |f: &dyn Fn(f64) -> f64| {
            Part { ends: [0.0, 1.0], values: [f(0.0), f(1.0)] }.peaks(|x| Some(f(x))).unwrap().len()
        };
        assert_eq!([count(&|x| x * x), count(&|_| 2.0), count(&|_| f64::NAN)], [1, 1, 1]);
        assert_eq!(count(&|x| 1.0 + 1e-17 * x * (1.0 - x)), 1);
        assert_eq!(Part { ends: [0.0, 1.0], values: [1.0, 1.0] }.peaks(|_| None), None);
    }
}
