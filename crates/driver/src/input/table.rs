//! Tables of values on rectangular grids: CSV with a header that has `value` and some of `x`, `y` and `z`.

use super::ReadError;
use super::lines::Lines;
use std::collections::HashSet;

/// How far outside a place may lie and count as on the border, parts of the extent of the grid.
const SLACK: f64 = 1e-9;

/// The columns of positions.
const AXES: [&str; 3] = ["x", "y", "z"];

/// Values at the places of a grid, linear between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Table {
    /// Along x, y and z the positions of the lines of the grid, increasing; none along which nothing varies.
    lines: [Option<Vec<f64>>; 3],
    /// Values, those along x the fastest, then those along y.
    values: Vec<f64>,
}

/// Reads a table for bodies with these many coordinates. Columns and rows may come in any order, other columns are passed over, and
/// so are blank lines.
///
/// # Errors
/// [`ReadError`] with the line.
pub fn read(bytes: &[u8], coordinates: usize) -> Result<Table, ReadError> {
    const COLUMNS: &str =
        "the first line names the columns: `value` and some of x, y and z, with commas between them";
    let mut lines = Lines::new(bytes);
    let header = lines.text("a header").map_err(|e| e.hint(COLUMNS))?;
    let names: Vec<&str> = header.split(',').map(str::trim).collect();
    let find = |name: &str| names.iter().position(|n| *n == name);
    let fault = |message: String| ReadError::at(lines.number(), message).hint(COLUMNS);
    let value = find("value").ok_or_else(|| fault("there is no column `value`".into()))?;
    if let Some(name) = names.iter().find(|name| names.iter().filter(|n| n == name).count() > 1) {
        return Err(fault(format!("there are several columns `{name}`")));
    }
    let axes = AXES.map(find);
    if let Some(axis) = (coordinates..3).find(|axis| axes[*axis].is_some()) {
        return Err(fault(format!("there is no `{}` in the plane", AXES[axis])));
    }
    if axes == [None; 3] {
        return Err(fault("there is no column of positions".into()));
    }
    let mut rows: Vec<([f64; 3], f64)> = Vec::new();
    while let Some(row) = lines.raw() {
        let cells: Vec<&[u8]> = row.split(|b| *b == b',').collect();
        if cells.len() != names.len() {
            let (found, asked) = (cells.len(), names.len());
            let message = format!("cells in this row: {found}, in the header: {asked}");
            return Err(ReadError::at(lines.number(), message).hint("decimals have a point"));
        }
        let number = |column: usize| {
            let text = cells.get(column).and_then(|c| std::str::from_utf8(c.trim_ascii()).ok());
            let found = text.and_then(|t| t.parse::<f64>().ok()).filter(|v| v.is_finite());
            let fault = || format!("there is no number in column `{}`", names[column]);
            found.ok_or_else(|| ReadError::at(lines.number(), fault()))
        };
        let mut place = [0.0; 3];
        for (at, column) in place.iter_mut().zip(axes) {
            // Without a sign of zero, by which equal lines would differ.
            *at = column.map_or(Ok(0.0), number)? + 0.0;
        }
        rows.push((place, number(value)?));
    }
    Table::new(rows, axes.map(|column| column.is_some()))
}

impl Table {
    fn new(mut rows: Vec<([f64; 3], f64)>, varies: [bool; 3]) -> Result<Self, ReadError> {
        const GRID: &str = "a table has one row for every place where lines of its grid cross";
        if rows.is_empty() {
            return Err(ReadError::whole("has no rows"));
        }
        let along = |axis: usize| {
            let mut all: Vec<f64> = rows.iter().map(|(place, _)| place[axis]).collect();
            all.sort_unstable_by(f64::total_cmp);
            all.dedup();
            all
        };
        let lines = [0, 1, 2].map(|axis| varies[axis].then(|| along(axis)));
        let places = lines.iter().flatten().map(|l| l.len() as u128).product::<u128>();
        let known: HashSet<[u64; 3]> = rows.iter().map(|(place, _)| place.map(f64::to_bits)).collect();
        if places != rows.len() as u128 || known.len() != rows.len() {
            let size: Vec<String> = lines.iter().flatten().map(|l| l.len().to_string()).collect();
            let message = format!("has {} rows, and its grid has {} places", rows.len(), size.join(" × "));
            return Err(ReadError::whole(message).hint(GRID));
        }
        rows.sort_unstable_by(|(a, _), (b, _)| {
            let order = |k: usize| a[k].total_cmp(&b[k]);
            order(2).then(order(1)).then(order(0))
        });
        Ok(Self { lines, values: rows.into_iter().map(|(_, value)| value).collect() })
    }

