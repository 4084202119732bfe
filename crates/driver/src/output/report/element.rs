//! Elements of a page: paragraphs, tables, and the frames of figures.

use super::table::{Cell, Column, Table, Tone};
use crate::output::xml;
use std::fmt::Write;

/// Text as content of an element or an attribute.
pub(super) fn escaped(text: &str) -> String {
    xml(text)
}

/// Escaped text in which what stands between backticks is set as code.
pub(super) fn set(text: &str) -> String {
    let mut out = String::new();
    let mut parts = text.split('`').peekable();
    let mut is_code = false;
    while let Some(part) = parts.next() {
        match (is_code, parts.peek()) {
            (true, Some(_)) => out.extend(["<code>", &escaped(part), "</code>"]),
            // The last backtick has no partner.
            (true, None) => out.extend(["`", &escaped(part)]),
            (false, _) => out.push_str(&escaped(part)),
        }
        is_code = !is_code;
    }
    out
}

pub(super) fn tone(tone: Tone) -> &'static str {
    match tone {
        Tone::Plain => "plain",
        Tone::Good => "good",
        Tone::Bad => "bad",
    }
}

/// What it is about, under a title where there is one.
pub(super) fn titled(title: &str, text: &str) -> String {
    if title.is_empty() { text.into() } else { format!("{title}: {text}") }
}

pub(super) fn paragraph(out: &mut String, text: &str) {
    let _ = writeln!(out, "<p>{}</p>", set(text));
}

/// A table in a box that scrolls where the window is narrow.
pub(super) fn table(out: &mut String, table: &Table) {
    out.push_str("<div class=\"scroll\" tabindex=\"0\"><table>\n");
    if !table.title.is_empty() {
        let _ = writeln!(out, "<caption>{}</caption>", escaped(&table.title));
    }
    let side = |column: usize| if table.columns.get(column).is_some_and(|c| c.numbers) { "n" } else { "w" };
    let head = |(k, c): (usize, &Column)| {
        format!("<th scope=\"col\" class=\"{}\">{}</th>", side(k), escaped(&c.title))
    };
    let head: String = table.columns.iter().enumerate().map(head).collect();
    let _ = writeln!(out, "<thead><tr>{head}</tr></thead>\n<tbody>");
    for row in &table.rows {
        let cell = |(k, c): (usize, &Cell)| {
            format!("<td class=\"{} {}\">{}</td>", side(k), tone(c.tone), set(&c.text))
        };
        let _ = writeln!(out, "<tr>{}</tr>", row.iter().enumerate().map(cell).collect::<String>());
    }
    out.push_str("</tbody></table></div>\n");
}

/// The beginning of a figure that a script draws: a title with a remark, what stands above the canvas, the canvas with its
/// description, and the data as JSON that is safe to stand in a script. What follows is up to `</figure>`.
pub(super) fn figure(
    out: &mut String,
    kind: &str,
    (title, note): (&str, &str),
    description: &str,
    data: &str,
    above: &dyn Fn(&mut String),
) {
    let _ = writeln!(out, "<figure data-kind=\"{kind}\">");
    if !title.is_empty() {
        let _ = writeln!(out, "<figcaption>{}</figcaption>", escaped(title));
    }
    if !note.is_empty() {
        let _ = writeln!(out, "<p class=\"note\">{}</p>", escaped(note));
    }
    above(out);
    let _ = writeln!(
        out,
        "<div class=\"stage\"><canvas role=\"img\" aria-label=\"{}\"></canvas><div class=\"tip\" hidden></div></div>\n\
         <script type=\"application/json\">{data}</script>",
        escaped(description)
    );
}

/// A slider for the factor on displacements; the script writes the factor beside it.
pub(super) fn slider(out: &mut String) {
    out.push_str(
        "<label class=\"slides\">Deformed <input type=\"range\" class=\"scale\" min=\"0\" max=\"2\" step=\"0.05\" value=\"1\"> \
         <output></output></label>",
    );
}

/// A slider over states, the last of which has a number, and a button that plays them; the script writes the state beside it.
pub(super) fn states(out: &mut String, last: usize) {
    let _ = write!(
        out,
        "<label class=\"states\">State <input type=\"range\" class=\"state\" min=\"0\" max=\"{last}\" step=\"1\" value=\"{last}\"></label> \
         <button type=\"button\" class=\"play\">play</button> <output class=\"told\" aria-live=\"polite\"></output>"
    );
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_between_backticks_are_code_and_a_lone_one_is_a_backtick() {
        assert_eq!(set("joint `<A>` of `b`"), "joint <code>&lt;A&gt;</code> of <code>b</code>");
        assert_eq!(set("a ` b"), "a ` b");
        assert_eq!(set("plain"), "plain");
    }
}
