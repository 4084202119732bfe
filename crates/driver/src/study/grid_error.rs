//! What the values of a few grids tell of the error of one of them: numbers, nothing else.
//!
//! The error is that of Richardson's extrapolation, on the safe side wherever two or three grids are not enough: no order
//! above two is believed, first order is taken where none is observed, and where values go to and fro, so that two of them
//! may agree by chance, the coarsest grid has its say.

use super::order;

/// Smallest order that is believed; it is taken where none is observed, too.
const LEAST: f64 = 1.0;
/// Largest order that is taken, that of nearly all methods: values on their way across their limit seem to have a higher one.
const MOST: f64 = 2.0;
/// Orders this much above the largest are still that one: grids are finite.
const SECOND: f64 = 0.1;
/// Observed orders above this are chance: the bond law of the highest order has three.
const CHANCE: f64 = 4.0;

/// The error of a value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct GridError {
    /// Estimated magnitude.
    pub(super) error: f64,
    /// Observed order.
    pub(super) order: Option<f64>,
    /// Whether the grids agree but for rounding.
    pub(super) settled: bool,
    /// Whether the values go anywhere.
    pub(super) reliable: bool,
    /// Whether they go there by no order that a method has, so that two of them may be near by chance.
    pub(super) by_chance: bool,
    /// What the estimate rests on.
    pub(super) basis: String,
}

/// The error of the value of a grid of spacing one, from those of two or three grids, itself among them, as pairs of
/// spacing and value; those that differ by `rounding` at most agree. In a body with corners that turn into it no order above the first
/// is believed: what they spoil, they spoil everywhere.
pub(super) fn of(mut grids: Vec<(f64, f64)>, rounding: f64, turns_inward: bool) -> GridError {
    grids.sort_by(|a, b| b.0.total_cmp(&a.0));
    let own = grids.iter().find(|g| g.0 == 1.0).map_or(f64::NAN, |g| g.1);
    let (h, q): (Vec<f64>, Vec<f64>) = grids.into_iter().unzip();
    let last = h.len() - 1;
    let at =
        |order: f64| (own - order::extrapolate([h[last - 1], h[last]], [q[last - 1], q[last]], order)).abs();
    if q.iter().all(|value| (value - own).abs() <= rounding) {
        let basis = "the grids agree".into();
        let (settled, reliable, by_chance) = (true, true, false);
        return GridError { error: at(LEAST), order: None, settled, reliable, by_chance, basis };
    }
    let told = |error: f64, order: Option<f64>, basis: String| GridError {
        error,
        order,
        settled: false,
        reliable: true,
        by_chance: false,
        basis,
    };
    let by_chance = |found: GridError| GridError { by_chance: true, ..found };
    let (Ok(three), Ok(values)) = (<[f64; 3]>::try_from(&h[..]), <[f64; 3]>::try_from(&q[..])) else {
        return told(at(LEAST), None, format!("order {LEAST} assumed"));
    };
    // What the coarsest grid says if it is the one of the two pairs that is right.
    let guarded = || at(LEAST).max((q[0] - own).abs() / (h[0].powf(MOST) - 1.0));
    match order::of_three(three, values) {
        Ok(order) if order < LEAST => {
            told(at(LEAST), Some(order), format!("order {order:.2} observed, {LEAST} taken"))
        }
        Ok(order) if order <= MOST + SECOND && turns_inward => {
            told(at(LEAST), Some(order), format!("order {order:.2} observed, {LEAST} taken for the corner"))
        }
        Ok(order) if order <= MOST + SECOND => {
            told(at(order.min(MOST)), Some(order), format!("order {order:.2} observed"))
        }
        Ok(order) if order <= CHANCE => {
            by_chance(told(at(MOST), Some(order), format!("order {order:.2} observed, {MOST} taken")))
        }
        Ok(order) => {
            by_chance(told(guarded(), Some(order), format!("order {order:.1} is chance, {LEAST} taken")))
        }
        Err(reason) => GridError {
            reliable: (q[0] - q[1]).abs() > (q[1] - q[2]).abs(),
            ..by_chance(told(guarded(), None, format!("no order: {reason}")))
        },
    }
}

