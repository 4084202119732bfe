//! Reports: one HTML file that shows tables, charts, maps, solids and pictures, without any other file and without a network.
//!
//! A [`Page`] is a title and [`Section`]s of [`Block`]s; it knows no physics. Texts and tables are in the HTML itself;
//! charts, maps, solids and pictures carry their numbers as JSON and are drawn on canvases by the scripts beside this file. All
//! texts are escaped, so that names of users may hold anything.
//!
//! ```
//! use peristat::output::report::{Axis, Block, Chart, Look, Page, Section, Series, Slope, render};
//!
//! let points = vec![(0.1, 2e-3), (0.05, 5e-4), (0.025, 1.25e-4)];
//! let chart = Chart {
//!     title: "error over spacing".into(),
//!     x: Axis::log("spacing [m]"),
//!     y: Axis::log("relative error"),
//!     slopes: Slope::below(&points, 2.0).into_iter().collect(),
//!     series: vec![Series { label: "w".into(), look: Look::Marked, points }],
//!     ..Chart::default()
//! };
//! let section = Section::new("Convergence", vec![Block::Text("Second order.".into()), Block::Chart(chart)]);
//! let page = Page { title: "A study".into(), sections: vec![section], ..Page::default() };
//! assert!(render(&page).starts_with("<!doctype html>"));
//! ```

mod block;
mod chart;
mod element;
mod field;
mod figures;
mod frames;
mod html;
mod json;
mod map;
mod number;
mod pack;
mod picture;
mod solid;
mod table;

pub use block::{Badge, Bar, Block, Page, Section};
pub use chart::{Axis, Chart, Look, Series, Slope};
pub use field::{Field, Moves};
pub use frames::{Frame, Frames};
pub use map::{Arrows, Cells, Map, Marks};
pub use number::{number, typeset};
pub use picture::{Part, Picture, Shape, View};
pub use solid::{Bricks, Solid};
pub use table::{Cell, Column, Table, Tone};

use super::atomic;
use std::io;
use std::path::Path;

/// The page as the text of an HTML file.
pub fn render(page: &Page) -> String {
    html::page(page)
}

/// Writes a page as HTML.
///
/// # Errors
/// What the file system reports.
pub fn write(path: &Path, page: &Page) -> io::Result<()> {
    atomic::write_atomically(path, render(page).as_bytes())
}
