//! The inputs that the fuzzer keeps, once more: none brings the readers or the resolution of cases down.

use super::entry::{fills, reads, resolves};
use std::fs;
use std::path::{Path, PathBuf};

/// Inputs of a target of the fuzzer.
fn corpus(target: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../fuzz/corpus").join(target);
    let entries = fs::read_dir(folder).expect("a corpus");
    let found: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    assert!(found.len() > 30, "the corpus of {target} has only {} inputs", found.len());
    found
}

#[test]
fn cases_of_the_corpus_are_resolved_or_refused() {
    let resolved = corpus("case").iter().filter(|file| resolves(fs::read(file).expect("a file"))).count();
    // Most inputs are faulty; those that are not reach the end.
    assert!(resolved > 10, "{resolved} were resolved");
}

#[test]
fn files_of_the_corpus_are_read_or_refused() {
    let read = corpus("mesh").iter().filter(|file| reads(&fs::read(file).expect("a file"))).count();
    assert!(read > 5, "{read} were read");
}

#[test]
fn solids_of_the_corpus_are_filled_or_refused() {
    let filled = corpus("solid").iter().filter(|file| fills(&fs::read(file).expect("a file"))).count();
    assert!(filled > 5, "{filled} were filled");
}
