//! Orders of convergence and extrapolation: numbers over the sizes of discretisations, nothing else.

use serde::Serialize;

/// Relative errors below this are rounding: they have no order.
pub const ROUNDING: f64 = 1e-12;
/// Orders that are looked for.
const ORDERS: [f64; 2] = [0.05, 12.0];
/// The largest order that is believed to be that of a method: values that happen to cross their limit seem to have higher ones.
const MOST: f64 = 5.0;
/// The smallest one: √h is what a strong singularity leaves. Below it the rest that is extrapolated is several times the difference that
/// was seen: three values 1 + 0.3 h^0.19 at h = 1, 1/2, 1/4 are seven differences away from their limit.
const LEAST: f64 = 0.45;
/// How far two successive orders may differ in the asymptotic range.
const STABLE: f64 = 0.3;
/// Halvings of the interval of orders: enough for double precision.
const HALVINGS: usize = 60;

/// Orders between successive sizes, coarse to fine; none where an error is rounding or vanishes.
pub fn between(sizes: &[f64], errors: &[f64]) -> Vec<Option<f64>> {
    let pairs = sizes.windows(2).zip(errors.windows(2));
    pairs
        .map(|(h, e)| {
            let order = (e[0] / e[1]).ln() / (h[0] / h[1]).ln();
            (e[0] > ROUNDING && e[1] > ROUNDING && order.is_finite()).then_some(order)
        })
        .collect()
}

/// A straight line through logarithms.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Fit {
    /// Its slope, the order.
    pub order: f64,
    /// Standard error of the slope; none of two points.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub spread: Option<f64>,
}

/// Least squares through the logarithms of the errors that are no rounding; none of fewer than two.
pub fn fit(sizes: &[f64], errors: &[f64]) -> Option<Fit> {
    let points = sizes.iter().zip(errors).filter(|(_, e)| **e > ROUNDING && e.is_finite());
    let points: Vec<(f64, f64)> = points.map(|(h, e)| (h.ln(), e.ln())).collect();
    let n = points.len() as f64;
    let mean = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (x, y) = (mean(|p| p.0), mean(|p| p.1));
    let spread = points.iter().map(|p| (p.0 - x) * (p.0 - x)).sum::<f64>();
    if points.len() < 2 || spread == 0.0 {
        return None;
    }
    let order = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum::<f64>() / spread;
    let rest = |p: &(f64, f64)| p.1 - y - order * (p.0 - x);
    let squares = points.iter().map(|p| rest(p) * rest(p)).sum::<f64>();
    Some(Fit { order, spread: (points.len() > 2).then(|| (squares / (n - 2.0) / spread).sqrt()) })
}

/// What successive values tell of their limit.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Limit {
    /// The values agree to rounding.
    Exact {
        /// The finest value.
        value: f64,
    },
    /// The values go to a limit at a stable order.
    Extrapolated {
        /// Richardson's value.
        value: f64,
        /// Estimated error of it: how far it is from that of the grids before or, of three grids, from the finest value.
        error_estimate: f64,
        /// Order of the last three values.
        order: f64,
        /// Whether more than three values bear the order out.
        confirmed: bool,
    },
    /// They do not, and why.
    NotInTheAsymptoticRange(String),
}

impl Limit {
    /// The value, if there is one.
    pub fn value(&self) -> Option<f64> {
        match self {
            Self::Exact { value } | Self::Extrapolated { value, .. } => Some(*value),
            Self::NotInTheAsymptoticRange(_) => None,
        }
    }
}

/// The order at which three values, coarse to fine, go to their limit: p with `(q₀ − q₁)/(q₁ − q₂) = (h₀ᵖ − h₁ᵖ)/(h₁ᵖ − h₂ᵖ)`.
pub fn of_three(h: [f64; 3], q: [f64; 3]) -> Result<f64, String> {
    let ratio = (q[0] - q[1]) / (q[1] - q[2]);
    if !ratio.is_finite() || ratio == 0.0 {
        return Err("two of three values are the same".into());
    }
    if ratio < 0.0 {
        return Err("the last differences have different signs".into());
    }
    // Of sizes over the middle one, so that powers do not leave the range of doubles.
    let steps = |p: f64| ((h[0] / h[1]).powf(p) - 1.0) / (1.0 - (h[2] / h[1]).powf(p));
    let [mut low, mut high] = ORDERS;
    if steps(low) > ratio {
        return Err("the differences do not fall".into());
    }
    if steps(high) < ratio {
        return Err(format!("the differences fall faster than by order {high}"));
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if steps(middle) < ratio { low = middle } else { high = middle }
    }
    Ok(0.5 * (low + high))
}

/// Richardson's value of the two finest of values at a known order.
pub fn extrapolate(h: [f64; 2], q: [f64; 2], order: f64) -> f64 {
    q[1] + (q[1] - q[0]) / ((h[0] / h[1]).powf(order) - 1.0)
}

