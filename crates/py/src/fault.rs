//! Failures as exceptions: the text of the program, in the classes of `lineament._errors`.

use std::io::ErrorKind;

use pyo3::prelude::*;

/// A failure on its way to Python.
#[derive(Debug)]
pub enum Fault {
    /// Of the points or a parameter.
    Core(lineament::Error),
    /// Of a file.
    File(lineament_io::Error),
    /// Of an argument.
    Argument(String),
    /// A panic, which is an error of ours.
    Internal(String),
}

impl Fault {
    fn class(&self) -> &'static str {
        match self {
            Fault::Core(lineament::Error::Parameter { .. }) => "ParameterError",
            Fault::Core(_) => "CloudError",
            Fault::File(error) if error.is_input() => match error {
                lineament_io::Error::Io { source, .. } if source.kind() == ErrorKind::NotFound => {
                    "InputNotFoundError"
                }
                _ => "InputError",
            },
            Fault::File(_) => "OutputError",
            Fault::Argument(_) => "ParameterError",
            Fault::Internal(_) => "InternalError",
        }
    }

    fn text(&self) -> String {
        match self {
            Fault::Core(error) => error.to_string(),
            Fault::File(error) => error.to_string(),
            Fault::Argument(text) => text.clone(),
            Fault::Internal(text) => {
                format!("this is an error of lineament itself, please report it: {text}")
            }
        }
    }
}

impl From<lineament::Error> for Fault {
    fn from(error: lineament::Error) -> Self {
        Fault::Core(error)
    }
}

impl From<lineament_io::Error> for Fault {
    fn from(error: lineament_io::Error) -> Self {
        Fault::File(error)
    }
}

impl From<Fault> for PyErr {
    fn from(fault: Fault) -> Self {
        let made = |py: Python<'_>| -> PyResult<PyErr> {
            let class = py.import("lineament._errors")?.getattr(fault.class())?;
            Ok(PyErr::from_value(class.call1((fault.text(),))?))
        };
        Python::attach(|py| made(py).unwrap_or_else(|error| error))
    }
}
