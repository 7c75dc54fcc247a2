//! Patches as dictionaries.

use lineament::patch::{Fit, Loop, Sides, Surface};
use lineament::{Patch, Patches};
use numpy::PyArray1;
use pyo3::prelude::*;

use crate::arrays::triple;

/// The patches of a cloud.
#[derive(IntoPyObject)]
pub struct PatchesOut<'py> {
    patches: Vec<PatchOut<'py>>,
    sides: Vec<SidesOut>,
}

#[derive(IntoPyObject)]
struct PatchOut<'py> {
    points: usize,
    area: f64,
    neighbors: Vec<u32>,
    loops: Vec<LoopOut>,
    surface: SurfaceOut<'py>,
}

#[derive(IntoPyObject)]
struct LoopOut {
    strips: Vec<(u32, bool)>,
    closed: bool,
    outer: bool,
}

#[derive(IntoPyObject)]
struct SidesOut {
    left: Option<u32>,
    right: Option<u32>,
    fold_deg: Option<f64>,
    convex: Option<bool>,
}

#[derive(IntoPyObject)]
struct SurfaceOut<'py> {
    kind: &'static str,
    point: Bound<'py, PyArray1<f64>>,
    axis: Option<Bound<'py, PyArray1<f64>>>,
    radius: Option<f64>,
    minor_radius: Option<f64>,
    half_angle_deg: Option<f64>,
    residual: f64,
    free_form: bool,
}

/// The patches for Python.
pub fn out<'py>(py: Python<'py>, patches: &Patches) -> PatchesOut<'py> {
    PatchesOut {
        patches: patches.patches.iter().map(|p| patch(py, p)).collect(),
        sides: patches.sides.iter().map(sides).collect(),
    }
}

fn patch<'py>(py: Python<'py>, patch: &Patch) -> PatchOut<'py> {
    PatchOut {
        points: patch.points,
        area: patch.area,
        neighbors: patch.neighbors.clone(),
        loops: patch.loops.iter().map(boundary).collect(),
        surface: surface(py, &patch.fit),
    }
}

fn boundary(boundary: &Loop) -> LoopOut {
    let strips = boundary.coedges.iter().map(|c| (c.strip, c.forward));
    LoopOut { strips: strips.collect(), closed: boundary.closed, outer: boundary.outer }
}

fn sides(sides: &Sides) -> SidesOut {
    let Sides { left, right, fold_deg, convex } = *sides;
    SidesOut { left, right, fold_deg, convex }
}

fn surface<'py>(py: Python<'py>, fit: &Fit) -> SurfaceOut<'py> {
    let (point, axis, radius, minor_radius, half_angle) = match fit.surface {
        Surface::Plane { point, normal } => (point, Some(normal), None, None, None),
        Surface::Sphere { center, radius } => (center, None, Some(radius), None, None),
        Surface::Cylinder { point, axis, radius } => (point, Some(axis), Some(radius), None, None),
        Surface::Cone { apex, axis, half_angle } => (apex, Some(axis), None, None, Some(half_angle)),
        Surface::Torus { center, axis, major, minor } => (center, Some(axis), Some(major), Some(minor), None),
    };
    SurfaceOut {
        kind: fit.surface.name(),
        point: triple(py, point),
        axis: axis.map(|axis| triple(py, axis)),
        radius,
        minor_radius,
        half_angle_deg: half_angle.map(f64::to_degrees),
        residual: fit.residual,
        free_form: fit.free,
    }
}
