//! `--open`: the report in the viewer of the system.

use super::note;
use std::path::Path;

/// Shows the report of a folder. A system without a viewer is no fault of the run.
pub(super) fn show(folder: &Path) {
    let report = folder.join("report.html");
    if let Err(error) = open::that_detached(&report) {
        note(&format!("notice: {} cannot be shown: {error}\n", report.display()));
    }
}
