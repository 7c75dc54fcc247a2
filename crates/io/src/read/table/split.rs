//! Lines of a table into fields.

use crate::number::{is_blank, token};

/// The separator of fields.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Separator {
    /// Any run of spaces and tabs.
    Blanks,
    /// One comma, semicolon or tab; fields may be empty.
    Byte(u8),
}

/// The fields of a line, trimmed and without quotes. A separator at the very end of a line closes its last field
/// and opens none.
pub(super) struct Fields<'a> {
    rest: Option<&'a [u8]>,
    separator: Separator,
}

impl<'a> Fields<'a> {
    pub fn new(line: &'a [u8], separator: Separator) -> Self {
        let line = line.trim_ascii();
        let line = match separator {
            Separator::Byte(byte) => line.strip_suffix(&[byte]).unwrap_or(line),
            Separator::Blanks => line,
        };
        Self { rest: Some(line).filter(|line| !line.is_empty()), separator }
    }

    /// The next field, or `None` behind the last.
    #[inline]
    pub fn next_field(&mut self) -> Option<&'a [u8]> {
        let line = self.rest?;
        match self.separator {
            Separator::Blanks => {
                let (field, rest) = token(line)?;
                self.rest = Some(rest);
                Some(unquoted(field))
            }
            Separator::Byte(byte) => {
                let end = end_of_field(line, byte);
                self.rest = line.get(end + 1..);
                Some(unquoted(line[..end].trim_ascii()))
            }
        }
    }
}

/// The end of the first field: the first separator outside quotes.
#[inline]
fn end_of_field(line: &[u8], separator: u8) -> usize {
    let start = line.iter().position(|&b| !is_blank(b)).unwrap_or(0);
    let from = if line.get(start) == Some(&b'"') { end_of_quotes(line, start) } else { 0 };
    line[from..].iter().position(|&b| b == separator).map_or(line.len(), |at| from + at)
}

/// The position after the quotes that open at `start`; two quotes within them represent one. `start` if they do not close.
fn end_of_quotes(line: &[u8], start: usize) -> usize {
    let mut at = start + 1;
    while let Some(next) = line[at..].iter().position(|&b| b == b'"') {
        at += next + 1;
        if line.get(at) != Some(&b'"') {
            return at;
        }
        at += 1;
    }
    start
}

/// Whether a line ends in a separator, behind which a last field may be missing.
#[inline]
pub(super) fn ends_open(line: &[u8], separator: Separator) -> bool {
    matches!((separator, line.trim_ascii().last()), (Separator::Byte(byte), Some(&last)) if last == byte)
}

#[inline]
fn unquoted(field: &[u8]) -> &[u8] {
    match field {
        [b'"', inner @ .., b'"'] => inner.trim_ascii(),
        _ => field,
    }
}

/// All fields of a line.
pub(super) fn fields(line: &[u8], separator: Separator) -> Vec<&[u8]> {
    let mut fields = Fields::new(line, separator);
    std::iter::from_fn(|| fields.next_field()).collect()
}

/// Whether a line is a comment by its first sign.
#[inline]
pub(super) fn is_comment(line: &[u8]) -> bool {
    match line.iter().find(|&&b| !is_blank(b)) {
        Some(b'#' | b'%' | b'!') => true,
        Some(b'/') => line.trim_ascii_start().starts_with(b"//"),
        _ => false,
    }
}

/// A comment without its sign.
pub(super) fn uncommented(line: &[u8]) -> &[u8] {
    let text = line.trim_ascii_start();
    let signs = text.iter().take_while(|&&b| matches!(b, b'#' | b'%' | b'!' | b'/')).count();
    &text[signs..]
}