/// The limit of values, coarse to fine.
pub fn limit(sizes: &[f64], values: &[f64]) -> Limit {
    let Some(&finest) = values.last() else { return Limit::NotInTheAsymptoticRange("no values".into()) };
    if values.len() > 1 && values.iter().all(|v| (v - finest).abs() <= ROUNDING * finest.abs()) {
        return Limit::Exact { value: finest };
    }
    if values.len() < 3 {
        return Limit::NotInTheAsymptoticRange("fewer than three values".into());
    }
    let at = |k: usize| ([sizes[k], sizes[k + 1], sizes[k + 2]], [values[k], values[k + 1], values[k + 2]]);
    let extrapolated = |k: usize, order: f64| {
        let (h, q) = at(k);
        extrapolate([h[1], h[2]], [q[1], q[2]], order)
    };
    let last = values.len() - 3;
    let (h, q) = at(last);
    let order = match of_three(h, q) {
        Ok(order) => order,
        Err(reason) => return Limit::NotInTheAsymptoticRange(reason),
    };
    if order > MOST {
        return Limit::NotInTheAsymptoticRange(format!(
            "order {order:.2}, as of values that cross their limit"
        ));
    }
    if order < LEAST {
        return Limit::NotInTheAsymptoticRange(format!("order {order:.2}, as of values that hardly settle"));
    }
    let value = extrapolated(last, order);
    if last == 0 {
        // One order cannot be compared with another: the value is not said to be better than the finest.
        let error_estimate = (value - finest).abs();
        return Limit::Extrapolated { value, error_estimate, order, confirmed: false };
    }
    let (h, q) = at(last - 1);
    match of_three(h, q) {
        Ok(before) if (before - order).abs() <= STABLE => {
            let error_estimate = (value - extrapolated(last - 1, before)).abs();
            Limit::Extrapolated { value, error_estimate, order, confirmed: true }
        }
        Ok(before) => Limit::NotInTheAsymptoticRange(format!("orders {before:.2}, then {order:.2}")),
        Err(reason) => Limit::NotInTheAsymptoticRange(format!("before the last three values {reason}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values 1 + 0.3 hᵖ at some sizes.
    fn values(sizes: &[f64], order: f64) -> Vec<f64> {
        sizes.iter().map(|h| 1.0 + 0.3 * h.powf(order)).collect()
    }

    #[test]
    fn pure_powers_have_their_order_and_limit() {
        // Ratios of sizes 2, 1.5 and 3.
        let sizes = [0.9, 0.45, 0.3, 0.1];
        for order in [0.5, 1.0, 2.0, 3.3] {
            let found = values(&sizes, order);
            let errors: Vec<f64> = found.iter().map(|v| v - 1.0).collect();
            for o in between(&sizes, &errors) {
                assert!((o.unwrap() - order).abs() < 1e-10, "{order}: {o:?}");
            }
            let fit = fit(&sizes, &errors).unwrap();
            assert!((fit.order - order).abs() < 1e-10 && fit.spread.unwrap() < 1e-10);
            match limit(&sizes, &found) {
                Limit::Extrapolated { value, order: found, confirmed: true, error_estimate } => {
                    assert!((value - 1.0).abs() < 1e-12 && (found - order).abs() < 1e-9, "{value} {found}");
                    assert!(error_estimate < 1e-12);
                }
                other => panic!("{other:?}"),
            }
        }
    }

    #[test]
    fn three_values_promise_no_more_than_the_finest() {
        match limit(&[1.0, 0.5, 0.25], &[1.4, 1.1, 1.025]) {
            Limit::Extrapolated { value, error_estimate, confirmed: false, .. } => {
                assert!((value - 1.0).abs() < 1e-12 && (error_estimate - 0.025).abs() < 1e-12);
            }
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn what_has_no_stable_order_is_said_to() {
        let halved = [1.0, 0.5, 0.25, 0.125];
        let reason = |values: &[f64]| match limit(&halved[..values.len()], values) {
            Limit::NotInTheAsymptoticRange(reason) => reason,
            other => panic!("{other:?}"),
        };
        assert!(reason(&[1.0, 1.1]).contains("fewer"));
        assert!(reason(&[1.0, 1.2, 1.1]).contains("signs"));
        assert!(reason(&[1.0, 1.1, 1.3]).contains("do not fall"));
        assert!(reason(&[2.0, 1.0, 0.9, 0.85]).contains("orders 3.32, then 1.00"));
        assert!(reason(&[1.0, 1.1, 1.1]).contains("the same"));
        assert!(reason(&[1.0, 1.1, 1.101]).contains("order 6.64"));
        assert!(reason(&values(&halved, 0.19)[..3]).contains("order 0.19"));
        assert!(reason(&values(&halved, 0.19)).contains("order 0.19"));
        assert_eq!(limit(&halved, &[1.0; 4]), Limit::Exact { value: 1.0 });
        assert_eq!(limit(&halved[..3], &[0.0; 3]), Limit::Exact { value: 0.0 });
    }

    #[test]
    fn errors_at_rounding_have_no_order() {
        let sizes = [1.0, 0.5, 0.25];
        assert_eq!(between(&sizes, &[1e-15, 3e-15, 0.0]), [None, None]);
        let orders = between(&sizes, &[1e-15, 1e-11, 2.5e-12]);
        assert!(orders[0].is_none() && (orders[1].unwrap() - 2.0).abs() < 1e-12, "{orders:?}");
        assert_eq!(fit(&sizes, &[1e-15, 3e-15, 0.0]), None);
        let fit = fit(&sizes, &[4e-2, 1e-2, 1e-16]).unwrap();
        assert!((fit.order - 2.0).abs() < 1e-12 && fit.spread.is_none(), "{fit:?}");
    }
}
