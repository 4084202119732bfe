//! The record of a run in words: facts and tables, for the screen and for reports.

mod beam;
mod body;
mod estimate;
mod fracture;
mod path;
mod plate;
mod resultants;
mod state;

pub use estimate::estimates;
pub(crate) use estimate::times;
pub use state::extremes;
pub(crate) use state::{kind, place, position};

pub use crate::model::Fact;
pub use crate::units::number;

use super::{Forces, Located, ModelSummary, StateSummary, Summary};
use crate::diagnostic::tidy;
use crate::run::{CheckResult, ProbeResult};
use crate::units::Units;

/// Rows of a table of members or supports, at most.
const MOST_ROWS: usize = 40;

/// A table of names and numbers; the first column holds names, the others mostly numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Listing {
    /// Heads of the columns.
    pub header: Vec<String>,
    /// Rows.
    pub rows: Vec<Vec<String>>,
    /// Where the rest of a long table is.
    pub more: Option<String>,
}

impl Listing {
    /// A table of the first rows of `count`; `None` if there are none.
    fn new(header: &[&str], rows: Vec<Vec<String>>, count: usize, what: &str) -> Option<Self> {
        let more =
            (count > rows.len()).then(|| format!("{} {what} more are in summary.json", count - rows.len()));
        let header = header.iter().map(ToString::to_string).collect();
        (!rows.is_empty()).then_some(Self { header, rows, more })
    }

    /// A table of all rows.
    pub fn whole(header: &[&str], rows: Vec<Vec<String>>) -> Self {
        Self { header: header.iter().map(ToString::to_string).collect(), rows, more: None }
    }
}

/// The model, its sizes, and how it was solved.
pub fn model(summary: &Summary) -> Vec<Fact> {
    let mut lines = match &summary.model {
        ModelSummary::Beam(model) => beam::model(model, summary.units),
        ModelSummary::Body(model) => body::model(model, summary.units),
        ModelSummary::Plate(model) => plate::model(model, summary.units),
    };
    let sizes = &summary.sizes;
    let size = format!("{} points, {} bonds, {} unknowns", sizes.points, sizes.bonds, sizes.unknowns);
    let iterations: Vec<String> = summary.solver.iterations.iter().map(ToString::to_string).collect();
    let method = &summary.solver.method;
    let mut solver = match iterations.is_empty() {
        true => method.clone(),
        false => format!("{method} finished by {} PCG iterations on the bonds", iterations.join(", ")),
    };
    if summary.solver.refined > 0 {
        solver += ", with residuals in twice the precision";
    }
    let rest = [("size", size), ("solver", solver), ("why", summary.solver.reason.clone())];
    lines.extend(rest.map(|(key, text)| (key.into(), text)));
    lines.extend(body::limit(&summary.states).map(|text| ("limit".into(), text)));
    lines
}

/// How the body broke or softened, where it did.
pub fn course(summary: &Summary) -> Option<Vec<Fact>> {
    let broken = summary.fracture.as_ref().map(fracture::fracture);
    broken.or_else(|| summary.path.as_ref().map(path::path))
}

/// Forces of members and of what holds the body, and the resultants of all that acts on it.
pub fn forces(state: &StateSummary, units: Units) -> Vec<Listing> {
    let mut tables = match &state.forces {
        Forces::Beam(forces) => beam::forces(forces, units),
        Forces::Body(forces) => body::forces(forces, units),
        Forces::Plate(forces) => plate::forces(forces, units),
    };
    tables.extend(state.certificate.resultants.as_ref().map(|found| resultants::table(found, state, units)));
    tables
}

/// Smallest and largest values over all load cases and combinations.
pub fn envelope(summary: &Summary) -> Option<Listing> {
    let rows: Vec<Vec<String>> = summary
        .envelope
        .iter()
        .map(|(field, [low, high])| {
            let place = |e: &(String, Located)| format!("{} at {}", e.0, place(&e.1));
            let unit = summary.states.iter().find_map(|state| Some(state.extremes.get(field)?.unit.as_str()));
            let field = match unit {
                None | Some("") => field.to_string(),
                Some(unit) => format!("{field} [{unit}]"),
            };
            vec![field, number(low.1.value), place(low), number(high.1.value), place(high)]
        })
        .collect();
    let header = ["field", "smallest", "in", "largest", "in"];
    (!rows.is_empty()).then(|| Listing::whole(&header, rows))
}

/// A number with the twelve digits that are not of rounding.
pub fn digits(value: f64) -> String {
    tidy(value)
}

/// Probed values with their units, with as many digits as `value` gives them.
pub fn probes<'a>(
    probes: impl Iterator<Item = &'a ProbeResult> + Clone,
    value: &dyn Fn(f64) -> String,
) -> Listing {
    let fitted = probes.clone().any(|p| p.misfit.is_some());
    let row = |p: &ProbeResult| {
        let place = p.place.clone().or_else(|| Some(position(p.x?, p.y, p.z))).unwrap_or_default();
        let field = p.of.map_or_else(|| p.field.to_string(), |of| of.words(&p.field));
        let mut cells = vec![
            p.name.clone(),
            p.state.clone(),
            field,
            place,
            format!("{} {}", value(p.value), p.unit).trim_end().into(),
        ];
        cells.extend(fitted.then(|| p.misfit.map_or(String::new(), |misfit| format!("{misfit:.1e}"))));
        cells
    };
    let on_lines = probes.clone().all(|p| p.place.is_none() && p.y.is_none());
    let at = if on_lines { "x" } else { "at" };
    let header = ["probe", "state", "field", at, "value", "misfit"];
    Listing::whole(&header[..5 + usize::from(fitted)], probes.map(row).collect())
}

/// The checks of a case; the last column says whether they passed.
pub fn checks(checks: &[CheckResult]) -> Listing {
    let row = |c: &CheckResult| {
        vec![
            c.name.clone(),
            number(c.expected),
            number(c.found),
            if c.error.is_finite() { format!("{:.2e}", c.error) } else { "none".into() },
            format!("{:.0e}", c.tolerance),
            match &c.remark {
                _ if c.passed => "passed".into(),
                None => "FAILED".into(),
                Some(remark) => format!("FAILED: {remark}"),
            },
        ]
    };
    let header = ["check", "expected", "found", "error", "tolerance", ""];
    Listing::whole(&header, checks.iter().map(row).collect())
}
