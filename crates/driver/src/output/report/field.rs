//! Fields of maps and of solids: what cells hold, of which readers choose one.

use super::pack::{Order, pack};
use super::{element, number};
use rayon::prelude::*;
use serde_json::{Value, json};
use std::fmt::Write;

/// Values of cells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// Name.
    pub name: String,
    /// Unit; empty for none.
    pub unit: String,
    /// A value per cell; finite.
    pub values: Vec<f64>,
    /// Smallest and largest value, at the ends of the colour bar; those of cells that are means may be less far apart.
    pub range: [f64; 2],
}

/// How cells move along their axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Moves<const AXES: usize> {
    /// Numbers of the fields that are displacements along the axes.
    pub fields: [usize; AXES],
    /// Factor on them at first; readers may choose from none to twice as much.
    pub factor: f64,
}

/// All fields, as finely as their bytes allow.
pub(super) fn packed(fields: &[Field], order: &Order, most_bytes: usize) -> Value {
    let packed = |bits: u32| -> (usize, Value) {
        let all: Vec<Value> = fields.par_iter().map(|f| pack(&f.values, order, bits)).collect();
        let bytes = all.iter().map(|p| p["data"].as_str().map_or(0, str::len)).sum();
        let named = fields
            .iter()
            .zip(all)
            .map(|(f, packed)| json!({ "name": f.name, "unit": f.unit, "range": f.range, "packed": packed }));
        (bytes, named.collect())
    };
    let fits = [16, 13, 10].into_iter().map(packed).find(|(bytes, _)| *bytes <= most_bytes);
    fits.unwrap_or_else(|| packed(8)).1
}

/// Cells and their fields in words.
pub(super) fn described(title: &str, fields: &[Field]) -> String {
    let range =
        |f: &Field| format!("{} from {} to {} {}", f.name, number(f.range[0]), number(f.range[1]), f.unit);
    let ranges: Vec<String> = fields.iter().map(|f| range(f).trim_end().to_string()).collect();
    element::titled(title, &ranges.join(", "))
}

/// The list from which readers choose a field.
pub(super) fn choice(out: &mut String, fields: &[Field]) {
    out.push_str("<label>Field <select class=\"field\">");
    fields.iter().enumerate().for_each(|(k, f)| {
        let _ = write!(out, "<option value=\"{k}\">{}</option>", element::escaped(&f.name));
    });
    out.push_str("</select></label>");
}
