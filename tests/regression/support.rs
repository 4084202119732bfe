//! Files of the repository.

use peristat::run::{RunOptions, taking};
use peristat::summary::Summary;
use peristat::{Error, Loaded};
use std::fs;
use std::path::{Path, PathBuf};

/// Root of the repository.
pub(crate) fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package.ancestors().nth(2).expect("a package is in crates").to_path_buf()
}

/// All files below a folder whose names end like this, sorted; none where the folder is missing.
pub(crate) fn files(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten() {
        let path = entry.expect("the entry can be read").path();
        if path.is_dir() {
            found.extend(files(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// Path of a file from the root of the repository.
pub(crate) fn short(path: &Path) -> String {
    let path = path.strip_prefix(root()).unwrap_or(path);
    path.display().to_string()
}

/// Cases that are to run: all but the invalid ones.
pub(crate) fn gallery() -> Vec<PathBuf> {
    let mut cases = files(&root().join("cases"), ".json");
    cases.retain(|case| {
        !case.starts_with(root().join("cases/invalid")) && !case.to_string_lossy().ends_with(".study.json")
    });
    cases
}

/// A case of the gallery.
pub(crate) fn load(case: &Path) -> Loaded {
    Loaded::read(case, &[], None).unwrap_or_else(|error| panic!("{error}"))
}

/// The record of a run of a case.
pub(crate) fn solve(case: &Path) -> Summary {
    try_solve(case).unwrap_or_else(|error| panic!("{}: {error}", short(case)))
}

/// The same, or why there is none.
pub(crate) fn try_solve(case: &Path) -> Result<Summary, Error> {
    let options = RunOptions { recover: false, max_memory: None, compare: false };
    Loaded::read(case, &[], None)?.run(&options, None, &mut taking(|_| Ok(())))
}
