//! Expectations of a study.

use super::file::{Expect, Study};
use super::findings::{Outcome, Quantity, Series};
use super::order;
use super::settings::includes;

/// Outcomes of all expectations, one for each series that is meant.
pub(super) fn outcomes(study: &Study, series: &[Series]) -> Vec<Outcome> {
    let unknown = study.exact.iter().filter(|exact| {
        let meant = series.iter().filter(|s| includes(&s.settings, &exact.r#where));
        !meant.flat_map(|s| &s.quantities).any(|q| q.name == exact.quantity && !q.values.is_empty())
    });
    let unknown = unknown.map(|exact| Outcome {
        expected: format!("{}: the exact value of a probe or of energy", exact.quantity),
        found: "no such quantity".into(),
        passed: false,
    });
    let pairs = study.expect.iter().flat_map(|expect| series.iter().map(move |s| (expect, s)));
    let meant = pairs.filter(|(expect, s)| includes(&s.settings, &expect.r#where));
    unknown.chain(meant.flat_map(|(expect, s)| outcomes_of(expect, s))).collect()
}

fn outcomes_of(expect: &Expect, series: &Series) -> Vec<Outcome> {
    let title = series.title();
    let place =
        if title.is_empty() { expect.quantity.clone() } else { format!("{}, {title}", expect.quantity) };
    let Some(quantity) = series.quantities.iter().find(|q| q.name == expect.quantity) else {
        let known: Vec<&str> = series.quantities.iter().map(|q| q.name.as_str()).collect();
        let found = match known.is_empty() {
            true => "no results".into(),
            false => format!("no such quantity; there are {}", known.join(", ")),
        };
        return vec![Outcome { expected: place, found, passed: false }];
    };
    let asked = [
        expect.order.map(|order| of_order(order, expect.within, quantity)),
        expect.error_at_most.map(|most| {
            let known = quantity.errors.last().copied().filter(|_| quantity.is_known());
            bounded("error of the finest", known, most)
        }),
        expect.extrapolated_over_finest.map(|most| {
            let finest = quantity.errors.last().filter(|_| quantity.is_known());
            let ratio = quantity.extrapolated_error.zip(finest);
            // Nothing is closer than rounding.
            let ratio = ratio.map(|(e, f)| if *f <= order::ROUNDING { 0.0 } else { e / f });
            bounded("error of the extrapolated value over that of the finest", ratio, most)
        }),
    ];
    let named = |outcome: Outcome| Outcome { expected: format!("{place}: {}", outcome.expected), ..outcome };
    asked.into_iter().flatten().map(named).collect()
}

fn of_order(order: f64, within: f64, quantity: &Quantity) -> Outcome {
    let found = quantity.last_order();
    Outcome {
        expected: format!("order {order} within {within}"),
        found: found.map_or("no order".into(), |found| format!("{found:.3}")),
        passed: found.is_some_and(|found| (found - order).abs() <= within),
    }
}

fn bounded(what: &str, found: Option<f64>, most: f64) -> Outcome {
    Outcome {
        expected: format!("{what} at most {most:e}"),
        found: found.map_or("no exact value is known".into(), |found| format!("{found:.2e}")),
        passed: found.is_some_and(|found| found <= most),
    }
}
