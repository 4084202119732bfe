//! Estimated errors of the discretisation in words.

use super::Listing;
use crate::summary::{Estimate, Estimates};

/// A multiple of the spacing: `3`, `1/3`.
pub(crate) fn times(multiple: f64) -> String {
    if multiple < 1.0 { format!("1/{}", multiple.recip().round()) } else { multiple.round().to_string() }
}

/// What the estimates are against and rest on, in a sentence, and their table.
pub(crate) fn estimates(estimates: &Estimates) -> (String, Listing) {
    let row = |e: &Estimate| {
        let relative = e.relative.map_or(String::new(), |relative| format!("{relative:.1e}"));
        vec![e.name.clone(), format!("{:?}", e.value), format!("{:.1e}", e.error), relative, e.basis.clone()]
    };
    let spacings: Vec<String> = estimates.spacings.iter().map(|s| times(*s)).collect();
    let remark = estimates.remark.as_ref().map_or(String::new(), |remark| format!("; {remark}"));
    let sentence = format!(
        "error of the discretisation, against {}; from {} times the spacing, in {:.3} s{remark}",
        estimates.against,
        spacings.join(" and "),
        estimates.seconds
    );
    let header = ["quantity", "value", "estimated error", "relative", "basis"];
    (sentence, Listing::whole(&header, estimates.quantities.iter().map(row).collect()))
}
