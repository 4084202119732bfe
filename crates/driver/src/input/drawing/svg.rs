//! SVG: paths and shapes with their transforms; `id`s are their names. Its y points downwards, that of bodies upwards: the lower left
//! corner of the `viewBox` becomes the origin.
//!
//! Source of the format: W3C, Scalable Vector Graphics 2.

use super::super::ReadError;
use super::strokes::Strokes;
use super::svg_shape;
use roxmltree::{Document, Node, ParsingOptions};
use std::str::FromStr;
use svgtypes::{Transform, ViewBox};

/// Elements whose shapes are not drawn where they stand.
const HIDDEN: [&str; 7] = ["defs", "clipPath", "mask", "marker", "pattern", "symbol", "metadata"];

/// Properties that a style sheet gives to shapes without their being told apart here.
const MOVING: [&str; 9] = ["display", "visibility", "transform", "d", "cx", "cy", "r", "x", "y"];

/// Elements within each other, at most.
const DEEPEST: usize = 200;

/// From positions of an element to those of the body.
#[derive(Clone, Copy, Debug)]
pub(super) struct Axes {
    by: [f64; 6],
}

impl Axes {
    fn then(&self, inner: Transform) -> Self {
        let [a, b, c, d, e, f] = self.by;
        let t = inner;
        let by = [
            a * t.a + c * t.b,
            b * t.a + d * t.b,
            a * t.c + c * t.d,
            b * t.c + d * t.d,
            a * t.e + c * t.f + e,
            b * t.e + d * t.f + f,
        ];
        Self { by }
    }

    /// Where a position of the element is.
    pub(super) fn at(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let [a, b, c, d, e, f] = self.by;
        [a * x + c * y + e, b * x + d * y + f]
    }

    /// What lengths are multiplied by, at most.
    pub(super) fn stretch(&self) -> f64 {
        let [a, b, c, d, ..] = self.by;
        let (sum, rest) = (0.5 * (a * a + b * b + c * c + d * d), a * d - b * c);
        (sum + (sum * sum - rest * rest).max(0.0).sqrt()).sqrt()
    }

    /// What lengths are multiplied by, if it is the same in all directions.
    pub(super) fn scale(&self) -> Option<f64> {
        let [a, b, c, d, ..] = self.by;
        let scale = a.hypot(b);
        let is_same =
            (c.hypot(d) - scale).abs() <= 1e-9 * scale && (a * c + b * d).abs() <= 1e-9 * scale * scale;
        is_same.then_some(scale)
    }
}

/// The line of an element.
pub(super) fn line(node: Node) -> usize {
    node.document().text_pos_at(node.range().start).row as usize
}

/// Reads the lines of a drawing.
pub(super) fn read(bytes: &[u8], deviation: f64) -> Result<Strokes, ReadError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|_| ReadError::whole("is no UTF-8 text").hint("save the SVG as UTF-8"))?;
    check_depth(bytes)?;
    let options = ParsingOptions { allow_dtd: true, ..ParsingOptions::default() };
    let document = Document::parse_with_options(text, options).map_err(|error| {
        ReadError::at(error.pos().row as usize, format!("the XML is broken: {error}"))
            .hint("export the drawing again")
    })?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(ReadError::at(line(root), format!("expected `svg`, found `{}`", root.tag_name().name())));
    }
    let mut strokes = Strokes::default();
    let mut open = vec![(root, upwards(root)?)];
    while let Some((node, axes)) = open.pop() {
        let name = node.tag_name().name();
        if HIDDEN.contains(&name) || is_hidden(node) {
            continue;
        }
        check_is_read(node, root)?;
        let axes = match node.attribute("transform") {
            Some(text) => axes.then(Transform::from_str(text).map_err(|error| {
                ReadError::at(line(node), format!("the attribute `transform` is broken: {error}"))
            })?),
            None => axes,
        };
        svg_shape::add(node, &axes, deviation, &mut strokes)?;
        // The first child is the next one.
        let children: Vec<Node> = node.children().filter(Node::is_element).collect();
        open.extend(children.into_iter().rev().map(|child| (child, axes)));
    }
    Ok(strokes)
}

