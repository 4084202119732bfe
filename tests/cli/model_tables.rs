//! The tables of models in the README and the guide, made of what the models say of themselves.

use super::support::root;
use peristat::model::TABLE;
use std::{env, fs};

const HEAD: &str = "| body | model |\n|---|---|\n";

/// The rows, with links to pages in a folder.
fn rows(folder: &str) -> String {
    let of_model = TABLE.iter().flat_map(|model| model.bodies.iter().map(|body| (model.name, body)));
    of_model.map(|(name, (body, page))| format!("| {body} | [`{name}`]({folder}/{page}.md) |\n")).collect()
}

#[test]
fn tables_of_models_are_those_of_the_program() {
    for (page, folder) in [("README.md", "docs/src/models"), ("docs/src/introduction.md", "models")] {
        let file = root().join(page);
        let text = fs::read_to_string(&file).unwrap();
        let (before, after) =
            text.split_once(HEAD).unwrap_or_else(|| panic!("{page} has no table of models"));
        let rest = after.split_once("\n\n").map_or("", |(_, rest)| rest);
        let expected = format!("{before}{HEAD}{}\n{rest}", rows(folder));
        if env::var_os("UPDATE_EXPECTED").is_some() {
            fs::write(&file, &expected).unwrap();
        }
        let stored = fs::read_to_string(&file).unwrap();
        assert!(
            stored == expected,
            "the table of {page} is not that of the models; UPDATE_EXPECTED=1 writes it anew"
        );
    }
}
