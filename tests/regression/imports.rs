//! Who imports whom among the files of the driver: no large circle of files, none of folders, and the order of the folders.

use super::modules::Modules;
use std::collections::BTreeMap;

/// Folders from the bottom upwards: each uses those before it.
const ORDER: [&str; 13] = [
    "diagnostic",
    "memory",
    "units",
    "input",
    "output",
    "reference",
    "model",
    "case",
    "scene",
    "run",
    "summary",
    "results",
    "study",
];

/// Files of a circle that are still read together.
const MOST: usize = 3;

#[test]
fn no_circle_of_imports_has_more_than_three_files() {
    let circles = Modules::of_driver().circles();
    let large: Vec<_> = circles.iter().filter(|circle| circle.len() > MOST).collect();
    assert!(large.is_empty(), "{large:#?}");
}

#[test]
fn folders_form_no_circle() {
    let circles = Modules::of_driver().folders().circles();
    assert!(circles.is_empty(), "{circles:#?}");
}

#[test]
fn folders_use_those_before_them() {
    let place: BTreeMap<&str, usize> = ORDER.iter().enumerate().map(|(k, folder)| (*folder, k)).collect();
    let modules = Modules::of_driver();
    let against: Vec<String> = modules
        .edges()
        .filter(|(from, to)| {
            let rank = |path: &str| place.get(path.split('/').next().unwrap_or_default()).copied();
            rank(from).zip(rank(to)).is_some_and(|(from, to)| from < to)
        })
        .map(|(from, to)| format!("{from} uses {to}"))
        .collect();
    assert!(against.is_empty(), "{against:#?}");
}

/// The reader of imports sees what it should.
#[test]
fn imports_are_followed_to_the_file_of_a_name() {
    let text = |name: &str| match name {
        "a/mod" => "mod b;\nmod c;\npub use b::B;\n",
        "a/b" => "use super::c::{C, d};\npub struct B;\n#[cfg(test)]\nmod tests { use crate::e::E; }\n",
        "a/c" => "// use crate::e::E;\npub fn c() { crate::e::f(); }\n",
        _ => "use crate::a::B;\npub struct E;\n",
    };
    let modules =
        Modules::new(["a/mod", "a/b", "a/c", "e"].map(|name| (name.to_string(), text(name).to_string())));
    let found: Vec<(&str, &str)> = modules.edges().collect();
    assert_eq!(found, [("a", "a/b"), ("a/b", "a/c"), ("a/c", "e"), ("e", "a/b")]);
    assert_eq!(modules.circles(), [["a/b", "a/c", "e"]]);
}
