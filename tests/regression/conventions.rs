//! Rules of the repository that no compiler checks.

use super::support::{files, root, short};
use std::fs;
use std::path::Path;

/// Modules of `peristat-assembly`: each uses only what stands before it.
const LAYERS: [&str; 13] = [
    "sum",
    "quadrature",
    "recovery",
    "law",
    "material",
    "bonds",
    "body",
    "condition",
    "stiffness",
    "model",
    "correction",
    "system",
    "cubic",
];

/// Lines of code of a file up to its tests.
fn code(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).unwrap();
    let text = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = text.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.map(ToString::to_string).collect()
}

/// Modules of the own crate that a line names.
fn modules(line: &str) -> Vec<&str> {
    let word = |rest: &'_ str| rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    line.split("crate::").skip(1).map(|rest| &rest[..word(rest)]).collect()
}

#[test]
fn modules_of_a_line_are_found() {
    assert_eq!(modules("use crate::bonds::{Mat, Rows};"), ["bonds"]);
    assert_eq!(modules("    let x: crate::model::A = crate::system::b(1);"), ["model", "system"]);
    assert_eq!(modules("use std::fmt;"), Vec::<&str>::new());
}

#[test]
fn a_module_of_the_mechanics_uses_only_what_stands_to_its_left() {
    let source = root().join("crates/assembly/src");
    let files = files(&source, ".rs");
    assert!(files.len() > 20, "found only {} files", files.len());
    let place = |name: &str| LAYERS.iter().position(|l| *l == name);
    for file in files {
        let inside = file.strip_prefix(&source).unwrap();
        if inside.components().any(|c| c.as_os_str() == "tests") {
            continue;
        }
        let first = inside.components().next().unwrap();
        let own = first.as_os_str().to_string_lossy().trim_end_matches(".rs").to_string();
        let Some(own_place) = place(&own) else {
            assert!(["lib", "register"].contains(&own.as_str()), "{own} is in no layer");
            continue;
        };
        for line in code(&file) {
            for used in modules(&line) {
                let right = place(used).is_some_and(|used| used > own_place);
                assert!(
                    !right,
                    "{} uses `{used}`, which stands to the right of `{own}`: {line}",
                    short(&file)
                );
            }
        }
    }
}

#[test]
fn mechanics_and_algebra_know_neither_each_other_nor_the_driver() {
    // Numbers and loops, which both need, know nothing.
    for (name, known) in [
        ("assembly", &["peristat-vector.workspace = true"][..]),
        ("solve", &["peristat-vector.workspace = true"]),
        ("vector", &[]),
    ] {
        let manifest = root().join("crates").join(name).join("Cargo.toml");
        let text = fs::read_to_string(&manifest).unwrap();
        let own: Vec<&str> = text.lines().filter(|line| line.trim_start().starts_with("peristat")).collect();
        assert_eq!(own, known, "{}", short(&manifest));
    }
}

/// What names a model of bodies in the plane: its key in cases, and its types.
fn names_of(model: &str) -> [String; 2] {
    let capital = |word: &str| word[..1].to_uppercase() + &word[1..];
    [model.to_string(), model.split('_').map(capital).collect()]
}

/// The model that a file is about: one with scenes of its own has a folder, or a file, in every folder of the driver.
fn own_model(file: &str) -> Option<&'static str> {
    let is_of_plates = |part: &str| ["plate", "plate.rs", "plate_forces.rs"].contains(&part);
    file.split('/').any(is_of_plates).then_some("plate_bending")
}

#[test]
fn only_its_own_folder_names_a_model() {
    let source = root().join("crates/driver/src");
    let models =
        peristat::model::TABLE.iter().map(|entry| entry.name).filter(|name| *name != "timoshenko_beam");
    let models: Vec<&str> = models.collect();
    assert!(models.len() > 3, "{models:?}");
    for file in files(&source, ".rs") {
        let inside = short(&file).replace('\\', "/");
        // The table of models, and the models themselves.
        if inside.contains("/src/model/") || inside.ends_with("tests.rs") || inside.contains("/tests/") {
            continue;
        }
        let own = own_model(&inside);
        for line in code(&file) {
            for name in models.iter().filter(|model| Some(**model) != own).flat_map(|model| names_of(model)) {
                assert!(!line.contains(&name), "{inside} names `{name}`: {line}");
            }
        }
    }
}

