//! A patch as an object of the schema `lineament-network/2`.

use crate::write::encode::json::{Number, Point, list};
use lineament::Patch;
use lineament::patch::{Fit, Loop, Surface};
use std::io::{self, Write};

pub(super) fn patch(out: &mut dyn Write, id: usize, patch: &Patch) -> io::Result<()> {
    let Patch { loops, neighbors, points, area, fit } = patch;
    write!(out, "{{\"id\": {id}, \"points\": {points}, \"area\": {}, \"surface\": ", Number(*area))?;
    surface(out, fit)?;
    write!(out, ", \"neighbors\": [")?;
    list(out, neighbors, |out, _, n| write!(out, "{n}"))?;
    write!(out, "], \"loops\": [")?;
    list(out, loops, boundary)?;
    write!(out, "]}}")
}

pub(in crate::write) fn surface(out: &mut dyn Write, fit: &Fit) -> io::Result<()> {
    write!(out, "{{\"type\": \"{}\", ", fit.surface.name())?;
    match &fit.surface {
        Surface::Plane { point, normal } => {
            write!(out, "\"point\": {}, \"normal\": {}", Point(point), Point(normal))?;
        }
        Surface::Sphere { center, radius } => {
            write!(out, "\"center\": {}, \"radius\": {}", Point(center), Number(*radius))?;
        }
        Surface::Cylinder { point, axis, radius } => {
            write!(out, "\"point\": {}, \"axis\": {}, ", Point(point), Point(axis))?;
            write!(out, "\"radius\": {}", Number(*radius))?;
        }
        Surface::Cone { apex, axis, half_angle } => {
            write!(out, "\"apex\": {}, \"axis\": {}, ", Point(apex), Point(axis))?;
            write!(out, "\"half_angle_deg\": {}", Number(half_angle.to_degrees()))?;
        }
        Surface::Torus { center, axis, major, minor } => {
            write!(out, "\"center\": {}, \"axis\": {}, ", Point(center), Point(axis))?;
            write!(out, "\"major_radius\": {}, \"minor_radius\": {}", Number(*major), Number(*minor))?;
        }
    }
    write!(out, ", \"residual\": {}, \"free_form\": {}}}", Number(fit.residual), fit.free)
}

fn boundary(out: &mut dyn Write, _: usize, boundary: &Loop) -> io::Result<()> {
    let Loop { coedges, closed, outer } = boundary;
    write!(out, "{{\"outer\": {outer}, \"closed\": {closed}, \"strips\": [")?;
    list(out, coedges, |out, _, c| write!(out, "{{\"strip\": {}, \"forward\": {}}}", c.strip, c.forward))?;
    write!(out, "]}}")
}
