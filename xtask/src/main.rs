//! Tasks of the project: `cargo xtask` lists them.

mod browser;
mod figures;
mod man;
mod python;
mod rivals;
mod test;
mod web;
mod workspace;

use std::process::ExitCode;

const USAGE: &str = "\
Usage: cargo xtask TASK

  test [ARGS...]    run all tests; ARGS go to `cargo test`
  python [PROFILE]  install the Python package in out/python and run its tests; PROFILE of cargo, `dev` unless named
  wheel             build the wheel of the Python package into out/wheels
  rivals            compare with other programs; installs them in `out` by pip and npm, and a browser by apt if none is there
  figures [NAME [PROFILE]]
                    draw the figures of Gumhold 2001 from generated scans into out/figures, or those whose names begin with NAME
  man               write the manual pages to out/man
  web               bundle the viewer of reports from the folder web; needs Node.js with npm
  web --test        open reports in a browser, if one is there";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let result = match args.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["test", rest @ ..] => test::run(rest),
        ["rivals"] => rivals::run(),
        ["python"] => python::test(None),
        ["python", profile] => python::test(Some(profile)),
        ["wheel"] => python::wheel(),
        ["figures"] => figures::run("figure", None),
        ["figures", name] => figures::run(name, None),
        ["figures", name, profile] => figures::run(name, Some(profile)),
        ["man"] => man::run(),
        ["web"] => web::bundle(),
        ["web", "--test"] => web::test(),
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
