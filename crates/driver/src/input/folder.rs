//! The folder of a case, and the files in it that the case names.
//!
//! A case may come from anywhere. What it names is read only where it lies in the folder of the case, or below; links that
//! lead out of it count as outside.

use super::file::{self, Refusal};
use std::path::{Component, Path, PathBuf};

/// How far from a case the files may lie that it names.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Reach {
    /// In its folder and those below.
    #[default]
    Inside,
    /// Anywhere.
    Anywhere,
}

/// Where the files that a case names are looked for.
#[derive(Clone, Debug)]
pub struct Folder {
    path: PathBuf,
    reach: Reach,
}

/// The current folder.
impl Default for Folder {
    fn default() -> Self {
        Self::new(Path::new("."), Reach::Inside)
    }
}

impl From<&Path> for Folder {
    fn from(path: &Path) -> Self {
        Self::new(path, Reach::Inside)
    }
}

impl From<&Folder> for Folder {
    fn from(folder: &Folder) -> Self {
        folder.clone()
    }
}

const OUTSIDE: &str = "put the file beside the case, or add `--allow-outside` if you trust the case";

impl Folder {
    /// A folder, and how far beyond it files may lie.
    pub fn new(path: &Path, reach: Reach) -> Self {
        let path = if path.as_os_str().is_empty() { Path::new(".") } else { path };
        Self { path: path.into(), reach }
    }

    /// The folder of a file.
    pub fn of(file: &Path, reach: Reach) -> Self {
        Self::new(file.parent().unwrap_or(Path::new("")), reach)
    }

    /// The bytes of a regular file that fits into the memory that may be used.
    ///
    /// # Errors
    /// It lies outside, is none, is too large, or cannot be read.
    pub(crate) fn read(&self, file: &str, max_memory: Option<u64>) -> Result<Vec<u8>, Refusal> {
        file::read(&self.find(file)?, max_memory)
    }

    /// The path of a file. Names that lead outside are refused as they are written; links in a name that stays inside are
    /// followed to see where they lead, and nothing is read there.
    fn find(&self, file: &str) -> Result<PathBuf, Refusal> {
        let path = self.path.join(file);
        if self.reach == Reach::Anywhere {
            return Ok(path);
        }
        let outside = |reason: &str| Refusal { reason: reason.into(), hint: Some(OUTSIDE) };
        let home = self.path.canonicalize()?;
        let inside = Path::new(file);
        if leaves(inside.strip_prefix(&home).unwrap_or(inside)) {
            return Err(outside("lies outside the folder of the case"));
        }
        let real = path.canonicalize()?;
        match real.starts_with(&home) {
            true => Ok(real),
            false => Err(outside("is a link that leads out of the folder of the case")),
        }
    }
}

/// Whether a path goes above the folder that it starts from, or does not start from one.
fn leaves(path: &Path) -> bool {
    let depth = path.components().try_fold(0_usize, |depth, part| match part {
        Component::Normal(_) => Some(depth + 1),
        Component::CurDir => Some(depth),
        Component::ParentDir => depth.checked_sub(1),
        Component::RootDir | Component::Prefix(_) => None,
    });
    depth.is_none()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::fs;

    #[test]
    fn steps_up_leave_only_where_none_down_came_before() {
        for inside in ["a.csv", "a/b.csv", "a/../b.csv", "./a.csv", "a/b/../../c.csv", ""] {
            assert!(!leaves(Path::new(inside)), "{inside}");
        }
        for outside in ["../a.csv", "a/../../b.csv", "/a.csv", "./../a.csv", ".."] {
            assert!(leaves(Path::new(outside)), "{outside}");
        }
    }

    #[test]
    fn files_are_read_inside_and_anywhere_only_where_that_is_allowed() {
        let all = tempfile::tempdir().unwrap();
        let (case, other) = (all.path().join("case"), all.path().join("other.csv"));
        fs::create_dir_all(case.join("sub")).unwrap();
        fs::write(case.join("sub/own.csv"), "own").unwrap();
        fs::write(&other, "other").unwrap();
        let reason = |file: &str| Folder::from(&*case).read(file, None).unwrap_err().reason;
        let open = Folder::new(&case, Reach::Anywhere);
        let full = case.canonicalize().unwrap().join("sub/own.csv");
        for file in ["sub/own.csv", "sub/../sub/own.csv", &full.display().to_string()] {
            assert_eq!(Folder::from(&*case).read(file, None).unwrap(), b"own", "{file}");
            assert_eq!(open.read(file, None).unwrap(), b"own", "{file}");
        }
        for file in ["../other.csv", "sub/../../other.csv", "../none.csv", &other.display().to_string()] {
            assert_eq!(reason(file), "lies outside the folder of the case", "{file}");
        }
        assert_eq!(open.read("../other.csv", None).unwrap(), b"other");
        assert_eq!(reason("none.csv"), "does not exist");
        assert_eq!(reason("sub"), "is a folder");
        assert!(Folder::from(&*case).read("sub/own.csv", Some(2)).unwrap_err().reason.contains("larger"));
    }

    #[cfg(unix)]
    #[test]
    fn links_are_followed_inside_only() {
        use std::os::unix::fs::symlink;
        let all = tempfile::tempdir().unwrap();
        let case = all.path().join("case");
        fs::create_dir(&case).unwrap();
        fs::write(case.join("own.csv"), "own").unwrap();
        fs::write(all.path().join("other.csv"), "other").unwrap();
        symlink("own.csv", case.join("near.csv")).unwrap();
        symlink("../other.csv", case.join("far.csv")).unwrap();
        symlink("..", case.join("up")).unwrap();
        symlink("/dev/zero", case.join("zero.csv")).unwrap();
        let strict = Folder::from(&*case);
        assert_eq!(strict.read("near.csv", None).unwrap(), b"own");
        for file in ["far.csv", "up/other.csv", "zero.csv"] {
            let reason = strict.read(file, None).unwrap_err().reason;
            assert_eq!(reason, "is a link that leads out of the folder of the case", "{file}");
        }
        let open = Folder::new(&case, Reach::Anywhere);
        assert_eq!(open.read("far.csv", None).unwrap(), b"other");
        assert_eq!(open.read("zero.csv", None).unwrap_err().reason, "is no regular file");
        // A folder that is reached by a link is as good as any.
        symlink("case", all.path().join("alias")).unwrap();
        assert_eq!(Folder::from(&*all.path().join("alias")).read("own.csv", None).unwrap(), b"own");
    }
}
