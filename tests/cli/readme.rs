//! What README.md shows of the command.

use crate::support::{gallery, root, run};
use std::fs;

/// Lines of an output but for those of the certificate, which hold rounding.
fn lines(text: &str) -> Vec<&str> {
    let rounding =
        |line: &&str| ["certificate:", "next correction"].iter().any(|s| line.trim_start().starts_with(s));
    text.trim_end().lines().filter(|line| !rounding(line)).collect()
}

#[test]
fn the_output_in_the_readme_is_that_of_the_command() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["run", &gallery("cantilever.json"), "-o", "out"]);
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let shown = readme.split_once("under a tip load and prints").unwrap().1.split("```").nth(1).unwrap();
    let printed = outcome.stdout.split("\nresults in").next().unwrap();
    assert_eq!(lines(printed), lines(shown.trim_start_matches("text\n")));
}
