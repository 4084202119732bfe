//! Which folders a run may write into, and that no two write into one at once.

use super::files::{OWN, is_finished, is_leftover, names_in};
use super::pictures::is_picture;
use super::{inputs, restart};
use crate::input::file;
use crate::output::lock::{Hold, Lock};
use crate::scene::INPUTS;
use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Name of the file that marks a folder as written by peristat; whoever writes into the folder holds a lock on it.
pub const MARK: &str = ".peristat";

/// A folder that one run writes into, and no other one until this is dropped. If nothing came of it, it leaves no folder.
#[derive(Debug)]
pub struct Claim {
    folder: PathBuf,
    /// Whether the folder was made for this.
    is_new: bool,
    /// The case file that the run is of, as the mark names it; empty if it is of none.
    case: String,
    mark: Lock,
}

impl Claim {
    /// A folder that is made for a run, is empty, or holds a finished run of the same case file; with `force` one that holds
    /// something else, too.
    ///
    /// # Errors
    /// The folder holds another run or something that peristat did not write, another run writes into it, or it cannot
    /// be made; each but the last with a hint.
    pub fn new(folder: &Path, force: bool, case: Option<&Path>) -> io::Result<Self> {
        let case = case.map_or(String::new(), |case| case.display().to_string());
        let marked = fs::read_to_string(folder.join(MARK));
        let is_same = !case.is_empty() && marked.is_ok_and(|marked| marked == case);
        if !folder.join(MARK).exists() {
            vacant(folder, force, is_same)?;
        }
        let is_new = !folder.exists();
        let describe = |error: io::Error| {
            io::Error::new(error.kind(), format!("cannot write {}: {error}", folder.display()))
        };
        fs::create_dir_all(folder).map_err(describe)?;
        let claim = Self { folder: folder.into(), is_new, case, mark: mark(folder)? };
        // What is in a folder is certain only when nobody else writes there.
        vacant(folder, force, is_same)?;
        Ok(claim)
    }

    /// Writes into the mark which case file the run is of that the folder is about to hold.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn sign(&self) -> io::Result<()> {
        self.mark.write(&self.case)
    }

    /// A folder that a run has written into.
    ///
    /// # Errors
    /// Another run writes into it; the mark cannot be opened.
    pub(super) fn again(folder: &Path) -> io::Result<Self> {
        Ok(Self { folder: folder.into(), is_new: false, case: String::new(), mark: mark(folder)? })
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// Whether a path is that of a file which a run writes into the folder, or lies where one writes.
    pub fn writes(&self, path: &Path) -> bool {
        let outer = path.parent().filter(|outer| !outer.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let (Ok(outer), Ok(folder)) = (outer.canonicalize(), self.folder.canonicalize()) else {
            return false;
        };
        let place = outer.join(path.file_name().unwrap_or_default());
        let first = place.strip_prefix(folder).ok().and_then(|inner| inner.iter().next()?.to_str());
        first.is_some_and(|name| name == MARK || OWN.contains(&name))
    }
}

impl Drop for Claim {
    fn drop(&mut self) {
        let came_to_nothing = || names_in(&self.folder).is_ok_and(|names| names == [MARK]);
        if self.is_new && came_to_nothing() {
            // An empty folder that stays does no harm.
            let _ = fs::remove_file(self.folder.join(MARK)).and_then(|()| fs::remove_dir(&self.folder));
        }
    }
}

/// Locks the mark of a folder.
fn mark(folder: &Path) -> io::Result<Lock> {
    let place = folder.display();
    match Lock::take(&folder.join(MARK), Hold::Alone) {
        Ok(Some(lock)) => Ok(lock),
        Ok(None) => refuse(format!(
            "another peristat is writing into {place}\nhint: choose another folder with `-o`, or wait until it has ended"
        )),
        Err(error) => Err(io::Error::new(error.kind(), format!("cannot write {place}: {error}"))),
    }
}

fn refuse<T>(message: String) -> io::Result<T> {
    Err(io::Error::new(ErrorKind::AlreadyExists, message))
}

/// Whether a run may write into a folder without loss: it is not there, empty, or given up.
fn vacant(folder: &Path, force: bool, is_same: bool) -> io::Result<()> {
    let place = folder.display();
    if folder.exists() && !folder.is_dir() {
        return refuse(format!("{place} is a file, not a folder\nhint: choose a folder with `-o`"));
    }
    let in_the_way =
        |name: &&&str| !is_part(name) && folder.join(name).symlink_metadata().is_ok_and(|data| data.is_dir());
    if let Some(name) = OWN.iter().find(in_the_way) {
        return refuse(format!(
            "{place} holds a folder `{name}`, where a file of this name belongs\nhint: choose another folder with `-o`"
        ));
    }
    if !folder.exists() || force {
        return Ok(());
    }
    if let Some(name) = foreign(folder)? {
        return refuse(format!(
            "{place} holds {name}\nhint: choose another folder with `-o`, or add `--force`"
        ));
    }
    let has = |name: &str| folder.join(name).exists();
    if !names_in(folder)?.iter().any(|name| name != MARK && !is_leftover(name)) {
        return Ok(());
    }
    let finished = is_finished(folder);
    if finished && is_same {
        return Ok(());
    }
    let state = if finished { "a finished" } else { "an unfinished" };
    let of = title(folder).map_or(String::new(), |title| format!(" of `{title}`"));
    let resume = match has(restart::FILE) && !finished {
        true => "; `peristat run` goes on with it if `--resume` is added",
        false => "",
    };
    refuse(format!(
        "{place} holds {state} run{of}\n\
         hint: choose another folder with `-o`, or add `--force` to replace it{resume}"
    ))
}

/// What is in a folder that no run wrote, in words.
fn foreign(folder: &Path) -> io::Result<Option<String>> {
    let names = names_in(folder)?;
    let marked = names.iter().any(|name| name == MARK);
    if marked && names.iter().any(|name| name == "tasks") {
        return Ok(Some("a study".into()));
    }
    let own = |name: &str| OWN.contains(&name) || is_leftover(name);
    let mut found = names.into_iter().find(|name| name != MARK && !(marked && own(name)));
    for part in PARTS.into_iter().chain([INPUTS]) {
        let path = folder.join(part);
        if found.is_none() && path.is_dir() {
            let inside = names_in(&path)?.into_iter().find(|name| !is_of_part(folder, part, name));
            found = inside.map(|name| format!("{part}/{name}"));
        }
    }
    Ok(found.map(|name| format!("`{name}`, which peristat did not write")))
}

/// Folders in that of every run.
pub(super) const PARTS: [&str; 2] = ["fields", "plots"];

/// Whether this is the name of a folder in that of a run.
pub(super) fn is_part(name: &str) -> bool {
    name == INPUTS || PARTS.contains(&name)
}

/// Whether a run writes files of such a name into a folder of its folder.
pub(super) fn is_of_part(folder: &Path, part: &str, name: &str) -> bool {
    is_leftover(name)
        || match part {
            "fields" => name.starts_with("step_"),
            INPUTS => inputs::wrote(folder, name),
            _ => is_picture(name),
        }
}

/// Title of the case that a folder is of.
fn title(folder: &Path) -> Option<String> {
    let case = file::read(&folder.join("case.json"), Some(file::LARGEST_RECORD)).ok()?;
    let case: serde_json::Value = serde_json::from_slice(&case).ok()?;
    Some(plain(case.get("title")?.as_str()?))
}

/// A title as a part of a message: on one line, of moderate length.
pub(crate) fn plain(title: &str) -> String {
    title.chars().take(80).map(|c| if c.is_control() { ' ' } else { c }).collect()
}
