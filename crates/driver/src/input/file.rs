//! Reading a file as a whole: only one that has an end and fits into memory.

use crate::memory;
use std::fs;
use std::io::{self, ErrorKind, Read};
use std::path::Path;

/// The largest record of an earlier run that is looked into, bytes: whoever sent the folder may have put anything there.
pub(crate) const LARGEST_RECORD: u64 = 256 << 20;

/// Why a file gives no bytes.
#[derive(Debug)]
pub struct Refusal {
    /// What is said of the file, such as `does not exist`.
    pub reason: String,
    /// What to do about it, where that is not to mend its name.
    pub hint: Option<&'static str>,
}

impl From<io::Error> for Refusal {
    fn from(error: io::Error) -> Self {
        let reason = match error.kind() {
            ErrorKind::NotFound => "does not exist".into(),
            _ => format!("cannot be read: {error}"),
        };
        Self { reason, hint: None }
    }
}

/// The bytes of a regular file that fits into the memory that may be used.
///
/// # Errors
/// It is none, is too large, or cannot be read.
pub fn read(path: &Path, max_memory: Option<u64>) -> Result<Vec<u8>, Refusal> {
    let kind = fs::metadata(path)?;
    let most = memory::allowed_for(kind.len(), max_memory);
    let refuse = |reason: &str, hint| Err(Refusal { reason: reason.into(), hint });
    let large = || Refusal {
        reason: format!("is larger than the {} of memory that may be used", memory::words(most)),
        hint: Some("raise `--max-memory`"),
    };
    match (kind.is_dir(), kind.is_file()) {
        (true, _) => return refuse("is a folder", None),
        // A device or a pipe may have no end.
        (_, false) => return refuse("is no regular file", Some("name a file that lies on a disk")),
        _ if kind.len() > most => return Err(large()),
        _ => {}
    }
    let mut bytes = Vec::new();
    fs::File::open(path)?.take(most.saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as u64 > most { Err(large()) } else { Ok(bytes) }
}
