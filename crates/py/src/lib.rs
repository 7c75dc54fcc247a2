//! The compiled part of the Python package `lineament`: arrays in, plain dictionaries and arrays out. Their types, and all that
//! users see, stand in `python/lineament`.
#![deny(unsafe_code)]

mod arrays;
mod cleaned;
mod curves;
mod evaluation;
mod extraction;
mod fault;
mod marks;
mod network;
mod patches;
mod picture;
mod program;
mod provenance;
mod report;
mod samples;
mod scan;
mod sections;
mod settings;
mod state;
mod work;

/// Functions of the package `lineament`, which alone calls them.
#[pyo3::pymodule]
mod _lineament {
    #[pymodule_export]
    use crate::cleaned::{clean, write_scan};
    #[pymodule_export]
    use crate::curves::Typed;
    #[pymodule_export]
    use crate::evaluation::{evaluate, truth};
    #[pymodule_export]
    use crate::extraction::applied::{enrich, graph, mesh, write_enriched, write_graph, write_mesh};
    #[pymodule_export]
    use crate::extraction::{Found, extract};
    #[pymodule_export]
    use crate::marks::{detectors, mark, write_points};
    #[pymodule_export]
    use crate::network::{draw, write_network};
    #[pymodule_export]
    use crate::picture::{png, read_mesh, render, write_picture, write_text};
    #[pymodule_export]
    use crate::program::main;
    #[pymodule_export]
    use crate::samples::{sample, samples};
    #[pymodule_export]
    use crate::scan::{Folds, Las, read};
    #[pymodule_export]
    use crate::sections::{Cut, section};
    #[pymodule_export]
    use crate::settings::{parameters, parameters_of};

    /// The version of the package.
    #[pymodule_export]
    const VERSION: &str = env!("CARGO_PKG_VERSION");
}
