//! What a command line that is refused may have meant.

use super::args::Arguments;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue, Error};
use std::ffi::OsString;
use std::path::Path;

/// A refusal with a tip, where the word in place of a command is a case, or a command whose letters are not in order, or where a
/// replaced value of the `given` arguments has a blank for its `=`.
pub(super) fn with_tip(mut refusal: Error, given: &[OsString]) -> Error {
    if let Some(ContextValue::String(word)) = refusal.get(ContextKind::InvalidArg) {
        if let Some(tip) = of_override(word, given) {
            refusal.remove(ContextKind::SuggestedArg);
            refusal.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
        }
        return refusal;
    }
    let word = match refusal.get(ContextKind::InvalidSubcommand) {
        Some(ContextValue::String(word)) => word.clone(),
        _ => return refusal,
    };
    if let Some(tip) = tip(&word) {
        refusal.remove(ContextKind::SuggestedSubcommand);
        refusal.insert(ContextKind::Suggested, ContextValue::StyledStrs(vec![tip.into()]));
    }
    refusal
}

/// What `--set path value` should be, where the value is the word that was not expected.
fn of_override(word: &str, given: &[OsString]) -> Option<String> {
    let meant = given.windows(3).find(|w| w[0] == "--set" && w[2] == word)?;
    let path = meant[1].to_str().filter(|path| !path.contains('='))?;
    Some(format!("a value is replaced by `--set {path}={word}`"))
}

/// What a word that is no command may have meant.
fn tip(word: &str) -> Option<String> {
    let extension = Path::new(word).extension().and_then(|extension| extension.to_str());
    if matches!(extension, Some("json" | "jsonc")) {
        let command = if word.contains(".study.") { "study" } else { "run" };
        return Some(format!("`peristat {command} {word}` solves it"));
    }
    let sorted = |name: &str| {
        let mut letters: Vec<char> = name.to_lowercase().chars().collect();
        letters.sort_unstable();
        letters
    };
    let commands = Arguments::command();
    let mut names = commands.get_subcommands().map(|command| command.get_name());
    let meant = names.find(|name| sorted(name) == sorted(word))?;
    Some(format!("a similar subcommand exists: `{meant}`"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use clap::Parser;

    #[test]
    fn a_case_or_a_shuffled_command_is_understood() {
        for (word, tip) in [
            ("my.json", Some("tip: `peristat run my.json` solves it")),
            ("a.study.jsonc", Some("tip: `peristat study a.study.jsonc` solves it")),
            ("rnu", Some("tip: a similar subcommand exists: `run`")),
            ("RUN", Some("tip: a similar subcommand exists: `run`")),
            ("verfy", Some("tip: a similar subcommand exists: 'verify'")),
            ("nothing", None),
        ] {
            let refusal = with_tip(Arguments::try_parse_from(["peristat", word]).unwrap_err(), &[]);
            let found =
                refusal.to_string().lines().find(|line| line.contains("tip:")).map(|l| l.trim().to_string());
            assert_eq!(found.as_deref(), tip, "{word}");
        }
    }

    #[test]
    fn a_replaced_value_after_the_case_lacks_its_sign() {
        let tip = |words: &[&str]| {
            let given: Vec<OsString> = words.iter().map(OsString::from).collect();
            with_tip(Arguments::try_parse_from(&given).unwrap_err(), &given).to_string()
        };
        let text = tip(&["peristat", "run", "a.json", "--set", "body.line.cells", "2"]);
        assert!(text.contains("tip: a value is replaced by `--set body.line.cells=2`"), "{text}");
        let text = tip(&["peristat", "run", "a.json", "b.json"]);
        assert!(text.contains("'b.json'") && !text.contains("replaced"), "{text}");
    }
}
