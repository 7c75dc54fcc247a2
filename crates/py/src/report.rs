//! The report of an extraction.

pub mod page;

use lineament::Report;
use pyo3::prelude::*;

/// A [`Report`] as a dictionary.
#[derive(IntoPyObject)]
pub struct ReportOut {
    read: usize,
    dropped: usize,
    merged: usize,
    points: usize,
    scattered: usize,
    stray: usize,
    thinned: usize,
    spacing: f64,
    noise: f64,
    stages: Vec<(&'static str, f64)>,
    settings: Vec<(String, String)>,
    used: Vec<(String, String)>,
    notes: Vec<String>,
}

/// The report for Python.
pub fn out(report: &Report) -> ReportOut {
    let Report { read, dropped, merged, points, surface, spacing, noise, stages, settings, used, notes } =
        report;
    ReportOut {
        read: *read,
        dropped: *dropped,
        merged: *merged,
        points: *points,
        scattered: surface.scattered,
        stray: surface.stray,
        thinned: surface.thinned,
        spacing: *spacing,
        noise: *noise,
        stages: stages.iter().map(|(stage, seconds)| (stage.name(), *seconds)).collect(),
        settings: settings.clone(),
        used: used.clone(),
        notes: notes.clone(),
    }
}
