//! The load of a body that breaks or softens over a displacement, where a probe has one: at the states that are written.

use crate::case::{Case, FieldName, Probe};
use crate::output::report::{Axis, Chart, Look, Series};

/// A curve of fewer states says nothing.
const FEWEST: usize = 3;

/// The chart; `history` has a row per state, which ends with the values of all probes. `marked` if rings follow the states.
pub(super) fn chart(case: &Case, history: &[Vec<f64>], marked: bool) -> Option<Chart> {
    let load = match (&case.fracture, &case.path) {
        (Some(fracture), _) => &fracture.load,
        // The other curves of such a path are over its opening already.
        (None, Some(path)) if path.opening.is_none() => &path.load,
        _ => return None,
    };
    let probe = |is: &dyn Fn(&Probe) -> bool| case.probes.iter().position(is);
    let (x, y) = (probe(&|p| is_displacement(p.field))?, probe(&|p| p.name == *load)?);
    let values = |row: &Vec<f64>| {
        row.len().checked_sub(case.probes.len()).map(|first| (row[first + x], row[first + y]))
    };
    let points: Vec<(f64, f64)> = history.iter().map_while(values).collect();
    if points.len() < FEWEST || x == y {
        return None;
    }
    let axis = |k: usize| {
        let probe: &Probe = &case.probes[k];
        Axis::linear(case.units.label(&probe.name, probe.field.about().unit.label(case.units)))
    };
    Some(Chart {
        x: axis(x),
        y: axis(y),
        marks: if marked { points.clone() } else { Vec::new() },
        series: vec![Series { label: "states that are written".into(), look: Look::Marked, points }],
        ..Chart::default()
    })
}

fn is_displacement(field: FieldName) -> bool {
    matches!(field, FieldName::Ux | FieldName::Uy | FieldName::W | FieldName::Opening)
}
