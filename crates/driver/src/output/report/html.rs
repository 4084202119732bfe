//! The HTML of a page.

use super::{Bar, Block, Cell, Page, Section, Table, Tone, chart, map, picture};
use crate::output::xml;
use std::fmt::Write;

/// What a browser may do with the page: nothing but show it.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

const STYLE: &str = include_str!("page.css");
/// In the order in which they need each other.
const SCRIPTS: [&str; 6] = [
    include_str!("number.js"),
    include_str!("stage.js"),
    include_str!("chart.js"),
    include_str!("map.js"),
    include_str!("picture.js"),
    include_str!("page.js"),
];

/// Bytes that the fields of all maps of a page may take: a page is to stay below a megabyte.
const MAP_BYTES: usize = 760_000;

/// Text as content of an element or an attribute.
pub(super) fn escaped(text: &str) -> String {
    xml(text)
}

/// Escaped text in which what stands between backticks is set as code.
fn set(text: &str) -> String {
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

/// The whole page.
pub(super) fn page(page: &Page) -> String {
    let title = escaped(&page.title);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<header>\n\
         <button id=\"theme\" type=\"button\" aria-label=\"Light or dark\" hidden></button>\n<h1>{title}"
    );
    if let Some(badge) = &page.badge {
        let _ = write!(out, " <span class=\"badge {}\">{}</span>", tone(badge.tone), escaped(&badge.text));
    }
    out.push_str("</h1>\n");
    if !page.about.is_empty() {
        let _ = writeln!(out, "<p class=\"about\">{}</p>", escaped(&page.about));
    }
    out.push_str(
        "</header>\n<main>\n<noscript><p class=\"notice plain\">Charts and maps need JavaScript; \
         every number is in the tables, and in the files beside this one.</p></noscript>\n",
    );
    let maps = page.sections.iter().map(|s| maps(&s.blocks)).sum::<usize>().max(1);
    page.sections.iter().for_each(|s| section(&mut out, s, MAP_BYTES / maps));
    let _ = writeln!(out, "</main>\n<footer>{}</footer>", escaped(&page.footer));
    let _ = writeln!(out, "<script>\n'use strict';\n(() => {{\n{}}})();\n</script>", SCRIPTS.concat());
    out + "</body>\n</html>\n"
}

fn tone(tone: Tone) -> &'static str {
    match tone {
        Tone::Plain => "plain",
        Tone::Good => "good",
        Tone::Bad => "bad",
    }
}

/// Number of maps among blocks.
fn maps(blocks: &[Block]) -> usize {
    let of = |block: &Block| match block {
        Block::Map(_) => 1,
        Block::Choice(_, sets) => sets.iter().map(|(_, blocks)| maps(blocks)).sum(),
        _ => 0,
    };
    blocks.iter().map(of).sum()
}

/// What it is about, under a title where there is one.
pub(super) fn titled(title: &str, text: &str) -> String {
    if title.is_empty() { text.into() } else { format!("{title}: {text}") }
}

/// A section, in which a map may take some bytes.
fn section(out: &mut String, section: &Section, map_bytes: usize) {
    let title = escaped(&section.title);
    let [begin, end] = match section.folded {
        true => {
            [format!("<details class=\"section\"><summary><h2>{title}</h2></summary>"), "</details>".into()]
        }
        false => [format!("<section>\n<h2>{title}</h2>"), "</section>".into()],
    };
    let _ = writeln!(out, "{begin}");
    blocks(out, &section.blocks, map_bytes);
    let _ = writeln!(out, "{end}");
}

/// Blocks from the top; charts that follow each other stand side by side where there is room.
fn blocks(out: &mut String, blocks: &[Block], map_bytes: usize) {
    let is_chart = |block: &Block| matches!(block, Block::Chart(_));
    for group in blocks.chunk_by(|a, b| is_chart(a) && is_chart(b)) {
        let [begin, end] = if group.len() > 1 { ["<div class=\"charts\">\n", "</div>\n"] } else { ["", ""] };
        out.push_str(begin);
        group.iter().for_each(|b| block(out, b, map_bytes));
        out.push_str(end);
    }
}

fn block(out: &mut String, block: &Block, map_bytes: usize) {
    match block {
        Block::Text(text) => paragraph(out, text),
        Block::Notice(of, text) => {
            let _ = writeln!(out, "<p class=\"notice {}\">{}</p>", tone(*of), set(text));
        }
        Block::List(lines) => {
            let lines: String = lines.iter().map(|line| format!("<li>{}</li>\n", set(line))).collect();
            let _ = writeln!(out, "<ul>\n{lines}</ul>");
        }
        Block::Facts(facts) => {
            let fact = |(name, text): &(String, String)| {
                format!("<div><dt>{}</dt><dd>{}</dd></div>\n", escaped(name), set(text))
            };
            let _ = writeln!(out, "<dl>\n{}</dl>", facts.iter().map(fact).collect::<String>());
        }
        Block::Table(of) => table(out, of),
        Block::Bars(of) => bars(out, of),
        Block::Chart(of) => chart::render(out, of),
        Block::Map(of) => map::render(out, of, map_bytes),
        Block::Picture(of) => picture::render(out, of),
        Block::Code(text) => {
            let _ = writeln!(out, "<pre tabindex=\"0\">{}</pre>", lines(text));
        }
        Block::Choice(name, sets) => choice(out, name, sets, map_bytes),
    }
}

