//! STEP, the exchange structure of ISO 10303-21: numbered instances of the entities of an application protocol. `frame` writes what
//! stands around a shape: product, units, uncertainty; `geometry` points, directions, curves.

mod frame;
mod geometry;
mod value;

use crate::unit::Unit;
use std::fmt::Display;
use std::io::{self, Write};

pub(in crate::write) use value::{Id, List, Real, Text};

/// The application protocol of a file.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StepProtocol {
    /// Managed model-based 3D engineering, ISO 10303-242.
    #[default]
    Ap242,
    /// Core data for automotive mechanical design processes, ISO 10303-214, for older programs.
    Ap214,
}

/// What a file says of all that is in it.
pub(in crate::write) struct Head<'a> {
    pub protocol: StepProtocol,
    /// Name of the product.
    pub name: &'a str,
    /// Version of the program.
    pub version: &'a str,
    /// Unit of lengths; millimetres where it is not known, as the format has no way to say so.
    pub unit: Option<Unit>,
    /// Distance up to which places that should be the same may lie apart.
    pub uncertainty: f64,
}

/// Writes instances, each with the next number.
pub(in crate::write) struct Step<'a> {
    out: &'a mut dyn Write,
    last: Id,
    /// The representation context that shapes name.
    pub context: Id,
    shape: Id,
}

impl<'a> Step<'a> {
    /// Begins a file.
    pub fn begin(out: &'a mut dyn Write, head: &Head) -> io::Result<Self> {
        frame::header(out, head)?;
        let mut step = Self { out, last: 0, context: 0, shape: 0 };
        frame::product(&mut step, head)?;
        Ok(step)
    }

    /// Writes an instance: the keyword and its parameters in brackets, or the bracketed list of a complex one.
    pub fn add(&mut self, instance: impl Display) -> io::Result<Id> {
        self.last += 1;
        writeln!(self.out, "#{}={instance};", self.last)?;
        Ok(self.last)
    }

    /// Assigns instances to a layer, if there are any.
    pub fn layer(&mut self, name: &str, items: &[Id]) -> io::Result<()> {
        if !items.is_empty() {
            self.add(format_args!("PRESENTATION_LAYER_ASSIGNMENT({},'',{})", Text(name), List(items)))?;
        }
        Ok(())
    }

    /// Ends the file; the product has the shape of these representations.
    pub fn end(mut self, representations: &[Id]) -> io::Result<()> {
        frame::shapes(&mut self, representations)?;
        writeln!(self.out, "ENDSEC;\nEND-ISO-10303-21;")
    }
}
