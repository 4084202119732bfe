//! What a study found in words: tables for the screen and for the report.

use super::findings::{Quantity, Series};
use super::order::{Limit, ROUNDING};
use crate::summary::words::{Listing, number};

/// Orders and limits of the quantities of a series.
pub fn conclusions(series: &Series) -> Listing {
    let row = |quantity: &Quantity| {
        let exact = quantity.exact.map_or(String::new(), |exact| format!("{exact:?}"));
        let orders = quantity.orders.iter().flatten().map(|order| format!("{order:.2}"));
        let fit = quantity.fit.map_or(String::new(), |fit| match fit.spread {
            Some(spread) => format!("{:.2} ± {spread:.2}", fit.order),
            None => format!("{:.2}", fit.order),
        });
        let [limit, estimate] = limit(quantity);
        let orders = orders.collect::<Vec<_>>().join(" ");
        vec![quantity.name.clone(), exact, error(quantity), orders, fit, limit, estimate]
    };
    let header = [
        "quantity",
        "exact",
        "error of the finest",
        "orders",
        "by fit",
        "extrapolated",
        "estimated error of it",
    ];
    Listing::whole(&header, series.quantities.iter().map(row).collect())
}

/// Error of the finest level; what is against an extrapolated value is only about so much.
fn error(quantity: &Quantity) -> String {
    match quantity.errors.last() {
        None => String::new(),
        Some(error) if *error <= ROUNDING => format!("{error:.1e}, rounding"),
        Some(error) if quantity.is_known() => format!("{error:.2e}"),
        Some(error) => format!("≈ {error:.1e}"),
    }
}

/// Value and estimated error of a limit, or why there is none.
fn limit(quantity: &Quantity) -> [String; 2] {
    match &quantity.limit {
        None => Default::default(),
        Some(Limit::Exact { value }) => [format!("{value:?}"), "rounding".into()],
        Some(Limit::Extrapolated { value, error_estimate, confirmed, .. }) => {
            let doubt = if *confirmed { "" } else { ", one order only" };
            [with_digits_of(*value, *error_estimate), format!("{error_estimate:.1e}{doubt}")]
        }
        Some(Limit::NotInTheAsymptoticRange(reason)) => {
            ["not in the asymptotic range".into(), reason.clone()]
        }
    }
}

/// A number with the digits that its error leaves, and two more.
fn with_digits_of(value: f64, error: f64) -> String {
    let digits =
        if error > 0.0 && value != 0.0 { (value.abs() / error).log10().ceil() as usize + 2 } else { 16 };
    format!("{value:.*e}", digits.clamp(3, 16) - 1)
}

/// Values, errors and orders of some quantities of a series, level by level.
pub fn levels(series: &Series, quantities: &[Quantity]) -> Listing {
    let mut header = vec!["task", "horizon", "spacing", "ratio", "points", "time, s"];
    for quantity in quantities {
        header.push(&quantity.name);
        if !quantity.values.is_empty() && !quantity.errors.is_empty() {
            header.push("error");
        }
        if !quantity.orders.is_empty() {
            header.push("order");
        }
    }
    let row = |(k, level): (usize, &super::Level)| {
        let r = &level.record;
        let mut row = vec![
            level.task.to_string(),
            number(r.horizon),
            number(r.spacing),
            number(r.horizon / r.spacing),
            r.points.to_string(),
            format!("{:.3}", r.seconds),
        ];
        for quantity in quantities {
            row.extend(quantity.values.get(k).map(|value| number(*value)));
            row.extend(quantity.errors.get(k).map(|error| format!("{error:.2e}")));
            if !quantity.orders.is_empty() {
                let order = k.checked_sub(1).and_then(|k| quantity.orders[k]);
                row.push(order.map_or(String::new(), |order| format!("{order:.2}")));
            }
        }
        row
    };
    Listing::whole(&header, series.levels.iter().enumerate().map(row).collect())
}
