//! Errors of reading and writing. Every message names the file, the place, the value and a remedy.

use std::fmt;
use thiserror::Error;

/// A place in an input.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// Bytes from the start of the input, the first being 0.
    Byte(u64),
    /// Line of the input, the first being 1.
    Line(u64),
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Place::Byte(offset) => write!(f, "byte {offset}"),
            Place::Line(line) => write!(f, "line {line}"),
        }
    }
}

/// Limit on the bytes that a message quotes from an input: a header may name thousands of columns.
const LONGEST: usize = 300;

/// Text from an input, for a message: shortened, and with unprintable characters escaped, so that no input can steer a
/// terminal.
pub(crate) fn printable(text: &str) -> String {
    let mut short = String::new();
    for c in text.chars() {
        if short.len() >= LONGEST {
            short.push_str("...");
            break;
        }
        if c.is_control() || c == char::REPLACEMENT_CHARACTER {
            short.extend(c.escape_unicode());
        } else {
            short.push(c);
        }
    }
    short
}

/// Everything that can keep a file from being read or written.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// The system refused an operation.
    #[error("cannot {action} `{name}`: {source}")]
    Io {
        /// The operation: `open`, `read`, `write`, ...
        action: &'static str,
        /// The file, or `standard input` / `standard output`.
        name: String,
        /// The answer of the system.
        #[source]
        source: std::io::Error,
    },
    /// An input without a single byte.
    #[error("`{name}`, byte 0: the input is empty (0 bytes): a point cloud was expected")]
    Empty {
        /// The input.
        name: String,
    },
    /// The input has no known format.
    #[error("`{name}`, byte 0: format not recognised, it begins with {found}: {advice}")]
    UnknownFormat {
        /// The input.
        name: String,
        /// The first bytes, printable.
        found: String,
        /// A remedy.
        advice: String,
    },
    /// A format, or a variant of it, that is known but not read or written.
    #[error("`{name}`: {what}: {advice}")]
    Unsupported {
        /// The file.
        name: String,
        /// The variant.
        what: String,
        /// A remedy.
        advice: String,
    },
    /// The input breaks the rules of its format.
    #[error("`{name}`, {place}: {found}: {advice}")]
    Malformed {
        /// The input.
        name: String,
        /// Where.
        place: Place,
        /// The finding there, with its value.
        found: String,
        /// The expectation, or a remedy.
        advice: String,
    },
    /// The input ends before the length that its header announces.
    #[error(
        "`{name}`, {place}: the input ends early, with {read} of {expected} {unit}: get it anew, or read its whole \
         part with --salvage"
    )]
    EndsEarly {
        /// The input.
        name: String,
        /// The place where it ends.
        place: Place,
        /// The items counted: `points`, `rows of element face`, ...
        unit: String,
        /// The number that the header announces.
        expected: u64,
        /// The number of whole items.
        read: u64,
    },
    /// The extension of an output names no format.
    #[error("output `{name}`: the extension names no format of {kind}: use one of {known}")]
    UnknownOutput {
        /// The output.
        name: String,
        /// `networks` or `points`.
        kind: &'static str,
        /// The extensions that are known.
        known: String,
    },
    /// Writing the output would destroy the input.
    #[error(
        "output `{output}` is the input `{input}` itself: inputs are never overwritten, name another output"
    )]
    OutputIsInput {
        /// The output as given.
        output: String,
        /// The input as given.
        input: String,
    },
    /// The folder of an output does not exist.
    #[error("output `{output}`: there is no folder `{folder}`: make it first")]
    NoFolder {
        /// The output as given.
        output: String,
        /// Its folder.
        folder: String,
    },
    /// The data to write do not fit together.
    #[error("output `{name}`: {what}")]
    Inconsistent {
        /// The output.
        name: String,
        /// The contradiction, with its values.
        what: String,
    },
}

impl Error {
    /// Whether the fault lies with an input (its bytes, or that it cannot be opened) rather than an output.
    pub fn is_input(&self) -> bool {
        match self {
            Error::Io { action, .. } => matches!(*action, "open" | "read"),
            Error::UnknownOutput { .. }
            | Error::OutputIsInput { .. }
            | Error::NoFolder { .. }
            | Error::Inconsistent { .. } => false,
            _ => true,
        }
    }
}
