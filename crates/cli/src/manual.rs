//! `man`: the manual, a page per command.

use super::args::Arguments;
use super::{DONE, say};
use clap::{Command, CommandFactory};
use clap_mangen::Man;
use peristat::Error;
use peristat::output::atomic::write_atomically;
use std::fs;
use std::io;
use std::path::Path;

/// Prints all pages one behind the other, or writes each into a file of a folder.
pub(super) fn man(folder: Option<&Path>) -> Result<u8, Error> {
    let mut command = Arguments::command().disable_help_subcommand(true);
    // Names of subcommands and options of all commands are only there then.
    command.build();
    let pages = pages(&command)?;
    let Some(folder) = folder else {
        for (_, page) in &pages {
            say(&String::from_utf8_lossy(page))?;
        }
        return Ok(DONE);
    };
    fs::create_dir_all(folder)?;
    for (name, page) in &pages {
        write_atomically(&folder.join(format!("{name}.1")), page)?;
    }
    Ok(DONE)
}

/// Pages of a command and of those below it: name and roff.
fn pages(command: &Command) -> io::Result<Vec<(String, Vec<u8>)>> {
    let name = command.get_display_name().unwrap_or(command.get_name()).to_string();
    let mut page = Vec::new();
    Man::new(command.clone()).render(&mut page)?;
    let mut all = vec![(name, page)];
    for below in command.get_subcommands() {
        all.extend(pages(below)?);
    }
    Ok(all)
}
