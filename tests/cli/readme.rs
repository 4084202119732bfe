//! What README.md shows of the command.

use crate::support::{gallery, root, run};
use std::fs;

/// Words of the lines of an output but for those of the certificate, which hold rounding.
fn words(text: &str) -> Vec<&str> {
    let rounding = |line: &&str| {
        ["certificate of the discrete solution:", "next correction"]
            .iter()
            .any(|s| line.trim_start().starts_with(s))
    };
    let lines = text.trim_end().lines().filter(|line| !rounding(line));
    let words = lines.flat_map(|line| line.split([' ', '|']));
    words.filter(|word| !word.trim_matches('-').is_empty()).collect()
}

/// Whether two words are the same, or numbers that differ by rounding.
fn same(a: &str, b: &str) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 1e-14 + 1e-12 * b.abs(),
        _ => a == b,
    }
}

#[test]
fn the_output_in_the_readme_is_that_of_the_command() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["run", &gallery("cantilever.json"), "-o", "out"]);
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let shown = readme.split_once("under a tip load and prints").unwrap().1.split("```").nth(1).unwrap();
    let printed = outcome.stdout.split("\nresults in").next().unwrap();
    let (printed, shown) = (words(printed), words(shown.trim_start_matches("text\n")));
    assert_eq!(printed.len(), shown.len(), "{}", outcome.stdout);
    for (a, b) in printed.iter().zip(&shown) {
        assert!(same(a, b), "{a} is shown as {b}");
    }
}
