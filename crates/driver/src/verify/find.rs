//! Which files of a folder are cases.

use crate::diagnostic::without_comments;
use crate::input::file;
use crate::results::MARK;
use serde::de::IgnoredAny;
use std::collections::HashMap;
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// How the names of studies end, which lie beside cases.
const STUDY: [&str; 2] = [".study.json", ".study.jsonc"];
/// Keys that a case cannot do without.
const CASE: [&str; 3] = ["title", "model", "body"];

/// JSON files at a path, sorted; folders of benchmarks and of invalid cases are entered only if they are named, those of
/// results never.
pub(super) fn collect(path: &Path, all: bool, files: &mut Vec<PathBuf>) -> io::Result<()> {
    let describe = |error: io::Error| io::Error::new(error.kind(), format!("{}: {error}", path.display()));
    if !path.is_dir() {
        fs::metadata(path).map_err(describe)?;
        files.push(path.into());
        return Ok(());
    }
    if path.join(MARK).exists() {
        return Ok(());
    }
    let entries = fs::read_dir(path).map_err(describe)?;
    let mut entries: Vec<PathBuf> = entries.map(|e| e.map(|e| e.path())).collect::<Result<_, _>>()?;
    entries.sort();
    for entry in entries {
        let name = entry.file_name().unwrap_or_default().to_string_lossy().into_owned();
        // A link to a folder may lead anywhere, round in circles, too.
        if entry.is_dir() {
            if !entry.is_symlink() && name != "invalid" && (all || name != "bench") {
                collect(&entry, all, files)?;
            }
        } else if entry.is_file() && [".json", ".jsonc"].iter().any(|end| name.ends_with(end)) {
            files.push(entry);
        }
    }
    Ok(())
}

/// What a JSON file is, if it is no case. One that cannot be read or is no JSON is a case with faults.
pub(super) fn other_than_case(path: &Path, max_memory: Option<u64>) -> Option<&'static str> {
    if STUDY.iter().any(|end| path.to_string_lossy().ends_with(end)) {
        return Some("study");
    }
    let bytes = file::read(path, max_memory).ok()?;
    let text = String::from_utf8_lossy(&bytes);
    let plain = without_comments(&text);
    let Ok(keys) = serde_json::from_str::<HashMap<String, IgnoredAny>>(&plain) else {
        // A list, say.
        return serde_json::from_str::<IgnoredAny>(&plain).is_ok().then_some("no case");
    };
    let has = |key: &&str| keys.contains_key(*key);
    if ["properties", "$defs"].iter().any(has) {
        Some("schema")
    } else if has(&"case") && !has(&"model") {
        Some("study")
    } else if ["materials", "profiles"].iter().any(has) && !has(&"model") {
        Some("library")
    } else {
        (!CASE.iter().any(has)).then_some("no case")
    }
}