/// The value of a property: a declaration of the attribute `style` has precedence over the attribute.
fn property<'a>(node: Node<'a, '_>, name: &str) -> Option<&'a str> {
    let declarations = node.attribute("style").unwrap_or_default().split(';');
    let styled = declarations.filter_map(|text| text.split_once(':')).find(|(key, _)| key.trim() == name);
    styled.map(|(_, value)| value.trim()).or_else(|| node.attribute(name))
}

/// Whether neither an element nor what is within it is drawn.
fn is_hidden(node: Node) -> bool {
    let hides = |value: &str| ["hidden", "collapse"].iter().any(|hidden| value.starts_with(hidden));
    property(node, "display").is_some_and(|value| value.starts_with("none"))
        || property(node, "visibility").is_some_and(hides)
}

/// A fault for what would move shapes, or hide them, in ways that are not read.
fn check_is_read(node: Node, root: Node) -> Result<(), ReadError> {
    let refused =
        |what: &str, hint| Err(ReadError::at(line(node), format!("{what} are not read")).hint(hint));
    match node.tag_name().name() {
        "use" => refused("elements `use`", "unlink clones before the export"),
        "svg" if node != root => {
            refused("drawings `svg` within a drawing", "ungroup imported drawings before the export")
        }
        "switch" => refused("elements `switch`", "export the drawing as plain SVG"),
        "style" => {
            let sheet: String =
                node.descendants().filter_map(|n| n.is_text().then(|| n.text()).flatten()).collect();
            match MOVING.iter().find(|name| declares(&sheet, name)) {
                Some(name) => refused(
                    &format!("style sheets with `{name}`"),
                    "export with attributes in place of style sheets, as plain SVG",
                ),
                None => Ok(()),
            }
        }
        _ if property(node, "transform").is_some() && node.attribute("transform").is_none() => {
            refused("styles with `transform`", "write the attribute `transform`")
        }
        _ => Ok(()),
    }
}

/// Whether a style sheet declares a property of that name.
fn declares(sheet: &str, name: &str) -> bool {
    let is_word = |c: char| c.is_ascii_alphanumeric() || c == '-';
    sheet.match_indices(name).any(|(at, _)| {
        !sheet[..at].ends_with(is_word) && sheet[at + name.len()..].trim_start().starts_with(':')
    })
}

/// A fault for elements too deep within each other, before a parser goes there.
fn check_depth(bytes: &[u8]) -> Result<(), ReadError> {
    let (mut depth, mut row) = (0_usize, 1);
    for pair in bytes.windows(2) {
        row += usize::from(pair[0] == b'\n');
        match pair {
            b"</" | b"/>" => depth = depth.saturating_sub(1),
            [b'<', next] if next.is_ascii_alphabetic() => depth += 1,
            _ => {}
        }
        if depth > DEEPEST {
            return Err(ReadError::at(
                row,
                format!("elements are more than {DEEPEST} deep within each other"),
            ));
        }
    }
    Ok(())
}

/// Axes with y upwards from the lower left corner of the view box, or of the page.
fn upwards(root: Node) -> Result<Axes, ReadError> {
    let broken = |what: &str| ReadError::at(line(root), format!("the attribute `{what}` is broken"));
    let corner = match root.attribute("viewBox") {
        Some(text) => {
            let view = ViewBox::from_str(text).map_err(|_| broken("viewBox"))?;
            [view.x, view.y + view.h]
        }
        None => {
            [0.0, root.attribute("height").and_then(|h| h.trim_end_matches("px").parse().ok()).unwrap_or(0.0)]
        }
    };
    Ok(Axes { by: [1.0, 0.0, 0.0, -1.0, -corner[0], corner[1]] })
}
