//! All tests of the workspace. A fresh machine needs nothing but cargo for them.

use std::io::{BufRead, BufReader};
use std::process::Stdio;

use crate::workspace::cargo;

/// Tests that passed, failed, and were not run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Tally {
    passed: u64,
    failed: u64,
    skipped: u64,
}

/// Runs `cargo test` over the workspace to the end, whatever fails, and closes with the sum of all.
pub fn run(args: &[&str]) -> Result<(), String> {
    let mut child = cargo()
        .args(["test", "--workspace", "--locked", "--no-fail-fast"])
        .args(args)
        .stdout(Stdio::piped())
        .spawn()
        .map_err(|e| format!("cannot run cargo: {e}"))?;
    let mut tally = Tally::default();
    for line in child.stdout.take().into_iter().flat_map(|out| BufReader::new(out).lines()) {
        let line = line.map_err(|e| format!("cannot read the output of the tests: {e}"))?;
        println!("{line}");
        tally.count(&line);
    }
    let status = child.wait().map_err(|e| format!("cannot wait for cargo: {e}"))?;
    println!("\n{} passed, {} failed, {} skipped", tally.passed, tally.failed, tally.skipped);
    match (status.success(), tally.passed) {
        (false, _) => Err(format!("tests failed ({status})")),
        (true, 0) if args.is_empty() => Err("no test ran".into()),
        (true, _) => Ok(()),
    }
}

impl Tally {
    /// Adds the numbers of a closing line such as `test result: ok. 3 passed; 0 failed; 1 ignored; ...`.
    fn count(&mut self, line: &str) {
        let Some(rest) = line.strip_prefix("test result: ") else { return };
        for part in rest.split([';', '.']) {
            let Some((number, what)) = part.trim().split_once(' ') else { continue };
            let Ok(number) = number.parse::<u64>() else { continue };
            match what {
                "passed" => self.passed += number,
                "failed" => self.failed += number,
                "ignored" => self.skipped += number,
                _ => {}
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn closing_lines_add_up_and_other_lines_do_not_count() {
        let mut tally = Tally::default();
        tally.count(
            "test result: ok. 12 passed; 0 failed; 2 ignored; 0 measured; 3 filtered out; finished in 0.61s",
        );
        tally.count("test result: FAILED. 1 passed; 4 failed; 0 ignored; 0 measured; 0 filtered out; finished in 1.0s");
        tally.count("test five_passed ... ok");
        tally.count("7 passed; 7 failed");
        assert_eq!(tally, Tally { passed: 13, failed: 4, skipped: 2 });
    }
}