/// Libraries that only a command needs, and a program that builds on the library should not compile.
const OF_THE_COMMAND: [&str; 6] =
    ["clap", "clap_complete", "clap_mangen", "comfy-table", "indicatif", "signal-hook"];

#[test]
fn the_library_neither_prints_nor_knows_of_terminals_and_signals() {
    let dependencies = |name: &str| {
        let text = fs::read_to_string(root().join("crates").join(name).join("Cargo.toml")).unwrap();
        let names = text.lines().filter_map(|line| line.split_once('.').map(|(name, _)| name.to_string()));
        names.collect::<Vec<String>>()
    };
    let (library, command) = (dependencies("driver"), dependencies("cli"));
    for name in OF_THE_COMMAND {
        assert!(command.iter().any(|d| d == name), "`{name}` is not in the manifest of the command");
        assert!(!library.iter().any(|d| d == name), "the library needs `{name}`");
    }
    for file in files(&root().join("crates/driver/src"), ".rs") {
        for line in code(&file) {
            for word in
                ["println!", "eprintln!", "print!(", "eprint!(", "stdout()", "stderr()", "is_terminal"]
            {
                assert!(!line.contains(word), "{} has `{word}`: {line}", short(&file));
            }
        }
    }
}

#[test]
fn the_algebra_has_never_heard_of_a_bond() {
    for file in files(&root().join("crates/solve/src"), ".rs") {
        let text = fs::read_to_string(&file).unwrap().to_lowercase();
        for word in ["bond", "peridynamic", "horizon"] {
            assert!(!text.contains(word), "{} speaks of `{word}`", short(&file));
        }
    }
}

#[test]
fn only_the_driver_prints_reads_the_clock_and_touches_files() {
    for name in ["assembly", "solve"] {
        for file in files(&root().join("crates").join(name).join("src"), ".rs") {
            for line in code(&file) {
                for word in [
                    "println!",
                    "eprintln!",
                    "print!(",
                    "eprint!(",
                    "dbg!(",
                    "std::fs",
                    "std::time",
                    "std::io",
                ] {
                    assert!(!line.contains(word), "{} has `{word}`: {line}", short(&file));
                }
            }
        }
    }
}

/// Words of a text that are paths into the repository.
fn paths(text: &str) -> Vec<&str> {
    let separator = |c: char| c.is_whitespace() || "`()[]<>\"',;|".contains(c);
    let folders = ["crates/", "cases/", "tests/", "bench/", "docs/", "fuzz/", ".ci/"];
    let words = text.split(separator).map(|word| word.trim_start_matches("./").trim_end_matches(['.', ':']));
    words
        .filter(|word| folders.iter().any(|f| word.starts_with(f)) && !word.contains(['*', '{', '…', '$']))
        .collect()
}

#[test]
fn paths_of_a_text_are_found() {
    let text = "Run `peristat run cases/a.json`, see [bonds](crates/assembly/src/bonds.rs). Not results/x or crates/*/src.";
    assert_eq!(paths(text), ["cases/a.json", "crates/assembly/src/bonds.rs"]);
}

#[test]
fn every_path_that_a_document_names_exists() {
    let mut documents = files(&root().join("docs"), ".md");
    documents.extend(
        ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "cases/README.md", "bench/README.md"]
            .map(|name| root().join(name)),
    );
    documents.retain(|document| document.exists());
    for document in documents {
        let text = fs::read_to_string(&document).unwrap();
        for path in paths(&text) {
            assert!(root().join(path).exists(), "{} names {path}, which does not exist", short(&document));
        }
    }
}

#[test]
fn the_citation_names_the_version_of_the_workspace() {
    let citation = fs::read_to_string(root().join("CITATION.cff")).unwrap();
    let version = format!("version: {}", env!("CARGO_PKG_VERSION"));
    assert!(citation.lines().any(|line| line == version), "CITATION.cff has no line `{version}`");
}

#[test]
fn no_file_of_the_driver_is_longer_than_350_lines() {
    /// Longer ones hold more than one idea.
    const MOST: usize = 350;
    let lines = |file: &Path| fs::read_to_string(file).unwrap().lines().count();
    let source = root().join("crates/driver/src");
    let long: Vec<String> =
        files(&source, ".rs").iter().filter(|file| lines(file) > MOST).map(|file| short(file)).collect();
    assert!(long.is_empty(), "{long:#?}");
}
