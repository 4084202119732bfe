//! Folders that are written into. What lies behind a link is somebody else's: nothing is written through one that the user has
//! not named.

use std::fs;
use std::io::{self, ErrorKind};
use std::path::{Path, PathBuf};

/// Makes a folder in a folder of results, unless it is there.
///
/// # Errors
/// There is a link or a file of this name, or what the file system reports.
pub fn make(path: &Path) -> io::Result<()> {
    match fs::create_dir(path) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => match fs::symlink_metadata(path)? {
            data if data.is_dir() => Ok(()),
            data if data.is_symlink() => Err(link(path, "remove it, or choose another folder with `-o`")),
            _ => Err(error),
        },
        made => made,
    }
}

/// The path of a folder for results in another one.
///
/// # Errors
/// A part of `inner`, which no user has named, is a link.
pub fn below(outer: &Path, inner: &Path) -> io::Result<PathBuf> {
    let mut path = outer.to_path_buf();
    for part in inner {
        path.push(part);
        if path.is_symlink() {
            return Err(link(&path, "name the folder that is meant with `-o`"));
        }
    }
    Ok(path)
}

fn link(path: &Path, hint: &str) -> io::Error {
    let message = format!("{} is a link, and nothing is written through it\nhint: {hint}", path.display());
    io::Error::new(ErrorKind::InvalidInput, message)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_made_once_and_a_file_is_none() {
        let folder = tempfile::tempdir().unwrap();
        let inner = folder.path().join("inner");
        make(&inner).unwrap();
        make(&inner).unwrap();
        assert_eq!(below(folder.path(), Path::new("inner/most")).unwrap(), inner.join("most"));
        fs::write(folder.path().join("file"), "").unwrap();
        assert_eq!(make(&folder.path().join("file")).unwrap_err().kind(), ErrorKind::AlreadyExists);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_not_written_through() {
        let folder = tempfile::tempdir().unwrap();
        let (outer, inner) = (folder.path().join("outer"), folder.path().join("outer/inner"));
        fs::create_dir(&outer).unwrap();
        for target in [folder.path().join("elsewhere"), folder.path().to_path_buf()] {
            std::os::unix::fs::symlink(&target, &inner).unwrap();
            assert!(make(&inner).unwrap_err().to_string().contains("is a link"));
            assert!(below(&outer, Path::new("inner/most")).unwrap_err().to_string().contains("`-o`"));
            fs::remove_file(&inner).unwrap();
        }
    }
}
