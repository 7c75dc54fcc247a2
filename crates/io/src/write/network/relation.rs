//! Relations between typed curves, and what their imposition moved, as members of the schema `lineament-network/2`.

use crate::write::encode::json::{Number, Point, list};
use lineament::Relation;
use lineament::relation::{Member, Regularised};
use std::io::{self, Write};

/// A relation: its curves, how likely it is, and what they share.
pub(super) fn relation(out: &mut dyn Write, _: usize, relation: &Relation) -> io::Result<()> {
    let Relation { kind, likelihood, deviation, imposed, .. } = relation;
    write!(out, "{{\"type\": \"{}\", \"members\": ", kind.name())?;
    members(out, &relation.members)?;
    if !relation.others.is_empty() {
        write!(out, ", \"others\": ")?;
        members(out, &relation.others)?;
    }
    write!(out, ", \"likelihood\": {}, ", Number(*likelihood))?;
    // One that is imposed has no deviation any more.
    let before = if *imposed { "_before" } else { "" };
    match kind.is_angle() {
        true => write!(out, "\"deviation{before}_deg\": {}", Number(deviation.to_degrees()))?,
        false => write!(out, "\"deviation{before}\": {}", Number(*deviation))?,
    }
    for (name, value) in [("direction", relation.direction), ("point", relation.point)] {
        if let Some(value) = value {
            write!(out, ", \"{name}\": {}", Point(&value))?;
        }
    }
    if let Some(radius) = relation.radius {
        write!(out, ", \"radius\": {}", Number(radius))?;
    }
    write!(out, ", \"imposed\": {imposed}}}")
}

/// The greatest move, and the curves left out.
pub(super) fn regularised(out: &mut dyn Write, moved: &Regularised) -> io::Result<()> {
    write!(out, "{{\"greatest\": {}, \"released\": ", Number(moved.greatest()))?;
    members(out, &moved.released)?;
    write!(out, "}}")
}

/// Curves by strip and place in it.
fn members(out: &mut dyn Write, of: &[Member]) -> io::Result<()> {
    write!(out, "[")?;
    list(out, of, |out, _, m| write!(out, "[{}, {}]", m.strip, m.curve))?;
    write!(out, "]")
}
