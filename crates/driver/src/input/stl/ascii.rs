//! STL in ASCII: sections from `solid` to `endsolid`, with a name each.

use super::super::ReadError;
use super::super::lines::{Fields, Lines};
use super::super::surface::Triangles;
use peristat_assembly::body::Facet;

/// The triangles of a file, by the names of their sections.
pub(super) fn triangles(bytes: &[u8]) -> Result<Triangles, ReadError> {
    let mut lines = Lines::new(bytes);
    let mut found = Triangles::default();
    let mut sections = 0;
    while let Some(line) = next(&mut lines)? {
        let Some(name) = behind(line, "solid") else { return Err(expected(&lines, "`solid`", line)) };
        let name = number(name.trim(), &mut found.names);
        let before = found.facets.len();
        section(&mut lines, name, &mut found.facets)?;
        sections += usize::from(found.facets.len() > before);
    }
    if sections < 2 {
        found.names.clear();
        found.facets.iter_mut().for_each(|facet| facet.name = None);
    }
    Ok(found)
}

/// Number of a name; sections of the same name are one part.
fn number(name: &str, names: &mut Vec<String>) -> Option<u32> {
    if name.is_empty() {
        return None;
    }
    let found = names.iter().position(|other| other == name).unwrap_or_else(|| {
        names.push(name.to_string());
        names.len() - 1
    });
    Some(found as u32)
}

/// The triangles of a section, up to its end.
fn section(lines: &mut Lines, name: Option<u32>, facets: &mut Vec<Facet>) -> Result<(), ReadError> {
    loop {
        let line = some(lines, "`facet` or `endsolid`")?;
        if behind(line, "endsolid").is_some() {
            return Ok(());
        }
        // Colours of parts, as some programs write them.
        if behind(line, "color").is_some() {
            continue;
        }
        if behind(line, "facet").is_none() {
            return Err(expected(lines, "`facet` or `endsolid`", line));
        }
        word(lines, "outer loop")?;
        let corners = [corner(lines)?, corner(lines)?, corner(lines)?];
        word(lines, "endloop")?;
        word(lines, "endfacet")?;
        facets.push(Facet { corners, name });
    }
}

fn corner(lines: &mut Lines) -> Result<[f64; 3], ReadError> {
    let line = some(lines, "`vertex`")?;
    let Some(rest) = behind(line, "vertex") else { return Err(expected(lines, "`vertex`", line)) };
    let mut fields = Fields::new(rest, lines.number(), "a vertex");
    Ok([fields.real("x")?, fields.real("y")?, fields.real("z")?])
}

fn word(lines: &mut Lines, word: &str) -> Result<(), ReadError> {
    let line = some(lines, word)?;
    let found = line.split_ascii_whitespace();
    let is_it = found.clone().count() == word.split(' ').count()
        && found.zip(word.split(' ')).all(|(a, b)| a.eq_ignore_ascii_case(b));
    if is_it { Ok(()) } else { Err(expected(lines, &format!("`{word}`"), line)) }
}

/// The next line as text; names may have any characters.
fn next<'a>(lines: &mut Lines<'a>) -> Result<Option<&'a str>, ReadError> {
    let Some(line) = lines.raw() else { return Ok(None) };
    let fault = |_| ReadError::at(lines.number(), "is no text").hint("names are read as UTF-8");
    std::str::from_utf8(line).map(Some).map_err(fault)
}

fn some<'a>(lines: &mut Lines<'a>, what: &str) -> Result<&'a str, ReadError> {
    next(lines)?.ok_or_else(|| {
        ReadError::whole(format!("ends where {what} belongs"))
            .hint("the file is cut off: export or copy it again")
    })
}

/// What comes behind a word at the start of a line.
fn behind<'a>(line: &'a str, word: &str) -> Option<&'a str> {
    let (start, rest) = line.split_at_checked(word.len())?;
    let ends = rest.is_empty() || rest.starts_with(|c: char| c.is_ascii_whitespace());
    (start.eq_ignore_ascii_case(word) && ends).then_some(rest)
}

fn expected(lines: &Lines, what: &str, found: &str) -> ReadError {
    let found: String = found.chars().take(40).collect();
    ReadError::at(lines.number(), format!("expected {what}, found `{found}`"))
}
