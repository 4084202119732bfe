//! Estimated errors of the discretisation in words.

use super::{Listing, MOST_ROWS, digits, number};
use crate::summary::{Estimate, Estimates, Grids, Summary};

/// A multiple of the spacing: `3`, `1/3`.
pub(crate) fn times(multiple: f64) -> String {
    if multiple < 1.0 { format!("1/{}", number(multiple.recip())) } else { number(multiple) }
}

/// What the estimates of a run are against and rest on, in a sentence, and their table; or why there are none.
pub fn estimates(summary: &Summary) -> Option<(String, Option<Listing>)> {
    let Some(estimates) = &summary.estimate else {
        return summary
            .no_estimate
            .as_ref()
            .map(|reason| (format!("error of the grid: not estimated; {reason}"), None));
    };
    let remark = estimates.remark.as_ref().map_or(String::new(), |remark| format!("; {remark}"));
    let sentence = format!("error of the grid, against {}, {}{remark}", estimates.against, source(estimates));
    let header = ["quantity", "value", "estimated error", "relative", "basis"];
    let all = &estimates.quantities;
    let rows = all.iter().take(MOST_ROWS).map(row).collect();
    Some((sentence, Listing::new(&header, rows, all.len(), "quantities")))
}

/// Where the estimates are from.
fn source(estimates: &Estimates) -> String {
    let spacings: Vec<String> = estimates.spacings.iter().map(|s| times(*s)).collect();
    match estimates.kind {
        Grids::ExactBeam => "from the same beam with the law, ends and grid that are exact".into(),
        Grids::Coarser | Grids::FinerAndCoarser => {
            format!("estimated from {} times the spacing", spacings.join(" and "))
        }
    }
}

fn row(e: &Estimate) -> Vec<String> {
    // Digits of rounding say nothing.
    let error = if e.settled { "rounding".into() } else { format!("{:.1e}", e.error) };
    let relative = e.relative.filter(|_| !e.settled).map_or(String::new(), |r| format!("{r:.1e}"));
    vec![e.name.clone(), digits(e.value), error, relative, e.basis.clone()]
}
