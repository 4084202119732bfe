//! Estimated errors of the discretisation in words.

use super::Listing;
use crate::summary::{Estimate, Estimates};

/// What the estimates are against and rest on, in a sentence, and their table.
pub(crate) fn estimates(estimates: &Estimates) -> (String, Listing) {
    let row = |e: &Estimate| {
        let relative = e.relative.map_or(String::new(), |relative| format!("{relative:.1e}"));
        vec![e.name.clone(), format!("{:?}", e.value), format!("{:.1e}", e.error), relative, e.basis.clone()]
    };
    let spacing = |s: &f64| if *s < 1.0 { format!("1/{}", s.recip().round()) } else { s.to_string() };
    let spacings: Vec<String> = estimates.spacings.iter().map(spacing).collect();
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
