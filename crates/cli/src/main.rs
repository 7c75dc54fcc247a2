//! The `lineament` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    ExitCode::from(lineament_cli::run(std::env::args_os()))
}
