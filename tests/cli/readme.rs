//! What README.md shows of its two commands.

use super::support::{root, run};
use std::fs;

/// The case that the README breaks.
const CASE: &str = "cases/orthotropic/case_b_45.json";

fn readme() -> String {
    fs::read_to_string(root().join("README.md")).unwrap()
}

/// Words of a line, without the bars and rules of tables.
fn words(line: &str) -> Vec<&str> {
    line.split([' ', '|']).filter(|word| !word.trim_matches('-').is_empty()).collect()
}

/// Whether two words are the same, or numbers that differ by rounding.
fn same(a: &str, b: &str) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) => (a - b).abs() <= 1e-14 + 1e-12 * b.abs(),
        _ => a == b,
    }
}

/// Whether two lines have the same words.
fn same_line(a: &str, b: &str) -> bool {
    let (a, b) = (words(a), words(b));
    a.len() == b.len() && a.iter().zip(&b).all(|(a, b)| same(a, b))
}

#[test]
fn the_first_command_prints_what_the_readme_shows() {
    let readme = readme();
    assert!(readme.contains(&format!("\n$ cargo run --release -- run {CASE}\n")));
    let case = root().join(CASE).display().to_string();
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["run", &case]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    let shown = readme.split_once("```text\n").unwrap().1.split("```").next().unwrap();
    assert!(shown.lines().count() > 5, "{shown}");
    for line in shown.lines() {
        assert!(
            outcome.stdout.lines().any(|l| same_line(l, line)),
            "not printed: {line}\n{}",
            outcome.stdout
        );
    }
    assert!(folder.path().join("results/case_b_45/report.html").is_file());
}

#[test]
fn the_second_command_is_the_one_of_the_gate() {
    let gate = fs::read_to_string(root().join(".ci/run")).unwrap();
    let tests = gate.lines().last().unwrap();
    assert!(tests.starts_with("cargo test"), "{tests}");
    assert!(readme().contains(&format!("\n$ {tests}\n```")), "the README does not have `{tests}`");
}