#[cfg(test)]
mod tests {
    use super::super::order::ROUNDING;
    use super::*;

    fn found(others: &[(f64, f64)], own: f64) -> GridError {
        of([others, &[(1.0, own)]].concat(), ROUNDING * own.abs(), false)
    }

    #[test]
    fn powers_are_found_from_coarser_and_from_finer_grids() {
        // 1 + 0.1 h².
        for others in [[(2.0, 1.4), (4.0, 2.6)], [(2.0, 1.4), (0.5, 1.025)]] {
            let found = found(&others, 1.1);
            assert!((found.error - 0.1).abs() < 1e-12 && (found.order.unwrap() - 2.0).abs() < 1e-12);
            assert!(found.reliable && !found.settled, "{found:?}");
        }
    }

    /// 1 + 0.1 h² seems to be 0.1 off; of first order it would be 0.3.
    #[test]
    fn beside_corners_the_second_order_is_chance() {
        let found = of(vec![(1.0, 1.1), (2.0, 1.4), (4.0, 2.6)], ROUNDING, true);
        assert!((found.error - 0.3).abs() < 1e-12 && (found.order.unwrap() - 2.0).abs() < 1e-12, "{found:?}");
    }

    #[test]
    fn without_an_order_the_first_is_assumed() {
        // The estimate of 1 + 0.1 h² from two grids is three times, or one and a half times, too large.
        let coarser = found(&[(2.0, 1.4)], 1.1);
        assert!((coarser.error - 0.3).abs() < 1e-12 && coarser.order.is_none(), "{coarser:?}");
        let finer = found(&[(0.5, 1.025)], 1.1);
        assert!((finer.error - 0.15).abs() < 1e-12 && finer.basis == "order 1 assumed", "{finer:?}");
    }

    #[test]
    fn values_that_meet_by_chance_are_not_believed() {
        // The two finest are the same, all but: 1.4 − 1.1001 at order two are an error of 0.02.
        let crossing = found(&[(2.0, 1.1001), (4.0, 1.4)], 1.1);
        assert!((crossing.error - 0.02).abs() < 1e-4 && crossing.reliable, "{crossing:?}");
        assert!(crossing.by_chance && !found(&[(2.0, 1.4), (4.0, 2.6)], 1.1).by_chance);
        let to_and_fro = found(&[(2.0, 1.0999), (4.0, 1.4)], 1.1);
        assert!((to_and_fro.error - 0.02).abs() < 1e-4 && to_and_fro.order.is_none(), "{to_and_fro:?}");
        // Too quick for any method.
        let quick = found(&[(2.0, 1.108), (4.0, 1.3)], 1.1);
        assert!(quick.basis.contains("chance") && quick.error > 0.013, "{quick:?}");
    }

    #[test]
    fn what_goes_nowhere_is_not_reliable() {
        // As the stress at a corner: a factor for every halving.
        let singular = found(&[(2.0, 2.0), (4.0, 1.0)], 4.0);
        assert!(!singular.reliable && singular.error >= 2.0, "{singular:?}");
    }

    #[test]
    fn grids_that_agree_leave_no_error() {
        let settled = found(&[(2.0, 1.0), (4.0, 1.0 + 1e-14)], 1.0);
        assert!(settled.settled && settled.error == 0.0, "{settled:?}");
        // Rounding of a value that vanishes is measured by its field.
        assert!(of(vec![(2.0, 3e-15), (1.0, -1e-15)], ROUNDING, false).settled);
        assert!(!of(vec![(2.0, 3e-15), (1.0, -1e-15)], 1e-14 * ROUNDING, false).settled);
    }
}
