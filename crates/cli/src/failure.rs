//! Failures, and their exit codes.

use std::fmt::Display;
use std::io::Write;

/// Exit codes. `--help` and the README list them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Code {
    /// Some of several inputs failed.
    Partial = 1,
    /// The command line does not make sense. clap uses the same code.
    Usage = 2,
    /// An input cannot be read, or is malformed.
    Input = 3,
    /// A parameter is out of range, or the cloud has no surface.
    Refused = 4,
    /// An output cannot be written.
    Output = 5,
}

impl Code {
    /// In a word, for tables.
    pub fn name(self) -> &'static str {
        match self {
            Code::Partial => "in part",
            Code::Usage => "usage",
            Code::Input => "input",
            Code::Refused => "refused",
            Code::Output => "output",
        }
    }
}

/// Writes lines to standard error. If it is closed, full, or a pipe without a reader, the lines are lost and the work goes on.
/// Names may come from files, so control characters in them are made harmless for terminals.
pub fn say(text: &str) {
    let _ = std::io::stderr().lock().write_all(format!("{}\n", shown(text)).as_bytes());
}

/// Text in which signs that steer a terminal are spelled out; lines stay.
pub fn shown(text: &str) -> String {
    let steers = |c: char| c.is_control() && c != '\n' && c != '\t';
    text.chars().flat_map(|c| if steers(c) { c.escape_unicode().collect() } else { vec![c] }).collect()
}

/// The exit code after an interrupt, 128 + SIGINT.
pub const INTERRUPTED: i32 = 130;

/// The end of a run that did not succeed.
#[derive(Clone, Debug)]
pub struct Failure {
    pub code: Code,
    /// File, place, value and reason.
    pub message: String,
    /// A remedy.
    pub advice: Option<String>,
}

impl Failure {
    /// A failure without advice.
    pub fn new(code: Code, message: impl Display) -> Self {
        Self { code, message: message.to_string(), advice: None }
    }

    /// The same, with a remedy.
    pub fn advise(self, advice: impl Into<String>) -> Self {
        Self { advice: Some(advice.into()), ..self }
    }

    /// The same, with the place it concerns in front.
    pub fn at(self, place: impl Display) -> Self {
        Self { message: format!("{place}: {}", self.message), ..self }
    }

    /// Tells the user on standard error.
    pub fn tell(&self) {
        let advice = self.advice.iter().map(|advice| format!("\n  {advice}"));
        say(&format!("lineament: error: {}{}", self.message, advice.collect::<String>()));
    }
}

impl From<lineament::Error> for Failure {
    fn from(error: lineament::Error) -> Self {
        let advice = match &error {
            lineament::Error::Parameter { .. } => {
                Some("`lineament params` lists all parameters with their ranges")
            }
            lineament::Error::TooFewPoints { .. } => {
                Some("`lineament info FILE` describes the file; `lineament render --network none` draws it")
            }
            _ => None,
        };
        Self { code: Code::Refused, message: error.to_string(), advice: advice.map(String::from) }
    }
}

impl From<lineament_io::Error> for Failure {
    fn from(error: lineament_io::Error) -> Self {
        Self::new(if error.is_input() { Code::Input } else { Code::Output }, error)
    }
}
