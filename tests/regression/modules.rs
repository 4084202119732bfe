//! Files of a crate and what they import, read from their text.

use super::support::{files, root};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

/// Files by their paths without an ending, a folder standing for its `mod.rs`, and those that each uses.
pub(crate) struct Modules {
    uses: BTreeMap<String, BTreeSet<String>>,
}

/// A file as text.
struct Source {
    /// Whether its text is that of a folder.
    is_hub: bool,
    /// Code without comments and tests.
    code: String,
}

impl Modules {
    /// The files of the driver, those of tests left out.
    pub(crate) fn of_driver() -> Self {
        let source = root().join("crates/driver/src");
        let of = |file: &std::path::PathBuf| {
            let inside = file.strip_prefix(&source).expect("a file below").with_extension("");
            (inside.display().to_string(), fs::read_to_string(file).expect("a text"))
        };
        let all: Vec<(String, String)> = files(&source, ".rs").iter().map(of).collect();
        Self::new(all.into_iter().filter(|(path, _)| !path.split('/').any(|part| part == "tests")))
    }

    /// Files by path and text.
    pub(crate) fn new(texts: impl IntoIterator<Item = (String, String)>) -> Self {
        let mut sources = BTreeMap::new();
        for (path, text) in texts {
            let hub = path.strip_suffix("/mod").map(str::to_string);
            let is_hub = hub.is_some() || path == "lib";
            let path = if path == "lib" { String::new() } else { hub.unwrap_or(path) };
            sources.insert(path, Source { is_hub, code: code(&text) });
        }
        let uses = |(path, source): (&String, &Source)| {
            let named = paths(&source.code);
            let found = named.iter().filter_map(|named| resolved(&sources, path, named));
            (path.clone(), found.filter(|to| to != path && !to.is_empty()).collect())
        };
        Self { uses: sources.iter().map(uses).filter(|(path, _): &(String, _)| !path.is_empty()).collect() }
    }

    /// Who uses whom.
    pub(crate) fn edges(&self) -> impl Iterator<Item = (&str, &str)> {
        self.uses.iter().flat_map(|(from, to)| to.iter().map(move |to| (from.as_str(), to.as_str())))
    }

    /// Folders beside each other and what their files use of each other.
    pub(crate) fn folders(&self) -> Self {
        let mut uses: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for (from, to) in self.edges() {
            let (from, to): (Vec<&str>, Vec<&str>) = (from.split('/').collect(), to.split('/').collect());
            let same = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
            // Files that lie beside each other are no folders.
            if from.len() > same + 1 && to.len() > same + 1 {
                let [from, to] = [from, to].map(|path| path[..=same].join("/"));
                uses.entry(from).or_default().insert(to);
            }
        }
        Self { uses }
    }

    /// Files that use each other, by whatever way; those of a circle in order.
    pub(crate) fn circles(&self) -> Vec<Vec<String>> {
        let reached: BTreeMap<&str, BTreeSet<&str>> =
            self.uses.keys().map(|from| (from.as_str(), self.reached(from))).collect();
        let mut told: BTreeSet<&str> = BTreeSet::new();
        let mut circles = Vec::new();
        for (from, all) in &reached {
            let back = |to: &&&str| reached.get(**to).is_some_and(|back| back.contains(from));
            let circle: Vec<&str> = all.iter().filter(back).copied().collect();
            if circle.len() > 1 && told.insert(circle[0]) {
                circles.push(circle.into_iter().map(str::to_string).collect());
            }
        }
        circles
    }

    fn reached(&self, from: &str) -> BTreeSet<&str> {
        let (mut found, mut open) = (BTreeSet::new(), vec![from]);
        while let Some(next) = open.pop() {
            for to in self.uses.get(next).into_iter().flatten() {
                if found.insert(to.as_str()) {
                    open.push(to);
                }
            }
        }
        found
    }
}

/// Code up to the tests, without comments.
fn code(text: &str) -> String {
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.collect::<Vec<_>>().join("\n")
}

/// All paths that begin in the crate, of imports and of code.
fn paths(code: &str) -> Vec<String> {
    let mut found = Vec::new();
    for import in code.split("use ").skip(1) {
        let import = import.split(';').next().unwrap_or_default();
        let import: String = import.split_whitespace().collect::<Vec<_>>().join(" ");
        found.extend(expanded(&import));
    }
    for start in ["crate::", "super::"] {
        for (at, _) in code.match_indices(start) {
            let is_begin = !code[..at].ends_with("::");
            let end = code[at..].find(|c: char| !(c.is_alphanumeric() || c == '_' || c == ':'));
            let path = &code[at..end.map_or(code.len(), |end| at + end)];
            // Groups are those of imports.
            if is_begin && !path.ends_with(':') {
                found.push(path.to_string());
            }
        }
    }
    found
}

/// The paths of an import with its groups taken apart.
fn expanded(import: &str) -> Vec<String> {
    let Some((before, rest)) = import.split_once('{') else { return vec![import.trim().to_string()] };
    let (mut depth, mut parts, mut part) = (0, Vec::new(), String::new());
    for c in rest.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            _ => {}
        }
        if c == ',' && depth == 0 {
            parts.push(std::mem::take(&mut part));
        } else {
            part.push(c);
        }
    }
    parts.push(part);
    let parts = parts.iter().map(|part| part.trim()).filter(|part| !part.is_empty());
    parts.flat_map(|part| expanded(&format!("{before}{part}"))).collect()
}

/// The file that a path in some file leads to; none outside of the crate.
fn resolved(sources: &BTreeMap<String, Source>, from: &str, path: &str) -> Option<String> {
    let mut names: Vec<&str> = path.split("::").map(|name| name.split(' ').next().unwrap_or(name)).collect();
    let mut at: Vec<&str> = from.split('/').filter(|part| !part.is_empty()).collect();
    match names[0] {
        "crate" => at.clear(),
        "self" => {}
        "super" => {
            at.pop();
        }
        // A child of a folder.
        _ if sources.get(from).is_some_and(|source| source.is_hub) => {
            names.insert(0, "");
            let child = [from, names[1]].join("/");
            if !sources.contains_key(child.trim_start_matches('/')) {
                return None;
            }
        }
        _ => return None,
    }
    let mut rest = names.into_iter().skip(1).peekable();
    while rest.next_if_eq(&"super").is_some() {
        at.pop();
    }
    while let Some(name) = rest.next_if(|name| {
        let next = at.iter().copied().chain([*name]).collect::<Vec<_>>().join("/");
        sources.contains_key(&next)
    }) {
        at.push(name);
    }
    let file = at.join("/");
    match rest.next() {
        Some(name) if file != from => Some(home(sources, &file, name)),
        _ => Some(file),
    }
}

/// The file that defines a name, through what folders hand on.
fn home(sources: &BTreeMap<String, Source>, file: &str, name: &str) -> String {
    let Some(Source { is_hub: true, code }) = sources.get(file) else { return file.to_string() };
    for import in code.split("use ").skip(1) {
        let import = import.split(';').next().unwrap_or_default();
        let import: String = import.split_whitespace().collect::<Vec<_>>().join(" ");
        for path in expanded(&import) {
            let last = path.rsplit([':', ' ']).next().unwrap_or_default();
            if last == name
                && let Some(found) = resolved(sources, file, &path).filter(|found| found != file)
            {
                return found;
            }
        }
    }
    file.to_string()
}
