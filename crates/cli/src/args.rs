//! The command line.

use super::choices::{Color, Files, Kind, States, assignment, size, starts};
use clap::{ArgGroup, Args, Parser, Subcommand, ValueHint};
use peristat::input::Reach;
use peristat::results::FieldFiles;
use std::path::PathBuf;

/// Implicit static peridynamics: beams, frames, plates, bodies of revolution, shells and solids.
///
/// Exit codes: 0 done and all checks passed; 1 ran, but did not converge or a check failed; 2 bad input or usage; 130
/// interrupted.
#[derive(Debug, Parser)]
#[command(name = "peristat", version, propagate_version = true)]
pub(super) struct Arguments {
    /// What to do.
    #[command(subcommand)]
    pub(super) command: Command,
    /// Options of all commands.
    #[command(flatten)]
    pub(super) global: Global,
}

/// Options of all commands.
#[derive(Clone, Debug, Args)]
pub(super) struct Global {
    /// Print more: what was skipped, counters, times.
    #[arg(short, long, global = true)]
    pub(super) verbose: bool,
    /// Print errors only.
    #[arg(short, long, global = true, conflicts_with = "verbose")]
    pub(super) quiet: bool,
    /// Print JSON for machines instead of text.
    #[arg(long, global = true)]
    pub(super) json: bool,
    /// When to colour messages.
    #[arg(long, global = true, value_enum, default_value = "auto")]
    pub(super) color: Color,
    /// Threads for a body other than a beam, or cases that `verify` and `study` solve at the same time; default: all cores.
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub(super) threads: Option<u16>,
    /// Largest memory that a case may need, such as `2GB`; peristat estimates it before it allocates.
    #[arg(long, global = true, value_name = "SIZE", value_parser = size)]
    pub(super) max_memory: Option<u64>,
    /// Read files that cases and studies name even where they lie outside their folders.
    #[arg(long, global = true)]
    pub(super) allow_outside: bool,
}

impl Global {
    /// How far the files may lie that cases and studies name.
    pub(super) fn reach(&self) -> Reach {
        if self.allow_outside { Reach::Anywhere } else { Reach::Inside }
    }
}

/// Commands.
#[derive(Debug, Subcommand)]
pub(super) enum Command {
    /// Solve a case, write its results and run its checks.
    Run(Run),
    /// Build cases and estimate their size without solving them.
    Check {
        /// Case files.
        #[arg(required = true, value_name = "CASE", value_hint = ValueHint::FilePath)]
        cases: Vec<PathBuf>,
        /// Replace a value of the cases, such as `body.line.cells=200`.
        #[arg(long = "set", value_name = "PATH=VALUE", value_parser = assignment)]
        overrides: Vec<String>,
    },
    /// Solve cases and run their checks; writes no results.
    #[command(group(ArgGroup::new("written").args(["junit", "output"]).multiple(true)))]
    Verify {
        /// Case files and folders of them; `cases` if none is given.
        #[arg(value_name = "PATH", value_hint = ValueHint::FilePath)]
        paths: Vec<PathBuf>,
        /// Include cases marked slow and those in `bench` folders.
        #[arg(long)]
        all: bool,
        /// Write a JUnit report.
        #[arg(long, value_name = "FILE")]
        junit: Option<PathBuf>,
        /// Write the results of every case into a folder below this one.
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
        /// Replace earlier runs in those folders, other files there stay; write the report in place of any file.
        #[arg(long, requires = "written")]
        force: bool,
    },
    /// Solve a case on many discretisations: orders of convergence and extrapolated values.
    Study(Study),
    /// Lay cases and studies out tidily, in place; comments and numbers stay as they are written.
    Fmt {
        /// Case and study files; `-` tidies stdin to stdout.
        #[arg(required = true, value_name = "CASE", value_hint = ValueHint::FilePath)]
        cases: Vec<PathBuf>,
        /// Change nothing; say which files are not tidy, and exit with 1 if there are any.
        #[arg(long)]
        check: bool,
    },
    /// Print a starting case.
    New {
        /// The model, or the kind of body.
        #[arg(value_parser = starts())]
        model: String,
    },
    /// List what cases can say: models, bodies, loads, fields and more.
    List {
        /// List this kind only.
        #[arg(value_enum)]
        kind: Option<Kind>,
    },
    /// Print the JSON Schema of case files, for editors.
    Schema {
        /// Print the schema of study files instead.
        #[arg(long)]
        study: bool,
        /// Print a Markdown page instead of JSON.
        #[arg(long)]
        markdown: bool,
    },
    /// Print a completion script.
    Completions {
        /// Shell.
        shell: clap_complete::Shell,
    },
    /// Print the manual, for `man`.
    Man {
        /// Write a page per command into this folder instead.
        #[arg(short, long, value_name = "DIR")]
        output: Option<PathBuf>,
    },
}

