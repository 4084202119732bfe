//! What the command prints of itself: the manual, and the reference of cases in the book.

use super::support::{names, root, run};
use std::env;
use std::fs;

#[test]
fn the_references_of_the_book_are_those_of_the_command() {
    for (page, arguments) in [
        ("case_reference", &["schema", "--markdown"][..]),
        ("study_reference", &["schema", "--study", "--markdown"]),
    ] {
        let outcome = run(&root(), arguments);
        assert_eq!(outcome.code, 0);
        let file = root().join(format!("docs/src/{page}.md"));
        if env::var_os("UPDATE_EXPECTED").is_some() {
            fs::write(&file, &outcome.stdout).unwrap();
        }
        let stored = fs::read_to_string(&file).unwrap_or_default();
        assert!(
            stored == outcome.stdout,
            "docs/src/{page}.md is not what `peristat {}` prints; UPDATE_EXPECTED=1 writes it anew",
            arguments.join(" ")
        );
        assert!(!stored.contains("any value"), "a type that the page cannot name");
    }
}

#[test]
fn the_manual_has_a_page_for_every_command() {
    let folder = tempfile::tempdir().unwrap();
    let outcome = run(folder.path(), &["man", "-o", "man1"]);
    assert_eq!((outcome.code, outcome.stdout.as_str()), (0, ""));
    let pages = names(&folder.path().join("man1"));
    for command in [
        "",
        "-check",
        "-completions",
        "-fmt",
        "-list",
        "-man",
        "-new",
        "-run",
        "-schema",
        "-study",
        "-verify",
    ] {
        assert!(pages.contains(&format!("peristat{command}.1")), "{command}: {pages:?}");
    }
    let page = fs::read_to_string(folder.path().join("man1/peristat-run.1")).unwrap();
    assert!(page.contains(".SH SYNOPSIS") && page.contains("write\\-matrix"), "{page}");
    let first = fs::read_to_string(folder.path().join("man1/peristat.1")).unwrap();
    assert_eq!(first.matches("(1)").count(), pages.len() - 1, "every page is named, and no other: {first}");
    let all = run(folder.path(), &["man"]).stdout;
    assert_eq!(all.matches(".TH ").count(), pages.len());
    assert!(all.contains(&page));
}
