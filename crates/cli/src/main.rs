//! The process `peristat`.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(peristat_cli::command(std::env::args_os()))
}
