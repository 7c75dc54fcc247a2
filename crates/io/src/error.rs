//! What reading and writing refuse. Every message names the file, the place, the value and what to do.

use std::fmt;
use thiserror::Error;

/// Where in an input something stands.
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

/// Bytes of what a message says of an input: a header may name thousands of columns.
const LONGEST: usize = 300;

/// Text that came from an input, for a message: shortened, and with what is no printable character escaped, so that
/// no input can steer a terminal.
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
        /// What was tried: `open`, `read`, `write`, ...
        action: &'static str,
        /// The file, or `standard input` / `standard output`.
        name: String,
        /// What the system said.
        #[source]
        source: std::io::Error,
    },
    /// An input without a single byte.
    #[error("`{name}`, byte 0: the input is empty (0 bytes): a point cloud was expected")]
    Empty {
        /// The input.
        name: String,
    },
    /// The input is none of the formats that are read.
    #[error("`{name}`, byte 0: format not recognised, it begins with {found}: {advice}")]
    UnknownFormat {
        /// The input.
        name: String,
        /// The first bytes, printable.
        found: String,
        /// What could be done.
        advice: String,
    },
    /// A format, or a variant of it, that is known but not read or written.
    #[error("`{name}`: {what}: {advice}")]
    Unsupported {
        /// The file.
        name: String,
        /// The variant.
        what: String,
        /// What could be done.
        advice: String,
    },
    /// The input breaks the rules of its format.
    #[error("`{name}`, {place}: {found}: {advice}")]
    Malformed {
        /// The input.
        name: String,
        /// Where.
        place: Place,
        /// What stands there, with its value.
        found: String,
        /// What was expected or could be done.
        advice: String,
    },
    /// The input stops before what its header announces.
    #[error(
        "`{name}`, {place}: the input ends early, with {read} of {expected} {unit}: get it anew, or read what is \
         whole with --salvage"
    )]
    EndsEarly {
        /// The input.
        name: String,
        /// Where it ends.
        place: Place,
        /// What is counted: `points`, `rows of element face`, ...
        unit: String,
        /// How many the header announces.
        expected: u64,
        /// How many are there whole.
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
    /// What is to be written does not fit together.
    #[error("output `{name}`: {what}")]
    Inconsistent {
        /// The output.
        name: String,
        /// What does not fit, with its values.
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
