//! An input as words between blanks, whatever its lines: a line may be as long as the file.

use super::Source;
use crate::error::Error;
use crate::number::{is_blank, shown};

/// No number is longer.
const LONGEST: usize = 1 << 12;

/// The next item of a text.
pub(crate) enum Word {
    Text(Vec<u8>),
    /// The end of a line that holds words.
    LineEnd,
}

impl Source {
    /// The next word, or the end of a line; `None` at the end of the input. Comments, from `#` to the end of their line, are
    /// passed over.
    pub fn word(&mut self) -> Result<Option<Word>, Error> {
        let mut wanted = 1;
        loop {
            let ended = self.terminator;
            let here = self.peek(wanted)?;
            let Some(&first) = here.first() else { return Ok(None) };
            if first == ended {
                self.consume(1);
                self.line += 1;
                return Ok(Some(Word::LineEnd));
            }
            if is_blank(first) || first == b'\n' {
                self.consume(1);
                continue;
            }
            let stop = |&b: &u8| b == ended || b == b'#' || first != b'#' && (is_blank(b) || b == b'\n');
            let from = usize::from(first == b'#');
            let length = here[from..].iter().position(stop).map(|at| at + from);
            let all = here.len();
            match length {
                Some(length) if first != b'#' => {
                    let word = here[..length].to_vec();
                    self.consume(length);
                    self.open = false;
                    return Ok(Some(Word::Text(word)));
                }
                Some(length) => self.consume(length),
                None if first == b'#' => self.consume(all),
                None if all < wanted => {
                    let word = here.to_vec();
                    self.consume(all);
                    self.open = true;
                    return Ok(Some(Word::Text(word)));
                }
                None if all > LONGEST => {
                    let found = format!("a word {} of more than {LONGEST} bytes", shown(&here[..64]));
                    self.line += 1;
                    return Err(self.malformed_line(found, "expected numbers"));
                }
                None => wanted = all + 1,
            }
        }
    }
}
