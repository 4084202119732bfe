//! `restart.bin`: what a run goes on from.
//!
//! The file is `peristat restart\n`, the version of its content, the length of that (both little-endian), the BLAKE3 hash of
//! the content, and the content itself in the format of `postcard`: what the solution goes on from, the names and digests
//! of the tables and grids that were written before, and what the report keeps of their states.

use super::digest::Digest;
use super::report::Recorded;
use crate::input::file;
use crate::output::atomic;
use crate::run::Restart;
use std::io::{self, ErrorKind};
use std::path::Path;

/// Name of the file.
pub(super) const FILE: &str = "restart.bin";

const MAGIC: &[u8; 17] = b"peristat restart\n";
/// To be raised with every change of the content, what a summary says of states among it.
const VERSION: u32 = 4;
const HASH: usize = blake3::OUT_LEN;

/// A table or grid that was written before.
pub(super) type Kept = (String, Digest);

/// What a run goes on from, tables and grids, and what the report keeps.
type Content = (Restart, Vec<Kept>, Recorded);

/// Writes what a run goes on from in place of an older file.
///
/// # Errors
/// What the file system reports; the older file is then unchanged.
pub(super) fn write(
    path: &Path,
    restart: &Restart,
    (digests, recorded): (&[Kept], &Recorded),
) -> io::Result<()> {
    let content = postcard::to_stdvec(&(restart, digests, recorded)).map_err(io::Error::other)?;
    atomic::replace(path, |file| {
        file.write_all(MAGIC)?;
        file.write_all(&VERSION.to_le_bytes())?;
        file.write_all(&(content.len() as u64).to_le_bytes())?;
        file.write_all(blake3::hash(&content).as_bytes())?;
        file.write_all(&content)
    })
}

/// Reads what a run goes on from.
///
/// # Errors
/// [`ErrorKind::InvalidData`] if the file is another one, of another version, or damaged; what the file system reports.
pub(super) fn read(path: &Path) -> io::Result<Content> {
    let bytes = file::read(path, None).map_err(|refusal| refusal.reason);
    bytes.and_then(|bytes| decode(&bytes).map_err(Into::into)).map_err(|reason| {
        let message = format!(
            "{} {reason}\nhint: add `--force` in place of `--resume` to run the case anew",
            path.display()
        );
        io::Error::new(ErrorKind::InvalidData, message)
    })
}

fn decode(bytes: &[u8]) -> Result<Content, &'static str> {
    const DAMAGED: &str = "is damaged";
    let rest = bytes.strip_prefix(MAGIC).ok_or("is not a restart of peristat")?;
    let (version, rest) = rest.split_first_chunk().ok_or(DAMAGED)?;
    if u32::from_le_bytes(*version) != VERSION {
        return Err("was written by another version of peristat");
    }
    let (length, rest) = rest.split_first_chunk().ok_or(DAMAGED)?;
    let (hash, content) = rest.split_first_chunk::<HASH>().ok_or(DAMAGED)?;
    if content.len() as u64 != u64::from_le_bytes(*length) {
        return Err("is not complete");
    }
    if blake3::hash(content) != *hash {
        return Err(DAMAGED);
    }
    postcard::from_bytes(content).map_err(|_| DAMAGED)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::run::RestartFrom;
    use crate::run::fracture::{BreakRestart, Event};
    use std::fs;

    fn restart() -> Restart {
        let values = [0.1, -0.0, 1.0 / 3.0, 5e-324, f64::MAX, -1e-7, 2.0_f64.powi(60) + 256.0];
        let event = Event { step: 3, solve: 70_000, load: 0.1 + 0.2, balance: -1e-300, ..Event::default() };
        let from = BreakRestart {
            events: vec![Event::default(), event],
            broken: vec![7, u64::MAX, 0],
            factored: 2,
            unit: values.to_vec(),
            frozen: vec![(12, values[2])],
            step: 3,
            right_hand_sides: 7,
            pcg_iterations: 81,
            target: 1.0e-9 / 3.0,
            load_factor: 1.1,
        };
        let from = RestartFrom::Break(Box::new(from));
        Restart { case: "abc".into(), summaries: "[[],[]]".into(), recorded: 4, from }
    }

    /// One of nothing.
    fn empty() -> Restart {
        let from = RestartFrom::Break(Box::default());
        Restart { case: String::new(), summaries: String::new(), recorded: 0, from }
    }

    /// Those of two files.
    fn digests(folder: &Path) -> Vec<Kept> {
        let of = |text: &str| {
            let path = folder.join("field");
            fs::write(&path, text).unwrap();
            let digest = Digest::of(&path).unwrap();
            fs::remove_file(&path).unwrap();
            (format!("fields/{text}"), digest)
        };
        vec![of(""), of("x,y\n")]
    }

    #[test]
    fn everything_reads_back_to_the_same_bits() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(FILE);
        let digests = digests(folder.path());
        write(&path, &empty(), (&[], &Recorded::default())).unwrap();
        write(&path, &restart(), (&digests, &Recorded::default())).unwrap();
        let (found, kept, _) = read(&path).unwrap();
        assert_eq!((&found, &kept[..]), (&restart(), &digests[..]));
        let unit = |restart: &Restart| match &restart.from {
            RestartFrom::Break(kept) => kept.unit.iter().map(|u| u.to_bits()).collect::<Vec<u64>>(),
            RestartFrom::Path(_) => panic!("it breaks"),
        };
        assert_eq!(unit(&found), unit(&restart()));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_file_that_is_cut_off_anywhere_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(FILE);
        let digests = digests(folder.path());
        write(&path, &restart(), (&digests, &Recorded::default())).unwrap();
        let whole = fs::read(&path).unwrap();
        for length in 0..whole.len() {
            assert!(decode(&whole[..length]).is_err(), "{length} of {}", whole.len());
        }
        assert_eq!(decode(&whole[..whole.len() - 1]), Err("is not complete"));
        fs::write(&path, &whole[..whole.len() - 1]).unwrap();
        let error = read(&path).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::InvalidData);
        assert!(error.to_string().contains("restart.bin is not complete\nhint: "), "{error}");
    }

    #[test]
    fn a_foreign_changed_or_future_file_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(FILE);
        let digests = digests(folder.path());
        write(&path, &restart(), (&digests, &Recorded::default())).unwrap();
        let whole = fs::read(&path).unwrap();
        assert_eq!(decode(b"{}"), Err("is not a restart of peristat"));
        for place in MAGIC.len()..whole.len() {
            let mut changed = whole.clone();
            changed[place] ^= 1;
            let reason = decode(&changed).unwrap_err();
            let is_version = place < MAGIC.len() + 4;
            assert_eq!(reason == "was written by another version of peristat", is_version, "byte {place}");
        }
    }
}
