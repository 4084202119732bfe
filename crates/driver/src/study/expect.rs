//! Expectations of a study.

use super::file::{Expect, Study};
use super::findings::{Outcome, Quantity, Series, includes};

/// Outcomes of all expectations, one for each series that is meant.
pub(super) fn outcomes(study: &Study, series: &[Series]) -> Vec<Outcome> {
    let pairs = study.expect.iter().flat_map(|expect| series.iter().map(move |s| (expect, s)));
    pairs
        .filter(|(expect, s)| includes(&s.settings, &expect.r#where))
        .flat_map(|(expect, s)| outcomes_of(expect, s))
        .collect()
}

fn outcomes_of(expect: &Expect, series: &Series) -> Vec<Outcome> {
    let title = series.title();
    let place =
        if title.is_empty() { expect.quantity.clone() } else { format!("{}, {title}", expect.quantity) };
    let Some(quantity) = series.quantities.iter().find(|q| q.name == expect.quantity) else {
        let known: Vec<&str> = series.quantities.iter().map(|q| q.name.as_str()).collect();
        let found = format!("no such quantity; there are {}", known.join(", "));
        return vec![Outcome { expected: place, found, passed: false }];
    };
    let asked = [
        expect.order.map(|order| of_order(order, expect.within, quantity)),
        expect
            .error_at_most
            .map(|most| bounded("error of the finest", quantity.errors.last().copied(), most)),
        expect.extrapolated_over_finest.map(|most| {
            let finest = quantity.errors.last().filter(|error| **error > 0.0);
            let ratio = quantity.extrapolated_error.zip(finest).map(|(e, f)| e / f);
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
        found: found.map_or("none".into(), |found| format!("{found:.2e}")),
        passed: found.is_some_and(|found| found <= most),
    }
}
