//! Digests of files, to tell later whether they are as they were written.

use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io;
use std::path::Path;

/// Length, bytes, and BLAKE3 hash of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Digest {
    length: u64,
    hash: [u8; blake3::OUT_LEN],
}

impl Digest {
    /// That of a file.
    ///
    /// # Errors
    /// What the file system reports.
    pub(super) fn of(path: &Path) -> io::Result<Self> {
        let (file, mut hasher) = (File::open(path)?, blake3::Hasher::new());
        let length = file.metadata()?.len();
        hasher.update_reader(file)?;
        Ok(Self { length, hash: *hasher.finalize().as_bytes() })
    }

    /// Whether a regular file has it; one of another length is not read.
    pub(super) fn is_of(&self, path: &Path) -> bool {
        let fits = path.metadata().is_ok_and(|data| data.is_file() && data.len() == self.length);
        fits && Self::of(path).is_ok_and(|found| found == *self)
    }
}
