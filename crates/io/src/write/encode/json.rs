//! JSON text: numbers, points, texts, lists, and the head that every file of ours begins with.

use std::fmt;
use std::io::{self, Write};

/// The first members of a file: its schema, the program, the input, frame and unit.
pub(in crate::write) struct Head<'a> {
    pub schema: &'a str,
    /// Version of the program.
    pub version: &'a str,
    /// Name of the input.
    pub input: &'a str,
    pub sha256: Option<&'a str>,
    /// Rows of the input.
    pub points: u64,
}

impl Head<'_> {
    /// Writes the opening brace and the members; others follow.
    pub fn write(&self, out: &mut dyn Write) -> io::Result<()> {
        let Head { schema, version, input, sha256, points } = self;
        writeln!(out, "{{\n\"schema\": {},", Text(schema))?;
        writeln!(out, "\"program\": {{\"name\": \"lineament\", \"version\": {}}},", Text(version))?;
        write!(out, "\"input\": {{\"name\": {}, \"sha256\": ", Text(input))?;
        match sha256 {
            Some(hash) => write!(out, "{}", Text(hash))?,
            None => write!(out, "null")?,
        }
        writeln!(out, ", \"points\": {points}}},\n\"frame\": \"input\",\n\"unit\": \"input\",")
    }
}

/// Items with commas between them.
pub(in crate::write) fn list<T>(
    out: &mut dyn Write,
    items: &[T],
    mut item: impl FnMut(&mut dyn Write, usize, &T) -> io::Result<()>,
) -> io::Result<()> {
    for (i, value) in items.iter().enumerate() {
        if i > 0 {
            write!(out, ", ")?;
        }
        item(out, i, value)?;
    }
    Ok(())
}

/// Items on a line each.
pub(in crate::write) fn lines<T>(
    out: &mut dyn Write,
    items: &[T],
    mut item: impl FnMut(&mut dyn Write, usize, &T) -> io::Result<()>,
) -> io::Result<()> {
    for (i, value) in items.iter().enumerate() {
        write!(out, "{}", if i > 0 { ",\n" } else { "\n" })?;
        item(out, i, value)?;
    }
    if items.is_empty() { Ok(()) } else { writeln!(out) }
}

/// A number; `null` for one that is not finite.
pub(in crate::write) struct Number(pub(in crate::write) f64);

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(digits(&mut zmij::Buffer::new(), self.0))
    }
}

/// The shortest decimals that give the same number back.
fn digits(buffer: &mut zmij::Buffer, number: f64) -> &str {
    if number.is_finite() { buffer.format_finite(number) } else { "null" }
}

pub(in crate::write) struct Point<'a>(pub(in crate::write) &'a [f64; 3]);

impl fmt::Display for Point<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [mut x, mut y, mut z] = [(); 3].map(|()| zmij::Buffer::new());
        let texts = [digits(&mut x, self.0[0]), digits(&mut y, self.0[1]), digits(&mut z, self.0[2])];
        ["[", texts[0], ", ", texts[1], ", ", texts[2], "]"].into_iter().try_for_each(|t| f.write_str(t))
    }
}

pub(in crate::write) struct Index(pub(in crate::write) Option<u32>);

impl fmt::Display for Index {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.0 {
            Some(index) => write!(f, "{index}"),
            None => f.write_str("null"),
        }
    }
}

/// A text in quotes.
pub(in crate::write) struct Text<'a>(pub(in crate::write) &'a str);

impl fmt::Display for Text<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("\"")?;
        for c in self.0.chars() {
            match c {
                '"' | '\\' => write!(f, "\\{c}")?,
                c if u32::from(c) < 0x20 || c == '\u{7f}' => write!(f, "\\u{:04x}", u32::from(c))?,
                c => write!(f, "{c}")?,
            }
        }
        f.write_str("\"")
    }
}

/// The value of a parameter: a number or a truth value as such, all else as text.
pub(in crate::write) struct Value<'a>(pub(in crate::write) &'a str);

impl fmt::Display for Value<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let text = self.0.trim();
        if matches!(text, "true" | "false") {
            return f.write_str(text);
        }
        if let Ok(integer) = text.parse::<i64>() {
            return write!(f, "{integer}");
        }
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => write!(f, "{}", Number(number)),
            _ => write!(f, "{}", Text(text)),
        }
    }
}
