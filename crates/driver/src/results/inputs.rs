//! The files that a case names, beside its `case.json`.

use crate::input::file;
use crate::output::{atomic, folder};
use crate::scene::{INPUTS, Scene};
use std::io;
use std::path::Path;

/// Writes them; makes no folder where there are none.
///
/// # Errors
/// What the file system reports.
pub(super) fn write(results: &Path, scene: &Scene) -> io::Result<()> {
    if scene.files().is_empty() {
        return Ok(());
    }
    folder::make(&results.join(INPUTS))?;
    let mut files = scene.files().iter();
    files.try_for_each(|file| atomic::write_atomically(&results.join(INPUTS).join(&file.name), &file.bytes))
}

/// Whether an earlier run wrote a file: its case names it.
pub(super) fn wrote(results: &Path, name: &str) -> bool {
    let case = file::read(&results.join("case.json"), Some(file::LARGEST_RECORD)).unwrap_or_default();
    let case = String::from_utf8(case).unwrap_or_default();
    serde_json::to_string(&format!("{INPUTS}/{name}")).is_ok_and(|written| case.contains(&written))
}
