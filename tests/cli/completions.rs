//! Completion scripts, in the shells that there are.

use super::support::{notice, root, run};
use std::fs;
use std::path::Path;
use std::process::Command;

/// A folder with cases and other files, and the script of a shell.
fn folder(shell: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    for name in ["a case.json", "b.jsonc", "notes.txt"] {
        fs::write(folder.path().join(name), "").unwrap();
    }
    fs::create_dir(folder.path().join("below")).unwrap();
    let script = run(&root(), &["completions", shell]);
    assert_eq!(script.code, 0);
    fs::write(folder.path().join("script"), script.stdout).unwrap();
    folder
}

/// What a shell prints; nothing where it is not there.
fn answer(shell: &str, folder: &Path, script: &str) -> Option<Vec<String>> {
    let mut command = Command::new(shell);
    match shell {
        "bash" => command.args(["--norc", "--noprofile"]),
        "zsh" => command.arg("-f"),
        _ => command.arg("--no-config"),
    };
    let Ok(output) = command.current_dir(folder).args(["-c", script]).output() else {
        notice(&format!("no {shell} to complete in"));
        return None;
    };
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}\n{}", String::from_utf8_lossy(&output.stderr));
    let mut lines: Vec<String> =
        text.lines().map(|line| line.split('\t').next().unwrap().to_string()).collect();
    lines.sort();
    Some(lines)
}

/// Words before the one that is completed, what of that is there, and what is offered.
const EXPECTED: [(&str, &str, &[&str]); 5] = [
    ("run", "", &["a case.json", "b.jsonc", "below"]),
    ("check", "b", &["b.jsonc", "below"]),
    ("new", "bond_", &["bond_antiplane", "bond_plane", "bond_solid"]),
    ("list", "pro", &["probes", "profiles"]),
    ("run --fields", "l", &["last"]),
];

#[test]
fn bash_offers_cases_models_and_lists() {
    let folder = folder("bash");
    for (words, start, expected) in EXPECTED {
        let all = format!("peristat {words}");
        let previous = all.rsplit(' ').next().unwrap();
        let script = format!(
            "source ./script; COMP_WORDS=({all} '{start}'); COMP_CWORD=$((${{#COMP_WORDS[@]}} - 1)); \
             _peristat_words peristat '{start}' {previous}; printf '%s\\n' \"${{COMPREPLY[@]}}\""
        );
        let Some(found) = answer("bash", folder.path(), &script) else { return };
        assert_eq!(found, expected, "{words} {start}");
    }
}

#[test]
fn fish_offers_cases_models_and_lists() {
    let folder = folder("fish");
    for (words, start, expected) in EXPECTED {
        let script = format!("source ./script; complete -C 'peristat {words} {start}'");
        let Some(found) = answer("fish", folder.path(), &script) else { return };
        let found: Vec<&str> = found.iter().map(|word| word.trim_end_matches('/')).collect();
        let expected: Vec<String> = expected.iter().map(|word| word.replace(' ', "\\ ")).collect();
        let plain: Vec<String> =
            found.iter().map(|word| word.replace("\\ ", " ").replace(' ', "\\ ")).collect();
        assert_eq!(plain, expected, "{words} {start}");
    }
}

#[test]
fn zsh_reads_its_script_and_asks_for_cases() {
    let folder = folder("zsh");
    let script = fs::read_to_string(folder.path().join("script")).unwrap();
    for argument in ["':case -- Case file", "'*::cases -- Case files", "':study -- Study file"] {
        let line = script.lines().find(|line| line.starts_with(argument)).unwrap();
        assert!(line.contains(":_files -g \"*.(json|jsonc)\"'"), "{line}");
    }
    answer(
        "zsh",
        folder.path(),
        "autoload -U compinit && compinit -D && source ./script && whence -w _peristat",
    );
}
