//! The user guide: every command in it works, and prints what it shows.
//!
//! On every page of `docs/src`, and in the README, in order and in a folder that holds the `cases` of the repository:
//!
//! * a block `json` behind a line that begins with ``Save this as `NAME` `` becomes a file;
//! * every line of a block `sh` is run by `sh` and must end with exit code 0, or N behind a comment `# exit N`;
//! * every line of a block `output` must be a line that the block `sh` before it printed; behind `…` anything may follow;
//! * blocks `yaml`, `bash` and `python` must be parts of the files in `docs/examples`.
//!
//! Blocks `console` show commands that need more than peristat, such as `cargo`, `mdbook` or `sbatch`, and are not run.

use super::support::{files, root};
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A fenced block, and the line before it that is not blank.
struct Block {
    before: String,
    language: String,
    lines: Vec<String>,
}

/// Fenced blocks of a page.
fn blocks(text: &str) -> Vec<Block> {
    let mut found: Vec<Block> = Vec::new();
    let (mut before, mut inside) = (String::new(), false);
    for line in text.lines() {
        match (line.strip_prefix("```"), inside) {
            (Some(language), false) => {
                let (before, language) = (before.clone(), language.to_string());
                found.push(Block { before, language, lines: Vec::new() });
                inside = true;
            }
            (Some(_), true) => inside = false,
            (None, true) => found.last_mut().expect("a block is open").lines.push(line.into()),
            (None, false) if !line.trim().is_empty() => before = line.into(),
            (None, false) => {}
        }
    }
    found
}

/// The exit code that a command says it ends with.
fn expected_code(command: &str) -> i32 {
    let comment = command.rsplit_once("# exit ").and_then(|(_, code)| code.trim().parse().ok());
    comment.unwrap_or(0)
}

/// Runs a command of a page; what it printed, or what is wrong.
fn run_line(folder: &Path, line: &str) -> Result<String, String> {
    let own = Path::new(env!("CARGO_BIN_EXE_peristat")).parent().expect("the command is in a folder");
    let others = env::var_os("PATH").unwrap_or_default();
    let paths = [own.to_path_buf()].into_iter().chain(env::split_paths(&others));
    let path = env::join_paths(paths).expect("no path has a colon");
    let shell = Command::new("sh").args(["-c", line]).current_dir(folder).env("PATH", path).output();
    let output = shell.expect("a shell starts");
    let printed = [&output.stdout, &output.stderr].map(|text| String::from_utf8_lossy(text)).concat();
    let (code, expected) = (output.status.code(), expected_code(line));
    if code == Some(expected) {
        Ok(printed)
    } else {
        Err(format!("`{line}` ended with {code:?}:\n{printed}"))
    }
}

/// Whether a line of a page is one of those that were printed.
fn was_printed(line: &str, printed: &str) -> bool {
    match line.split_once('…') {
        Some((start, _)) => printed.lines().any(|p| p.starts_with(start)),
        None => printed.lines().any(|p| p.trim_end() == line.trim_end()),
    }
}

/// What is wrong with the commands of a page.
fn faults(page: &str, examples: &[String]) -> Vec<String> {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    // No link: studies read no cases through one that leads out of their folder.
    let copied = Command::new("cp").arg("-r").arg(root().join("cases")).arg(folder).status().unwrap();
    assert!(copied.success());
    let (mut faults, mut printed) = (Vec::new(), String::new());
    for block in blocks(page) {
        let text = block.lines.join("\n") + "\n";
        match block.language.as_str() {
            "json" => {
                if let Some(rest) = block.before.strip_prefix("Save this as `") {
                    let file = folder.join(rest.split('`').next().unwrap());
                    fs::create_dir_all(file.parent().unwrap()).unwrap();
                    fs::write(file, text).unwrap();
                }
            }
            "sh" => {
                printed.clear();
                for line in &block.lines {
                    match run_line(folder, line) {
                        Ok(more) => printed += &more,
                        Err(fault) => faults.push(fault),
                    }
                }
            }
            "output" => {
                let missing = block.lines.iter().filter(|line| !was_printed(line, &printed));
                faults.extend(missing.map(|line| format!("not printed: {line}")));
            }
            "yaml" | "bash" | "python" if !examples.iter().any(|example| example.contains(&text)) => {
                faults.push(format!("in no file of docs/examples:\n{text}"));
            }
            "yaml" | "bash" | "python" | "console" | "text" | "rust" => {}
            other => faults.push(format!("a block in `{other}`, which this test does not know")),
        }
    }
    faults
}

/// Pages with commands.
fn pages() -> Vec<PathBuf> {
    let mut pages = files(&root().join("docs/src"), ".md");
    pages.push(root().join("README.md"));
    pages
}

#[test]
fn every_command_of_the_book_works_and_prints_what_is_shown() {
    let examples: Vec<String> = files(&root().join("docs/examples"), "")
        .iter()
        .map(|file| fs::read_to_string(file).unwrap())
        .collect();
    let mut wrong = Vec::new();
    for page in pages() {
        let text = fs::read_to_string(&page).unwrap();
        let name = page.strip_prefix(root()).unwrap().display().to_string();
        wrong.extend(faults(&text, &examples).into_iter().map(|fault| format!("{name}: {fault}")));
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_page_that_shows_something_else_is_found() {
    let page = "\
Save this as `a/b.txt`:

```json
{ \"a\": 1 }
```

```sh
cat a/b.txt
false  # exit 1
true  # exit 1
```

```output
{ \"a\": …
{ \"a\": 2 }
```
";
    let found = faults(page, &[]);
    assert_eq!(found.len(), 2, "{found:?}");
    assert!(found[0].starts_with("`true  # exit 1` ended with Some(0)"), "{found:?}");
    assert_eq!(found[1], "not printed: { \"a\": 2 }");
}
