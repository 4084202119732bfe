//! Locks on files, which end with their process, however it ends.

use std::fs::{File, OpenOptions, TryLockError};
use std::io::{self, ErrorKind, Seek, Write};
use std::path::{Path, PathBuf};

/// Who else may hold a lock at the same time.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Hold {
    /// Nobody.
    Alone,
    /// All who hold it together, too.
    Together,
}

/// How often a file is opened that others remove at the same time.
const TRIES: usize = 1000;

/// A locked file.
#[derive(Debug)]
pub struct Lock {
    path: PathBuf,
    file: File,
}

impl Lock {
    /// Locks a file, which is made if it is not there; `None` if someone else has locked it. Where the file system knows no
    /// locks, everyone gets one.
    ///
    /// # Errors
    /// The file is a link, cannot be opened for writing, or is removed again and again.
    pub fn take(path: &Path, hold: Hold) -> io::Result<Option<Self>> {
        for _ in 0..TRIES {
            let Some(file) = open(path)? else { continue };
            let locked = match hold {
                Hold::Alone => file.try_lock(),
                Hold::Together => file.try_lock_shared(),
            };
            if matches!(locked, Err(TryLockError::WouldBlock)) {
                return Ok(None);
            }
            // Whoever held it may have removed the file since it was opened: its lock would be of nothing.
            if is_at(&file, path) {
                return Ok(Some(Self { path: path.into(), file }));
            }
        }
        Err(io::Error::other("it is removed again and again"))
    }

    /// Replaces what is in the file.
    ///
    /// # Errors
    /// What the file system reports.
    pub fn write(&self, text: &str) -> io::Result<()> {
        let mut file = &self.file;
        file.set_len(0)?;
        file.rewind()?;
        file.write_all(text.as_bytes())
    }

    /// The file.
    pub fn path(&self) -> &Path {
        &self.path
    }
}

/// Opens a file, which is made if it is not there; `None` if it has gone meanwhile.
fn open(path: &Path) -> io::Result<Option<File>> {
    let mut options = OpenOptions::new();
    options.write(true).read(true);
    // What is made new is never made through a link.
    match options.create_new(true).open(path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
        made => return made.map(Some),
    }
    if path.is_symlink() {
        let name = path.file_name().unwrap_or_default().display();
        let message = format!("`{name}` is a link, and nothing is written through it\nhint: remove it");
        return Err(io::Error::new(ErrorKind::InvalidInput, message));
    }
    match options.create_new(false).open(path) {
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        opened => opened.map(Some),
    }
}

/// Whether an open file is the one at a path, which is no link to it.
#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let place = |data: std::fs::Metadata| (data.dev(), data.ino());
    matches!((file.metadata().map(place), path.symlink_metadata().map(place)), (Ok(a), Ok(b)) if a == b)
}

/// Systems that keep files which are open at their place.
#[cfg(not(unix))]
fn is_at(_: &File, _: &Path) -> bool {
    true
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_locked_by_one_or_by_those_who_share_it() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lock");
        let take = |hold| Lock::take(&path, hold).unwrap();
        let alone = take(Hold::Alone).unwrap();
        assert!(take(Hold::Alone).is_none() && take(Hold::Together).is_none());
        drop(alone);
        let together = [take(Hold::Together).unwrap(), take(Hold::Together).unwrap()];
        assert!(take(Hold::Alone).is_none());
        drop(together);
        assert!(take(Hold::Alone).is_some());
        assert!(Lock::take(&folder.path().join("no/lock"), Hold::Alone).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn nothing_is_made_or_locked_through_a_link() {
        let folder = tempfile::tempdir().unwrap();
        let (link, file) = (folder.path().join("link"), folder.path().join("file"));
        std::os::unix::fs::symlink(&file, &link).unwrap();
        let refused = || Lock::take(&link, Hold::Alone).unwrap_err().to_string().contains("is a link");
        assert!(refused() && !file.exists());
        std::fs::write(&file, "").unwrap();
        assert!(refused());
        assert!(!is_at(&std::fs::File::open(&link).unwrap(), &link));
        assert!(is_at(&std::fs::File::open(&file).unwrap(), &file));
    }

    #[test]
    fn the_lock_of_a_file_that_was_removed_holds_nobody_up() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("lock");
        let first = Lock::take(&path, Hold::Alone).unwrap().unwrap();
        std::fs::remove_file(first.path()).unwrap();
        let second = Lock::take(&path, Hold::Alone).unwrap().unwrap();
        assert!(Lock::take(&path, Hold::Alone).unwrap().is_none());
        drop((first, second));
    }
}
