//! Groups: a code and a value, a line each; and handles, the numbers by which objects of a file name each other.

use std::fmt::Display;
use std::io::{self, Write};

/// Writes groups.
pub(super) struct Groups<'a> {
    out: &'a mut dyn Write,
}

impl<'a> Groups<'a> {
    pub fn new(out: &'a mut dyn Write) -> Self {
        Self { out }
    }

    /// A group with a text or a whole number.
    pub fn put(&mut self, code: u16, value: impl Display) -> io::Result<()> {
        write!(self.out, "{code}\n{value}\n")
    }

    /// A group with a real number, in the shortest decimals that give it back.
    pub fn real(&mut self, code: u16, value: f64) -> io::Result<()> {
        write!(self.out, "{code}\n{value:?}\n")
    }

    /// A handle, which is hexadecimal.
    pub fn handle(&mut self, code: u16, handle: usize) -> io::Result<()> {
        write!(self.out, "{code}\n{handle:X}\n")
    }

    /// A position in groups ten apart: 10, 20 and 30 if `first` is 10.
    pub fn place<const D: usize>(&mut self, first: u16, position: [f64; D]) -> io::Result<()> {
        (first..).step_by(10).zip(position).try_for_each(|(code, value)| self.real(code, value))
    }

    /// Groups as they stand, their lines ended.
    pub fn text(&mut self, text: &str) -> io::Result<()> {
        self.out.write_all(text.as_bytes())
    }
}

/// The first handle that the fixed parts of a file leave free.
const FREE: usize = 0x100;

/// Handles in order.
pub(super) struct Handles(usize);

impl Default for Handles {
    fn default() -> Self {
        Self(FREE)
    }
}

impl Handles {
    pub fn next(&mut self) -> usize {
        self.0 += 1;
        self.0 - 1
    }

    /// The first one free after so many more.
    pub fn after(&self, taken: usize) -> usize {
        self.0 + taken
    }
}
