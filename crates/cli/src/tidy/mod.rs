//! `fmt`: files with the layout of the gallery. Every word, number and comment stays as it is written.

mod layout;
mod tokens;
mod tree;

use super::args::Global;
use super::{DONE, FAILED, USAGE, complain, say};
use peristat::Error;
use peristat::case::read_text;
use peristat::diagnostic::{Report, decode, parse};
use peristat::output::atomic::write_atomically;
use serde_json::{Value, json};
use std::fs;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// The name of stdin on the command line.
const STDIN: &str = "-";

/// Tidies files in place, or says which are not tidy.
pub(super) fn fmt(files: &[PathBuf], is_check: bool, global: &Global) -> Result<u8, Error> {
    let mut code = DONE;
    let mut all = Vec::new();
    for file in files {
        let name = file.display().to_string();
        let found = match name == STDIN {
            true => pass(is_check),
            false => one(file, is_check, global),
        };
        let outcome = match found {
            Ok(true) => json!({ "case": name, "tidy": true }),
            Ok(false) => {
                code = code.max(if is_check { FAILED } else { DONE });
                if !global.json && !global.quiet && (is_check || name != STDIN) {
                    say(&if is_check {
                        format!("{name} is not tidy\n")
                    } else {
                        format!("tidied {name}\n")
                    })?;
                }
                json!({ "case": name, "tidy": false })
            }
            Err(error) => {
                code = USAGE;
                if !global.json {
                    complain(&error, global);
                }
                json!({ "case": name, "error": error.text(), "faults": error.records() })
            }
        };
        all.push(outcome);
    }
    if global.json && !files.iter().any(|file| file.as_os_str() == STDIN && !is_check) {
        say(&format!("{:#}\n", Value::from(all)))?;
    }
    Ok(code)
}

/// Tidies stdin to stdout; returns whether it was tidy.
fn pass(is_check: bool) -> Result<bool, Error> {
    let mut bytes = Vec::new();
    io::stdin().lock().read_to_end(&mut bytes)?;
    let text = decode("stdin", bytes)?;
    let tidied = tidied("stdin", &text)?;
    if !is_check {
        say(&tidied)?;
    }
    Ok(tidied == text)
}

/// Tidies a file in place; returns whether it was tidy. A link stays one, and who may read the file still may.
fn one(file: &Path, is_check: bool, global: &Global) -> Result<bool, Error> {
    let text = read_text(file, global.max_memory)?;
    let tidied = tidied(&file.display().to_string(), &text)?;
    let is_tidy = tidied == text;
    if !is_tidy && !is_check {
        let place = file.canonicalize()?;
        let permissions = fs::metadata(&place)?.permissions();
        if permissions.readonly() {
            let message = format!("{} may not be written", file.display());
            return Err(io::Error::new(io::ErrorKind::PermissionDenied, message).into());
        }
        write_atomically(&place, tidied.as_bytes())?;
        fs::set_permissions(&place, permissions)?;
    }
    Ok(is_tidy)
}

/// A text with a tidy layout and the line ends that it has.
fn tidied(file: &str, text: &str) -> Result<String, Report> {
    parse::<Value>(file, text)?;
    let unix = text.replace("\r\n", "\n");
    let tidied = match tree::tree(&unix) {
        Some((root, last)) => layout::layout(&root, &last),
        None => return Ok(text.into()),
    };
    Ok(if unix.len() < text.len() { tidied.replace('\n', "\r\n") } else { tidied })
}

#[cfg(test)]
mod tests;
