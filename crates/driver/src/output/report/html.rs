//! The HTML of a page.

use super::block::{Bar, Block, Page, Section};
use super::element::{escaped, paragraph, set, table, tone};
use super::figures::Figures;
use super::{chart, map, picture, solid};
use std::fmt::Write;

/// What a browser may do with the page: nothing but show it.
const POLICY: &str =
    "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:";

const STYLE: &str = include_str!("page.css");

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
    let mut figures = Figures::default();
    page.sections.iter().for_each(|s| figures.add(&s.blocks));
    page.sections.iter().for_each(|s| section(&mut out, s, figures.bytes()));
    let _ = writeln!(out, "</main>\n<footer>{}</footer>", escaped(&page.footer));
    let _ = writeln!(out, "<script>\n'use strict';\n(() => {{\n{}}})();\n</script>", figures.scripts());
    out + "</body>\n</html>\n"
}

/// A section, in which a figure with fields may take some bytes.
fn section(out: &mut String, section: &Section, field_bytes: usize) {
    let title = escaped(&section.title);
    let [begin, end] = match section.folded {
        true => {
            [format!("<details class=\"section\"><summary><h2>{title}</h2></summary>"), "</details>".into()]
        }
        false => [format!("<section>\n<h2>{title}</h2>"), "</section>".into()],
    };
    let _ = writeln!(out, "{begin}");
    blocks(out, &section.blocks, field_bytes);
    let _ = writeln!(out, "{end}");
}

/// Blocks from the top; charts that follow each other stand side by side where there is room.
fn blocks(out: &mut String, blocks: &[Block], field_bytes: usize) {
    let is_chart = |block: &Block| matches!(block, Block::Chart(_));
    for group in blocks.chunk_by(|a, b| is_chart(a) && is_chart(b)) {
        let [begin, end] = if group.len() > 1 { ["<div class=\"charts\">\n", "</div>\n"] } else { ["", ""] };
        out.push_str(begin);
        group.iter().for_each(|b| block(out, b, field_bytes));
        out.push_str(end);
    }
}

fn block(out: &mut String, block: &Block, field_bytes: usize) {
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
        Block::Map(of) => map::render(out, of, field_bytes),
        Block::Solid(of) => solid::render(out, of, field_bytes),
        Block::Picture(of) => picture::render(out, of),
        Block::Code(text) => {
            let _ = writeln!(out, "<pre tabindex=\"0\">{}</pre>", lines(text));
        }
        Block::Choice(name, sets) => choice(out, name, sets, field_bytes),
    }
}

/// Escaped text whose line ends stay.
fn lines(text: &str) -> String {
    text.lines().map(escaped).collect::<Vec<_>>().join("\n")
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
fn choice(out: &mut String, name: &str, sets: &[(String, Vec<Block>)], field_bytes: usize) {
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
        blocks(out, set, field_bytes);
        out.push_str("</div>\n");
    }
    out.push_str("</div>\n");
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::report::{
        Axis, Badge, Bricks, Chart, Column, Field, Look, Map, Picture, Series, Shape, Solid, Table, Tone,
        View,
    };

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
            marks: Vec::new(),
        };
        let field = Field { name: text(), unit: text(), values: vec![1.0], range: [1.0; 2] };
        let cells = crate::output::report::Cells::Squares { centres: vec![[0.0; 2]], sides: vec![1.0] };
        let map = Map {
            title: text(),
            note: text(),
            length: text(),
            cells,
            fields: vec![field.clone()],
            ..Map::default()
        };
        let bricks = Bricks { size: [1; 3], sides: [[1.0; 3]; 2], spans: vec![0, 1], ..Bricks::default() };
        let (title, note, length) = (text(), text(), text());
        let solid = Solid { title, note, length, bricks, fields: vec![field], moves: None };
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
            Block::Solid(solid),
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
        // Four figures in two sections, and the script of the page: each begins and ends once.
        assert_eq!(html.matches("</script>").count(), 9);
        assert_eq!(html.matches("<script").count(), 9);
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
    fn code_keeps_its_lines() {
        let mut out = String::new();
        block(&mut out, &Block::Code("{\n  \"a\": 1\n}\n".into()), 0);
        assert_eq!(out, "<pre tabindex=\"0\">{\n  &quot;a&quot;: 1\n}</pre>\n");
    }
}
