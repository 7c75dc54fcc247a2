//! Tests of the program as its users run it, one module a subject.

mod batch;
mod chosen;
mod clean;
mod commands;
mod common;
mod degenerate;
mod detectors;
mod evaluate;
mod exit_codes;
mod faults;
mod map_coordinates;
mod reading;
mod report;
mod same_bytes;
mod section;
mod streams;
mod threads;
