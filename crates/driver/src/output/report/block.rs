//! What a page is made of.

use super::table::{Table, Tone};
use super::{Chart, Map, Picture, Solid};

/// A report.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    /// Heading, and title of the window.
    pub title: String,
    /// What it is about, below the heading; empty for nothing.
    pub about: String,
    /// How it ended, beside the heading.
    pub badge: Option<Badge>,
    /// What it holds, from the top.
    pub sections: Vec<Section>,
    /// The last line, such as the name and version of the program.
    pub footer: String,
}

/// A part of a page under a heading.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Section {
    /// Heading.
    pub title: String,
    /// What it holds, from the top.
    pub blocks: Vec<Block>,
    /// Whether it is shown only when the heading is clicked; such a section is not printed.
    pub folded: bool,
}

impl Section {
    /// A section that is open.
    pub fn new(title: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self { title: title.into(), blocks, folded: false }
    }
}

/// A piece of a section.
#[derive(Clone, Debug, PartialEq)]
pub enum Block {
    /// A paragraph.
    Text(String),
    /// A paragraph that stands out.
    Notice(Tone, String),
    /// Lines of a list.
    List(Vec<String>),
    /// Names and what they are.
    Facts(Vec<(String, String)>),
    /// Rows and columns.
    Table(Table),
    /// Bars from zero, such as a breakdown of time.
    Bars(Vec<Bar>),
    /// Lines over an axis, linear or logarithmic.
    Chart(Chart),
    /// Coloured cells in the plane.
    Map(Map),
    /// Coloured cells in space.
    Solid(Solid),
    /// Lines in the plane.
    Picture(Picture),
    /// Text of a fixed pitch.
    Code(String),
    /// Blocks of which a reader chooses one set by its name; the last is shown first. A single one is shown as it is.
    Choice(String, Vec<(String, Vec<Block>)>),
}

/// A word beside the heading.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Badge {
    /// The word.
    pub text: String,
    /// Its colour.
    pub tone: Tone,
}

/// A bar from zero.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Bar {
    /// Name.
    pub name: String,
    /// Length, not negative.
    pub value: f64,
    /// The value in words, with its unit.
    pub text: String,
}
