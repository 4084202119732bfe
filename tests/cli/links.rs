//! Links of the documents: every file, picture and heading that one of them names is there.

use super::support::{files, root};
use std::fs;
use std::path::{Path, PathBuf};

/// A text without its fenced blocks.
fn prose(text: &str) -> String {
    let parts = text.split("\n```").step_by(2);
    parts.collect::<Vec<_>>().join("\n")
}

/// Targets of the links and pictures of a text that lie in the repository.
fn targets(text: &str) -> Vec<String> {
    let all = text.split("](").skip(1).filter_map(|rest| rest.split_once(')')).map(|(target, _)| target);
    all.filter(|target| !target.contains("://")).map(ToString::to_string).collect()
}

/// The name under which a heading is linked.
fn anchor(heading: &str) -> String {
    let kept = heading
        .to_lowercase()
        .chars()
        .filter(|c| c.is_alphanumeric() || " -_".contains(*c))
        .collect::<String>();
    kept.trim().replace(' ', "-")
}

/// What is wrong with a link of a document.
fn fault(document: &Path, target: &str) -> Option<String> {
    let (file, heading) = target.split_once('#').unwrap_or((target, ""));
    let path = if file.is_empty() { document.to_path_buf() } else { document.parent()?.join(file) };
    let Ok(path) = path.canonicalize() else { return Some(format!("{target} is not there")) };
    let is_page = path.extension().is_some_and(|ending| ending == "md");
    let book = root().join("docs/src").canonicalize().ok()?;
    if document.starts_with(root().join("docs/src")) && is_page && !path.starts_with(book) {
        return Some(format!(
            "{target} is no page of the book, which would lead nowhere there: link its folder"
        ));
    }
    if heading.is_empty() {
        return None;
    }
    let text = prose(&fs::read_to_string(&path).ok()?);
    let headings =
        text.lines().filter(|line| line.starts_with('#')).map(|line| anchor(line.trim_start_matches('#')));
    (!headings.into_iter().any(|own| own == heading)).then(|| format!("{target}: no such heading"))
}

fn documents() -> Vec<PathBuf> {
    let mut documents = files(&root().join("docs/src"), ".md");
    documents.extend(
        ["README.md", "CONTRIBUTING.md", "cases/README.md", "bench/README.md"].map(|name| root().join(name)),
    );
    documents
}

#[test]
fn every_link_and_picture_of_the_documents_is_there() {
    let mut wrong = Vec::new();
    for document in documents() {
        let text = prose(&fs::read_to_string(&document).unwrap());
        let found = targets(&text);
        wrong.extend(
            found.iter().filter_map(|t| fault(&document, t)).map(|f| format!("{}: {f}", document.display())),
        );
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_page_is_in_the_contents_of_the_book() {
    let source = root().join("docs/src");
    let contents = targets(&fs::read_to_string(source.join("SUMMARY.md")).unwrap());
    for page in files(&source, ".md") {
        let name = page.strip_prefix(&source).unwrap().display().to_string();
        assert!(name == "SUMMARY.md" || contents.contains(&name), "{name} is not in SUMMARY.md");
    }
}

#[test]
fn a_link_that_leads_nowhere_is_found() {
    let page = root().join("docs/src/models/frames.md");
    let found = |target: &str| fault(&page, target).is_some();
    assert!(!found("../tutorial.md#8-a-gate") && !found("../../images/tube_w.svg") && !found("#equation"));
    assert!(found("tutorial.md") && found("../tutorial.md#9-a-gate") && found("../../../README.md"));
    assert_eq!(targets("a [b](c.md) ![d](e.svg) [f](https://g.h)"), ["c.md", "e.svg"]);
}