    /// The value at a place; none outside of the grid.
    pub fn at(&self, place: [f64; 3]) -> Option<f64> {
        let mut corners = vec![(0, 1.0)];
        let mut stride = 1;
        for (lines, at) in self.lines.iter().zip(place) {
            let Some(lines) = lines else { continue };
            let (below, part) = between(lines, at)?;
            let next = if part > 0.0 { stride } else { 0 };
            corners = corners
                .into_iter()
                .flat_map(|(k, share)| {
                    let k = k + stride * below;
                    [(k, share * (1.0 - part)), (k + next, share * part)]
                })
                .collect();
            stride *= lines.len();
        }
        Some(corners.into_iter().map(|(k, share)| share * self.values[k]).sum())
    }
}

/// The line below a position, and how far it is from there to the next one; none outside.
fn between(lines: &[f64], at: f64) -> Option<(usize, f64)> {
    let (first, last) = (*lines.first()?, *lines.last()?);
    let slack = SLACK * (last - first);
    if !(first - slack..=last + slack).contains(&at) {
        return None;
    }
    let at = at.clamp(first, last);
    let below = lines.partition_point(|line| *line <= at).saturating_sub(1);
    let part = lines.get(below + 1).map_or(0.0, |next| (at - lines[below]) / (next - lines[below]));
    Some((below, part))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_of_linear_functions_are_themselves_between_the_lines_of_a_grid() {
        let value = |[x, y, z]: [f64; 3]| (1.0 + 2.0 * x) * (3.0 - y) * (0.5 + z);
        let mut text = String::from("z, value,y,note,x\n");
        for x in [4.0, -1.0, 0.5] {
            for y in [0.0, 2.0] {
                for z in [1.0, 0.0, 7.0] {
                    text += &format!("{z},{},{y},a,{x}\n", value([x, y, z]));
                }
            }
        }
        let table = read(text.as_bytes(), 3).unwrap();
        for place in [[-1.0, 0.0, 0.0], [4.0, 2.0, 7.0], [0.0, 0.3, 6.0], [0.5, 1.0, 0.2]] {
            let (found, expected) = (table.at(place).unwrap(), value(place));
            assert!((found - expected).abs() < 1e-14 * expected.abs().max(1.0), "{place:?}: {found}");
        }
        assert_eq!((table.at([4.1, 0.0, 0.0]), table.at([0.0, -0.1, 0.0])), (None, None));
        // What lies outside by rounding is on the border.
        assert_eq!(table.at([4.0 + 1e-12, 2.0, 7.0]), table.at([4.0, 2.0, 7.0]));
        let line = read(b"y,value\n0,1\n10,3", 2).unwrap();
        assert_eq!((line.at([1e9, 5.0, 0.0]), line.at([0.0, 11.0, 0.0])), (Some(2.0), None));
    }

    #[test]
    fn what_is_no_table_is_refused() {
        for (text, reason) in [
            ("", "ends where a header belongs"),
            ("x,y\n0,0", "no column `value`"),
            ("value\n1", "no column of positions"),
            ("x,z,value\n0,0,1", "no `z` in the plane"),
            ("x,value", "has no rows"),
            ("x,value\n0,a", "no number in column `value`"),
            ("x,value\n0,inf", "no number in column `value`"),
            ("x,value\n0", "cells in this row: 1, in the header: 2"),
            ("x,value\n0,1,5", "cells in this row: 3, in the header: 2"),
            ("x,value,x\n0,1,2", "several columns `x`"),
            ("x,y,value\n0,0,1\n1,1,1", "has 2 rows, and its grid has 2 × 2 places"),
            ("x,value\n0,1\n0,1", "has 2 rows, and its grid has 1 places"),
            ("x,y,value\n0,0,1\n1,1,1\n0,0,1\n1,1,1", "has 4 rows, and its grid has 2 × 2 places"),
        ] {
            let found = read(text.as_bytes(), 2).unwrap_err().to_string();
            assert!(found.contains(reason), "{text:?}: {found}");
        }
    }
}