/// Escaped text whose line ends stay.
fn lines(text: &str) -> String {
    text.lines().map(escaped).collect::<Vec<_>>().join("\n")
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
    let head = |(k, c): (usize, &super::Column)| {
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

fn bars(out: &mut String, bars: &[Bar]) {
    let longest = bars.iter().map(|b| b.value).fold(0.0, f64::max);
    out.push_str("<div class=\"bars\">\n");
    for bar in bars {
        let share = if longest > 0.0 { 100.0 * bar.value / longest } else { 0.0 };
        let [name, text] = [&bar.name, &bar.text].map(|t| escaped(t));
        let _ = writeln!(
            out,
            "<div><span>{name}</span><span class=\"track\"><i style=\"width:{share:.1}%\"></i></span><span>{text}</span></div>"
        );
    }
    out.push_str("</div>\n");
}

/// Sets of blocks and a list to choose from; the last set is shown first.
fn choice(out: &mut String, name: &str, sets: &[(String, Vec<Block>)], map_bytes: usize) {
    if sets.len() > 1 {
        let _ = write!(
            out,
            "<div class=\"choice\"><div class=\"controls\"><label>{} <select class=\"choose\">",
            escaped(name)
        );
        for (k, (name, _)) in sets.iter().enumerate() {
            let selected = if k + 1 == sets.len() { " selected" } else { "" };
            let _ = write!(out, "<option value=\"{k}\"{selected}>{}</option>", escaped(name));
        }
        out.push_str("</select></label></div>\n");
    } else {
        out.push_str("<div class=\"choice\">\n");
    }
    for (k, (_, set)) in sets.iter().enumerate() {
        let hidden = if k + 1 == sets.len() { "" } else { " hidden" };
        let _ = writeln!(out, "<div class=\"set\"{hidden}>");
        blocks(out, set, map_bytes);
        out.push_str("</div>\n");
    }
    out.push_str("</div>\n");
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::report::{Axis, Badge, Chart, Column, Field, Look, Map, Picture, Series, Shape, View};

    const HOSTILE: &str =
        "</script></title><script>alert(1)</script><img src=x onerror=alert(2)> \" ' & <!--";

    /// A page with this text wherever a text may stand.
    fn hostile() -> Page {
        let text = || HOSTILE.to_string();
        let chart = Chart {
            title: text(),
            note: text(),
            x: Axis::linear(HOSTILE),
            y: Axis::log(HOSTILE),
            series: vec![Series { label: text(), look: Look::Dots, points: vec![(1.0, 2.0)] }; 2],
            slopes: Vec::new(),
        };
        let field = Field { name: text(), unit: text(), values: vec![1.0], range: [1.0; 2] };
        let cells = crate::output::report::Cells::Squares { centres: vec![[0.0; 2]], sides: vec![1.0] };
        let map =
            Map { title: text(), note: text(), length: text(), cells, fields: vec![field], ..Map::default() };
        let shape = Shape { name: text(), points: vec![[0.0; 2]], ..Shape::default() };
        let view = View { name: text(), unit: text(), note: text(), shapes: vec![shape], ..View::default() };
        let picture = Picture { title: text(), description: text(), length: text(), views: vec![view] };
        let table =
            Table { title: text(), columns: vec![Column::words(HOSTILE)], rows: vec![vec![HOSTILE.into()]] };
        let blocks = vec![
            Block::Text(text()),
            Block::Notice(Tone::Bad, text()),
            Block::List(vec![text()]),
            Block::Facts(vec![(text(), text())]),
            Block::Table(table),
            Block::Bars(vec![Bar { name: text(), value: 1.0, text: text() }]),
            Block::Chart(chart),
            Block::Map(map),
            Block::Picture(picture),
            Block::Code(text()),
            Block::Choice(text(), vec![(text(), vec![Block::Text(text())]), (text(), Vec::new())]),
        ];
        let badge = Some(Badge { text: text(), tone: Tone::Good });
        let sections = [false, true].map(|folded| Section { title: text(), blocks: blocks.clone(), folded });
        Page { title: text(), about: text(), badge, sections: sections.into(), footer: text() }
    }

    #[test]
    fn a_hostile_text_is_text_wherever_it_stands() {
        let html = page(&hostile());
        // Three figures in two sections, and the script of the page: each begins and ends once.
        assert_eq!(html.matches("</script>").count(), 7);
        assert_eq!(html.matches("<script").count(), 7);
        assert_eq!(html.matches("<!--").count(), 0);
        assert!(!html.contains("<img") && !html.contains("</title><script>"));
    }

    #[test]
    fn a_page_needs_nothing_but_itself() {
        let html = page(&hostile());
        for outside in ["http://", "https://", "src=\"", "href=\"", "@import", "url("] {
            assert!(!html.contains(outside), "{outside}");
        }
        assert!(html.contains(POLICY));
    }

    #[test]
    fn names_between_backticks_are_code_and_a_lone_one_is_a_backtick() {
        assert_eq!(set("joint `<A>` of `b`"), "joint <code>&lt;A&gt;</code> of <code>b</code>");
        assert_eq!(set("a ` b"), "a ` b");
        assert_eq!(set("plain"), "plain");
    }

    #[test]
    fn code_keeps_its_lines() {
        let mut out = String::new();
        block(&mut out, &Block::Code("{\n  \"a\": 1\n}\n".into()), 0);
        assert_eq!(out, "<pre tabindex=\"0\">{\n  &quot;a&quot;: 1\n}</pre>\n");
    }
}
