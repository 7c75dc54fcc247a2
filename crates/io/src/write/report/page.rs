//! The page around the data: its head, the picture, and the viewer.

use super::Report;
use base64::prelude::{BASE64_STANDARD, Engine};
use std::fmt;
use std::io::{self, Write};

/// The viewer, as `cargo xtask web` bundles it from the folder `web`.
const SCRIPT: &str = include_str!("viewer.js");
const STYLE: &str = include_str!("viewer.css");

/// Greatest size of a report, bytes, and the part of it that is kept for the picture and the page.
const LIMIT: usize = 15_000_000;
const PICTURE: usize = 2_000_000;

/// Nothing is fetched and nothing is sent: all that the page may use stands in it.
const POLICY: &str =
    "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:";

/// Bytes left for the points beside lines of this size.
pub(super) fn room(lines: usize) -> usize {
    LIMIT.saturating_sub(PICTURE + SCRIPT.len() + STYLE.len() + lines)
}

/// Writes the page; `data` writes the data, a JSON text.
pub(super) fn write(
    out: &mut dyn Write,
    report: &Report,
    picture: &[u8],
    data: &dyn Fn(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let name = Escaped(&report.context.input_name);
    writeln!(out, "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">")?;
    writeln!(out, "<meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">")?;
    writeln!(out, "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">")?;
    let version = Escaped(&report.context.program_version);
    writeln!(out, "<meta name=\"generator\" content=\"lineament {version}\">")?;
    writeln!(out, "<title>{name} - lineament</title>\n<style>{STYLE}</style>\n</head>\n<body>")?;
    writeln!(out, "<main id=\"viewer\"></main>\n<figure id=\"picture\">")?;
    write!(out, "<img alt=\"Picture of {name} with its lines\" src=\"data:image/png;base64,")?;
    out.write_all(BASE64_STANDARD.encode(picture).as_bytes())?;
    writeln!(out, "\">\n<figcaption id=\"state\">{name}</figcaption>\n</figure>")?;
    writeln!(out, "<noscript><p>The viewer needs JavaScript; this is a picture.</p></noscript>")?;
    write!(out, "<script type=\"application/json\" id=\"data\">")?;
    data(&mut Inert(out))?;
    writeln!(out, "</script>\n<script>{SCRIPT}</script>\n</body>\n</html>")
}

/// JSON as it may stand in a script element: `<` occurs in its texts alone, where `\u003c` says the same.
struct Inert<'a>(&'a mut dyn Write);

impl Write for Inert<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for (i, part) in bytes.split(|&b| b == b'<').enumerate() {
            if i > 0 {
                self.0.write_all(b"\\u003c")?;
            }
            self.0.write_all(part)?;
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.0.flush()
    }
}

/// Text as it may stand in an element or an attribute.
struct Escaped<'a>(&'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|c| match c {
            '&' => f.write_str("&amp;"),
            '<' => f.write_str("&lt;"),
            '>' => f.write_str("&gt;"),
            '"' => f.write_str("&quot;"),
            c => write!(f, "{c}"),
        })
    }
}
