//! Smallest and largest values of fields over all states.

use super::files::{Column, write_table};
use crate::units::Units;
use std::io;
use std::path::Path;

/// The table of them, being widened state by state.
#[derive(Debug, Default)]
pub(super) struct Envelope {
    places: Vec<Column>,
    bounds: Vec<(&'static str, Vec<[f64; 2]>)>,
}

impl Envelope {
    /// Sets the columns that say where the points are.
    pub(super) fn place(&mut self, places: Vec<Column>) {
        self.places = places;
    }

    /// Takes the values of a field at all points into account.
    pub(super) fn widen(&mut self, field: &'static str, values: &[f64]) {
        let known = self.bounds.iter().position(|b| b.0 == field).unwrap_or_else(|| {
            self.bounds.push((field, vec![[f64::INFINITY, f64::NEG_INFINITY]; values.len()]));
            self.bounds.len() - 1
        });
        for (bound, value) in self.bounds[known].1.iter_mut().zip(values) {
            *bound = [bound[0].min(*value), bound[1].max(*value)];
        }
    }

    /// Writes the table, with columns such as `w_smallest`.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn write(&self, file: &Path, units: Units) -> io::Result<()> {
        let of = |(field, bounds): &(&str, Vec<[f64; 2]>)| -> [(String, Vec<f64>); 2] {
            let side =
                |k: usize, name: &str| (format!("{field}_{name}"), bounds.iter().map(|b| b[k]).collect());
            [side(0, "smallest"), side(1, "largest")]
        };
        let bounds: Vec<(String, Vec<f64>)> = self.bounds.iter().flat_map(of).collect();
        let mut table: Vec<(&str, &[f64])> = self.places.iter().map(|(n, v)| (*n, v.as_slice())).collect();
        table.extend(bounds.iter().map(|(name, v)| (name.as_str(), v.as_slice())));
        write_table(file, units, &table)
    }
}
