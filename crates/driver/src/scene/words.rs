//! Words of messages on fields and places.

use crate::case::FieldName;
use crate::diagnostic::tidy;
use peristat_assembly::body::PointBody;

/// The fields that there are where another one was asked for, for a hint.
pub(super) fn there_are(fields: &[FieldName]) -> String {
    let names: Vec<&str> = fields.iter().map(|f| f.name()).collect();
    format!("there are {}", names.join(", "))
}

/// A position on a body, `(1, 2)` in the plane and `(1, 2, 3)` in space.
pub(crate) fn place(at: [f64; 3], body: &PointBody) -> String {
    placed(at, body, tidy)
}

/// The same with numbers as `number` writes them.
pub(crate) fn placed(at: [f64; 3], body: &PointBody, number: impl Fn(f64) -> String) -> String {
    let numbers: Vec<String> = at[..body.axes()].iter().map(|x| number(*x)).collect();
    format!("({})", numbers.join(", "))
}

/// What else to say of a place at a distance from a body: if that is very much longer than the body, units are mixed up.
pub(crate) fn far(distance: f64, body: &PointBody) -> &'static str {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    body.visit(|at| (0..3).for_each(|k| (low[k], high[k]) = (low[k].min(at[k]), high[k].max(at[k]))));
    let size = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
    match distance > 20.0 * size {
        true => ", and the body is much smaller than its distance from there: give all lengths in one unit",
        false => "",
    }
}
