//! The command `peristat`.

use std::process::ExitCode;

fn main() -> ExitCode {
    peristat::cli::main()
}
