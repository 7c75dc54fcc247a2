//! One input or many: messages about each, and a table of all at the end.

use crate::args::Running;
use crate::failure::{Code, Failure, say};
use crate::source::Origin;

/// The outcome of one input.
pub struct Done {
    /// The summary.
    pub lines: Vec<String>,
    /// A row of the table of many inputs, a cell for each head after the first.
    pub row: Vec<String>,
}

/// Treats each input by `treat`, which gets its number. One input gets its summary, and its failure is the program's.
/// Of several, a failed one leaves the others alone; each failure is reported at once, and a table of all comes at the end.
///
/// # Errors
/// The failure of a single input; partial if one or more of several failed.
pub fn run(
    header: &[&str],
    origins: &[Origin],
    running: &Running,
    mut treat: impl FnMut(usize, &Origin) -> Result<Done, Failure>,
) -> Result<(), Failure> {
    let several = origins.len() > 1;
    let mut table = vec![header.iter().map(|head| head.to_string()).collect::<Vec<_>>()];
    let mut failed = 0;
    for (i, origin) in origins.iter().enumerate() {
        match treat(i, origin) {
            Ok(done) => {
                if !running.quiet && (running.verbose || !several) {
                    say(&done.lines.join("\n"));
                }
                table.push([vec![origin.shown()], done.row].concat());
            }
            Err(failure) if !several => return Err(failure),
            Err(failure) => {
                failed += 1;
                failure.tell();
                table.push(vec![origin.shown(), format!("failed ({})", failure.code.name())]);
            }
        }
    }
    if several && !running.quiet {
        say(aligned(&table).trim_end());
    }
    partial(failed, origins.len())
}

/// Success, unless some inputs failed.
pub fn partial(failed: usize, all: usize) -> Result<(), Failure> {
    match failed {
        0 => Ok(()),
        _ => Err(Failure::new(Code::Partial, format!("{failed} of {all} inputs failed"))),
    }
}

/// Rows as text, columns of numbers aligned to the right. A last cell that stands alone may run over.
fn aligned(table: &[Vec<String>]) -> String {
    let width = |column: usize| {
        let whole = table.iter().filter(|row| row.len() == table[0].len());
        whole.filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max().unwrap_or(0)
    };
    let first =
        table.iter().filter_map(|row| row.first()).map(|cell| cell.chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for row in table {
        for (column, cell) in row.iter().enumerate() {
            text += &match column {
                0 => format!("{cell:first$}"),
                _ => format!("  {cell:>width$}", width = width(column)),
            };
        }
        text.push('\n');
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_aligned_and_failures_may_run_over() {
        let row = |name: &str, points: &str| {
            [vec![name.to_string(), points.into()], vec!["1".to_string(); 7]].concat()
        };
        let table = [row("a", "12"), row("long", "7"), vec!["b".into(), "failed (unreadable)".into()]];
        assert_eq!(
            aligned(&table),
            "a     12  1  1  1  1  1  1  1\nlong   7  1  1  1  1  1  1  1\nb     failed (unreadable)\n"
        );
    }
}
