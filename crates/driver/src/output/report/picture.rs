//! Pictures: lines in the plane, both axes to one scale, which can be moved.

use super::element;
use super::json::{all, inline, rounded};
use serde_json::{Value, json};
use std::fmt::Write;

/// A picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Picture {
    /// What it shows.
    pub title: String,
    /// What it shows in words, for readers who do not see it.
    pub description: String,
    /// Unit of positions.
    pub length: String,
    /// What readers choose from; the first one is shown first.
    pub views: Vec<View>,
}

/// One view of a picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct View {
    /// Name.
    pub name: String,
    /// Unit of the values of its lines.
    pub unit: String,
    /// A remark; empty for none.
    pub note: String,
    /// Factor on the moves of all lines.
    pub factor: f64,
    /// Whether readers may choose the factor, from none to twice as much.
    pub slides: bool,
    /// What is drawn, the first lowest.
    pub shapes: Vec<Shape>,
}

/// How a shape is drawn.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Part {
    /// A thick line: the body itself.
    #[default]
    Body,
    /// A thin line: the body where it is not what the picture is about.
    Ghost,
    /// A line in colour that answers with its values.
    Line,
    /// The area between the points where they are and where they move to, which answers with its values.
    Area,
    /// Dots.
    Dots,
    /// Open circles.
    Circles,
}

/// Points of a shape.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shape {
    /// Name, told with its values.
    pub name: String,
    /// How it is drawn.
    pub part: Part,
    /// Its points, in the order of the line.
    pub points: Vec<[f64; 2]>,
    /// Where the factor moves them, as long as `points`; empty if they stay.
    pub moves: Vec<[f64; 2]>,
    /// Values of the points, as long as `points`; empty for none.
    pub values: Vec<f64>,
}

impl Part {
    fn name(self) -> &'static str {
        match self {
            Self::Body => "body",
            Self::Ghost => "ghost",
            Self::Line => "line",
            Self::Area => "area",
            Self::Dots => "dots",
            Self::Circles => "circles",
        }
    }
}

/// The picture as a figure.
///
/// # Panics
/// Moves or values are neither empty nor as long as the points.
pub(super) fn render(out: &mut String, picture: &Picture) {
    if picture.views.iter().all(|v| v.shapes.is_empty()) {
        element::paragraph(out, &element::titled(&picture.title, "there is nothing to draw."));
        return;
    }
    let views: Vec<Value> = picture.views.iter().map(view).collect();
    let data = json!({ "length": picture.length, "views": views });
    element::figure(out, "picture", (&picture.title, ""), &picture.description, &inline(&data), &|out| {
        out.push_str("<div class=\"controls\"><label>View <select class=\"field\">");
        picture.views.iter().enumerate().for_each(|(k, view)| {
            let _ = write!(out, "<option value=\"{k}\">{}</option>", element::escaped(&view.name));
        });
        out.push_str("</select></label>");
        if picture.views.iter().any(|view| view.slides) {
            element::slider(out);
        }
        out.push_str("</div>\n");
    });
    out.push_str("</figure>\n");
}

fn view(view: &View) -> Value {
    let shape = |s: &Shape| {
        let fits = |length: usize| length == 0 || length == s.points.len();
        assert!(fits(s.moves.len()) && fits(s.values.len()), "moves and values belong to points");
        let plane = |of: &[[f64; 2]], k: usize| all(of.iter().map(|at| at[k]));
        json!({
            "name": s.name, "part": s.part.name(), "x": plane(&s.points, 0), "y": plane(&s.points, 1),
            "dx": plane(&s.moves, 0), "dy": plane(&s.moves, 1), "values": all(s.values.iter().copied()),
        })
    };
    let shapes: Vec<Value> = view.shapes.iter().map(shape).collect();
    json!({
        "name": view.name, "unit": view.unit, "note": view.note, "factor": rounded(view.factor), "slides": view.slides,
        "shapes": shapes,
    })
}
