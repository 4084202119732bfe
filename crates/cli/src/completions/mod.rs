//! `completions`: the scripts of `clap`, and what these lack: cases where a command takes cases, and in fish names.

use super::args::Arguments;
use super::{DONE, say};
use clap::{Arg, Command, CommandFactory, ValueHint};
use clap_complete::Shell;
use peristat::Error;

/// Files of cases, and folders, with their descriptions.
const FISH_CASES: &str =
    r#"(__fish_complete_path (commandline -ct) | string match -r ".*(?:\.jsonc?|/)(?:\t.*)?\$")"#;

const BASH: &str = include_str!("more.bash");

/// Prints the script of a shell.
pub(super) fn completions(shell: Shell) -> Result<u8, Error> {
    let mut command = Arguments::command();
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut command, "peristat", &mut script);
    let script = String::from_utf8_lossy(&script);
    say(&match shell {
        Shell::Bash => format!("{script}{}", of_bash(&command)),
        Shell::Zsh => of_zsh(&script),
        Shell::Fish => format!("{script}{}", of_fish(&command)),
        _ => script.into_owned(),
    })?;
    Ok(DONE)
}

/// Whether an argument is a case or a study.
fn is_case(argument: &Arg) -> bool {
    argument.is_positional() && argument.get_value_hint() == ValueHint::FilePath
}

/// Commands that take cases.
fn of_cases(command: &Command) -> impl Iterator<Item = &str> {
    let takes = |command: &&Command| command.get_arguments().any(is_case);
    command.get_subcommands().filter(takes).map(Command::get_name)
}

fn of_bash(command: &Command) -> String {
    let mut options: Vec<String> = Vec::new();
    for argument in command.get_subcommands().flat_map(Command::get_arguments) {
        if argument.get_action().takes_values() {
            options.extend(argument.get_long().map(|long| format!("--{long}")));
            options.extend(argument.get_short().map(|short| format!("-{short}")));
        }
    }
    options.sort();
    options.dedup();
    let commands: Vec<&str> = of_cases(command).collect();
    BASH.replace("OPTIONS", &options.join("|")).replace("COMMANDS", &commands.join("|"))
}

/// Files of cases in place of all files.
fn of_zsh(script: &str) -> String {
    let line = |line: &str| match line.starts_with("':") || line.starts_with("'*::") {
        true => line.replace(":_files'", ":_files -g \"*.(json|jsonc)\"'") + "\n",
        false => format!("{line}\n"),
    };
    script.lines().map(line).collect()
}

fn of_fish(command: &Command) -> String {
    let condition =
        |name: &str| format!("complete -c peristat -n \"__fish_peristat_using_subcommand {name}\" -f");
    let mut all = String::new();
    for name in of_cases(command) {
        all += &format!("{} -a '{FISH_CASES}'\n", condition(name));
    }
    for below in command.get_subcommands() {
        for value in below.get_positionals().flat_map(Arg::get_possible_values) {
            let about = value.get_help().map_or(String::new(), ToString::to_string).replace('\'', "\\'");
            all += &format!("{} -a {} -d '{about}'\n", condition(below.get_name()), value.get_name());
        }
    }
    all
}