/// Options of `run`.
#[derive(Debug, Args)]
pub(super) struct Run {
    /// Case file.
    #[arg(value_hint = ValueHint::FilePath)]
    pub(super) case: PathBuf,
    /// Results folder; `results/<name of the case>` if not given.
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Replace a value of the case, such as `body.line.cells=200`.
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = assignment)]
    pub(super) overrides: Vec<String>,
    /// Replace any earlier run in the results folder; other files there stay. A finished run of the same case file is replaced
    /// without.
    #[arg(long)]
    pub(super) force: bool,
    /// Continue the interrupted run of a body that breaks or softens in the results folder.
    #[arg(long, conflicts_with = "force")]
    pub(super) resume: bool,
    /// Estimate the discretisation error of every probe from a finer grid as well; this costs more than the run itself.
    #[arg(long)]
    pub(super) estimate: bool,
    /// Skip the error estimate from coarser grids.
    #[arg(long, conflicts_with = "estimate")]
    pub(super) no_estimate: bool,
    /// States whose fields at all points are written as files; lines, probes and the report are written anyway.
    #[arg(long, value_enum, value_name = "STATES", default_value = "all")]
    pub(super) fields: States,
    /// Files that the fields of a state are written as.
    #[arg(long, value_enum, value_name = "FILES", default_value = "both")]
    pub(super) field_files: Files,
    /// Show the report when the run has ended.
    #[arg(long)]
    pub(super) open: bool,
    /// Write the assembled stiffness, before supports, as a Matrix Market file.
    #[arg(long, value_name = "FILE")]
    pub(super) write_matrix: Option<PathBuf>,
}

impl Run {
    /// The files of fields that are asked for.
    pub(super) fn field_files(&self) -> FieldFiles {
        FieldFiles {
            states: self.fields.into(),
            tables: self.field_files != Files::Vtu,
            grids: self.field_files != Files::Csv,
        }
    }
}

/// Options of `study`.
#[derive(Debug, Args)]
pub(super) struct Study {
    /// Study file.
    #[arg(value_hint = ValueHint::FilePath)]
    pub(super) study: PathBuf,
    /// Folder of the study; `results/<name of its file>` if not given, such as `results/orders.study`. Tasks that are finished in it are not solved again.
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,
    /// Replace a value of the base case, such as `body.line.cells=200`.
    #[arg(long = "set", value_name = "PATH=VALUE", value_parser = assignment)]
    pub(super) overrides: Vec<String>,
    /// Use a folder that holds other files, and replace the tables of another study there; finished tasks stay.
    #[arg(long)]
    pub(super) force: bool,
    /// Show the report when the study has ended.
    #[arg(long, conflicts_with_all = ["plan", "task"])]
    pub(super) open: bool,
    /// List the tasks and solve nothing.
    #[arg(long, conflicts_with_all = ["task", "collect"])]
    pub(super) plan: bool,
    /// Solve this task only, by its number in the plan; may be given several times.
    #[arg(long, value_name = "K", conflicts_with = "collect")]
    pub(super) task: Vec<usize>,
    /// Solve nothing: make tables and diagrams of the tasks that are finished.
    #[arg(long)]
    pub(super) collect: bool,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        use clap::CommandFactory;
        Arguments::command().debug_assert();
    }
}
