//! The files of a run: their names, and clearing them away.

use super::kept::FieldFiles;
use super::{claim, curve, inputs, report, restart};
use crate::case::FieldName;
use crate::output::{atomic, csv};
use crate::scene::{INPUTS, Scene};
use crate::units::Units;
use std::fs;
use std::io;
use std::path::Path;

/// What peristat writes into a folder.
pub(super) const OWN: [&str; 11] = [
    "case.json",
    INPUTS,
    "fields",
    "fields.pvd",
    "history.csv",
    curve::FILE,
    "envelope.csv",
    "plots",
    report::FILE,
    restart::FILE,
    SUMMARY,
];

/// What is written last.
pub(super) const SUMMARY: &str = "summary.json";

/// Whether a folder holds a run that nothing can go on with: one that is done, or was interrupted and left no restart.
pub(super) fn is_finished(folder: &Path) -> bool {
    folder.join(SUMMARY).exists() && !folder.join(restart::FILE).exists()
}

/// A column of a table.
pub(super) type Column = (&'static str, Vec<f64>);

/// Unit of a column of a place or a field, or of one of its sides, in the units of a case; empty if it has none.
pub(super) fn unit(column: &str, units: Units) -> &'static str {
    if ["s", "x", "y", "z"].contains(&column) {
        return units.length();
    }
    let sides = ["_left", "_smallest", "_largest"];
    let column = sides.iter().find_map(|side| column.strip_suffix(side)).unwrap_or(column);
    let lines = [FieldName::of_beam(true, true), FieldName::of_beam(false, true)];
    let all = lines.into_iter().chain([&FieldName::BODY[..], &FieldName::PLATE[..]]).flatten();
    let found = all.into_iter().find(|field| field.name() == column);
    found.map_or("", |field| field.about().unit.label(units))
}

/// Writes columns of places and fields as a table, with their units in the units of a case.
///
/// # Errors
/// What the file system reports.
pub(super) fn write_table(file: &Path, units: Units, columns: &[(&str, &[f64])]) -> io::Result<()> {
    let heads: Vec<String> = columns.iter().map(|(name, _)| csv::head(name, unit(name, units))).collect();
    let headed: Vec<(&str, &[f64])> =
        heads.iter().zip(columns).map(|(head, (_, values))| (head.as_str(), *values)).collect();
    csv::write(file, &headed)
}

/// Whether a file is one that was being written when its run was killed.
pub(super) fn is_leftover(name: &str) -> bool {
    name.starts_with('.') && name.ends_with(".part")
}

/// Removes what was being written in a folder when its run was killed.
pub(crate) fn sweep(folder: &Path) -> io::Result<()> {
    let leftover = names_in(folder)?.into_iter().filter(|name| is_leftover(name));
    leftover.map(|name| folder.join(name)).try_for_each(fs::remove_file)
}

/// Removes an earlier run from a folder, and nothing else.
pub(super) fn clear(folder: &Path) -> io::Result<()> {
    // The mark of a finished run goes first, so that an interrupted replacement cannot look finished.
    for name in OWN.iter().rev() {
        let path = folder.join(name);
        match path.symlink_metadata() {
            // Where a run writes a file, a folder is somebody else's.
            Ok(data) if data.is_dir() && !claim::is_part(name) => {}
            Ok(data) if data.is_dir() => {
                let own = names_in(&path)?.into_iter().filter(|file| claim::is_of_part(folder, name, file));
                own.map(|file| path.join(file)).try_for_each(fs::remove_file)?;
            }
            Ok(_) => fs::remove_file(&path)?,
            Err(_) => {}
        }
    }
    sweep(folder)
}

/// The table and the grid of a state, as far as they are written.
pub(super) fn fields(index: usize, files: FieldFiles) -> impl Iterator<Item = String> {
    files.extensions().map(move |extension| format!("fields/{}.{extension}", step_name(index)))
}

/// The first of some files that is not in a folder.
pub(super) fn lost(folder: &Path, files: impl IntoIterator<Item = String>) -> Option<String> {
    files.into_iter().find(|file| !folder.join(file).is_file())
}

/// Names of what a folder holds.
pub(super) fn names_in(folder: &Path) -> io::Result<Vec<String>> {
    fs::read_dir(folder)?.map(|entry| Ok(entry?.file_name().to_string_lossy().into_owned())).collect()
}

/// First part of the names of the files of a state.
pub(super) fn step_name(index: usize) -> String {
    format!("step_{index:03}")
}

/// A state in the collection: its time, which is the load factor of a step, the number of a load case or equilibrium; and
/// its grid.
pub(super) fn step(scene: &Scene, index: usize, load_factor: f64) -> (f64, String) {
    let time = if scene.case().steps.is_some() { load_factor } else { index as f64 };
    (time, format!("fields/{}.vtu", step_name(index)))
}

/// Writes `case.json` and the files that it names.
pub(super) fn write_case(folder: &Path, scene: &Scene) -> io::Result<()> {
    inputs::write(folder, scene)?;
    let case = serde_json::to_string_pretty(scene.case())?;
    atomic::write_atomically(&folder.join("case.json"), format!("{case}\n").as_bytes())
}
