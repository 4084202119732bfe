//! Maps: cells in the plane, coloured by one of several fields, which can be moved by a multiple of two of them.

use super::element;
use super::field::{self, Field, Moves};
use super::frames::Frame;
use super::json::{all, inline, rounded};
use super::pack::Order;
use serde_json::{Value, json};

/// A map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Map {
    /// What it shows.
    pub title: String,
    /// A remark below the title; empty for none.
    pub note: String,
    /// Unit of positions.
    pub length: String,
    /// Where the cells are.
    pub cells: Cells,
    /// What they hold; the first one is shown first.
    pub fields: Vec<Field>,
    /// How they move.
    pub moves: Option<Moves<2>>,
    /// Lines over the cells where they have not moved, such as cracks.
    pub lines: Vec<Vec<[f64; 2]>>,
    /// Sides along which cells have come apart: the cell, the side as in `torn`, and the number of the first such state.
    pub grown: Vec<[usize; 3]>,
    /// What lies over the cells.
    pub marks: Marks,
    /// Number of the state that it shows, and what that is called.
    pub state: (usize, String),
    /// States before, in their order.
    pub before: Vec<Frame>,
}

/// What lies over the cells of a map.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// How many lines of equal values each field has, about.
    pub isolines: Option<usize>,
    /// What arrows show.
    pub arrows: Option<Arrows>,
}

/// Arrows of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrows {
    /// Numbers of the fields on which they are shown.
    pub on: Vec<usize>,
    /// Numbers of the fields that are the components xx, yy and xy of the tensor whose principal values they show; without it
    /// they show how cells move.
    pub tensor: Option<[usize; 3]>,
}

impl Marks {
    fn json(&self) -> Value {
        let arrows = self.arrows.as_ref().map(|a| json!({ "on": a.on, "tensor": a.tensor }));
        json!({ "isolines": self.isolines, "arrows": arrows })
    }
}

/// Cells of a map.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Parallelograms in rows, the fields of which stand row by row from the lowest.
    Grid {
        /// Lower left corner of column 0 and row 0.
        origin: [f64; 2],
        /// Sides of a cell: along its row, and to the next row.
        sides: [[f64; 2]; 2],
        /// Number of columns and rows.
        size: [usize; 2],
        /// Part of the last column and of the last row that is there, 0 to 1.
        last: [f64; 2],
        /// Row, first column, and number of cells of every stretch that is there, in their order.
        runs: Vec<[usize; 3]>,
        /// Cells that do not move with their neighbour, by number: 0 for that on the right, 1 for that above.
        torn: Vec<[usize; 2]>,
    },
    /// Squares.
    Squares {
        /// Their centres.
        centres: Vec<[f64; 2]>,
        /// Length of their sides.
        sides: Vec<f64>,
    },
}

impl Default for Cells {
    fn default() -> Self {
        Self::Squares { centres: Vec::new(), sides: Vec::new() }
    }
}

impl Cells {
    fn count(&self) -> usize {
        match self {
            Self::Grid { runs, .. } => runs.iter().map(|run| run[2]).sum(),
            Self::Squares { centres, .. } => centres.len(),
        }
    }

    pub(super) fn order(&self) -> Order {
        match self {
            Self::Grid { size, runs, .. } => Order::of_runs(size[0], runs),
            Self::Squares { centres, .. } => Order::of_list(centres.len()),
        }
    }

    fn json(&self) -> Value {
        match self {
            Self::Grid { origin, sides, size, last, runs, torn } => json!({
                "origin": origin, "sides": sides, "size": size, "last": last, "runs": runs, "torn": torn
            }),
            Self::Squares { centres, sides } => json!({
                "x": all(centres.iter().map(|c| c[0])), "y": all(centres.iter().map(|c| c[1])),
                "side": all(sides.iter().copied())
            }),
        }
    }
}

/// The map as a figure, the fields of which take no more than some bytes, at the price of digits.
///
/// # Panics
/// A field does not have a value per cell.
pub(super) fn render(out: &mut String, map: &Map, most_bytes: usize) {
    let cells = map.cells.count();
    if cells == 0 || map.fields.is_empty() {
        element::paragraph(out, &element::titled(&map.title, "there are no cells to draw."));
        return;
    }
    assert!(map.fields.iter().all(|f| f.values.len() == cells), "a field has a value per cell");
    let moves = map.moves.map(|m| json!({ "fields": m.fields, "factor": rounded(m.factor) }));
    let packed = field::packed(&map.fields, &map.cells.order(), most_bytes);
    let data = json!({
        "length": map.length, "cells": map.cells.json(), "fields": field::json(&map.fields, &packed), "moves": moves,
        "lines": map.lines, "grown": map.grown, "marks": map.marks.json(), "before": map.before,
        "state": { "state": map.state.0, "name": map.state.1 },
    });
    let described = field::described(&map.title, &map.fields);
    element::figure(out, "map", (&map.title, &map.note), &described, &inline(&data), &|out| {
        out.push_str("<div class=\"controls\">");
        field::choice(out, &map.fields);
        if map.moves.is_some() {
            element::slider(out);
        }
        if !map.before.is_empty() {
            element::states(out, map.before.len());
        }
        out.push_str("</div>\n");
    });
    out.push_str("</figure>\n");
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map(side: usize, value: impl Fn(usize) -> f64) -> Map {
        let cells = Cells::Grid {
            origin: [0.0; 2],
            sides: [[1.0, 0.0], [0.0, 1.0]],
            size: [side; 2],
            last: [1.0; 2],
            runs: (0..side).map(|row| [row, 0, side]).collect(),
            torn: Vec::new(),
        };
        let field = |k: usize| Field {
            name: format!("field {k}"),
            values: (0..side * side).map(|cell| value(cell + k)).collect(),
            range: [-1.0, 1.0],
            ..Field::default()
        };
        Map { title: "m".into(), cells, fields: (0..12).map(field).collect(), ..Map::default() }
    }

    #[test]
    fn a_noisy_map_is_rounded_until_it_is_small() {
        let noise = |k: usize| ((k * 7919) % 104_729) as f64 / 104_729.0;
        let mut out = String::new();
        render(&mut out, &map(240, noise), 760_000);
        assert!(out.len() < 1_000_000, "{} bytes", out.len());
        assert!(out.contains("field 0 from −1 to 1"), "{}", &out[..400]);
    }

    #[test]
    #[should_panic(expected = "a field has a value per cell")]
    fn fields_of_another_length_are_a_broken_contract() {
        let mut map = map(3, |k| k as f64);
        map.fields[1].values.pop();
        render(&mut String::new(), &map, 0);
    }

    #[test]
    fn no_cells_are_told_in_a_sentence() {
        let mut out = String::new();
        render(&mut out, &Map { title: "m".into(), ..Map::default() }, 0);
        assert_eq!(out, "<p>m: there are no cells to draw.</p>\n");
    }
}
