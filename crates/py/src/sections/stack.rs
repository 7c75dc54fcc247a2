//! The features of a stack of slices as dictionaries.

use lineament::section::{Feature, Mirror, Run, Stack};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::triple;

/// The features of a stack.
#[derive(IntoPyObject)]
pub struct StackOut<'py> {
    runs: Vec<RunOut<'py>>,
    mirrors: Vec<MirrorOut<'py>>,
    repeats: Vec<RepeatOut>,
}

#[derive(IntoPyObject)]
struct RunOut<'py> {
    kind: &'static str,
    hole: bool,
    start: f64,
    end: f64,
    range_error: (f64, f64),
    residual: f64,
    center: Bound<'py, PyArray1<f64>>,
    contours: Vec<(usize, usize)>,
    radius: Option<f64>,
    greatest_radius: Option<f64>,
    angle_deg: Option<f64>,
    apex: Option<f64>,
}

#[derive(IntoPyObject)]
struct MirrorOut<'py> {
    point: Bound<'py, PyArray1<f64>>,
    normal: Bound<'py, PyArray1<f64>>,
    planes: usize,
    residual: f64,
}

#[derive(IntoPyObject)]
struct RepeatOut {
    runs: Vec<usize>,
    residual: f64,
}

/// The features for Python.
pub fn out<'py>(py: Python<'py>, stack: &Stack) -> StackOut<'py> {
    StackOut {
        runs: stack.runs.iter().map(|r| run(py, r)).collect(),
        mirrors: stack.mirrors.iter().map(|m| mirror(py, m)).collect(),
        repeats: stack
            .repeats
            .iter()
            .map(|r| RepeatOut { runs: r.runs.clone(), residual: r.residual })
            .collect(),
    }
}

fn run<'py>(py: Python<'py>, run: &Run) -> RunOut<'py> {
    let (radius, greatest_radius, angle_deg, apex) = match run.feature {
        Feature::Extrusion { radius } => (radius, None, None, None),
        Feature::Taper { angle_deg, apex, radius } => (radius, None, Some(angle_deg), Some(apex)),
        Feature::Revolution { least, most } => (Some(least), Some(most), None, None),
    };
    RunOut {
        kind: run.feature.name(),
        hole: run.hole,
        start: run.from,
        end: run.to,
        range_error: run.range_error.into(),
        residual: run.residual,
        center: triple(py, run.centre),
        contours: run.contours.clone(),
        radius,
        greatest_radius,
        angle_deg,
        apex,
    }
}

fn mirror<'py>(py: Python<'py>, mirror: &Mirror) -> MirrorOut<'py> {
    MirrorOut {
        point: triple(py, mirror.point),
        normal: triple(py, mirror.normal),
        planes: mirror.planes,
        residual: mirror.residual,
    }
}
