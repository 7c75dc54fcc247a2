//! Tasks of the project: `cargo xtask` lists them.

mod man;
mod rivals;
mod test;
mod workspace;

use std::process::ExitCode;

const USAGE: &str = "\
Usage: cargo xtask TASK

  test [ARGS...]  run all tests; ARGS go to `cargo test`
  rivals          compare with other programs; installs them in `out` by pip and npm, and a browser by apt if none is there
  man             write the manual pages to out/man";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let result = match args.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["test", rest @ ..] => test::run(rest),
        ["rivals"] => rivals::run(),
        ["man"] => man::run(),
        ["help" | "--help" | "-h"] => {
            println!("{USAGE}");
            Ok(())
        }
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    match result {
        Ok(()) => ExitCode::SUCCESS,
        Err(message) => {
            eprintln!("xtask: {message}");
            ExitCode::FAILURE
        }
    }
}
