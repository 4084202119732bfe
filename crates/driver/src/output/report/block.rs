//! What a page is made of.

use super::{Chart, Map, Picture};

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
    /// Lines in the plane.
    Picture(Picture),
    /// Text of a fixed pitch.
    Code(String),
    /// Blocks of which a reader chooses one set by its name; the last is shown first. A single one is shown as it is.
    Choice(String, Vec<(String, Vec<Block>)>),
}

/// How good something is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tone {
    /// Neither.
    #[default]
    Plain,
    /// Good.
    Good,
    /// Bad.
    Bad,
}

/// A word beside the heading.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Badge {
    /// The word.
    pub text: String,
    /// Its colour.
    pub tone: Tone,
}

/// A table. Columns scroll where the window is narrow.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Table {
    /// What it shows; empty for nothing.
    pub title: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows, as long as there are columns.
    pub rows: Vec<Vec<Cell>>,
}

/// The head of a column.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Column {
    /// Heading.
    pub title: String,
    /// Whether it holds numbers, which stand to the right.
    pub numbers: bool,
}

impl Column {
    /// A column of words.
    pub fn words(title: impl Into<String>) -> Self {
        Self { title: title.into(), numbers: false }
    }

    /// A column of numbers.
    pub fn numbers(title: impl Into<String>) -> Self {
        Self { title: title.into(), numbers: true }
    }
}

/// A cell of a table.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Cell {
    /// What it says.
    pub text: String,
    /// Its colour.
    pub tone: Tone,
}

impl<T: Into<String>> From<T> for Cell {
    fn from(text: T) -> Self {
        Self { text: text.into(), tone: Tone::Plain }
    }
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
