//! `stages.json`: what each file holds.

use super::files::Files;
use crate::error::Error;
use crate::write::encode::json::{Text, lines};
use std::io::{self, Write};

/// A file with numbers of what it holds, by name.
type Row = (String, Vec<(&'static str, usize)>);

/// The files written and what they hold.
pub(super) struct Table<'a, 'b> {
    files: &'a mut Files<'b>,
    rows: Vec<Row>,
}

impl<'a, 'b> Table<'a, 'b> {
    pub(super) fn new(files: &'a mut Files<'b>) -> Self {
        Self { files, rows: Vec::new() }
    }

    /// Writes `NAME.ply`, which holds so much of each.
    pub(super) fn add(
        &mut self,
        name: &str,
        held: &[(&'static str, usize)],
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<(), Error> {
        self.files.write(&format!("{name}.ply"), write)?;
        self.rows.push((name.into(), held.to_vec()));
        Ok(())
    }

    /// Writes `stages.json`: `head`, members of JSON that end in a comma, then the files.
    pub(super) fn finish(self, head: impl FnOnce(&mut dyn Write) -> io::Result<()>) -> Result<(), Error> {
        let rows = self.rows;
        self.files.write("stages.json", |out| {
            writeln!(out, "{{")?;
            head(out)?;
            write!(out, "\"stages\": [")?;
            lines(out, &rows, |out, _, (name, held)| {
                write!(out, "{{\"name\": {}", Text(name))?;
                held.iter().try_for_each(|(what, count)| write!(out, ", \"{what}\": {count}"))?;
                write!(out, "}}")
            })?;
            writeln!(out, "]\n}}")
        })
    }
}
