//! Fields of maps and of solids: what cells hold, of which readers choose one.

use super::pack::{Order, Packed, pack};
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

/// All fields, as finely as their bytes allow; with no bytes at once as coarsely as they ever are.
pub(super) fn packed(fields: &[Field], order: &Order, most_bytes: usize) -> Vec<Packed> {
    let packed = |bits: u32| -> Vec<Packed> {
        fields.par_iter().map(|field| pack(&field.values, order, bits)).collect()
    };
    let fits = |all: &Vec<Packed>| bytes(all) <= most_bytes;
    [16, 13, 10].into_iter().filter(|_| most_bytes > 0).map(packed).find(fits).unwrap_or_else(|| packed(8))
}

/// Bytes that packed fields take.
pub(super) fn bytes(all: &[Packed]) -> usize {
    all.iter().map(|packed| packed.data.len()).sum()
}

/// Fields with what they were packed into.
pub(super) fn json(fields: &[Field], packed: &[Packed]) -> Value {
    let both = fields.iter().zip(packed);
    both.map(|(f, packed)| json!({ "name": f.name, "unit": f.unit, "range": f.range, "packed": packed }))
        .collect()
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
