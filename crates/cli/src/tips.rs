//! What a command line that is refused may have meant.

use super::args::Arguments;
use clap::CommandFactory;
use clap::error::{ContextKind, ContextValue, Error};
use std::path::Path;

/// A refusal with a tip, where the word in place of a command is a case, or a command whose letters are not in order.
pub(super) fn with_tip(mut refusal: Error) -> Error {
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
            let refusal = with_tip(Arguments::try_parse_from(["peristat", word]).unwrap_err());
            let found =
                refusal.to_string().lines().find(|line| line.contains("tip:")).map(|l| l.trim().to_string());
            assert_eq!(found.as_deref(), tip, "{word}");
        }
    }
}
