//! Patches of a report.

use crate::write::encode::json::{Number, lines, list};
use crate::write::network::patch::surface;
use lineament::patch::Loop;
use lineament::{Patch, Patches};
use std::io::{self, Write};

pub(super) fn write(out: &mut dyn Write, found: &Patches) -> io::Result<()> {
    write!(out, "\"patches\": [")?;
    lines(out, &found.patches, |out, _, Patch { points, area, fit, loops, .. }| {
        write!(out, "{{\"points\": {points}, \"area\": {}, \"surface\": ", Number(*area))?;
        surface(out, fit)?;
        write!(out, ", \"loops\": [")?;
        list(out, loops, boundary)?;
        write!(out, "]}}")
    })?;
    writeln!(out, "],")
}

fn boundary(out: &mut dyn Write, _: usize, boundary: &Loop) -> io::Result<()> {
    let Loop { coedges, closed, outer } = boundary;
    write!(out, "{{\"outer\": {outer}, \"closed\": {closed}, \"strips\": [")?;
    list(out, coedges, |out, _, c| write!(out, "{}", c.strip))?;
    write!(out, "]}}")
}
